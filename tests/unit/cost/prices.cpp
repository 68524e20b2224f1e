// What effects cost: that every effect of the catalogue has a price, and what a price is made of. No time is judged.
#include "perf/effects/prices.h"

#include <algorithm>
#include <cmath>

#include "ballpark/catalogue.h"
#include "perf/effects/sample.h"
#include "tests/catch.h"

using namespace ballpark;
using namespace ballpark::cost;

namespace {

const Progress quietly = [](const std::string&, double) { return true; };

PricesRequest small_request() {
  PricesRequest request;
  request.bodies = 512;
  request.seconds = 0.1;
  request.body_steps = 1e4;
  return request;
}

Scene two_balls() {
  Scene scene;
  scene.name = "two";
  scene.run.duration = 0.1;
  scene.run.step = 0.01;
  BodyGroup group;
  group.name = "balls";
  group.shape = "sphere";
  group.radius = {0.1};
  group.mass = {1};
  group.position = {{0, 0, 0}, {1, 0, 0}};
  group.angular_velocity = {{0, 0, 5}};
  scene.bodies = {group};
  Effect magnus;
  magnus.kind = "magnus";
  magnus.parameters["coefficient"] = 0.1;
  Effect gravity;
  gravity.kind = "gravity";
  scene.effects = {gravity, magnus};
  return scene;
}

}  // namespace

TEST_CASE("prices: every effect of the catalogue has one, alone, in both precisions", "[prices]") {
  const auto list = prices(small_request(), quietly);
  REQUIRE(list);
  CHECK(list->left_out.empty());
  CHECK(list->threads == 1);
  REQUIRE(list->alone.size() == effects().size());
  for (std::size_t i = 0; i < effects().size(); ++i) {
    const EffectPrice& effect = list->alone[i];
    CAPTURE(effect.label);
    CHECK(effect.label == effects()[i].name);
    CHECK(effect.flops == effects()[i].flops);
    REQUIRE(effect.prices.size() == 2);
    CHECK(effect.prices[0].precision == Precision::double_);
    CHECK(effect.prices[1].precision == Precision::single_);
    for (const Price& price : effect.prices) {
      CHECK(price.bodies <= 512);
      CHECK(price.base > 0);
    }
    const int times = effects()[i].between_steps ? 1 : 4;  // rk4 evaluates four times
    CHECK(effect.flops_of_step >= times * effect.flops);
  }
}

TEST_CASE("prices: an effect that asks for a column moves its bytes", "[prices]") {
  const auto list = prices(small_request(), quietly);
  REQUIRE(list);
  const auto named = [&](const char* name) {
    return *std::find_if(list->alone.begin(), list->alone.end(), [&](auto& e) { return e.label == name; });
  };
  CHECK(named("gravity").bytes == 0);
  CHECK(named("gravity").flops_of_step == 4 * named("gravity").flops);
  CHECK(named("gravity").beside == "particles");
  CHECK(named("magnus").beside == "balls");
  CHECK(named("magnus").bytes == 2 * 3 * 8);  // angular momentum, read and written
  CHECK(named("spin_decay").beside == "balls");
  CHECK(named("spin_decay").bytes == 2 * 3 * 8);
  CHECK(named("buoyancy").beside == "balls");  // which have a radius, the same for all
  CHECK(named("buoyancy").bytes == 0);
  CHECK(named("buoyancy").flops_of_step == 4 * named("buoyancy").flops);
  CHECK(named("added_mass").bytes == 0);
  CHECK(named("added_mass").flops_of_step == 0);
  CHECK(named("gusts").beside == "particles");
  // Reading positions, they ask for those of three stages too.
  CHECK(named("gusts").flops_of_step == 4 * named("gusts").flops + 2 * 3 * 3);
}

TEST_CASE("prices: of a scene, those of its own effects alone and in it", "[prices]") {
  PricesRequest request = small_request();
  request.scene = two_balls();
  request.options.precision = Precision::double_;
  const auto list = prices(request, quietly);
  REQUIRE(list);
  REQUIRE(list->alone.size() == 2);
  REQUIRE(list->in_scene.size() == 2);
  CHECK(list->in_scene[0].label == "gravity");
  CHECK(list->in_scene[1].label == "magnus");
  CHECK(list->in_scene[1].bytes == 48);
  CHECK(list->in_scene[1].flops_of_step >= 4 * list->in_scene[1].flops);
  for (const EffectPrice& effect : list->in_scene) {
    REQUIRE(effect.prices.size() == 1);
    CHECK(effect.prices[0].bodies == 2);
    CHECK(effect.beside == "two");
  }
}

TEST_CASE("prices: a long scene is timed over its first part", "[prices]") {
  PricesRequest request = small_request();
  request.scene = two_balls();
  request.scene->run.duration = 1e6;
  const auto list = prices(request, quietly);
  REQUIRE(list);
  CHECK(list->whole == 1e6);
  CHECK(list->duration < 1e5);
  const double steps = list->duration / request.scene->run.step;
  CHECK(std::abs(steps - std::round(steps)) < 1e-6);
}

TEST_CASE("prices: a sample of an effect is a scene's effect as it stands", "[prices]") {
  for (const EffectDescription& effect : effects()) {
    CAPTURE(effect.name);
    std::string why;
    const auto scenes = plain_scenes(effect, 8, 3, why);
    REQUIRE(scenes);
    CHECK(scenes->without.effects.empty());
    REQUIRE(scenes->with.effects.size() == 1);
    CHECK(World(scenes->with).body_count() == 8);
    CHECK(perf::sample_of(effect, 8).kind == effect.name);
  }
}
