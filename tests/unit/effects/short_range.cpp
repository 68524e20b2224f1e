// Forces that end at a cut-off: closed forms of each pair, and that a list of neighbours gives the bits of all pairs.
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "engine/core/random.h"
#include "engine/effects/lennard_jones.h"
#include "engine/effects/pair_effects.h"
#include "engine/effects/soft_repulsion.h"
#include "engine/world/pair_neighbours.h"
#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;
using ballpark::Value;
using ballpark::Workers;
using Parameters = std::map<std::string, Value>;
using Vector = Vector3<Real>;

namespace {

const Parameters argon{{"epsilon", 1.5}, {"sigma", 0.8}, {"cutoff", 2.0}};
const Parameters soft{{"strength", 3.0}, {"cutoff", 2.0}};

/// Every body with every other: the oracle of the list.
class All : public Neighbours {
 public:
  explicit All(std::size_t count) : count_(count) {
    for (std::uint32_t a = 0; a < count; ++a) {
      for (std::uint32_t b = 0; b < count; ++b) {
        if (a != b) others_.push_back(b);
      }
    }
  }
  void follow(const PairBodies&, Workers&) override {}
  std::span<const std::uint32_t> of(std::size_t, std::size_t slot) const override {
    return {others_.data() + slot * (count_ - 1), count_ - 1};
  }
  bool searches() const override { return false; }

 private:
  std::size_t count_;
  std::vector<std::uint32_t> others_;
};

/// Bodies of some copies in columns, and where their forces go.
struct Cloud {
  std::size_t count, copies;
  std::vector<Real> mass, position[3], force[3];

  Cloud(std::size_t bodies, std::size_t of) : count(bodies), copies(of), mass(bodies * of, 2) {
    for (int c = 0; c < 3; ++c) position[c].assign(bodies * of, 0), force[c].assign(bodies * of, 0);
  }
  PairBodies bodies() {
    PairBodies all{.count = count, .copies = {0, copies}, .end = count * copies, .mass = mass.data()};
    for (int c = 0; c < 3; ++c) all.position[c] = position[c].data(), all.force[c] = force[c].data();
    return all;
  }
  Vector at(std::size_t i) const { return {position[0][i], position[1][i], position[2][i]}; }
  Vector force_on(std::size_t i) const { return {force[0][i], force[1][i], force[2][i]}; }
  void put(std::size_t i, const Vector& x) { position[0][i] = x.x, position[1][i] = x.y, position[2][i] = x.z; }
  void clear() {
    for (auto& column : force) column.assign(column.size(), 0);
  }
};

/// The effect on these bodies by all pairs, or by a list.
std::unique_ptr<PairEffect> made(const std::string& name, const Parameters& parameters, Cloud& cloud,
                                 const Period& period, Workers& workers, bool by_list) {
  const auto slot_of = [](std::size_t id) { return id; };
  const auto neighbours = [&](Real reach) -> std::unique_ptr<Neighbours> {
    if (!by_list) return std::make_unique<All>(cloud.count);
    return std::make_unique<PairNeighbours>(reach, cloud.count, cloud.copies, period);
  };
  const EffectInput input{parameters, 0, {}};
  return pair_effects()[static_cast<std::size_t>(pair_effect_index(name))].make(
      {input, cloud.bodies(), slot_of, {}, period, neighbours, workers});
}

struct Kind {
  const char* name;
  const Parameters* parameters;
};
const Kind kinds[] = {{"lennard_jones", &argon}, {"soft_repulsion", &soft}};

/// Two bodies of 2 kg so far apart along a direction.
Cloud two(const Vector& apart) {
  Cloud cloud(2, 1);
  cloud.put(0, {0.3, -0.2, 0.1});
  cloud.put(1, cloud.at(0) + apart);
  return cloud;
}

}  // namespace

TEST_CASE("Short range: Lennard-Jones pairs have their well where and as deep as the formula says", "[effects]") {
  const EffectInput input{argon, 0, {}};
  const LennardJones pair(input);
  const double sixth = std::pow(0.8 / 2.0, 6), at_cutoff = 6 * (sixth * sixth - sixth);
  const double bottom = std::pow(2.0, 1.0 / 6) * 0.8;
  CHECK(std::abs(pair.push(bottom * bottom)) < 1e-13);
  CHECK(std::abs(pair.energy(bottom * bottom) - (-1.5 - at_cutoff)) < 1e-14);
  CHECK(std::abs(pair.energy(0.64) - -at_cutoff) < 1e-14);
  CHECK(pair.energy(4.0) == 0);
  // What truncation leaves of the force: 24 e (2 (s/c)^12 - (s/c)^6) / c.
  CHECK(std::abs(2 * pair.push(4.0) - 36 * (2 * sixth * sixth - sixth) / 2) < 1e-15);
}

