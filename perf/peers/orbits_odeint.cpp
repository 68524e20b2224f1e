#include "perf/peers/orbits_odeint.h"

#if __has_include(<boost/numeric/odeint.hpp>)

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <functional>

namespace ballpark::perf {

namespace {

namespace odeint = boost::numeric::odeint;

struct Kepler {
  static constexpr const char* name = "kepler";
  using State = std::array<double, 4>;
  void operator()(const State& state, State& rate, double) const {
    const double x = state[0], y = state[1], square = x * x + y * y, pull = -1 / (square * std::sqrt(square));
    rate = {state[2], state[3], pull * x, pull * y};
  }
};

struct Pleiades {
  static constexpr const char* name = "pleiades";
  static constexpr int n = 7;
  using State = std::array<double, 4 * n>;
  void operator()(const State& state, State& rate, double) const {
    const double *x = state.data(), *y = x + n, *v = y + n;
    double *ax = rate.data() + 2 * n, *ay = ax + n;
    std::copy(v, v + 2 * n, rate.data());
    std::fill(ax, ax + 2 * n, 0.0);
    for (int i = 0; i < n; ++i) {
      for (int j = i + 1; j < n; ++j) {
        const double dx = x[j] - x[i], dy = y[j] - y[i], square = dx * dx + dy * dy;
        const double weight = 1 / (square * std::sqrt(square)), of_i = (i + 1) * weight, of_j = (j + 1) * weight;
        ax[i] += of_j * dx;
        ay[i] += of_j * dy;
        ax[j] -= of_i * dx;
        ay[j] -= of_i * dy;
      }
    }
  }
};

template <class Problem>
struct Counted {
  std::size_t* evaluations;
  void operator()(const typename Problem::State& state, typename Problem::State& rate, double t) const {
    ++*evaluations;
    Problem()(state, rate, t);
  }
};

/// How a stepper runs from 0 to `duration`; returns the number of steps.
template <class Stepper>
struct Fixed {
  template <class System, class State>
  static std::size_t run(const System& system, double steps, double duration, State& state) {
    const auto count = static_cast<std::size_t>(steps);
    Stepper stepper;
    odeint::integrate_n_steps(std::ref(stepper), system, state, 0.0, duration / steps, count);
    return count;
  }
};
template <class Stepper>
struct Controlled {
  template <class System, class State>
  static std::size_t run(const System& system, double tolerance, double duration, State& state) {
    constexpr double first_step = 1e-3;
    auto stepper = odeint::make_controlled<Stepper>(tolerance, tolerance);
    return odeint::integrate_adaptive(std::ref(stepper), system, state, 0.0, duration, first_step);
  }
};

template <class Problem, class Solver, class System>
std::size_t solve(const System& system, double setting, double duration, double* values) {
  typename Problem::State state;
  std::copy_n(values, state.size(), state.begin());
  const std::size_t steps = Solver::run(system, setting, duration, state);
  std::copy(state.begin(), state.end(), values);
  return steps;
}

template <class Problem, class Solver>
constexpr OdeintOrbit orbit(const char* name, bool adaptive) {
  return {Problem::name, name, adaptive,
          [](double setting, double duration, double* state) {
            solve<Problem, Solver>(Problem(), setting, duration, state);
          },
          [](double setting, double duration, double* state) {
            OdeintTally tally;
            const Counted<Problem> system{&tally.evaluations};
            tally.steps = solve<Problem, Solver>(system, setting, duration, state);
            return tally;
          }};
}

using K = Kepler::State;
using P = Pleiades::State;
constexpr OdeintOrbit orbits[] = {
    orbit<Kepler, Fixed<odeint::runge_kutta4<K>>>("runge_kutta4", false),
    orbit<Kepler, Controlled<odeint::runge_kutta_dopri5<K>>>("runge_kutta_dopri5", true),
    orbit<Kepler, Controlled<odeint::runge_kutta_fehlberg78<K>>>("runge_kutta_fehlberg78", true),
    orbit<Pleiades, Fixed<odeint::runge_kutta4<P>>>("runge_kutta4", false),
    orbit<Pleiades, Controlled<odeint::runge_kutta_dopri5<P>>>("runge_kutta_dopri5", true),
    orbit<Pleiades, Controlled<odeint::runge_kutta_fehlberg78<P>>>("runge_kutta_fehlberg78", true),
};

}  // namespace

std::span<const OdeintOrbit> odeint_orbits() {
  return orbits;
}

}  // namespace ballpark::perf

#else

namespace ballpark::perf {

std::span<const OdeintOrbit> odeint_orbits() {
  return {};
}

}  // namespace ballpark::perf

#endif
