// Every local effect and every motion gives its derivatives: held against differences of the rates themselves.
#include "engine/world/motion_calls.h"

#include <cmath>
#include <vector>

#include "engine/world/check.h"
#include "tests/catch.h"
#include "tests/unit/world/made_scenes.h"

using namespace ballpark::BALLPARK_PRECISION;
using made_scenes::sample;

namespace {

constexpr MotionKind motions[] = {MotionKind::point, MotionKind::spinning, MotionKind::oriented, MotionKind::rigid,
                                  MotionKind::pivoted};

/// One body that no value of is zero, under one effect (or none: -1); what flows has something to push.
struct Subject {
  StepGroup group;
  std::vector<std::byte> constants;
  EffectInstance instance, pushed;
  LinearDrag::Constants drag{0.7};

  explicit Subject(int effect) {
    BodyConstants& c = group.constants;
    c.mass.value = 1.25, c.effective_mass.value = 1.5;
    const Real inverse[] = {2, 1.5, 0.75, 0.1, -0.2, 0.05};
    for (int i = 0; i < 6; ++i) c.inverse_inertia[i].value = inverse[i];
    const Real arm[] = {0.3, -0.2, 0.5}, pivot[] = {0.1, 0.2, -0.3};
    for (int i = 0; i < 3; ++i) c.arm[i].value = arm[i], c.pivot[i].value = pivot[i];
    if (effect < 0) return;
    const EffectInfo& info = local_effects()[static_cast<std::size_t>(effect)];
    ballpark::Effect made = sample(info.description);
    if (info.description.name == "spring") made.parameters["damping"] = 0.4, made.parameters["rest_length"] = 0.7;
    const auto parameters = ballpark::complete_parameters(made, info.description);
    const auto per_body = [](const std::string&, const std::vector<ballpark::Vector3d>& rows) {
      std::array<PerBody, 3> columns;
      for (int i = 0; i < 3; ++i) columns[static_cast<std::size_t>(i)].value = rows[0][i];
      return columns;
    };
    constants.resize(info.constants_size);
    info.pack({parameters, 1, per_body, 1.25, {nullptr, 0.3}}, constants.data());
    instance = {effect, constants.data()};
    group.forces.begin = &instance, group.forces.end = &instance + 1;
    if (!info.flows) return;
    group.forces.flow_begin = &instance, group.forces.flow_end = &instance + 1, group.forces.start = 0.5;
    pushed = {local_effect_index("linear_drag"), &drag};
    group.forces.begin = &pushed, group.forces.end = &pushed + 1;
  }
};

/// A state of any motion whose quaternion has norm 1.
std::vector<Real> some_state(MotionKind kind) {
  const std::vector<Real> xv = {1.1, -0.7, 0.6, 0.4, 0.9, -1.3}, momentum = {0.2, -0.5, 0.35},
                          q = {0.5, -0.1, 0.7, 0.5};
  std::vector<Real> y;
  const auto add = [&](const std::vector<Real>& more) { y.insert(y.end(), more.begin(), more.end()); };
  if (kind != MotionKind::pivoted) add(xv);
  if (kind != MotionKind::point) add(momentum);
  if (kind >= MotionKind::oriented) add(q);
  return y;
}

/// Derivative of f(x) by a difference of sixth order.
template <class F>
Real slope(Real x, F f) {
  const Real d = 4e-3;
  return (45 * (f(x + d) - f(x - d)) - 9 * (f(x + 2 * d) - f(x - 2 * d)) + (f(x + 3 * d) - f(x - 3 * d))) / (60 * d);
}

}  // namespace

TEST_CASE("Derivatives: of every local effect under every motion", "[implicit]") {
  for (const MotionKind kind : motions) {
    for (int effect = -1; effect < LocalEffects::count; ++effect) {
      const std::string what = effect < 0 ? "none" : local_effects()[static_cast<std::size_t>(effect)].description.name;
      CAPTURE(static_cast<int>(kind), what);
      const Subject subject(effect);
      const MotionCalls& calls = calls_of(kind);
      const std::vector<Real> y = some_state(kind);
      REQUIRE(y.size() == static_cast<std::size_t>(calls.size));
      const Vector3<Real> pull = {0.3, -0.8, 0.45};
      BodyRates out, alone;
      calls.pulled_rates(subject.group, 0, y.data(), 0.25, pull, out);
      calls.rates(subject.group, 0, y.data(), 0.25, alone);
      const auto rate = [&](std::vector<Real> at, const Vector3<Real>& force, int p) {
        BodyRates rates;
        calls.pulled_rates(subject.group, 0, at.data(), 0.25, force, rates);
        return rates.rate[p];
      };
      Real worst = 0;
      for (int p = 0; p < calls.size; ++p) {
        for (int q = 0; q < calls.size; ++q) {
          const auto moved = [&](Real value) {
            std::vector<Real> at = y;
            at[static_cast<std::size_t>(q)] = value;
            return at;
          };
          const Real at = y[static_cast<std::size_t>(q)];
          const Real difference = slope(at, [&](Real value) { return rate(moved(value), pull, p); });
          worst = std::max(worst, std::abs(out.by_state[p][q] - difference));
          const Real lonely = slope(at, [&](Real value) { return rate(moved(value), {}, p); });
          worst = std::max(worst, std::abs(alone.by_state[p][q] - lonely));
        }
        worst = std::max(worst, std::abs(out.by_pull[p][1] - slope(pull.y, [&](Real value) {
                                           return rate(y, {pull.x, value, pull.z}, p);
                                         })));
      }
      CHECK(worst < 1e-8);
    }
  }
}

TEST_CASE("Derivatives: of where a body is by its state", "[implicit]") {
  for (const MotionKind kind : motions) {
    const Subject subject(-1);
    const MotionCalls& calls = calls_of(kind);
    const std::vector<Real> y = some_state(kind);
    BodyRates out;
    calls.pulled_rates(subject.group, 0, y.data(), 0.25, {}, out);
    for (int k = 0; k < 6; ++k) {
      for (std::size_t q = 0; q < y.size(); ++q) {
        const Real difference = slope(y[q], [&](Real value) {
          std::vector<Real> at = y;
          at[q] = value;
          Real place[6];
          calls.place(subject.group, 0, at.data(), place);
          return place[k];
        });
        CHECK(std::abs(out.place_by_state[k][q] - difference) < 1e-9);
      }
    }
  }
}
