// Forces that end at a cut-off, in worlds: two bodies with closed forms, crystals, and what gases keep.
#include <cmath>
#include <vector>

#include "tests/catch.h"
#include "tests/physics/scenes.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

const double bottom = std::pow(2.0, 1.0 / 6);  // of the well, in sigma

Effect lennard_jones(double cutoff) {
  return {"lennard_jones", {}, {{"epsilon", 1.0}, {"sigma", 1.0}, {"cutoff", cutoff}}};
}

Effect soft_repulsion(double strength, double cutoff) {
  return {"soft_repulsion", {}, {{"strength", strength}, {"cutoff", cutoff}}};
}

BodyGroup atoms(std::vector<double> masses, std::vector<Vector3d> positions, std::vector<Vector3d> velocities) {
  BodyGroup group;
  group.name = "atoms";
  group.mass = std::move(masses);
  group.position = std::move(positions);
  group.velocity = std::move(velocities);
  return group;
}

/// A face-centred cubic crystal in a space that repeats after `cells` cubes of four atoms.
Scene crystal(std::size_t cells, double nearest, double cutoff, const Vector3d& spread, double duration, double step,
              const std::string& integrator) {
  const double cube = std::sqrt(2.0) * nearest, length = cube * static_cast<double>(cells);
  Scene made = scene({}, {lennard_jones(cutoff)}, duration, step, integrator);
  made.bodies.clear();
  const Vector3d offsets[] = {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
  for (int k = 0; k < 4; ++k) {
    BodyGroup group;
    group.name = "atoms " + std::to_string(k);
    group.mass = {1};
    group.generate = Generate{};
    group.generate->kind = "lattice";
    group.generate->count = {cells, cells, cells};
    group.generate->origin = cube * offsets[k];
    group.generate->spacing = cube;
    group.generate->velocity_spread = spread;
    made.bodies.push_back(group);
  }
  Boundary space;
  space.shape = "periodic";
  space.size = {length, length, length};
  made.boundaries = {space};
  return made;
}

/// Sums over the sites of a face-centred cubic lattice, nearest distance 1, no farther than `reach`: how many there
/// are, and of r^-12 and r^-6.
struct Shells {
  double count = 0, twelve = 0, six = 0;
};
Shells shells(double reach) {
  Shells sum;
  const int most = static_cast<int>(reach * std::sqrt(2.0)) + 1;
  for (int x = -most; x <= most; ++x) {
    for (int y = -most; y <= most; ++y) {
      for (int z = -most; z <= most; ++z) {
        const double square = 0.5 * (x * x + y * y + z * z), sixth = 1 / (square * square * square);
        if ((x + y + z) % 2 != 0 || square == 0 || square > reach * reach) continue;
        sum.count += 1, sum.twelve += sixth * sixth, sum.six += sixth;
      }
    }
  }
  return sum;
}

double bodies_of(const Scene& made) {
  return static_cast<double>(World(made).body_count());
}

/// The largest change of energy on the way, over the number of bodies.
double worst_drift(const Scene& made) {
  World world(made);
  const double start = world.totals().energy();
  double worst = 0;
  while (world.time() < made.run.duration * (1 - 1e-9)) {
    world.advance_to(world.time() + made.run.duration / 200);
    worst = std::max(worst, std::abs(world.totals().energy() - start));
  }
  return worst / bodies_of(made);
}

}  // namespace

TEST_CASE("Lennard-Jones: two bodies in the well rest there, as deep as epsilon less what is left at the cut-off",
          "[physics]") {
  World world(scene(atoms({1}, {{0, 0, 0}, {bottom, 0, 0}}, {}), {lennard_jones(2.5)}, 1, 1e-3));
  const double sixth = std::pow(2.5, -6), at_cutoff = 4 * (sixth * sixth - sixth);
  CHECK(std::abs(world.totals().potential - (-1 - at_cutoff)) < 1e-14);
  world.step(1000);
  for (const std::size_t id : {0, 1}) CHECK(world.body(id).velocity.norm() < 1e-13);
}

