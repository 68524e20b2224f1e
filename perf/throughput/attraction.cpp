#include "perf/throughput/attraction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "perf/machine.h"

namespace ballpark::perf {

namespace {

constexpr double softening = 0.01, step = 1e-3;

/// In units where G, the mass of all and the scale radius are 1.
Scene plummer(std::size_t bodies, double opening_angle, const std::string& integrator) {
  Scene scene;
  scene.run.duration = step;
  scene.run.step = step;
  scene.run.integrator = integrator;
  BodyGroup stars;
  stars.name = "stars";
  stars.mass = {1 / static_cast<double>(bodies)};
  stars.generate = Generate{};
  stars.generate->kind = "plummer";
  stars.generate->count = {bodies};
  stars.generate->scale = 1;
  scene.bodies = {stars};
  scene.effects = {{.kind = "mutual_gravity",
                    .groups = {},
                    .parameters = {{"strength", 1.0}, {"softening", softening}, {"opening_angle", opening_angle}}}};
  return scene;
}

Subject hand_written(const std::string& name, std::size_t bodies) {
  struct Stars {
    StateColumns columns;
    std::vector<double> mass;
  };
  const auto stars = std::make_shared<Stars>();
  stars->columns = state_of(World(plummer(bodies, 0, "semi_implicit_euler")));
  const std::size_t room = (bodies + 15) / 16 * 16;
  for (std::vector<double>& column : stars->columns) column.resize(room);
  stars->mass.assign(room, 1 / static_cast<double>(bodies));
  const auto run = [stars, bodies] {
    double* columns[6];
    for (std::size_t c = 0; c < 6; ++c) columns[c] = stars->columns[c].data();
    hand_written_attraction({softening, step}, stars->mass.data(), columns, columns + 3, bodies);
  };
  const auto state = [stars, bodies] {
    StateColumns columns = stars->columns;
    for (std::vector<double>& column : columns) column.resize(bodies);
    return columns;
  };
  const auto all = static_cast<double>(bodies);
  return {.name = name, .bodies = bodies, .units = all, .bytes_per_unit = 56, .run = run, .state = state};
}

Subject direct_sum(const std::string& name, std::size_t bodies, int threads) {
  const auto world = std::make_shared<World>(plummer(bodies, 0, "semi_implicit_euler"), Options{.threads = threads});
  const auto all = static_cast<double>(bodies);
  return {.name = name,
          .bodies = bodies,
          .units = all,
          .bytes_per_unit = 56,
          .run = [world] { world->step(); },
          .state = [world] { return state_of(*world); }};
}

struct Sampled {
  std::vector<std::size_t> ids;
  std::vector<Vector3d> exact;  ///< acceleration
};

/// Every pair, in extended precision.
Sampled sample(const World& world, std::size_t samples) {
  const StateColumns x = state_of(world);
  const std::size_t bodies = x[0].size(), stride = std::max<std::size_t>(1, bodies / samples);
  const auto mass = 1 / static_cast<long double>(bodies);
  Sampled sampled;
  for (std::size_t i = 0; i < bodies && sampled.ids.size() < samples; i += stride) {
    long double sum[3] = {};
    for (std::size_t j = 0; j < bodies; ++j) {
      const double r[3] = {x[0][j] - x[0][i], x[1][j] - x[1][i], x[2][j] - x[2][i]};
      const double square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + softening * softening;
      const double pull = 1 / (square * std::sqrt(square));
      for (int c = 0; c < 3; ++c) sum[c] += pull * r[c];
    }
    sampled.ids.push_back(i);
    sampled.exact.emplace_back(static_cast<double>(mass * sum[0]), static_cast<double>(mass * sum[1]),
                               static_cast<double>(mass * sum[2]));
  }
  return sampled;
}

struct Off {
  double rms = 0, worst = 0;
};

/// After one step of Euler's method from rest the velocity is the step times the acceleration.
Off error_of(const World& world, const Sampled& sampled) {
  Off off;
  for (std::size_t k = 0; k < sampled.ids.size(); ++k) {
    const Vector3d found = world.body(sampled.ids[k]).velocity / step;
    const double relative = (found - sampled.exact[k]).norm() / sampled.exact[k].norm();
    off.rms += relative * relative;
    off.worst = std::max(off.worst, relative);
  }
  off.rms = std::sqrt(off.rms / static_cast<double>(sampled.ids.size()));
  return off;
}

}  // namespace

Comparison attraction(const Settings& settings) {
  const std::size_t bodies = std::min<std::size_t>(settings.bodies, 10'000);
  const std::string threads = fmt::format("every pair, {} threads", settings.threads);
  Comparison c;
  c.title = "Stars that attract each other: every pair, semi-implicit Euler, double, one thread if not said";
  c.note =
      fmt::format("ns: per star, which is attracted by {}. hand-written: 16 stars at a time in registers.", bodies);
  c.subjects = {direct_sum("every pair", bodies, 1), hand_written("hand-written", bodies),
                direct_sum(threads, bodies, settings.threads)};
  c.ratios = {{"every pair / hand-written", {"every pair"}, {"hand-written"}, Bar{.limit = 1.5, .aim = 1.0}},
              {"gain of threads", {"every pair"}, {threads}, {}}};
  c.agreements = {{"every pair", "hand-written", 1e-12}, {"every pair", threads, 0}};
  return c;
}

bool tree(const TreeSettings& settings) {
  fmt::print("Barnes and Hut's tree on {} stars of a Plummer sphere, double, {} threads, {}\n", settings.bodies,
             settings.threads, machine().processor);
  const Sampled sampled = sample(World(plummer(settings.bodies, 1, "euler")), 1000);
  fmt::print("  {:>13}{:>16}{:>12}{:>18}{:>22}\n", "opening angle", "rms |dF|/|F|", "largest", "s an evaluation",
             "ns a star, thread");
  bool met = true;
  for (const double angle : {0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}) {
    World world(plummer(settings.bodies, angle, "euler"), {.threads = settings.threads});
    const double start = seconds_now();
    world.step();
    const double seconds = seconds_now() - start;
    const Off off = error_of(world, sampled);
    fmt::print("  {:>13}{:>16.2e}{:>12.2e}{:>18.3f}{:>22.0f}\n", angle, off.rms, off.worst, seconds,
               1e9 * seconds * settings.threads / static_cast<double>(settings.bodies));
    if (angle == 0.5) met = off.rms < 0.01;
    std::fflush(stdout);
  }
  fmt::print("  {} stars sampled against the sum over all; bar at 0.5: below 1 %, {}\n", sampled.ids.size(),
             met ? "met" : "MISSED");
  return met;
}

}  // namespace ballpark::perf
