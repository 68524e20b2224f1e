// The project's scenarios, cut down so that each can be run a hundred times; and ways to run them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "ballpark/catalogue.h"
#include "ballpark/scenes.h"
#include "tests/integrators.h"

namespace scenarios {

using ballpark::Options;
using ballpark::Path;
using ballpark::Precision;
using ballpark::Scene;

/// Five blocks, the last of them short, and divided by no vector width.
inline constexpr std::size_t most_bodies = 17001;

/// Contacts cost more, and are tested apart over several blocks.
inline constexpr std::size_t most_in_contact = 700;

inline std::vector<std::string> files() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(BALLPARK_SCENARIOS_FOLDER)) {
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

inline Scene whole(const std::string& file) {
  return ballpark::scenes::load(file).scene;
}

inline Scene small(const std::string& file) {
  Scene scene = whole(file);
  for (ballpark::BodyGroup& group : scene.bodies) {
    if (group.generate && group.generate->count.size() == 1) {
      group.generate->count[0] = std::min(group.generate->count[0], most_bodies);
    }
    if (group.generate && group.generate->count.size() == 3) {  // some layers of a lattice
      std::vector<std::size_t>& count = group.generate->count;
      count[2] = std::clamp<std::size_t>(most_in_contact / (count[0] * count[1]), 1, count[2]);
    }
  }
  return scene;
}

/// Enough for an error to show, few enough for a hundred runs. Contacts need time to come about.
inline std::uint64_t some_steps(const Scene& scene) {
  if (!scene.contact.kind.empty()) return scene.bodies[0].generate ? 30 : 250;
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const auto& group) { return bool(group.generate); })
             ? 3
             : 120;
}

/// Of runs that are made in a hundred ways: sanitizers take many times as long.
inline std::uint64_t steps_of_many_runs(const Scene& scene) {
#ifdef BALLPARK_SANITIZE
  return std::min<std::uint64_t>(some_steps(scene), 25);
#else
  return some_steps(scene);
#endif
}

inline std::uint64_t hash_after(const Scene& scene, const Options& options, std::uint64_t steps) {
  ballpark::World world(scene, options);
  world.step(steps);
  return world.state_hash();
}

inline std::vector<std::string> available_targets() {
  std::vector<std::string> names;
  for (const ballpark::NamedDescription& target : ballpark::targets()) {
    if (target.available) names.push_back(target.name);
  }
  return names;
}

/// Do bodies move by forces of their own alone? Forces between bodies take the staged path, and have no derivative.
inline bool is_local(const Scene& scene) {
  const auto between = [](const ballpark::Effect& effect) {
    return std::any_of(ballpark::effects().begin(), ballpark::effects().end(), [&](const auto& description) {
      return description.name == effect.kind && description.between_bodies;
    });
  };
  return scene.contact.kind != "penalty" && std::none_of(scene.effects.begin(), scene.effects.end(), between);
}

inline std::vector<std::string> integrators_for(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& integrator : ballpark::tests::integrators_for(scene)) names.push_back(integrator.name);
  return names;
}

/// The plainest way first: one thread, the base target, the fused path. Then again, and all others.
inline std::vector<Options> ways(const Scene& scene, Precision precision) {
  const std::vector<Path> paths = is_local(scene) ? std::vector{Path::fused, Path::staged} : std::vector{Path::staged};
  const Options plain{.threads = 1, .target = "base", .precision = precision, .path = paths[0]};
  std::vector<Options> all{plain, plain};
  for (const int threads : {2, 3, 5, 8}) {
    for (const Path path : paths) {
      all.push_back({.threads = threads, .precision = precision, .path = path});
    }
  }
  for (const std::string& target : available_targets()) {
    for (const Path path : paths) {
      all.push_back({.threads = 1, .target = target, .precision = precision, .path = path});
    }
  }
  return all;
}

inline std::string text(const Options& way) {
  return std::to_string(way.threads) + " threads, target " + way.target + ", path " +
         (way.path == Path::staged ? "staged" : "fused");
}

}  // namespace scenarios
