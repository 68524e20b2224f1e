#include "scenarios/command/scene_edit.h"

#include <fmt/format.h>

#include <regex>
#include <sstream>
#include <vector>

#include "perf/cost/subject.h"
#include "scenarios/command/errors.h"

namespace ballpark::command {
namespace {

/// A scene file as lines, with the places of its keys.
class SceneText {
 public:
  SceneText(const std::string& text, const scenes::SceneFile& file) : file_(file) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      const bool returns = line.ends_with('\r');
      if (returns) line.pop_back();
      if (returns) end_ = "\r\n";
      lines_.push_back({line, {}, false});
    }
    ends_open_ = !text.ends_with('\n');
  }

  bool has(const std::string& table, const std::string& key) const {
    return file_.locations.count(table + "." + key) > 0;
  }

  /// Key and value in place of the value that `old` has; the rest of the line stays.
  void replace(const std::string& table, const std::string& old, const std::string& key, const std::string& value) {
    Line& line = line_of(table, old);
    const std::regex entry("\\b" + old + R"((\s*=\s*)("[^"]*"|'[^']*'|[^\s,#}]+))");
    const std::string changed =
        std::regex_replace(line.text, entry, key + "$01" + value, std::regex_constants::format_first_only);
    if (changed == line.text && line.text.find(value) == std::string::npos) refuse(table, old);
    line.text = changed;
  }

  /// A line of its own below the one that holds `neighbour`.
  void add(const std::string& table, const std::string& neighbour, const std::string& key, const std::string& value) {
    Line& line = line_of(table, neighbour);
    std::smatch found;
    const std::regex own_line("^(\\s*(?:" + table + "\\.)?)" + neighbour + R"(\s*=.*)");
    if (!std::regex_match(line.text, found, own_line)) refuse(table, key);
    line.below.push_back(found[1].str() + key + " = " + value);
  }

  void remove(const std::string& table, const std::string& key) {
    Line& line = line_of(table, key);
    if (!std::regex_match(line.text, std::regex("^\\s*(?:" + table + "\\.)?" + key + R"(\s*=\s*[^,}]*)"))) {
      refuse(table, key);
    }
    line.removed = true;
  }

  std::string text() const {
    std::string all;
    for (const Line& line : lines_) {
      if (!line.removed) all += line.text + end_;
      for (const std::string& more : line.below) all += more + end_;
    }
    if (ends_open_ && all.ends_with(end_)) all.erase(all.size() - end_.size());
    return all;
  }

 private:
  struct Line {
    std::string text;
    std::vector<std::string> below;
    bool removed;
  };

  Line& line_of(const std::string& table, const std::string& key) {
    const auto place = file_.locations.find(table + "." + key);
    const std::size_t line = place == file_.locations.end() ? 0 : place->second.line;
    if (line == 0 || line > lines_.size()) refuse(table, key);
    return lines_[line - 1];
  }

  [[noreturn]] void refuse(const std::string& table, const std::string& key) const {
    throw UsageError(
        fmt::format("--write: {} is not laid out so that {}.{} can be changed in place; nothing was written",
                    file_.path, table, key));
  }

  const scenes::SceneFile& file_;
  std::vector<Line> lines_;
  std::string end_ = "\n";  ///< of a line
  bool ends_open_ = false;  ///< the last line has none
};

void put(SceneText& text, const std::string& table, const std::string& neighbour, const std::string& key,
         const std::string& value) {
  text.has(table, key) ? text.replace(table, key, key, value) : text.add(table, neighbour, key, value);
}

/// The formulation, without the other's settings, and its own where they differ.
void put_contact(SceneText& text, const ContactSettings& own, const cost::ContactChoice& choice) {
  if (choice.kind.empty()) return;
  const bool other = choice.kind != own.kind;
  const ContactSettings like = other ? ContactSettings{} : own;
  if (other) {
    text.replace("contact", "kind", "kind", '"' + choice.kind + '"');
    for (const char* key : {"substeps", "iterations", "relax_iterations", "restitution_threshold", "stiffness",
                            "tangential_stiffness", "pull"}) {
      if (text.has("contact", key)) text.remove("contact", key);
    }
  }
  if (choice.kind == "penalty") {
    if (choice.stiffness != like.stiffness) {
      put(text, "contact", "kind", "stiffness", fmt::format("{}", choice.stiffness));
    }
    return;
  }
  if (choice.iterations != like.iterations) {
    put(text, "contact", "kind", "iterations", fmt::format("{}", choice.iterations));
  }
  if (choice.substeps != like.substeps) {
    put(text, "contact", "kind", "substeps", fmt::format("{}", choice.substeps));
  }
}

}  // namespace

std::string with_setting(const std::string& text, const scenes::SceneFile& file, const cost::Setting& setting) {
  SceneText edited(text, file);
  const bool adaptive = setting.tolerance > 0;
  const std::string pace = adaptive ? "tolerance" : "step", other = adaptive ? "step" : "tolerance";
  const std::string value = fmt::format("{}", adaptive ? setting.tolerance : setting.step);
  if (edited.has("run", pace)) {
    edited.replace("run", pace, pace, value);
  } else {
    edited.replace("run", other, pace, value);
  }
  if (!adaptive && edited.has("run", "absolute_tolerance")) edited.remove("run", "absolute_tolerance");
  put(edited, "run", "duration", "integrator", '"' + setting.integrator + '"');
  if (setting.precision != file.scene.run.precision) {
    put(edited, "run", "duration", "precision", setting.precision == Precision::single_ ? "\"single\"" : "\"double\"");
  }
  if (!setting.rotation.empty() && setting.rotation != file.scene.run.rotation) {
    put(edited, "run", "duration", "rotation", '"' + setting.rotation + '"');
  }
  put_contact(edited, file.scene.contact, setting.contact);
  if (setting.opening_angle != cost::setting_of(file.scene).opening_angle) {
    throw UsageError(
        fmt::format("--write: opening_angle = {:g} of mutual_gravity must be set by hand; nothing was written",
                    setting.opening_angle));
  }
  std::string changed = edited.text();
  try {
    if (cost::setting_of(scenes::parse(changed, file.path).scene) == setting) return changed;
  } catch (const scenes::SceneFileError&) {  // said below
  }
  throw UsageError(fmt::format("--write: {} would not load as meant; nothing was written", file.path));
}

}  // namespace ballpark::command
