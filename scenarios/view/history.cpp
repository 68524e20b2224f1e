#include "scenarios/view/history.h"

#include <algorithm>
#include <chrono>

namespace ballpark::view {
namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

constexpr const char* pace = "time per body-step";

}  // namespace

// Those of one unit stand together: a figure draws them on one scale.
History::History(const Scene& scene, bool ledger)
    : touching_(!scene.contact.kind.empty()), ledger_(ledger), substeps_(std::max(1, scene.contact.substeps)) {
  series_ = {{"energy", "J", {}},
             {"kinetic energy", "J", {}},
             {"potential energy", "J", {}},
             {"momentum", "kg m/s", {}},
             {"angular momentum", "kg m^2/s", {}}};
  if (touching_) {
    series_.push_back({"deepest penetration so far", "m", {}});
    series_.push_back({"contacts", "", {}});
  }
  if (ledger_) series_.push_back({"integrator error", "J", {}});
  series_.push_back({pace, "ns", {}});
}

/// Lines of causes, behind all others: as many as the first sample has.
void History::add(const Ledger& ledger) {
  std::size_t at = series_.size() - (times_.empty() ? 0 : ledger.lines.size());
  for (const LedgerLine& line : ledger.lines) {
    if (times_.empty()) series_.push_back({"work of " + line.name, "J", {}});
    series_[at++].values.push_back(line.work);
  }
}

void History::add(const World& world) {
  const double entered = now();
  const Totals totals = world.totals();
  const Counters counted = world.counters();
  const double steps = static_cast<double>(counted.steps - before_.steps);
  const double body_steps = steps * static_cast<double>(world.body_count());
  std::vector<double> values{totals.energy(), totals.kinetic, totals.potential, totals.momentum.norm(),
                             totals.angular_momentum.norm()};
  if (touching_) {
    const double loaded = static_cast<double>(counted.contacts - before_.contacts), substeps = steps * substeps_;
    values.push_back(counted.max_penetration);
    values.push_back(substeps > 0 ? loaded / substeps : 0);
  }
  if (ledger_) values.push_back(world.ledger().integrator_error());
  values.push_back(body_steps > 0 ? 1e9 * (entered - left_) / body_steps : 0);
  for (std::size_t i = 0; i < values.size(); ++i) series_[i].values.push_back(values[i]);
  if (ledger_) add(world.ledger());
  times_.push_back(world.time());
  before_ = counted;
  go_on();
}

void History::go_on() {
  left_ = now();
}

std::vector<Series> History::take() {
  for (Series& series : series_) {  // no step came before the first sample
    if (series.name == pace && series.values.size() > 1) series.values[0] = series.values[1];
  }
  return std::move(series_);
}

}  // namespace ballpark::view
