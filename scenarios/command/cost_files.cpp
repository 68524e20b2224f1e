// The files of `ballpark cost`: figure, page, points, and the scene itself.
#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "perf/cost/page.h"
#include "perf/cost/result_json.h"
#include "perf/cost/subject.h"
#include "perf/cost/svg.h"
#include "scenarios/command/cost_text.h"
#include "scenarios/command/errors.h"
#include "scenarios/command/scene_edit.h"
#include "scenarios/command/scene_options.h"

namespace ballpark::command {
namespace {

std::string content_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw DestinationError(fmt::format("cannot read '{}' again", path));
  return text;
}

void open(std::optional<OutputFile>& file, const std::optional<std::string>& path, const scenes::SceneFile& scene) {
  if (!path) return;
  refuse_inputs({*path}, scene);
  file.emplace(*path);
}

void deliver(std::optional<OutputFile>& file, const std::string& text) {
  if (!file) return;
  file->write(text);
  file->commit();
}

}  // namespace

CostFiles::CostFiles(const Arguments& arguments, const scenes::SceneFile& file)
    : file_(file), write_back_(arguments.write) {
  open(csv_, arguments.csv, file);
  open(svg_, arguments.svg, file);
  open(html_, arguments.html, file);
  if (!write_back_) return;
  if (!arguments.tolerance && !arguments.budget) {
    throw UsageError("--write needs --tolerance or --budget: what shall be written?");
  }
  if (!arguments.overrides.empty()) {
    throw UsageError("--write needs the scene as its file has it: it does not go with --set");
  }
  OutputFile probe(file.path);  // known before anything is measured
  with_setting(content_of(file.path), file, cost::setting_of(file.scene));
}

void CostFiles::write(const cost::Result& result, const Json& json) {
  deliver(csv_, cost::to_csv(result));
  deliver(svg_, cost::svg(result));
  deliver(html_, cost::page(json.dump(), result.scenario));
  if (!write_back_ || !result.recommended) return;
  const std::string changed =
      with_setting(content_of(file_.path), file_, result.points[result.recommended->point].setting);
  OutputFile scene(file_.path);
  scene.write(changed);
  scene.commit();
}

}  // namespace ballpark::command
