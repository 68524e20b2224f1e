// recheck SCENE RESULT.json: times the setting that `ballpark cost --tolerance` named beside every setting it swept
// that is as accurate, and says whether any of them is faster. It shares nothing with the tool but the library.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "ballpark/scenes.h"
#include "perf/timing.h"

namespace {

using nlohmann::json;

constexpr int rounds = 15;

/// A setting as a world that runs the whole duration again and again.
class Rerun {
 public:
  Rerun(const ballpark::Scene& scene, const json& point) : scene_(with(scene, point)), world_(scene_), point_(point) {
    start_ = world_.snapshot();
  }

  void run() {
    const int repeats = std::clamp(static_cast<int>(1e-4 / point_["seconds"]["min"].get<double>()), 1, 20);
    for (int i = 0; i < repeats; ++i) {
      world_.restore(start_);
      const auto begin = std::chrono::steady_clock::now();
      if (scene_.run.step > 0) {
        world_.step(point_["steps"].get<std::uint64_t>());
      } else {
        world_.advance_to(scene_.run.duration);
      }
      seconds_.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
  }
  ballpark::perf::Samples samples() const { return ballpark::perf::Samples(seconds_); }
  bool same_bits() const {
    return fmt::format("{:016x}", world_.state_hash()) == point_["state_hash"].get<std::string>();
  }
  std::string text() const {
    const std::string pace = scene_.run.step > 0 ? fmt::format("step {:g} s", scene_.run.step)
                                                 : fmt::format("tolerance {:g}", scene_.run.tolerance);
    return fmt::format("{}, {}, {}, {}{}", scene_.run.integrator, pace, point_["precision"].get<std::string>(),
                       scene_.run.rotation, point_["contact"].is_null() ? "" : ", " + point_["contact"].dump());
  }
  double error() const { return point_["error"]["value"]; }

 private:
  static void touch(ballpark::ContactSettings& contact, const json& choice) {
    if (const std::string kind = choice["kind"]; contact.kind != kind) {
      const double margin = contact.margin;
      contact = {};
      contact.kind = kind;
      contact.margin = margin;
    }
    if (contact.kind == "penalty") {
      contact.stiffness = choice["stiffness"];
    } else {
      contact.iterations = choice["iterations"];
      contact.substeps = choice["substeps"];
    }
  }

  static ballpark::Scene with(ballpark::Scene scene, const json& point) {
    scene.run.integrator = point["integrator"];
    scene.run.step = point["step"].is_null() ? 0 : point["step"].get<double>();
    scene.run.tolerance = point["tolerance"].is_null() ? 0 : point["tolerance"].get<double>();
    scene.run.precision = point["precision"] == "single" ? ballpark::Precision::single_ : ballpark::Precision::double_;
    if (!point["rotation"].is_null()) scene.run.rotation = point["rotation"];
    if (!point["contact"].is_null()) touch(scene.contact, point["contact"]);
    for (ballpark::Effect& effect : scene.effects) {
      if (effect.kind != "mutual_gravity" || point["opening_angle"].is_null()) continue;
      effect.parameters["opening_angle"] = point["opening_angle"].get<double>();
    }
    return scene;
  }

  ballpark::Scene scene_;
  ballpark::World world_;
  json point_;
  ballpark::Snapshot start_;
  std::vector<double> seconds_;
};

/// The named setting first, then all that keep the tolerance with the same margin.
std::vector<std::unique_ptr<Rerun>> settings_of(const ballpark::Scene& scene, const json& result) {
  const json& named = result["recommended"];
  const double limit = named["limit"].get<double>() / named["margin"].get<double>();
  std::vector<std::unique_ptr<Rerun>> list;
  const std::size_t chosen = named["point"];
  list.push_back(std::make_unique<Rerun>(scene, result["points"][chosen]));
  for (std::size_t i = 0; i < result["points"].size(); ++i) {
    const json& point = result["points"][i];
    if (i == chosen || !point["trouble"].is_null() || !(point["error"]["value"].get<double>() <= limit)) continue;
    list.push_back(std::make_unique<Rerun>(scene, point));
  }
  return list;
}

int recheck(const std::string& scene_path, const std::string& result_path) {
  const ballpark::Scene scene = ballpark::scenes::load(scene_path).scene;
  const json result = json::parse(std::ifstream(result_path));
  if (result["recommended"].is_null()) {
    fmt::print("no setting was named\n");
    return 1;
  }
  const auto list = settings_of(scene, result);
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t turn = 0; turn < list.size(); ++turn) {
      list[(turn + static_cast<std::size_t>(round)) % list.size()]->run();
    }
  }
  std::vector<const Rerun*> ranked;
  for (const auto& each : list) ranked.push_back(each.get());
  std::sort(ranked.begin(), ranked.end(),
            [](auto* a, auto* b) { return a->samples().minimum() < b->samples().minimum(); });
  const double named = list.front()->samples().minimum();
  fmt::print("{} settings as accurate, {} rounds in turns; the fastest:\n", list.size(), rounds);
  for (std::size_t i = 0; i < std::min<std::size_t>(5, ranked.size()); ++i) {
    const auto samples = ranked[i]->samples();
    fmt::print("  {:9.3f} us (median {:9.3f})  error {:.1e}  {}{}\n", 1e6 * samples.minimum(), 1e6 * samples.median(),
               ranked[i]->error(), ranked[i]->text(), ranked[i] == list.front().get() ? "  <- named" : "");
  }
  const double ratio = named / ranked.front()->samples().minimum();
  const bool bits = std::all_of(list.begin(), list.end(), [](auto& each) { return each->same_bits(); });
  fmt::print("the named setting takes {:.3f} times as long as the fastest (bar 1.3); same bits as swept: {}\n", ratio,
             bits ? "yes" : "NO");
  return ratio <= 1.3 && bits ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(
        stderr,
        "usage: recheck SCENE.toml RESULT.json\n"
        "Times the setting that `ballpark cost SCENE --tolerance E --json RESULT.json` named beside all it swept.\n");
    return 2;
  }
  try {
    return recheck(argv[1], argv[2]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "recheck: {}\n", error.what());
    return 2;
  }
}