TEST_CASE("Lennard-Jones: small swings about the well have the period of its curvature and the reduced mass",
          "[physics]") {
  // U'' = 72 e / (2^(1/3) s^2) = 57.146 e/s^2; masses 1 and 3: mu = 3/4. Of amplitude A, the period is longer by
  // 5 U'''^2/(48 U''^2) - U''''/(16 U'') times A^2, some 30 of them here.
  const double rate = std::sqrt(72 / std::cbrt(2.0) / 0.75), amplitude = 1e-4, time = 20.25 * 2 * pi / rate;
  World world(
      scene(atoms({1, 3}, {{0, 0, 0}, {0, bottom + amplitude, 0}}, {}), {lennard_jones(2.5)}, time, time / 8000));
  world.step(8000);
  const BodyState a = world.body(0), b = world.body(1);
  const double stretch = b.position.y() - a.position.y() - bottom, speed = b.velocity.y() - a.velocity.y();
  CHECK(std::abs(speed / (-amplitude * rate) - 1) < 1e-3);
  CHECK(std::abs(stretch) < 20 * amplitude * amplitude);
}

TEST_CASE("Lennard-Jones: the largest stable step of a pair is known exactly", "[physics]") {
  const Scene made =
      scene(atoms({1}, {{0, 0, 0}, {bottom, 0, 0}}, {}), {lennard_jones(2.5)}, 1, 1e-3, "velocity_verlet");
  const std::vector<StepLimitReport> limits = World(made).explain().step_limits;
  REQUIRE(limits.size() == 1);
  CHECK(limits[0].of == "lennard_jones");
  CHECK(std::abs(limits[0].largest / (2 / std::sqrt(2 * 72 / std::cbrt(2.0))) - 1) < 1e-6);
}

TEST_CASE("Lennard-Jones: the cohesive energy of a face-centred cubic crystal", "[physics]") {
  // E/N = 2 e (A12 (s/d)^12 - A6 (s/d)^6), least at -e A6^2/(2 A12) = -8.610 e (Kittel, Solid State Physics, ch. 3).
  const double a12 = 12.13188, a6 = 14.45392;
  const double nearest = std::pow(2 * a12 / a6, 1.0 / 6), cutoff = 4.6;
  const Scene made = crystal(6, nearest, cutoff, {0, 0, 0}, 1, 1e-3, "rk4");
  World world(made);
  const Shells within = shells(cutoff / nearest);
  const auto energy = [](double twelve, double six, double r) {
    return 4 * (twelve * std::pow(r, -12) - six * std::pow(r, -6));
  };
  const double each = world.totals().potential / bodies_of(made), at_cutoff = energy(1, 1, cutoff);
  const double sum = energy(within.twelve, within.six, nearest) / 2;
  CHECK(within.count > 300);
  CHECK(std::abs(each - (sum - within.count / 2 * at_cutoff)) < 1e-12 * within.count);
  // What lies beyond the cut-off, from the sums over the whole lattice as published.
  const double beyond = energy(a12 - within.twelve, a6 - within.six, nearest) / 2;
  CHECK(std::abs(each + within.count / 2 * at_cutoff + beyond - -a6 * a6 / (2 * a12)) < 1e-9);
  CHECK(std::abs(-a6 * a6 / (2 * a12) - -8.610) < 5e-4);
  const double reach = 30, tail = 4 * pi * std::sqrt(2.0) / (3 * reach * reach * reach);  // sites as a fluid
  CHECK(std::abs(shells(reach).six + tail - a6) < 1e-5);
  // No atom has anywhere to go.
  world.step(20);
  for (const std::size_t id : {0, 215, 500}) CHECK(world.body(id).velocity.norm() < 1e-13);
}

