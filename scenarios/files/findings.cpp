#include "scenarios/files/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <tuple>

namespace ballpark::scenes {

namespace {

std::string line_of(const LocatedProblem& problem) {
  std::string text = problem.location.file;
  if (problem.location.line > 0) text += fmt::format(":{}:{}", problem.location.line, problem.location.column);
  if (!problem.key.empty()) text += ": " + problem.key;
  return text + ": " + problem.message;
}

std::string lines_of(const std::vector<LocatedProblem>& problems) {
  std::string text;
  for (const LocatedProblem& problem : problems) text += (text.empty() ? "" : "\n") + line_of(problem);
  return text;
}

/// The path itself or something inside it.
bool within(const std::string& path, const std::string& outer) {
  if (!path.starts_with(outer)) return false;
  return path.size() == outer.size() || path[outer.size()] == '.' || path[outer.size()] == '[';
}

}  // namespace

SceneFileError::SceneFileError(std::vector<LocatedProblem> problems)
    : std::runtime_error(lines_of(problems)), problems_(std::move(problems)) {}

std::string enclosing(const std::string& path) {
  const std::size_t end = path.find_last_of(".[");
  return end == std::string::npos ? "" : path.substr(0, end);
}

Location locate(const SceneFile& file, std::string path) {
  for (; !path.empty(); path = enclosing(path)) {
    const auto found = file.locations.find(path);
    if (found != file.locations.end()) return found->second;
  }
  return {file.path, 0, 0};
}

Location Findings::location(const Place& place) const {
  if (place.override_index >= 0) return {"--set", 0, 0};
  return {file_, place.line, place.column};
}

void Findings::add(const std::string& path, const Place& place, const std::string& message) {
  std::string text = message;
  if (place.override_index >= 0) {
    const Override& source = overrides_[static_cast<std::size_t>(place.override_index)];
    text += " (" + printable(source.key + "=" + source.value) + ")";
  }
  problems_.push_back({location(place), path, std::move(text)});
}

void Findings::add(const Problem& problem) {
  add(problem.path, place_of(problem.path), problem.message);
}

/// Rows of lists are not marked, there may be millions: "bodies[0].mass[5]" is looked up in the list.
Place Findings::place_of(const std::string& path) const {
  std::string row;
  for (std::string at = path; !at.empty(); row = at.substr(enclosing(at).size()), at = enclosing(at)) {
    const auto found = nodes_.find(at);
    if (found == nodes_.end()) continue;
    const Node& node = *found->second;
    const auto* list = std::get_if<Array>(&node.value);
    std::size_t index = 0;
    const bool is_row =
        row.starts_with('[') && std::from_chars(&row[1], row.data() + row.size(), index).ec == std::errc{};
    return list && is_row && index < list->size() ? (*list)[index].place : node.place;
  }
  return {1, 1};
}

bool Findings::covers(const std::string& path) const {
  return std::any_of(problems_.begin(), problems_.end(), [&](const LocatedProblem& problem) {
    return !problem.key.empty() && (within(path, problem.key) || within(problem.key, path));
  });
}

void Findings::fail_if_any() const {
  if (problems_.empty()) return;
  std::vector<LocatedProblem> sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const LocatedProblem& a, const LocatedProblem& b) {
    return std::tie(a.location.line, a.location.column) < std::tie(b.location.line, b.location.column);
  });
  throw SceneFileError(std::move(sorted));
}

std::map<std::string, Location> Findings::locations() const {
  std::map<std::string, Location> located;
  for (const auto& [path, node] : nodes_) located[path] = location(node->place);
  return located;
}

}  // namespace ballpark::scenes
