// The last line against tunnelling: a body that contacts have deflected may meet one that it was not going to meet. Its
// motion then ends where they touch; it keeps its velocity, and the next step finds the contact.
#include <algorithm>
#include <atomic>
#include <cmath>

#include "engine/contact/impulse_solver.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {
constexpr int most_passes = 8;
}

/// Marks the bodies that leave the way they were expected to go, and ends motions where nothing was looked for.
bool ImpulseSolver::find_deflected(Real substep, Workers& workers) {
  std::atomic<bool> any = false;
  const bool first = settings.substeps == 1;
  const VectorColumn &start = first ? bodies.position : start_, &planned = first ? bodies.velocity : planned_;
  for_slots(workers, [&](std::size_t i) {
    const Vector3<Real> from_start = bodies.position.at(i) - start.at(i), motion = substep * movers_[i].velocity;
    const Vector3<Real> off = from_start + motion - elapsed_ * planned.at(i);
    const Real free = settings.margin * bodies.radius[i];
    deflected_[i] = dot(off, off) > free * free;
    if (!deflected_[i]) return;
    any.store(true, std::memory_order_relaxed);
    share_[i] = moment_beyond(from_start, motion, set_.swept[i] + free);
  });
  return any;
}

void ImpulseSolver::hold_back(Real substep, Workers& workers) {
  for (auto* list : {&share_, &shorter_}) list->resize(bodies.count);
  for (auto* list : {&deflected_, &next_deflected_}) list->resize(bodies.count);
  std::fill(share_.begin(), share_.end(), Real(1));
  if (!find_deflected(substep, workers)) return;
  for (int pass = 0; shorten(substep); ++pass) {
    if (pass < most_passes) continue;
    ++counters_.missed;
    break;
  }
  for (const Real share : share_) counters_.held_back += share < 1;
}

/// Ends motions that meet where they do; true if any was. All pairs are held against the same motions, so that their
/// order does not matter.
bool ImpulseSolver::shorten(Real substep) {
  shorter_ = share_;
  next_deflected_ = deflected_;
  bool any = false;
  for (std::size_t block = 0; block < set_.watched_blocks(); ++block) {
    for (const WatchedPair& pair : set_.watched(block)) {
      if (!deflected_[pair.a] && !deflected_[pair.b]) continue;
      const Real free = free_share(pair, substep);
      if (!(free < 1)) continue;
      for (const std::uint32_t slot : {pair.a, pair.b}) {
        shorter_[slot] = std::min(shorter_[slot], share_[slot] * free);
        next_deflected_[slot] = 1;  // what follows it may now run into it
      }
      any = true;
    }
  }
  share_.swap(shorter_);
  deflected_.swap(next_deflected_);
  return any;
}

/// How much of what they may still do two bodies can do before they touch.
Real ImpulseSolver::free_share(const WatchedPair& pair, Real substep) const {
  const auto [a, b] = pair;
  const Vector3<Real> apart = nearest_image(bodies.position.at(b) - bodies.position.at(a), period);
  const Vector3<Real> moved = (share_[b] * substep) * movers_[b].velocity - (share_[a] * substep) * movers_[a].velocity;
  if (!(dot(moved, moved) > 0)) return 1;
  bool meets = false;
  const Real moment = moment_within(apart, moved, bodies.radius[a] + bodies.radius[b], meets);
  return meets && dot(apart, moved) < 0 ? moment : Real(1);
}

}  // namespace ballpark::BALLPARK_PRECISION
