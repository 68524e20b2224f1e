// The energy ledger as people read it.
#pragma once

#include "ballpark/report.h"
#include "scenarios/command/page.h"

namespace ballpark::command {

/// A table: causes, what each did, and what is left for the integrator.
void add_ledger(Page& text, const Ledger& ledger);

}  // namespace ballpark::command
