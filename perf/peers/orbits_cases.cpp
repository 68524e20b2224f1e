#include "perf/peers/orbits_cases.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "ballpark/ballpark.h"
#include "perf/peers/orbits_odeint.h"
#include "perf/peers/orbits_problems.h"

namespace ballpark::perf {

namespace {

constexpr double spread = 1e-3;  // of the copies' starts, relative
constexpr int copies = 1024;

OrbitProblem problem_of(const OrbitCase& orbit) {
  return orbit.problem == "kepler" ? kepler_problem() : pleiades_problem();
}

const OdeintOrbit& peer_of(const std::string& problem, const std::string& stepper) {
  for (const OdeintOrbit& peer : odeint_orbits()) {
    if (problem == peer.problem && stepper == peer.name) return peer;
  }
  throw std::runtime_error("orbits needs Boost.odeint when it is built");
}

/// Of bodies [first, first + n).
OrbitState state_of(const World& world, std::size_t first, std::size_t n) {
  OrbitState state(4 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const BodyState body = world.body(first + i);
    state[i] = body.position.x();
    state[n + i] = body.position.y();
    state[2 * n + i] = body.velocity.x();
    state[3 * n + i] = body.velocity.y();
  }
  return state;
}

Scene scene_of(const OrbitCase& orbit, double setting) {
  const OrbitProblem problem = problem_of(orbit);
  const bool adaptive = setting < 1;
  Scene scene;
  scene.run = {.duration = problem.duration,
               .step = adaptive ? 0 : problem.duration / setting,
               .tolerance = adaptive ? setting : 0,
               .integrator = orbit.integrator};
  BodyGroup group{.name = "bodies", .mass = problem.mass};
  if (problem.mass.empty()) group.mass = {1};
  for (const PlaneVector& p : problem.position) group.position.push_back({p.x, p.y, 0});
  for (const PlaneVector& v : problem.velocity) group.velocity.push_back({v.x, v.y, 0});
  scene.bodies.push_back(group);
  scene.effects.push_back({.kind = problem.mass.empty() ? "central_gravity" : "mutual_gravity",
                           .groups = {},
                           .parameters = {{"strength", 1.0}}});
  return scene;
}

/// A world that is solved again and again from its start.
struct Solver {
  World world;
  Snapshot start;
  double duration;
  std::uint64_t steps;  ///< 0: as a tolerance allows

  Solver(const OrbitCase& orbit, double setting, int threads)
      : world(scene_of(orbit, setting), {.threads = threads, .copies = orbit.copies, .perturb = spread_of(orbit)}),
        start(world.snapshot()),
        duration(problem_of(orbit).duration),
        steps(setting < 1 ? 0 : static_cast<std::uint64_t>(setting)) {}
  static double spread_of(const OrbitCase& orbit) { return orbit.copies > 1 ? spread : 0; }
  void solve() {
    world.restore(start);
    steps > 0 ? world.step(steps) : world.advance_to(duration);
    if (world.status().code != Status::Code::ok) throw std::runtime_error(world.status().sentence);
  }
};

/// Where the copies start, and where they should end.
struct Ensemble {
  std::vector<OrbitState> starts, ends;

