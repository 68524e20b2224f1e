// The driver of `ballpark stress`: runs a hard case in each of its ways, and says which of them hold.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ballpark/scenes.h"

namespace ballpark::scenes {

struct CellResult {
  std::string name;
  bool owed = false;
  bool held = false;
  std::string refused, reported;           ///< what the engine must say; "": nothing
  std::string said;                        ///< by the engine, as it refused or reported the run; else ""
  std::vector<Verdict> verdicts;           ///< none if the scene was refused
  std::map<std::string, double> measures;  ///< of comparisons
  double seconds = 0;
  bool interrupted = false;
};

struct CaseResult {
  std::string name, what, length, waits_for;
  std::vector<CellResult> cells;
};

/// A hard case with each of its ways to run, loaded.
class StressCase {
 public:
  /// Throws SceneFileError if the file is no hard case, or a setting of a cell is wrong that need not be refused.
  explicit StressCase(const std::string& path);

  const SceneFile& file() const { return file_; }
  std::size_t cells() const { return cells_.size(); }
  CaseResult empty_result() const;
  /// Throws SceneFileError if an expectation names a quantity that does not exist.
  CellResult run(std::size_t cell, const Options& options, const RunHooks& hooks = {}) const;

 private:
  struct Way {
    StressCell cell;
    bool owed = false;
    std::optional<SceneFile> file;  ///< unless it was refused
    std::string refusal;
  };

  void add(const std::string& list, const std::vector<StressCell>& cells);
  Way loaded(const StressCell& cell, const std::string& path) const;
  std::string label(const StressCell& cell) const;
  static void run(const SceneFile& file, const Options& options, const RunHooks& hooks, CellResult& result);
  static void judge(CellResult& result);

  SceneFile file_;
  std::vector<Way> cells_;
};

/// Of the verdicts, the one that decides: the first that is not met, else the one nearest its limit. None: null.
const Verdict* decisive(const std::vector<Verdict>& verdicts);
/// Do all owed cells hold?
bool holds(const CaseResult& result);

}  // namespace ballpark::scenes
