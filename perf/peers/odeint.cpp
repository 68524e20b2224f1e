#include "perf/peers/odeint.h"

#if __has_include(<boost/numeric/odeint.hpp>)

#include <boost/numeric/odeint.hpp>
#include <cmath>

namespace ballpark::perf {

namespace {

struct Flight {
  DragProblem problem;
  void operator()(const OdeintState& state, OdeintState& rate, double) const {
    const double vx = state[3], vy = state[4], vz = state[5];
    const double drag = -problem.drag_over_mass * std::sqrt(vx * vx + vy * vy + vz * vz);
    rate = {vx, vy, vz, drag * vx, drag * vy, drag * vz - problem.gravity};
  }
};

template <class Stepper>
void step_each(const DragProblem& problem, OdeintState* bodies, std::size_t count) {
  Stepper stepper;
  const Flight flight{problem};
  for (std::size_t i = 0; i < count; ++i) stepper.do_step(flight, bodies[i], 0.0, problem.step);
}

namespace odeint = boost::numeric::odeint;

constexpr OdeintMethod methods[] = {
    {"runge_kutta4", "rk4", step_each<odeint::runge_kutta4<OdeintState>>},
    {"euler", "euler", step_each<odeint::euler<OdeintState>>},
};

}  // namespace

std::span<const OdeintMethod> odeint_methods() {
  return methods;
}

}  // namespace ballpark::perf

#else

namespace ballpark::perf {

std::span<const OdeintMethod> odeint_methods() {
  return {};
}

}  // namespace ballpark::perf

#endif