TEST_CASE("Short range: soft pairs have the field's standard form", "[effects]") {
  const EffectInput input{soft, 0, {}};
  const SoftRepulsion pair(input);
  const double pi = std::acos(-1.0);
  for (const double r : {1e-9, 0.3, 1.0, 1.7, 1.999}) {
    CHECK(std::abs(pair.energy(r * r) - 3 * (1 + std::cos(pi * r / 2))) < 1e-14);
    CHECK(std::abs(pair.push(r * r) * r - 3 * pi / 2 * std::sin(pi * r / 2)) < 1e-14);
  }
  CHECK(pair.energy(0) == 6);
}

TEST_CASE("Short range: forces are minus the slope of the energy, and opposite", "[effects]") {
  Workers workers(1);
  for (const Kind& kind : kinds) {
    for (const double r : {0.75, 0.9, 1.1, 1.6, 1.95}) {
      CAPTURE(kind.name, r);
      const Vector direction{0.36, -0.48, 0.8};
      Cloud cloud = two(r * direction);
      const auto effect = made(kind.name, *kind.parameters, cloud, {}, workers, true);
      effect->add_forces(cloud.bodies(), workers);
      const auto energy = [&](double distance) {
        Cloud moved = two(distance * direction);
        return effect->energy(moved.bodies(), workers);
      };
      const double step = 1e-4;
      const auto rise = [&](double by) { return energy(r + by) - energy(r - by); };
      const double slope = (8 * rise(step) - rise(2 * step)) / (12 * step);
      const Vector on_b = cloud.force_on(1), error = on_b - (-slope) * direction, both = on_b + cloud.force_on(0);
      CHECK(length(error) < 1e-8 * (1 + std::abs(slope)));
      CHECK(length(both) == 0);
    }
  }
}

TEST_CASE("Short range: links give the same forces, with their derivatives", "[effects]") {
  Workers workers(1);
  const Period period{{5, 5, 5}};
  for (const Kind& kind : kinds) {
    for (const Vector& apart : {Vector{0.5, -0.6, 0.4}, Vector{4.3, 0.5, -4.6}, Vector{1.5, 1.5, 1.5}}) {
      Cloud cloud = two(apart);
      const auto effect = made(kind.name, *kind.parameters, cloud, period, workers, true);
      REQUIRE(effect->links().size() == 1);
      const auto force = [&](const Vector& r) { return effect->force_of(0, effect->links()[0], r, {}); };
      effect->add_forces(cloud.bodies(), workers);
      const LinkForce here = force(cloud.at(1) - cloud.at(0));
      CHECK(here.x.value == cloud.force_on(1).x);
      CHECK(here.z.value == cloud.force_on(1).z);
      const double step = 1e-6;
      const LinkForce ahead = force(apart + Vector{0, step, 0}), behind = force(apart - Vector{0, step, 0});
      CHECK(std::abs((ahead.x.value - behind.x.value) / (2 * step) - here.x.by[1]) < 1e-6);
      CHECK(std::abs((ahead.y.value - behind.y.value) / (2 * step) - here.y.by[1]) < 1e-6);
      CHECK(here.x.by[4] == 0);
    }
  }
}

TEST_CASE("Short range: stiffness is that of two bodies as they start, and of nothing beyond the cut-off",
          "[effects]") {
  Workers workers(1);
  const double bottom = std::pow(2.0, 1.0 / 6) * 0.8;
  const auto stiffness = [&](const Kind& kind, double r) {
    Cloud cloud = two({r, 0, 0});
    return made(kind.name, *kind.parameters, cloud, {}, workers, true)->per_mass().spring;
  };
  // U'' = 72 e / (2^(1/3) s^2) at the bottom of the well; twice that over the mass of each.
  const double curvature = 72 * 1.5 / (std::cbrt(2.0) * 0.64);
  CHECK(std::abs(stiffness(kinds[0], bottom) / curvature - 1) < 1e-13);
  const double pi = std::acos(-1.0);
  CHECK(std::abs(stiffness(kinds[1], 1e-6) / (3 * pi * pi / 4) - 1) < 1e-9);
  for (const Kind& kind : kinds) {
    CHECK(stiffness(kind, 2.1) == 0);
    CHECK(stiffness(kind, 0) == 0);  // no force either
  }
  CHECK(std::isfinite(stiffness(kinds[0], 1e-40)));
}

