// Implicit integrators on forces without derivatives: the same stages by fixed-point iteration as by Newton's method.
#include "tests/catch.h"
#include "tests/physics/contact_scenes.h"
#include "tests/physics/scenes.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

const std::vector<std::string> implicit_names{"backward_euler", "implicit_midpoint", "gauss4"};

UserEffect user(const std::string& name, std::function<void(const BodyBlock<double>&)> run) {
  UserEffect made;
  made.name = name;
  made.run_double = std::move(run);
  return made;
}

UserEffect user_spring(double stiffness) {
  return user("spring of the user", [stiffness](const BodyBlock<double>& block) {
    for (int c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < block.count; ++i) block.force[c][i] -= stiffness * block.position[c][i];
    }
  });
}

/// Adds nothing, and gives no derivatives.
UserEffect onlooker() {
  return user("onlooker", [](const BodyBlock<double>&) {});
}

/// Bodies that attract each other, on a sphere of 1 m and moving at random-looking speeds.
Scene cluster(std::size_t count, const std::string& integrator) {
  BodyGroup group = particle({0, 0, 0});
  group.position.clear(), group.velocity.clear();
  group.mass = {1.0 / static_cast<double>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const double n = static_cast<double>(i), z = 1 - (2 * n + 1) / static_cast<double>(count), r = std::sqrt(1 - z * z);
    group.position.push_back({r * std::cos(2.4 * n), r * std::sin(2.4 * n), z});
    group.velocity.push_back({0.3 * std::sin(7 * n), 0.3 * std::sin(5 * n + 1), 0.3 * std::sin(3 * n + 2)});
  }
  const Effect attraction{"mutual_gravity", {}, {{"strength", 1.0}, {"softening", 0.1}}};
  return scene(group, {attraction}, 1, 0.01, integrator);
}

}  // namespace

TEST_CASE("a user's spring swings as the catalogue's does under Newton's method", "[physics]") {
  for (const std::string& name : implicit_names) {
    const BodyGroup group = particle({1, 0.5, -2}, {0, 3, 0.1});
    World iterated(scene(group, {gravity()}, 10, 0.01, name), {}, {user_spring(40)});
    World solved(scene(group, {gravity(), spring(40)}, 10, 0.01, name));
    iterated.step(1000);
    solved.step(1000);
    CAPTURE(name, iterated.status().sentence);
    CHECK(iterated.status().code == Status::Code::ok);
    CHECK((iterated.body(0).position - solved.body(0).position).norm() < 1e-12);
    CHECK((iterated.body(0).velocity - solved.body(0).velocity).norm() < 1e-11);
  }
}

TEST_CASE("implicit rows keep their order where they iterate", "[physics]") {
  const std::vector<double> orders{1, 2, 4};
  for (std::size_t n = 0; n < implicit_names.size(); ++n) {
    const auto error = [&](double step) {
      World world(scene(particle({1, 0, 0}), {}, 2, step, implicit_names[n]), {}, {user_spring(9)});
      world.step(static_cast<std::uint64_t>(std::llround(2 / step)));
      return std::abs(world.body(0).position.x() - std::cos(6.0));
    };
    const double coarse = error(1.0 / 128), fine = error(1.0 / 256);
    CAPTURE(implicit_names[n], coarse, fine);
    CHECK(std::abs(std::log2(coarse / fine) - orders[n]) < 0.15);
  }
}

TEST_CASE("the implicit midpoint keeps the energy of a user's spring to rounding", "[physics]") {
  const double stiffness = 4;
  World world(scene(particle({1, 0, 0}), {}, 1000, 0.1, "implicit_midpoint"), {}, {user_spring(stiffness)});
  double most = 0;
  for (int n = 0; n < 10000; ++n) {
    world.step();
    const BodyState now = world.body(0);
    const double energy = now.velocity.squaredNorm() / 2 + stiffness / 2 * now.position.squaredNorm();
    most = std::max(most, std::abs(energy / (stiffness / 2) - 1));
  }
  INFO("energy off by " << most);
  CHECK(most < 1e-12);
  CHECK(world.status().code == Status::Code::ok);
}

