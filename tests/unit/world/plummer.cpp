// Star clusters as Plummer's model has them: where stars are, how fast, and that each is a function of the seed and its
// id.
#include <cmath>

#include "tests/catch.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::World;

namespace {

constexpr std::size_t stars = 20000;

Scene cluster(double scale, double strength) {
  BodyGroup group = particles("stars", 1);
  group.position.clear();
  group.velocity.clear();
  group.generate = ballpark::Generate{};
  group.generate->kind = "plummer";
  group.generate->count = {stars};
  group.generate->scale = scale;
  group.generate->strength = strength;
  group.generate->origin = Vector3d(1, 2, 3);
  return scene_of({group});
}

}  // namespace

TEST_CASE("Plummer: a share r^3 / (r^2 + a^2)^(3/2) of the mass lies within r, of which 99 % are taken", "[start]") {
  const double a = 2;
  const World world(cluster(a, 0));
  for (const double r : {0.5, 1.0, 2.0, 2.6, 5.0, 12.0}) {
    std::size_t inside = 0;
    for (std::size_t id = 0; id < stars; ++id) inside += (world.body(id).position - Vector3d(1, 2, 3)).norm() < r;
    const double share = std::pow(r * r / (r * r + a * a), 1.5) / 0.99;
    CAPTURE(r);
    CHECK(std::abs(static_cast<double>(inside) / stars - share) < 5 * std::sqrt(share * (1 - share) / stars));
  }
  Vector3d centre = Vector3d::Zero();
  for (std::size_t id = 0; id < stars; ++id) {
    centre += (world.body(id).position - Vector3d(1, 2, 3)).normalized() / stars;
    REQUIRE(world.body(id).velocity.norm() == 0);
    REQUIRE((world.body(id).position - Vector3d(1, 2, 3)).norm() < 12.3 * a);
  }
  CHECK(centre.norm() < 5 / std::sqrt(double(stars)));  // all directions alike
}

TEST_CASE("Plummer: speeds are below that of escape, with a mean square of G M / (2 sqrt(r^2 + a^2))", "[start]") {
  const double a = 0.5, strength = 3;
  const World world(cluster(a, strength));
  double sum = 0, squares = 0, along = 0;
  for (std::size_t id = 0; id < stars; ++id) {
    const Vector3d x = world.body(id).position - Vector3d(1, 2, 3), v = world.body(id).velocity;
    const double depth = strength / std::sqrt(x.squaredNorm() + a * a), share = v.squaredNorm() / depth;
    REQUIRE(share < 2);
    sum += share;
    squares += share * share;
    along += x.normalized().dot(v.normalized());
  }
  const double mean = sum / stars, spread = std::sqrt((squares / stars - mean * mean) / stars);
  CHECK(std::abs(mean - 0.5) < 5 * spread);
  CHECK(std::abs(along / stars) < 5 / std::sqrt(double(stars)));
}

TEST_CASE("Plummer: the same stars for the same seed, others for another, in every copy", "[start]") {
  Scene scene = cluster(1, 1);
  scene.bodies[0].generate->count = {50};
  scene.run.seed = 3;
  const World two(scene, {.copies = 2}), again(scene);
  scene.run.seed = 4;
  const World next(scene);
  for (std::size_t id = 0; id < 50; ++id) {
    CHECK(two.body(id).position == again.body(id).position);
    CHECK(two.body(id).velocity == again.body(id).velocity);
    CHECK(two.body(50 + id).position == next.body(id).position);
    CHECK(again.body(id).velocity != next.body(id).velocity);
  }
}

TEST_CASE("Plummer: needs a scale, and no strength below 0", "[start]") {
  Scene scene = cluster(0, -1);
  const std::vector<ballpark::Problem> problems = check(scene);
  REQUIRE(problems.size() == 2);
  CHECK(problems[0].path == "bodies[0].generate.scale");
  CHECK(problems[1].path == "bodies[0].generate.strength");
}
