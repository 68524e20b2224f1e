// How bodies are shared out among tasks.
#include <algorithm>

#include "engine/world/build.h"

namespace ballpark::BALLPARK_PRECISION {

/// Blocks never straddle groups.
void Part::add(std::size_t group, std::size_t first, std::size_t last) {
  for (; first < last; first += block_length) blocks.push_back({group, first, std::min(first + block_length, last)});
  moved.resize(blocks.size());
}

void Builder::add_blocks() {
  std::size_t all_rows = 0;
  for (std::size_t g = 0; g < world_.groups_.size(); ++g) {
    world_.whole_.add(g, 0, world_.groups_[g].live);
    all_rows += padded(world_.groups_[g].live);
  }
  world_.whole_.copies = {0, world_.copies_};
  world_.whole_.alone = all_rows <= block_length;
  if (!world_.fused_ && scene_.contact.kind != "penalty") add_parts();
  world_.arrange_rates();
}

void Builder::add_implicit() {
  if (world_.row_->family != Family::implicit_runge_kutta) return;
  if (!world_.not_differentiated_.empty()) {
    const bool coupled = !world_.pair_systems_.empty() || scene_.contact.kind == "penalty";
    world_.fixed_point_ = std::make_unique<FixedPoint>(world_.groups_, world_.copies_, coupled);
    return;
  }
  world_.implicit_ =
      std::make_unique<ImplicitStep>(*world_.row_, world_.groups_, world_.pair_systems_, block_length,
                                     [this](const Group& group, std::size_t row) { return world_.id_of(group, row); });
}

/// Few bodies, which stay in cache for all of a step: some copies, whose rows in each group begin with a cache line and
/// so with a vector.
void Builder::add_parts() {
  constexpr std::size_t enough_rows = 64, line = cache_line / sizeof(Real);
  const std::size_t rows = line * std::max<std::size_t>(world_.per_copy_, 1);
  const std::size_t length = line * ((enough_rows + rows - 1) / rows);
  if (length >= world_.copies_ || length * world_.per_copy_ > block_length) return;
  for (std::size_t first = 0; first < world_.copies_; first += length) {
    Part& part = world_.parts_.emplace_back();
    part.alone = true;
    part.copies = {first, std::min(first + length, world_.copies_)};
    for (std::size_t g = 0; g < world_.groups_.size(); ++g) {
      const std::size_t bodies = world_.groups_[g].copies.per_copy;
      part.add(g, part.copies.first * bodies, part.copies.last * bodies);
    }
  }
  world_.moved_.resize(world_.parts_.size());
}

}  // namespace ballpark::BALLPARK_PRECISION
