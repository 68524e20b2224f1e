// Reads the document's tables into a draft, by the key table.
#pragma once

#include "scenarios/files/document.h"
#include "scenarios/files/draft.h"
#include "scenarios/files/findings.h"

namespace ballpark::scenes {

void read_tables(const Node& document, Draft& draft, Findings& findings);

}  // namespace ballpark::scenes
