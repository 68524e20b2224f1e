// Neighbours of effects between bodies that end at a cut-off: found in the grid and kept with a skin, copy by copy. Of
// few bodies all are neighbours, always.
#pragma once

#include "engine/collide/neighbour_list.h"
#include "engine/effects/pair_effect.h"

namespace ballpark::BALLPARK_PRECISION {

class PairNeighbours : public Neighbours {
 public:
  static constexpr std::size_t few = 64;  ///< bodies of a copy, among which a search costs more than it spares

  PairNeighbours(Real reach, std::size_t count, std::size_t copies, const Period& period);
  void follow(const PairBodies& bodies, Workers& workers) override;
  std::span<const std::uint32_t> of(std::size_t copy, std::size_t slot) const override {
    return (kept_.empty() ? all_ : kept_[copy].near).of(slot);
  }
  bool searches() const override { return !kept_.empty(); }

 private:
  struct Near {
    std::vector<std::uint32_t> first, other;  ///< of each slot: its first neighbour, and the end
    std::span<const std::uint32_t> of(std::size_t slot) const {
      return {other.data() + first[slot], other.data() + first[slot + 1]};
    }
  };
  struct Kept {
    VectorColumn position;  ///< where the bodies are now
    NeighbourList list;
    Near near;
  };
  void follow(const PairBodies& bodies, std::size_t copy, Workers& workers);
  static void list_both(const NeighbourList& list, Near& near);

  Period period_;
  std::size_t count_;
  std::vector<Real> radius_, skin_, ahead_;  ///< of each body: half of the reach, half of the skin, nothing
  Near all_;
  std::vector<Kept> kept_;  ///< of each copy; none: all are neighbours
};

}  // namespace ballpark::BALLPARK_PRECISION
