// `--set key=value`: changes the document before anything is read from it.
#pragma once

#include <vector>

#include "scenarios/files/document.h"
#include "scenarios/files/findings.h"

namespace ballpark::scenes {

void apply(const std::vector<Override>& overrides, Node& document, Findings& findings);

}  // namespace ballpark::scenes
