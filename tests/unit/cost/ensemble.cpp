// Statistics of a few runs, and ensembles of scenes whose paths mean nothing.
#include "perf/cost/ensemble.h"

#include <algorithm>
#include <cmath>

#include "perf/cost/cost.h"
#include "tests/catch.h"

using namespace ballpark;
using namespace ballpark::cost;

namespace {

const GoOn always = [] { return true; };

/// The Pythagorean three bodies (Burrau 1913), softened so that none leaves: they part after 50 s.
Scene three_bodies() {
  Scene scene;
  scene.name = "three";
  scene.run.duration = 100;
  scene.run.step = 0.005;
  scene.run.integrator = "rk4";
  BodyGroup stars;
  stars.name = "stars";
  stars.mass = {3, 4, 5};
  stars.position = {{1, 3, 0}, {-2, -1, 0}, {1, -1, 0}};
  stars.velocity = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  scene.bodies = {stars};
  Effect gravity;
  gravity.kind = "mutual_gravity";
  gravity.parameters["strength"] = 1.0;
  gravity.parameters["softening"] = 0.3;
  scene.effects = {gravity};
  return scene;
}

}  // namespace

TEST_CASE("Student's t: quantiles of the tables, and tails that belong to them", "[cost]") {
  CHECK(std::abs(student_quantile(0.975, 9) - 2.2621571628) < 1e-10);
  CHECK(std::abs(student_quantile(0.975, 19) - 2.0930240544) < 1e-10);
  CHECK(std::abs(student_quantile(0.975, 1) - 12.7062047362) < 1e-9);
  CHECK(std::abs(student_quantile(0.975, 1e6) - 1.9599663) < 1e-6);
  CHECK(std::abs(student_quantile(0.75, 1) - 1) < 1e-14);                                // Cauchy's: tan(pi / 4)
  CHECK(std::abs(student_quantile(0.95, 2) - 0.9 * std::sqrt(2 / (1 - 0.81))) < 1e-13);  // Abramowitz & Stegun 26.7.4
  CHECK(student_quantile(0.5, 7) < 1e-15);
  for (const double freedom : {1.0, 4.5, 18.0, 300.0}) {
    for (const double t : {0.01, 0.5, 1.0, 2.0, 4.0}) {
      CHECK(std::abs(student_quantile(1 - student_tails(t, freedom) / 2, freedom) - t) < 1e-9 * (1 + t * t));
    }
  }
}

TEST_CASE("means: of a known sample, and their difference by Welch", "[cost]") {
  const Mean a = mean_of({1, 2, 3, 4, 5}), b = mean_of({2, 4, 6, 8, 10, 12});
  CHECK(a.value == 3);
  CHECK(std::abs(a.error - std::sqrt(0.5)) < 1e-15);
  CHECK(std::abs(a.margin() - 2.7764451052 * std::sqrt(0.5)) < 1e-9);
  CHECK(b.value == 7);
  CHECK(std::abs(b.error * b.error - 14.0 / 6) < 1e-14);
  const Difference difference = difference_of(a, b);
  CHECK(difference.value == -4);
  CHECK(std::abs(difference.sigmas() - 4 / std::sqrt(0.5 + 14.0 / 6)) < 1e-14);
  const double freedom = std::pow(0.5 + 14.0 / 6, 2) / (0.25 / 4 + std::pow(14.0 / 6, 2) / 5);
  CHECK(std::abs(difference.chance - student_tails(difference.sigmas(), freedom)) < 1e-15);
  CHECK(difference_of(a, a).sigmas() == 0);
  CHECK(difference_of(a, a).chance == 1);
  CHECK(mean_of({7, 7, 7}).margin() == 0);
}

TEST_CASE("ensembles: copy k is that of a batch, and the same ones come again", "[cost]") {
  Scene scene = three_bodies();
  scene.run.duration = 5;
  EnsembleRequest request{.perturb = 1e-8};
  const auto copies = run_copies(scene, setting_of(scene), request, {}, always);
  REQUIRE(copies);
  CHECK(copies->trouble.empty());
  CHECK(run_copies(scene, setting_of(scene), request, {}, always)->values == copies->values);
  Options batch;
  batch.copies = request.copies;
  batch.perturb = request.perturb;
  World world(scene, batch);
  world.step(1000);
  const std::size_t speed = 2;
  CHECK(observables()[speed].name == "mean speed");
  for (std::size_t k = 0; k < 10; ++k) {
    double mean = 0;
    for (std::size_t id = 3 * k; id < 3 * (k + 1); ++id) mean += world.body(id).velocity.norm() / 3;
    CHECK(copies->values[speed][k] == mean);
  }
}

TEST_CASE("ensembles: beyond the horizon good methods agree, one that gains energy is seen", "[cost]") {
  const Scene scene = three_bodies();
  EnsembleRequest request{.perturb = 1e-8};
  const Setting good{"rk4", 0.005, 0, Precision::double_}, other{"dormand_prince8", 0, 1e-10, Precision::double_};
  const auto first = run_copies(scene, good, request, {}, always),
             second = run_copies(scene, other, request, {}, always);
  const auto wrong = run_copies(scene, {"euler", 0.05, 0, Precision::double_}, request, {}, always);
  REQUIRE((first && second && wrong));
  CHECK(first->values[3] != second->values[3]);
  double most = 0;
  for (std::size_t o = 0; o < observables().size(); ++o) {
    const Mean right = mean_of(second->values[o]);
    INFO(observables()[o].name);
    if (right.error > 0 && observables()[o].unit != "") {
      CHECK(difference_of(mean_of(first->values[o]), right).sigmas() < 3);
    }
    most = std::max(most, difference_of(mean_of(wrong->values[o]), right).sigmas());
  }
  CHECK(most > 5);
}

TEST_CASE("ensembles: a study takes them beyond a horizon, and says what it did", "[cost]") {
  Scene scene = three_bodies();
  Request request;
#ifdef BALLPARK_SANITIZE
  request.seconds = 300;
#else
  request.seconds = 20;  // far more than it takes, on a busy machine too
#endif
  request.axes.integrators = {"rk4", "dormand_prince8"};
  request.axes.precisions = {Precision::double_};
  request.copies = 12;
  const auto result = cost::cost(scene, request, [](const std::string&, double) { return true; });
  REQUIRE(result);
  REQUIRE(result->ensemble);
  const Ensemble& ensemble = *result->ensemble;
  CHECK(ensemble.copies == 12);
  CHECK(ensemble.time == scene.run.duration);
  CHECK(result->duration < result->horizon->time);
  CHECK(result->horizon->sentence.find("statistics of 12 runs") != std::string::npos);
  CHECK(ensemble.reference.means.size() == ensemble.observables.size());
  for (const Observable& observable : ensemble.observables) CHECK(observable.name != "centre z");  // 0 in all runs
  for (const EnsembleRuns& runs : ensemble.settings) {
    CHECK(runs.means.size() == ensemble.observables.size());
    CHECK(runs.from_reference.size() == ensemble.observables.size());
  }
  scene.run.duration = 10;
  const auto together = cost::cost(scene, request, [](const std::string&, double) { return true; });
  REQUIRE(together);
  CHECK_FALSE(together->ensemble);
  CHECK(together->left_out.back().find("paths stay together") != std::string::npos);
}