TEST_CASE("Short range: a list of neighbours gives the bits of all pairs, wherever bodies go", "[effects]") {
  constexpr std::size_t count = 400, copies = 3;
  const Real box = 9;
  for (const Kind& kind : kinds) {
    for (const bool periodic : {false, true}) {
      const Period period = periodic ? Period{{box, box, 0}} : Period{};
      Cloud cloud(count, copies);
      const auto uniform = [&](std::uint64_t step, std::size_t i, int c) {
        return ballpark::random::uniform<Real>({step, static_cast<std::uint64_t>(c), i});
      };
      for (std::size_t i = 0; i < count * copies; ++i) {
        for (int c = 0; c < 3; ++c) cloud.position[c][i] = box * uniform(0, i, c);
      }
      Workers one(1), many(3);
      const auto brute = made(kind.name, *kind.parameters, cloud, period, one, false);
      const auto listed = made(kind.name, *kind.parameters, cloud, period, many, true);
      CHECK(listed->searches());
      CHECK(listed->per_mass().spring == brute->per_mass().spring);
      std::size_t differ = 0, pushed = 0;
      for (std::uint64_t step = 1; step <= 40; ++step) {
        // Some steps leave all within the skin, some carry a body through the box and out of it.
        const Real far = step % 8 == 0 ? 2 * box : Real(0.02);
        for (std::size_t i = 0; i < count * copies; ++i) {
          const bool goes = step % 8 != 0 || i % 50 == 0;
          for (int c = 0; c < 3; ++c) cloud.position[c][i] += goes ? far * (uniform(step, i, c) - Real(0.5)) : 0;
        }
        cloud.clear();
        brute->add_forces(cloud.bodies(), one);
        const std::vector<Real> expected[3] = {cloud.force[0], cloud.force[1], cloud.force[2]};
        cloud.clear();
        listed->add_forces(cloud.bodies(), many);
        for (std::size_t i = 0; i < count * copies; ++i) {
          for (int c = 0; c < 3; ++c) {
            differ += std::bit_cast<std::uint64_t>(expected[c][i]) != std::bit_cast<std::uint64_t>(cloud.force[c][i]);
            pushed += cloud.force[c][i] != 0;
          }
        }
        CHECK(listed->energy(cloud.bodies(), many) == brute->energy(cloud.bodies(), one));
      }
      CAPTURE(kind.name, periodic);
      CHECK(differ == 0);
      CHECK(pushed > 40 * count * copies);
    }
  }
}

TEST_CASE("Short range: a body that is nowhere pushes nobody, and two at one place do not push each other",
          "[effects]") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN(), huge = std::numeric_limits<Real>::max();
  Workers workers(2);
  for (const Kind& kind : kinds) {
    for (const Real side : {Real(0), Real(12)}) {
      const Period period{{side, side, 0}};
      Cloud cloud(200, 1);
      for (std::size_t i = 0; i < 200; ++i) {
        cloud.put(i, {Real(1.5) * static_cast<Real>(i % 8), Real(1.5) * static_cast<Real>(i / 8 % 8),
                      Real(1.5) * static_cast<Real>(i / 64)});
      }
      const auto listed = made(kind.name, *kind.parameters, cloud, period, workers, true);
      const auto brute = made(kind.name, *kind.parameters, cloud, period, workers, false);
      cloud.put(17, {nan, 0, 0});
      cloud.put(40, {1, 0, huge});
      cloud.put(60, cloud.at(61));
      std::vector<Real> expected;
      for (const auto* effect : {&brute, &listed}) {
        cloud.clear();
        (*effect)->add_forces(cloud.bodies(), workers);
        if (effect == &brute) expected = cloud.force[0];
        CHECK(cloud.force[0] == expected);
        CHECK(length(cloud.force_on(17)) == 0);
        for (std::size_t i = 0; i < 200; ++i) CHECK(std::isfinite(cloud.force[1][i]));
      }
    }
  }
}
