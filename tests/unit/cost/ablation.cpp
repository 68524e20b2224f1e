// What effects are worth: a spinning ball in air without each of its effects, beside runs made by hand, and flights
// with closed forms.
#include "perf/effects/ablation.h"

#include <algorithm>
#include <cmath>

#include "tests/catch.h"

using namespace ballpark;
using namespace ballpark::cost;

namespace {

const Progress quietly = [](const std::string&, double) { return true; };

/// A football kicked with side spin, watched for its landing.
const char* const kick = R"(
name = "kick"
[run]
duration = 2.4
step = 0.01
[[bodies]]
name = "ball"
shape = "sphere"
radius = 0.11
mass = 0.43
position = [0.0, 0.0, 0.0]
velocity = [20.0, 0.0, 10.0]
angular_velocity = [0.0, 0.0, 60.0]
[[effects]]
kind = "gravity"
[[effects]]
kind = "quadratic_drag"
coefficient = 0.005
[[effects]]
kind = "magnus"
coefficient = 0.002
[[effects]]
kind = "force"
force = [0.0, 1e-6, 0.0]
[[effects]]
kind = "force"
force = [0.0, 5.0, 0.0]
at = 2.9
until = 3.0
[[event]]
name = "landing"
quantity = "state.0.z"
crossing = "falling"
[[expect]]
quantity = "state.0.y"
min = 1.0
)";

scenes::SceneFile file() {
  return scenes::parse(kick, "kick.toml");
}

Request request() {
  Request request;
  request.seconds = 2;
  request.options.threads = 1;
  return request;
}

const Loss& loss_of(const Ablation& ablation, std::size_t index) {
  const auto& list = ablation.losses;
  return *std::find_if(list.begin(), list.end(), [&](const Loss& loss) { return loss.index == index; });
}

BodyState end_of(const Scene& scene) {
  World world(scene);
  world.advance_to(scene.run.duration);
  return world.body(0);
}

const Change& change_of(const Loss& loss, const std::string& name) {
  const auto& list = loss.own;
  return *std::find_if(list.begin(), list.end(), [&](const Change& change) { return change.name == name; });
}

}  // namespace

TEST_CASE("ablation: what a kicked ball loses is what runs by hand say", "[ablate]") {
  const auto ablation = ablate(file(), request(), quietly);
  REQUIRE(ablation);
  REQUIRE(ablation->trouble.empty());
  REQUIRE(ablation->losses.size() == 5);
  CHECK(ablation->own_error < 1e-6);
  CHECK(ablation->about.which == "end");
  const Scene scene = file().scene;
  const BodyState full = end_of(scene);
  const double path = full.position.norm();
  for (std::size_t i = 0; i < 5; ++i) {
    Scene dropped = scene;
    dropped.effects.erase(dropped.effects.begin() + static_cast<std::ptrdiff_t>(i));
    const Loss& loss = loss_of(*ablation, i);
    CAPTURE(loss.sentence);
    CHECK(loss.kind == scene.effects[i].kind);
    const double moved = (end_of(dropped).position - full.position).norm();
    CHECK(std::abs(loss.moved - moved) <= 1e-12 * path);
    CHECK(loss.keep == (moved > 0.01 * path));
    CHECK(loss.time.seconds.runs > 0);
  }
  CHECK(loss_of(*ablation, 4).same_bits);
  CHECK(loss_of(*ablation, 4).sentence.find("changes no bit") != std::string::npos);
  CHECK_FALSE(loss_of(*ablation, 3).same_bits);
  CHECK(loss_of(*ablation, 2).bytes > 0);  // nothing else asks for the spin
  CHECK(loss_of(*ablation, 3).label == "force (effects.3)");
}

TEST_CASE("ablation: the cheapest to lose come first", "[ablate]") {
  const auto ablation = ablate(file(), request(), quietly);
  REQUIRE(ablation);
  const std::vector<Loss>& list = ablation->losses;
  CHECK(list.front().index == 4);
  CHECK(list.back().index == 0);  // gravity moves it farthest
  for (std::size_t k = 1; k < list.size(); ++k) {
    CHECK(list[k - 1].keep <= list[k].keep);
    CHECK(list[k - 1].moved <= list[k].moved);
  }
}