TEST_CASE("attraction of more bodies than a matrix is good for: momenta are kept to rounding", "[physics]") {
  World world(cluster(250, "implicit_midpoint"));
  const Totals start = world.totals();
  world.step(50);
  const Totals end = world.totals();
  CHECK(world.status().sentence == "ok");
  CHECK((end.momentum - start.momentum).norm() < 1e-13 * start.momentum_scale);
  CHECK((end.angular_momentum - start.angular_momentum).norm() < 1e-12 * start.angular_momentum_scale);
  CHECK(std::abs(end.energy() / start.energy() - 1) < 1e-3);
  CHECK(world.counters().newton_residual < 1e-13);
}

TEST_CASE("attraction by fixed-point iteration is that by Newton's method", "[physics]") {
  for (const std::string& name : implicit_names) {
    const Scene scene = cluster(20, name);
    World iterated(scene, {}, {onlooker()}), solved(scene);
    iterated.step(20);
    solved.step(20);
    double most = 0;
    for (std::size_t id = 0; id < 20; ++id) {
      most = std::max(most, (iterated.body(id).position - solved.body(id).position).norm());
    }
    CAPTURE(name, most);
    CHECK(most < 1e-12);
  }
}

TEST_CASE("a rigid body that a user's torque brakes turns as under Newton's method", "[physics]") {
  for (const std::string& name : implicit_names) {
    BodyGroup group = rigid_body({0.1, 0.2, 0.25}, {1, -2, 0.5});
    group.velocity = {{1, 0.2, 0}};
    const Effect torque{"torque", {}, {{"torque", Vector3d(0.02, 0.01, -0.03)}}};
    const Effect drag = effect("linear_drag", 0.3);
    World solved(scene(group, {torque, drag}, 2, 0.01, name));
    const UserEffect both = user("both", [](const BodyBlock<double>& block) {
      const double push[3] = {0.02, 0.01, -0.03};
      for (int c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < block.count; ++i) {
          block.torque[c][i] += push[c];
          block.force[c][i] -= 0.3 * block.velocity[c][i];
        }
      }
    });
    UserEffect turning = both;
    turning.needs_rotation = true;
    World iterated(scene(group, {}, 2, 0.01, name), {}, {turning});
    iterated.step(200);
    solved.step(200);
    const BodyState a = iterated.body(0), b = solved.body(0);
    CAPTURE(name, iterated.status().sentence);
    CHECK(iterated.status().code == Status::Code::ok);
    CHECK((a.position - b.position).norm() < 1e-12);
    CHECK((a.angular_velocity - b.angular_velocity).norm() < 1e-11);
  }
}

TEST_CASE("elastic penalty contacts under an implicit row: two balls change their speeds", "[physics]") {
  using namespace contact_scenes;
  for (const char* name : {"implicit_midpoint", "gauss4"}) {
    Scene made = touching_scene(1e-4, {1, 0}, name);
    made.contact.kind = "penalty";
    made.contact.stiffness = 1e6;
    made.bodies = {ball_group({{0, 0, 0}, {1.01, 0, 0}}, {{1, 0, 0}, {-0.5, 0, 0}})};
    World world(made);
    const Totals start = world.totals();
    world.step(500);
    CAPTURE(name, world.status().sentence);
    CHECK(world.status().code == Status::Code::ok);
    CHECK(world.counters().contacts > 10);
    CHECK(off(world.body(0).velocity, {-0.5, 0, 0}) < 2e-3);
    CHECK(off(world.body(1).velocity, {1, 0, 0}) < 2e-3);
    CHECK(off(world.totals().momentum, start.momentum) < 1e-13);
  }
}
