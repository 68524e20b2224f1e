// The files of `ballpark cost`: figure, page, points, and the scene itself.
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <utility>

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

/// Returns the line that says so.
std::string deliver(std::optional<OutputFile>& file, const std::string& text) {
  if (!file) return "";
  file->write(text);
  file->commit();
  return "  wrote " + file->path() + "\n";
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
  if (arguments.name != file.path) {
    throw UsageError(fmt::format("--write needs the path of a scene file, not the name of a scenario: {}", file.path));
  }
  if (arguments.precisions && arguments.precisions->find("extended") != std::string::npos) {
    throw UsageError("--write: a scene file takes no extended precision; expected --precisions of single and double");
  }
  OutputFile probe(file.path);  // known before anything is measured
  with_setting(content_of(file.path), file, cost::setting_of(file.scene));
}

std::string CostFiles::write(const cost::Result& result, const Json& json) {
  std::string said = deliver(csv_, cost::to_csv(result)) + deliver(svg_, cost::svg(result)) +
                     deliver(html_, cost::page(json.dump(), result.scenario));
  if (write_back_ && result.recommended) {
    std::optional<OutputFile> scene(std::in_place, file_.path);
    said +=
        deliver(scene, with_setting(content_of(file_.path), file_, result.points[result.recommended->point].setting));
  }
  return said.empty() ? said : "\n" + said;
}

}  // namespace ballpark::command