TEST_CASE("ablation: what is expected and missed without an effect keeps it", "[ablate]") {
  const auto ablation = ablate(file(), request(), quietly);
  REQUIRE(ablation);
  const Change& y = change_of(loss_of(*ablation, 2), "state.0.y");  // the spin alone bends the path
  CHECK(y.full.value.x() > 1);
  CHECK(std::abs(y.without.value.x()) < 1e-4);
  CHECK(y.breaks());
  CHECK_FALSE(change_of(loss_of(*ablation, 3), "state.0.y").breaks());
  CHECK(loss_of(*ablation, 2).sentence.find("misses the expected state.0.y") != std::string::npos);
}

TEST_CASE("ablation: without drag and lift a ball lands where Galileo says", "[ablate]") {
  scenes::SceneFile flight = file();
  std::erase_if(flight.scene.effects,
                [](const Effect& e) { return e.kind != "gravity" && e.kind != "quadratic_drag"; });
  flight.expectations.clear();
  const auto ablation = ablate(flight, request(), quietly);
  REQUIRE(ablation);
  const double g = 9.81, vx = 20, vz = 10, t = flight.scene.run.duration;
  const Loss& drag = loss_of(*ablation, 1);
  CHECK(std::abs(change_of(drag, "landing").without.value.x() - 2 * vz / g) < 1e-12);
  CHECK((change_of(drag, "place of landing").without.value - Vector3d(vx * 2 * vz / g, 0, 0)).norm() < 1e-11);
  CHECK(drag.sentence.find("the place of landing by") != std::string::npos);
  const Vector3d projectile(vx * t, 0, vz * t - g * t * t / 2);
  CHECK(std::abs(drag.moved - (end_of(flight.scene).position - projectile).norm()) < 1e-11);
  // The full scene counts its energy as kinetic, with the spin's, and potential: a projectile keeps it.
  const double spinning = 0.5 * 0.4 * 0.43 * 0.11 * 0.11 * 60 * 60;
  const double energy = 0.5 * 0.43 * (vx * vx + vz * vz) + spinning;
  CHECK(std::abs(drag.energy.without.value.x() - energy) < 1e-10 * energy);
  // Without gravity the ball never comes down, and its energy is still that of the full scene, weight included.
  const Loss& gravity = loss_of(*ablation, 0);
  CHECK(gravity.keep);
  CHECK_FALSE(change_of(gravity, "landing").without.there);
  CHECK(gravity.sentence.find("leaves no landing:") != std::string::npos);
  Scene weightless = flight.scene;
  weightless.effects.erase(weightless.effects.begin());
  const BodyState end = end_of(weightless);
  const double counted = 0.43 * (0.5 * end.velocity.squaredNorm() + g * end.position.z()) + spinning;
  CHECK(std::abs(gravity.energy.without.value.x() - counted) < 1e-10 * counted);
}

TEST_CASE("ablation: wind is worth what it carries along, and nothing where nothing feels it", "[ablate]") {
  scenes::SceneFile drift = file();
  drift.expectations.clear();
  Effect drag, wind, gravity;
  drag.kind = "linear_drag", drag.parameters["coefficient"] = 0.43 / 2;  // m / k = 2 s
  wind.kind = "wind", wind.parameters["velocity"] = Vector3d(0, 5, 0);
  gravity.kind = "gravity";
  drift.scene.effects = {drag, wind};
  const auto carried = ablate(drift, request(), quietly);
  REQUIRE(carried);
  const double t = drift.scene.run.duration, expected = 5 * (t - 2 * (1 - std::exp(-t / 2)));
  CHECK(std::abs(loss_of(*carried, 1).moved - expected) < 1e-8);
  CHECK(loss_of(*carried, 1).keep);
  drift.scene.effects = {gravity, wind};
  const auto unfelt = ablate(drift, request(), quietly);
  REQUIRE(unfelt);
  CHECK(loss_of(*unfelt, 1).same_bits);
  CHECK(loss_of(*unfelt, 1).sentence.find("changes no bit") != std::string::npos);
}

