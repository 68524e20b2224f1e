#include "perf/throughput/benchmarks.h"

#include <fmt/format.h>

#include <algorithm>

#include "perf/effects/sample.h"
#include "perf/throughput/attraction.h"
#include "perf/throughput/neighbours.h"
#include "perf/throughput/scenes.h"

namespace ballpark::perf {

namespace {

Options on_threads(int threads, Path path = Path::automatic) {
  Options options;
  options.threads = threads;
  options.path = path;
  return options;
}

Options on_target(const std::string& target, Precision precision) {
  Options options = on_threads(1);
  options.target = target;
  options.precision = precision;
  return options;
}

std::string named(const std::string& name, int threads) {
  return fmt::format("{}, {} threads", name, threads);
}

std::vector<Ratio> ratios_of_methods(const std::string& rk4_threads, const std::string& triad_threads) {
  return {
      {"rk4 / hand-written rk4", {"rk4"}, {"hand-written rk4"}, Bar{.at_most = true, .limit = 1.35, .aim = 1.1}},
      {"rk4 / semi_implicit_euler", {"rk4"}, {"semi_implicit_euler"}, Bar{.at_most = true, .limit = 3, .aim = 2.0}},
      {"rk4 / euler", {"rk4"}, {"euler"}, {}},
      {"odeint runge_kutta4 / rk4", {"odeint runge_kutta4"}, {"rk4"}, Bar{.at_most = false, .limit = 4, .aim = {}}},
      {"gain of threads / triad's gain",
       {"rk4", triad_threads},
       {rk4_threads, "triad"},
       Bar{.at_most = false, .limit = 0.9, .aim = {}}},
      {"gain of threads, rk4", {"rk4"}, {rk4_threads}, {}},
      {"gain of threads, triad", {"triad"}, {triad_threads}, {}},
      {"rk4 staged / rk4", {"rk4 staged"}, {"rk4"}, {}},
      {"rk4 / touch", {"rk4"}, {"touch"}, {}},
      {"unused effect: with / without", {"rk4, unused effect"}, {"rk4"}, {}},
      {"noise: rk4 again / rk4", {"rk4 again"}, {"rk4"}, {}},
  };
}

// The comparison that the bars are about.
Comparison methods(const Settings& settings) {
  const Start start = start_of_falling_particles(settings.bodies);
  const Scene scene = falling_particles(settings.bodies);
  Scene with_unused = scene;
  with_unused.effects.push_back(force_that_is_over());
  const std::string rk4_threads = named("rk4", settings.threads);
  const std::string triad_threads = named("triad", settings.threads);

  Comparison c;
  c.title = "Particles under gravity and quadratic drag, double, one thread if not said";
  c.note =
      "touch: the same columns read and written with one addition each. triad: ns per element of 24 bytes; the "
      "read that its write causes is not counted, in-place steps cause none.";
  c.subjects = {hand_written_subject("hand-written rk4", start), touch_subject("touch", start)};
  for (const IntegratorDescription& row : integrators()) {
    if (row.implicit) continue;  // a thousand times the time, for scenes that are not stiff
    if (!check(falling_particles(1, row.name)).empty()) continue;  // refuses forces that read velocity
    c.subjects.push_back(world_subject(row.name, falling_particles(settings.bodies, row.name), on_threads(1)));
  }
  c.subjects.push_back(world_subject("rk4 again", scene, on_threads(1)));
  c.subjects.push_back(world_subject("rk4, unused effect", with_unused, on_threads(1)));
  c.subjects.push_back(world_subject("rk4 staged", scene, on_threads(1, Path::staged)));
  for (const OdeintMethod& method : odeint_methods()) {
    c.subjects.push_back(odeint_subject(fmt::format("odeint {}", method.name), start, method));
    c.agreements.push_back({method.integrator, c.subjects.back().name, 1e-12});
  }
  c.subjects.push_back(world_subject(rk4_threads, scene, on_threads(settings.threads)));
  c.subjects.push_back(triad_subject("triad", 1));
  c.subjects.push_back(triad_subject(triad_threads, settings.threads));

  c.ratios = ratios_of_methods(rk4_threads, triad_threads);
  c.agreements.push_back({"rk4", "hand-written rk4", 1e-12});
  for (const std::string& same_bits : {std::string("rk4 staged"), std::string("rk4, unused effect"), rk4_threads}) {
    c.agreements.push_back({"rk4", same_bits, 0});
  }
  return c;
}

// Sizes up to the largest that is asked for.
std::vector<std::size_t> up_to(std::size_t largest, std::vector<std::size_t> sizes) {
  std::erase_if(sizes, [&](std::size_t size) { return size >= largest; });
  sizes.push_back(largest);
  return sizes;
}

Comparison effect_prices(const Settings& settings) {
  Comparison c;
  c.title = "What an effect adds beside gravity: rk4, double, one thread";
  c.note =
      "Spheres that are particles until an effect asks for rotation: the price holds the columns that come with it.";
  c.by_size = true;
  c.base = "gravity alone";
  for (const std::size_t bodies : up_to(settings.bodies, {10'000})) {
    const Scene base = falling_spheres(bodies);
    c.subjects.push_back(world_subject(c.base, base, on_threads(1)));
    for (const EffectDescription& description : effects()) {
      if (description.name == "gravity" || (description.between_bodies && bodies > 10'000)) continue;
      Scene scene = base;
      scene.effects.push_back(sample_of(description, bodies));
      c.subjects.push_back(world_subject(description.name, scene, on_threads(1)));
    }
  }
  return c;
}

Comparison sizes_and_targets(const Settings& settings) {
  struct Kind {
    const char* name;
    Scene (*scene)(std::size_t bodies);
  };
  struct Arithmetic {
    const char* name;
    Precision precision;
  };
  constexpr Kind kinds[] = {{"particles", [](std::size_t n) { return falling_particles(n); }},
                            {"rigid", tumbling_bodies}};
  constexpr Arithmetic arithmetics[] = {{"double", Precision::double_}, {"single", Precision::single_}};

  Comparison c;
  c.title = "Sizes, precisions, targets: rk4, one thread";
  c.note = "particles: gravity and quadratic drag. rigid: tumbling asymmetric bodies under gravity.";
  c.by_size = true;
  for (const Kind& kind : kinds) {
    for (const Arithmetic& arithmetic : arithmetics) {
      for (const NamedDescription& target : targets()) {
        if (!target.available) continue;
        const std::string name = fmt::format("{} {} {}", kind.name, arithmetic.name, target.name);
        for (const std::size_t bodies : up_to(settings.bodies, {1'000, 10'000, 100'000})) {
          c.subjects.push_back(world_subject(name, kind.scene(bodies), on_target(target.name, arithmetic.precision)));
        }
      }
    }
  }
  return c;
}

}  // namespace

const std::vector<Benchmark>& benchmarks() {
  static const std::vector<Benchmark> all = {{"methods", methods},
                                             {"effects", effect_prices},
                                             {"sizes", sizes_and_targets},
                                             {"neighbours", neighbours},
                                             {"attraction", attraction}};
  return all;
}

}  // namespace ballpark::perf
