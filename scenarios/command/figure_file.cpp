#include "scenarios/command/figure_file.h"

#include <fmt/format.h>

#include "perf/machine.h"
#include "scenarios/command/errors.h"
#include "scenarios/command/text.h"
#include "scenarios/view/figure.h"
#include "scenarios/view/frame_times.h"

namespace ballpark::command {
namespace {

constexpr std::size_t samples = 301;

const std::string& vector_picture(const std::string& path) {
  if (!path.ends_with(".svg")) throw UsageError(fmt::format("--figure: '{}' must end in .svg", path));
  return path;
}

std::string setting_of(const World& world, const Scene& scene) {
  const std::string bodies = counted(world.body_count(), "body", "bodies");
  const std::string threads = counted(static_cast<std::uint64_t>(world.threads()), "thread", "threads");
  return fmt::format("{}; {}; {}, {}, {} path, {}", pace_text(scene.run), bodies, threads, world.explain().precision,
                     world.explain().path, perf::machine().processor);
}

}  // namespace

FigureFile::FigureFile(const std::string& path, const Scene& scene, bool ledger)
    : scene_(scene), file_(vector_picture(path)), history_(scene, ledger) {}

scenes::OutputRequest FigureFile::request() const {
  scenes::OutputRequest request;
  request.at = view::frame_times(scene_.run.duration, samples);
  request.file = path();
  return request;
}

void FigureFile::add(const World& world) {
  if (setting_.empty()) setting_ = setting_of(world, scene_);
  history_.add(world);
}

void FigureFile::write() {
  view::Figure figure;
  figure.title = scene_.name + ": energy, momenta and speed over time";
  if (!scene_.doc.empty()) figure.paragraphs.push_back(scene_.doc);
  figure.paragraphs.push_back(setting_);
  figure.times = history_.times();
  figure.series = history_.take();
  file_.write(view::svg(figure));
  file_.commit();
}

}  // namespace ballpark::command
