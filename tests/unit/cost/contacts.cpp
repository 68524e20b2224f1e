// The formulation of contacts as a way to run a scene: hard against soft, and what soft ones lose.
#include "perf/cost/contacts.h"

#include <algorithm>
#include <cmath>

#include "perf/cost/choice.h"
#include "perf/cost/cost.h"
#include "perf/cost/result_json.h"
#include "tests/catch.h"

using namespace ballpark;
using namespace ballpark::cost;

namespace {

const GoOn always = [] { return true; };

/// A ball that falls from 1 m and bounces.
Scene drop(double restitution) {
  Scene scene;
  scene.run = {.duration = 1, .step = 0.01, .integrator = "velocity_verlet"};
  scene.contact.kind = "impulse";
  scene.materials["rubber"] = {restitution, 0};
  scene.boundaries = {{.shape = "plane", .material = "rubber"}};
  BodyGroup ball{.name = "ball", .shape = "sphere", .material = "rubber", .radius = {0.1}, .mass = {1}};
  ball.position = {{0, 0, 1.1}};
  scene.bodies = {ball};
  scene.effects = {{"gravity", {}, {}}};
  return scene;
}

Scene soft_drop() {
  Scene scene = drop(0.8);
  scene.contact.kind = "penalty";
  scene.contact.stiffness = 1e4;
  return scene;
}

std::vector<std::string> texts(const std::vector<ContactChoice>& contacts) {
  std::vector<std::string> words;
  for (const ContactChoice& contact : contacts) words.push_back(text(contact));
  return words;
}

using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("contacts: of a scene by impulse springs are tried too, and stiffer ones come nearer to its closed form",
          "[cost]") {
  const auto ground = ground_for(drop(0.8), {}, always);
  REQUIRE(ground);
  CHECK(ground->about.reference.kind == "closed form");
  Result result;
  const std::vector<ContactChoice> contacts = contacts_to_try(*ground, {}, result);
  // 1 kg at 4.4 m/s within 1 % of 0.1 m: 2e7 N/m
  CHECK(texts(contacts) == Words{"12 iterations x 1", "penalty 2e+07 N/m", "4 iterations x 1", "36 iterations x 1",
                                 "12 iterations x 2", "12 iterations x 4", "penalty 200000 N/m", "penalty 2e+09 N/m"});
  REQUIRE(result.remarks.size() == 2);
  CHECK(result.remarks[0].find("no step takes away") != std::string::npos);
  CHECK(result.remarks[1].find("Springs of 2e+07 N/m") == 0);
  CHECK(result.left_out.empty());
  const auto error_of = [&](double stiffness, double step) {
    const Setting setting{"velocity_verlet", step, 0, Precision::double_, {.kind = "penalty", .stiffness = stiffness}};
    const Point point = measured_point(*ground, setting, always);
    INFO(text(setting) << ": " << point.error << " " << point.trouble);
    CHECK(point.trouble.empty());
    CHECK(point.errors.penetration > 0);
    return point.error;
  };
  const double soft = error_of(2e5, 1e-6), middle = error_of(2e6, 1e-6), usual = error_of(2e7, 1e-6);
  INFO(soft << ", " << middle << ", " << usual);
  CHECK(middle < 0.4 * soft);  // as the time of contact: 1 / sqrt(10) each
  CHECK(usual < 0.4 * middle);
  CHECK(usual < 0.15 * soft);
  CHECK(std::abs(error_of(2e5, 1e-5) / soft - 1) < 0.05);  // no step takes the difference of the models away
}

TEST_CASE("contacts: a scene by penalty is swept by impulse too, against a reference of its own springs", "[cost]") {
  Request request;
  request.seconds = 6;
  request.axes.steps = {1e-3, 1e-4, 1e-5};
  request.axes.integrators = {"velocity_verlet", "rk4"};
  request.axes.precisions = {Precision::double_};
  const auto result = cost::cost(soft_drop(), request, [](const std::string&, double) { return true; });
  REQUIRE(result);
  CHECK(result->reference.kind != "closed form");
  double nearest_soft = 1e300, nearest_hard = 1e300;
  for (const Point& point : result->points) {
    if (!counts(point)) continue;
    const bool soft = point.setting.contact == ContactChoice{.kind = "penalty", .stiffness = 1e4};
    CHECK((soft || point.setting.contact.kind == "impulse"));
    double& nearest = soft ? nearest_soft : nearest_hard;
    nearest = std::min(nearest, point.error);
  }
  CHECK(nearest_soft < 2e-3);
  CHECK(nearest_hard < 1);
  CHECK(nearest_hard > 10 * nearest_soft);  // the difference of the models
  REQUIRE(formulations(*result).size() == 2);
  CHECK(formulations(*result)[0].find("impulse contacts come as near as ") == 0);
  CHECK(formulations(*result)[1].find("penalty 10000 N/m") != std::string::npos);
}

TEST_CASE("contacts: what is asked for is taken, once, with the usual numbers where none are given", "[cost]") {
  const auto hard = ground_for(drop(0.8), {}, always);
  REQUIRE(hard);
  Result result;
  const ContactChoice stiff{.kind = "penalty", .stiffness = 3e6}, twice{"impulse", 12, 2};
  CHECK(texts(contacts_to_try(*hard, {twice, stiff, twice}, result)) ==
        Words{"12 iterations x 2", "penalty 3e+06 N/m"});
  CHECK(result.remarks.size() == 1);  // the stiffness was not chosen here
  Result soft;
  CHECK(contacts_to_try(*hard, {{.kind = "penalty"}}, soft).size() == 3);
  CHECK(soft.remarks.size() == 2);
  Result own;
  CHECK(contacts_to_try(*hard, {{.kind = "impulse"}}, own).size() == 5);
  CHECK(own.remarks.empty());
  CHECK(same_equations(hard->scene, twice));
  CHECK_FALSE(same_equations(hard->scene, stiff));
  CHECK_FALSE(same_equations(soft_drop(), stiff));
}

TEST_CASE("contacts: what cannot be had is left out, once, with the reason", "[cost]") {
  const auto ground = ground_for(drop(0), {}, always);  // which takes a dashpot that pulls
  REQUIRE(ground);
  Result result;
  CHECK(contacts_to_try(*ground, {}, result).size() == 5);
  REQUIRE(result.left_out.size() == 1);
  CHECK(result.left_out[0].find("penalty contacts: restitution 0 of rubber on rubber") == 0);
  CHECK(result.remarks.empty());
}

TEST_CASE("contacts: unstable steps are not tried, multistep methods only where they go with contacts", "[cost]") {
  Axes axes;
  axes.integrators = {"velocity_verlet", "ab4"};
  axes.precisions = {Precision::double_};
  axes.contacts = {{"impulse", 12, 1}, {.kind = "penalty", .stiffness = 1e6}};
  std::vector<std::string> refused, labels;
  for (const Candidate& candidate : candidates(drop(0.8), axes, 20, refused)) {
    labels.push_back(candidate.curve.label);
    const Setting& coarsest = candidate.settings.front();
    // velocity_verlet: 2 / omega = 2e-3 s without the dashpot
    if (coarsest.contact.kind == "penalty") CHECK(coarsest.step < 2e-3);
    if (coarsest.contact.kind == "impulse") CHECK(coarsest.step == 0.05);
  }
  CHECK(labels == Words{"velocity_verlet, 12 x 1", "velocity_verlet, penalty 1e+06 N/m", "ab4, penalty 1e+06 N/m"});
  REQUIRE(refused.size() == 2);
  CHECK(refused[0].find("ab4: impulse contacts") == 0);
  CHECK(refused[1].find("steps too long to be stable") == 0);
}

TEST_CASE("contacts: a setting makes the scene that it was made of, and JSON and CSV hold it", "[cost]") {
  const Scene hard = drop(0.8), soft = soft_drop();
  for (const Scene* from : {&hard, &soft}) {
    for (const Scene* to : {&hard, &soft}) CHECK(setting_of(scene_with(*from, setting_of(*to))) == setting_of(*to));
    CHECK(check(scene_with(*from, setting_of(hard))).empty());
    CHECK(check(scene_with(*from, setting_of(soft))).empty());
  }
  Setting other = setting_of(soft);
  other.contact.stiffness *= 2;
  CHECK_FALSE(same_curve(other, setting_of(soft)));
  other.contact.stiffness /= 2;
  other.step /= 2;
  CHECK(same_curve(other, setting_of(soft)));
  Result result;
  result.points.resize(2);
  result.points[0].setting = setting_of(hard);
  result.points[1].setting = setting_of(soft);
  const auto json = to_json(result);
  CHECK(json["points"][0]["contact"].dump() == R"({"kind":"impulse","iterations":12,"substeps":1})");
  CHECK(json["points"][1]["contact"].dump() == R"({"kind":"penalty","stiffness":10000.0})");
  const std::string csv = to_csv(result);
  CHECK(csv.find("contact,iterations,substeps,stiffness,rotation") != std::string::npos);
  CHECK(csv.find("double,penalty,0,0,10000,") != std::string::npos);
}
