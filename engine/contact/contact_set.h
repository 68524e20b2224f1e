// The contacts of a step: which bodies may touch each other or a wall, each with the impulses of the step before,
// coloured so that contacts of one colour share no body.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/collide/grid.h"
#include "engine/contact/contact_scene.h"

namespace ballpark::BALLPARK_PRECISION {

/// Impulse on side b [N s].
struct ContactImpulse {
  Real normal = 0;
  Vector3<Real> tangent;
};

/// One contact, as the solver streams it: 112 bytes in double. Effective masses are not kept: a division is cheaper
/// than their bytes.
struct Contact {
  std::uint32_t a = 0, b = 0;  ///< slots, a < b; of a wall's contact, a is the wall
  Vector3<Real> normal;        ///< from a to b
  Real least_speed = 0;        ///< b must leave a at no less, or the gap closes in this substep [m/s]
  Real friction = 0;           ///< mu
  ContactImpulse solved;       ///< what the gap needed in this substep
  ContactImpulse relaxed;      ///< what velocities needed beyond `solved`
  ContactImpulse sum() const { return {solved.normal + relaxed.normal, solved.tangent + relaxed.tangent}; }
  /// Is there any impulse to go on from?
  bool bears() const { return solved.normal != 0 || relaxed.normal != 0; }
  bool loaded() const { return solved.normal + relaxed.normal > 0; }
};

/// Two slots whose surfaces are far enough apart to need no contact, unless one of them is deflected.
using WatchedPair = Pair;

class ContactSet {
 public:
  /// Contacts lie in the order of their colours; the last colour may share bodies and is solved in the order of their
  /// ranks. Contacts with walls are in the order of ranks.
  std::vector<Contact> pairs, walls;
  std::vector<std::size_t> colour_begin;  ///< first contact of each colour, and the end
  bool last_colour_shares = false;
  static constexpr std::uint8_t was_loaded = 1, reflected = 2, touches = 4, approaches = 8, queued = 16;
  std::vector<std::uint8_t> pair_marks, wall_marks;  ///< of each contact in this substep
  std::vector<std::uint32_t> place;                  ///< of each pair in the order of ranks: where it lies in `pairs`
  std::vector<std::uint32_t> first_of_rank;  ///< in the order of ranks: first pair whose a has the rank, and the end
  std::vector<std::uint32_t> first_wall_of_rank;  ///< in `walls`
  std::vector<Real> swept;  ///< farthest that each body may go in the step without being deflected [m]
  std::size_t candidates = 0;

  /// Finds them for a step of length `step`, from bodies at its start. `margin`: how near, over their radii, surfaces
  /// pass each other to be a contact. `nearby`: gets an order of slots in
  /// which near bodies are near, copy after copy, each counted from its first.
  void find(const ContactBodies& bodies, const std::vector<Wall>& walls, const std::vector<WallMoment>& moments,
            const Period& period, const LawTable& laws, Real step, Real margin, Workers& workers,
            std::vector<std::uint32_t>* nearby = nullptr);

  /// Impulses of the last step, to go on from: as plain values, by rank.
  struct Saved {
    std::uint32_t a, b;
    ContactImpulse solved, relaxed;
    Vector3<Real> normal;  ///< for those who ask what contacts bear
  };
  std::vector<Saved> saved_pairs() const;
  std::vector<Saved> saved_walls() const;
  void restore(const std::vector<Saved>& saved_pairs, const std::vector<Saved>& saved_walls, std::size_t slots);

  std::size_t watched_blocks() const { return watched_.size(); }
  std::span<const WatchedPair> watched(std::size_t block) const { return watched_[block]; }
  std::size_t bytes() const;
  /// In the order of ranks: that of b of each pair.
  std::uint32_t other_rank(std::size_t pair) const { return other_[pair]; }

 private:
  /// Impulses of the step before that were not zero.
  struct Carried {
    std::vector<std::uint32_t> first;  ///< of each rank, and the end
    std::vector<std::uint32_t> other;  ///< rank or wall
    struct Impulses {
      ContactImpulse solved, relaxed;
    };
    std::vector<Impulses> impulses;
    std::size_t bytes() const;
  };
  void find_reaches(const ContactBodies& bodies, Real step, Real margin);
  void sift(const ContactBodies& bodies, std::size_t first, const Period& period, Real step, Real margin,
            Workers& workers);
  bool is_contact(const ContactBodies& bodies, const Period& period, Real step, Real margin, Pair pair,
                  std::vector<WatchedPair>& watched) const;
  void remember(const ContactBodies& bodies, Workers& workers);
  template <class At, class Other>
  static void keep_impulses(const ContactBodies& bodies, const std::vector<std::uint32_t>& first, At at, Other other,
                            Carried& kept, Workers& workers);
  void order(const ContactBodies& bodies, std::size_t begin, Workers& workers);
  void colour(const ContactBodies& bodies);
  template <std::size_t n>
  void lay_out(const ContactBodies& bodies, std::array<std::size_t, n>& next);
  void fill(const ContactBodies& bodies, const LawTable& laws, Workers& workers);
  void find_walls(const ContactBodies& bodies, const std::vector<Wall>& shapes, const std::vector<WallMoment>& moments,
                  const LawTable& laws, Real step, Real margin, Workers& workers);
  Contact wall_contact(const ContactBodies& bodies, const std::vector<Wall>& shapes, const LawTable& laws,
                       std::uint32_t wall, std::uint32_t slot) const;

  Grid grid_;
  std::vector<Real> grid_radius_;
  std::vector<std::uint32_t> fast_;  ///< bodies that go too far in a step for the grid
  std::vector<std::uint8_t> is_fast_;
  std::size_t lists_ = 0;                     ///< of candidates in this step: blocks of each copy, and fast bodies
  std::vector<std::vector<Pair>> fast_near_;  ///< contacts of each fast body, by slot in its copy
  std::vector<std::vector<WatchedPair>> watched_;
  std::vector<std::uint32_t> other_;           ///< in the order of ranks: that of b of each pair
  std::vector<Real> wall_ways_;                ///< farthest that each wall may go in the step [m]
  std::vector<std::vector<Pair>> near_walls_;  ///< wall and slot, of each block of slots
  std::vector<std::uint64_t> used_;            ///< colours of each slot
  Carried carried_, carried_walls_;
};

}  // namespace ballpark::BALLPARK_PRECISION
