// Where everything in a scene file stands, and what is wrong with it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ballpark/scenes.h"
#include "scenarios/files/document.h"

namespace ballpark::scenes {

/// Must not outlive the document whose nodes it is shown.
class Findings {
 public:
  Findings(std::string file, const std::vector<Override>& overrides) : file_(std::move(file)), overrides_(overrides) {}

  /// The value of that problem path ("bodies[0].mass") stands there.
  void mark(const std::string& path, const Node& node) { nodes_[path] = &node; }
  /// The value of `path` came by way of the one of `source`.
  void mark_like(const std::string& path, const std::string& source) { nodes_[path] = nodes_.at(source); }
  void add(const std::string& path, const Place& place, const std::string& message);
  /// Located by its path; what has no place of its own, where its table stands.
  void add(const Problem& problem);
  /// Something wrong was found there, above it or below it: what else is said of it follows from that.
  bool covers(const std::string& path) const;

  /// Throws SceneFileError with all problems, in the order of the file, if there are any.
  void fail_if_any() const;
  std::map<std::string, Location> locations() const;

 private:
  Location location(const Place& place) const;
  Place place_of(const std::string& path) const;

  std::string file_;
  const std::vector<Override>& overrides_;
  std::map<std::string, const Node*> nodes_;
  std::vector<LocatedProblem> problems_;
};

/// "bodies[0].mass[2]" -> "bodies[0].mass" -> "bodies[0]" -> "bodies" -> "".
std::string enclosing(const std::string& path);

/// The location of a path, or of what encloses it; without a line if there is none.
Location locate(const SceneFile& file, std::string path);

}  // namespace ballpark::scenes
