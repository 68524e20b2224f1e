// What the tests of scene files share: small scenes, what is wrong with a text, and files to read.
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "ballpark/scenes.h"
#include "tests/unit/command/scratch_folder.h"

namespace scene_texts {

using ballpark::scenes::LocatedProblem;
using ballpark::scenes::Override;

inline const std::string run_table = "[run]\nduration = 1.0\nstep = 0.1\n";

/// A ball of 2 kg that moves by (1, 0, 0) m/s from (1, 2, 3), in nothing.
inline const std::string drifting = run_table +
                                    "[[bodies]]\nname = \"ball\"\nmass = 2.0\nposition = [1.0, 2.0, 3.0]\n"
                                    "velocity = [1.0, 0.0, 0.0]\n";

/// Problems of a text that must have some; none if it is accepted.
inline std::vector<LocatedProblem> problems_of(const std::string& text, const std::vector<Override>& overrides = {}) {
  try {
    ballpark::scenes::parse(text, "test.toml", overrides);
  } catch (const ballpark::scenes::SceneFileError& error) {
    return error.problems();
  }
  return {};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Writes a file into the folder and returns its path.
inline std::string written(const ScratchFolder& folder, const std::string& name, const std::string& bytes) {
  std::ofstream(folder.path / name, std::ios::binary) << bytes;
  return folder.file(name);
}

}  // namespace scene_texts