TEST_CASE("ablation: no change is claimed below the full scene's own error", "[ablate]") {
  scenes::SceneFile coarse = file();
  coarse.scene.run.integrator = "euler";
  coarse.scene.run.step = 0.1;
  const auto ablation = ablate(coarse, request(), quietly);
  REQUIRE(ablation);
  CHECK(ablation->own_error > 0.1);
  const Loss& breeze = loss_of(*ablation, 3);  // F t^2 / 2m = 7 micrometres
  CHECK(breeze.moved > 1e-6);
  CHECK(breeze.moved < 1e-5);
  CHECK(breeze.sentence.find("less than the scene's own error") != std::string::npos);
  CHECK_FALSE(breeze.energy.seen());
  CHECK_FALSE(breeze.keep);
}

TEST_CASE("ablation: a change that is asked for as worth it is", "[ablate]") {
  Request generous = request();
  generous.tolerance = 1e3;
  scenes::SceneFile free = file();
  free.expectations.clear();
  free.events.clear();
  const auto ablation = ablate(free, generous, quietly);
  REQUIRE(ablation);
  for (const Loss& loss : ablation->losses) CHECK_FALSE(loss.keep);
}

TEST_CASE("ablation: an effect without which steps are unstable is kept, and said so", "[ablate]") {
  // Euler's method takes no oscillation, unless it is damped (numerics: its imaginary limit is 0).
  const scenes::SceneFile damped = scenes::parse(R"(
name = "damped"
[run]
duration = 1.0
step = 0.01
integrator = "euler"
[[bodies]]
name = "ball"
mass = 1.0
position = [1.0, 0.0, 0.0]
[[effects]]
kind = "spring"
stiffness = 100.0
anchor = [0.0, 0.0, 0.0]
[[effects]]
kind = "linear_drag"
coefficient = 10.0
)",
                                                 "damped.toml");
  const auto ablation = ablate(damped, request(), quietly);
  REQUIRE(ablation);
  const Loss& drag = loss_of(*ablation, 1);
  CHECK_FALSE(drag.trouble.empty());
  CHECK(drag.keep);
  CHECK(ablation->losses.back().index == 1);
  const Loss& spring = loss_of(*ablation, 0);  // without it the ball stays where it is
  CHECK(spring.trouble.empty());
  const double end = end_of(damped.scene).position.x();
  CHECK(std::abs(spring.moved - std::abs(1 - end)) < 1e-14);
}

TEST_CASE("ablation: beyond the horizon means decide", "[ablate]") {
  scenes::SceneFile three = scenes::parse(R"(
name = "three"
[run]
duration = 100.0
step = 0.01
[[bodies]]
name = "stars"
mass = [3.0, 4.0, 5.0]
position = [[1.0, 3.0, 0.0], [-2.0, -1.0, 0.0], [1.0, -1.0, 0.0]]
velocity = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]
[[effects]]
kind = "mutual_gravity"
strength = 1.0
softening = 0.3
[[effects]]
kind = "force"
force = [0.0, 1e-9, 0.0]
)",
                                          "three.toml");
  Request patient = request();
  patient.seconds = 60;
  const auto ablation = ablate(three, patient, quietly);
  REQUIRE(ablation);
  REQUIRE(ablation->about.horizon);
  REQUIRE(ablation->copies == 10);
  CHECK(loss_of(*ablation, 0).keep);  // nothing falls
  CHECK_FALSE(loss_of(*ablation, 1).keep);
  CHECK(loss_of(*ablation, 1).sentence.find("changes no mean beyond the horizon") != std::string::npos);
}

TEST_CASE("ablation: what takes more time without an effect is no reason to drop it", "[ablate]") {
  const auto said = [](double seconds) {
    Loss loss{.kind = "wind", .label = "wind"};
    loss.time = {{seconds, seconds, seconds, 9}, {1, 1, 1, 9}, 0.01};
    Ablation ablation{.own_error = 1e-9, .most = 1, .losses = {loss}};
    judge(ablation);
    CHECK_FALSE(ablation.losses[0].keep);
    return ablation.losses[0].sentence;
  };
  CHECK(said(0.9).find("drop it") != std::string::npos);
  CHECK(said(1.1).find("it may go") != std::string::npos);
  CHECK(said(0.999).find("it may go") != std::string::npos);
}