TEST_CASE("Lennard-Jones: a warm crystal's energy by velocity Verlet is off by the square of the step", "[physics]") {
  // The cut-off is midway between two shells of neighbours, across which no atom comes: forces are smooth.
  const auto drift = [](double step) {
    return worst_drift(crystal(4, 1.11, 2.37, {0.3, 0.3, 0.3}, 2, step, "velocity_verlet"));
  };
  const double coarse = drift(0.01), middle = drift(0.005), fine = drift(0.0025);
  INFO(coarse << " " << middle << " " << fine);
  CHECK(fine > 1e-8);
  CHECK(std::abs(std::log2(coarse / middle) - 2) < 0.15);
  CHECK(std::abs(std::log2(middle / fine) - 2) < 0.15);
}

TEST_CASE("Lennard-Jones: a gas through whose cut-off pairs come and go keeps momentum to rounding", "[physics]") {
  for (const std::string integrator : {"velocity_verlet", "rk4", "dormand_prince5"}) {
    World world(crystal(4, 1.6, 2.5, {2, 2, 2}, 2, 0.004, integrator));
    const Vector3d before = world.totals().momentum;
    world.step(500);
    CAPTURE(integrator);
    CHECK((world.totals().momentum - before).norm() < 1e-13 * world.totals().momentum_scale);
    CHECK(world.status().code == Status::Code::ok);
  }
}

TEST_CASE("Lennard-Jones: implicit methods solve few bodies by Newton's method, and iterate for many", "[physics]") {
  const BodyGroup three =
      atoms({1, 2, 1}, {{0, 0, 0}, {1.2, 0, 0}, {0.5, 1.1, 0.2}}, {{0, 0.3, 0}, {0, 0, 0}, {0, 0, 0.4}});
  const auto end = [](const Scene& made) {
    World world(made);
    world.step(static_cast<std::uint64_t>(std::llround(made.run.duration / made.run.step)));
    CHECK(world.status().code == Status::Code::ok);
    return world;
  };
  const World newton = end(scene(three, {lennard_jones(3)}, 1, 1e-3, "gauss4"));
  const World explicit_one = end(scene(three, {lennard_jones(3)}, 1, 1e-4));
  CHECK(newton.explain().stages == "Newton's method");
  for (std::size_t id = 0; id < 3; ++id) {
    CHECK((newton.body(id).position - explicit_one.body(id).position).norm() < 1e-8);
  }
  const Scene solid = crystal(3, 1.11, 2.07, {0.3, 0.3, 0.3}, 0.1, 1e-3, "gauss4");
  Scene reference = solid;
  reference.run.integrator = "rk4";
  const World iterated = end(solid), beside = end(reference);
  CHECK(iterated.explain().stages.find("lennard_jones joins 1296 unknowns") != std::string::npos);
  CHECK((iterated.body(77).position - beside.body(77).position).norm() < 1e-9);
}

TEST_CASE("Soft repulsion: two bodies turn round where it has taken up their energy, or pass through", "[physics]") {
  // Masses 1 and 1 at +-v: K = v^2, turned round at A (1 + cos(pi r/c)) = K; for K > 2 A they pass. The force begins
  // with a kink at the cut-off, which costs steps across it their order.
  const double strength = 0.5, cutoff = 2;
  const auto meet = [&](double speed) {
    World world(scene(atoms({1}, {{-2, 0, 0}, {2, 0, 0}}, {{speed, 0, 0}, {-speed, 0, 0}}),
                      {soft_repulsion(strength, cutoff)}, 12 / speed, 2e-4));
    double least = 4;
    while (world.time() < 12 / speed) {
      world.step();
      least = std::min(least, (world.body(1).position - world.body(0).position).norm());
    }
    CHECK(std::abs(std::abs(world.body(0).velocity.x()) / speed - 1) < 1e-8);
    CHECK((world.body(0).velocity + world.body(1).velocity).norm() < 1e-14);
    return std::pair(least, world.body(0).velocity.x() > 0);
  };
  const auto [turn, on] = meet(0.6);
  CHECK_FALSE(on);
  CHECK(std::abs(turn - cutoff / pi * std::acos(0.36 / strength - 1)) < 1e-6);
  CHECK(meet(1.1).second);
}