  explicit Ensemble(const OrbitCase& orbit) {
    const OrbitProblem problem = problem_of(orbit);
    if (orbit.copies == 1) {
      starts = {start_of(problem)};
      ends = {end_of(problem)};
      return;
    }
    const Solver solver(orbit, orbit.ours.front(), 1);
    const OdeintOrbit& exact = peer_of(orbit.problem, "runge_kutta_fehlberg78");
    const std::size_t n = problem.bodies();
    for (std::size_t copy = 0; copy < static_cast<std::size_t>(orbit.copies); ++copy) {
      starts.push_back(state_of(solver.world, copy * n, n));
      OrbitState end = starts.back();
      exact.solve(1e-14, problem.duration, end.data());
      end.resize(2 * n);
      ends.push_back(end);
    }
  }
};

Curve our_curve(const OrbitCase& orbit, const Ensemble& ensemble, int threads) {
  Curve curve{"Ballpark " + orbit.integrator + (threads > 1 ? ", 2 threads" : ""), {}};
  const std::size_t n = problem_of(orbit).bodies();
  for (const double setting : orbit.ours) {
    const auto solver = std::make_shared<Solver>(orbit, setting, threads);
    Point point{.setting = setting, .solve = [solver] { solver->solve(); }};
    solver->solve();
    const Counters counters = solver->world.counters();
    point.steps = counters.steps;
    point.evaluations = counters.force_evaluations;
    for (std::size_t copy = 0; copy < ensemble.ends.size(); ++copy) {
      point.error = std::max(point.error, orbit_error(ensemble.ends[copy], state_of(solver->world, copy * n, n)));
    }
    curve.points.push_back(std::move(point));
  }
  return curve;
}

/// Copies: one solve after the other; steps and evaluations are those of the first.
Curve peer_curve(const OrbitCase& orbit, const Ensemble& ensemble) {
  Curve curve{"odeint " + orbit.stepper, {}};
  const OdeintOrbit& peer = peer_of(orbit.problem, orbit.stepper);
  const double duration = problem_of(orbit).duration;
  const auto ends = std::make_shared<std::vector<OrbitState>>();
  for (const double setting : orbit.peers) {
    Point point{.setting = setting, .solve = [&peer, setting, duration, ends, starts = ensemble.starts] {
                  *ends = starts;
                  for (OrbitState& state : *ends) peer.solve(setting, duration, state.data());
                }};
    point.solve();
    for (std::size_t copy = 0; copy < ends->size(); ++copy) {
      point.error = std::max(point.error, orbit_error(ensemble.ends[copy], (*ends)[copy]));
    }
    OrbitState state = ensemble.starts.front();
    const OdeintTally tally = peer.tally(setting, duration, state.data());
    point.steps = tally.steps;
    point.evaluations = tally.evaluations;
    curve.points.push_back(std::move(point));
  }
  return curve;
}

}  // namespace

std::vector<OrbitCase> orbit_cases() {
  const std::string rk4 = "rk4", dp5 = "dormand_prince5", dp8 = "dormand_prince8";
  const std::string peer_rk4 = "runge_kutta4", peer_dp5 = "runge_kutta_dopri5", peer_f78 = "runge_kutta_fehlberg78";
  const std::vector<double> tolerances = {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};
  const std::vector<double> coarse = {3e-6, 1e-6, 1e-7, 1e-8, 1e-9};
  const std::vector<double> errors = {1e-4, 1e-6, 1e-8}, coarse_errors = {1e-4, 1e-6};
  const std::vector<double> pleiades_steps = {12e3, 25e3, 50e3, 1e5}, kepler_steps = {2500, 5e3, 1e4, 2e4, 4e4};
  const std::vector<double> few_steps = {2500, 5e3}, more_steps = {3500, 7e3};  // copies may come closer
  return {
      {"Pleiades, rk4", "pleiades", rk4, peer_rk4, pleiades_steps, pleiades_steps, {1e-5, 1e-6, 1e-7}, 1, true, 1.5, 1},
      {"Pleiades, order 5", "pleiades", dp5, peer_dp5, tolerances, tolerances, errors, 1, true, 1.5, 1},
      {"Pleiades, order 8", "pleiades", dp8, peer_f78, tolerances, tolerances, errors, 1, true, 1.5, 1},
      {"Kepler, rk4", "kepler", rk4, peer_rk4, kepler_steps, kepler_steps, {1e-6, 1e-8, 1e-10}, 1, true, 4},
      {"Kepler, order 5", "kepler", dp5, peer_dp5, tolerances, tolerances, errors, 1, true, 4},
      {"Kepler, order 8", "kepler", dp8, peer_f78, tolerances, tolerances, errors, 1, true, 4},
      {"Copies of Kepler, rk4", "kepler", rk4, peer_rk4, few_steps, few_steps, {3e-7}, copies, false, 4},
      {"Copies of Kepler, order 5", "kepler", dp5, peer_dp5, coarse, coarse, coarse_errors, copies, false, 4},
      {"Copies of Pleiades, rk4", "pleiades", rk4, peer_rk4, more_steps, more_steps, {2e-2}, copies, false, 2},
      {"Copies of Pleiades, order 5", "pleiades", dp5, peer_dp5, coarse, coarse, coarse_errors, copies, false, 2},
  };
}

OrbitResult measure(const OrbitCase& orbit, const Effort& effort) {
  const Ensemble ensemble(orbit);
  OrbitResult result{.orbit = orbit, .curves = {}, .at_errors = {}, .gain_of_threads = {}};
  result.curves = {our_curve(orbit, ensemble, 1), peer_curve(orbit, ensemble)};
  if (orbit.copies > 1) result.curves.push_back(our_curve(orbit, ensemble, 2));
  time_curves(result.curves, effort);
  const Curve &ours = result.curves[0], &peers = result.curves[1];
  result.at_errors = orbit.at_most ? compare(ours, peers, orbit.errors) : compare(peers, ours, orbit.errors);
  if (result.at_errors.empty()) throw std::runtime_error(orbit.name + ": no error that both curves reach");
  result.mean = mean(result.at_errors);
  result.met = orbit.at_most ? result.mean.of_minima <= orbit.bar : result.mean.of_minima >= orbit.bar;
  if (orbit.copies > 1) result.gain_of_threads = compare(ours, result.curves[2], orbit.errors);
  return result;
}

}  // namespace ballpark::perf
