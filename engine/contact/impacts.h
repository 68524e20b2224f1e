// Impacts of a substep by generalised reflections: all contacts that meet and approach are reflected together,
// connected set by connected set, and again until none approaches; a body that meets several one after the other, in
// that order. (Smith, Kaufman, Vouga, Tamstorf & Grinspun 2012, ACM Trans. Graph. 31, 106: Reflections on simultaneous
// impact, section 5.) A touching row passes an impact from ball to ball, a symmetric one stays symmetric, and at
// restitution 1 energy is kept.
#pragma once

#include "engine/contact/rows.h"

namespace ballpark::BALLPARK_PRECISION {

/// The substep in which impacts happen.
struct Substep {
  const ContactBodies& bodies;
  const std::vector<Wall>& walls;
  const std::vector<WallMoment>& moments;
  const LawTable& laws;
  const Period& period;
  Real length;                 ///< h [s]
  Real push_out;               ///< share of an overlap that it takes away
  Real restitution_threshold;  ///< slower approaches end at restitution 0 [m/s]

  /// Normal and least speed of a contact whose sides' motion impacts have changed by these velocities. Returns when
  /// they meet, as a share of the substep: 0 if they touch, above 1 if they do not.
  Real place(Contact& contact, bool wall, const Vector3<Real>& kick_a, const Vector3<Real>& kick_b) const;
  /// Motion of a body in the substep without contacts.
  Vector3<Real> trial(std::size_t slot) const { return bodies.end_position.at(slot) - bodies.position.at(slot); }
};

class Impacts {
 public:
  /// Contact i < pairs.size() is pair i in the order of ranks; those behind are contacts with walls.
  using Index = std::uint32_t;

  /// For one substep. What impacts add to velocities and surface speeds goes into the movers of the bodies that they
  /// touch; those of the others hold nothing yet.
  void begin(const ContactBodies& bodies, std::vector<Mover>& movers);
  bool touches(std::size_t slot) const { return is_touched_[slot]; }
  Vector3<Real> kick_of(std::size_t slot) const { return touches(slot) ? (*movers_)[slot].velocity : Vector3<Real>{}; }
  /// Reflects `first`, then what that sets in motion.
  void resolve(const Substep& substep, ContactSet& set, const std::vector<std::vector<Index>>& first, Workers& workers);
  void forget_neighbours() { neighbours_known_ = false; }

  std::uint64_t count = 0, rounds = 0, unfinished = 0;  ///< of the last call
  std::size_t bytes() const;

 private:
  /// One contact that approaches, while its set is solved.
  struct Meeting {
    Index index;
    const Contact* contact;
    Real normal_mass, tangent_mass;  ///< impulse per speed [kg]
    Real base;                       ///< normal speed but for the kicks; a loaded contact is held: 0
    Real moment;                     ///< at which they meet, as a share of the substep
    Real wanted;                     ///< speed at which the sides part: e times that at which they met
    Real impulse = 0;                ///< of this round
    Vector3<Real> tangent;
    Vector3<Real> drift;  ///< slip but for the kicks
    std::uint32_t set = 0;
  };
  /// A contact that meets and approaches: when and how fast.
  struct Hit {
    Index index;
    Real moment, approach;
  };
  struct Found {
    std::vector<Hit> hits;  ///< of a block of contacts
    std::uint64_t unfinished = 0;
  };
  void find_meetings(const Substep& substep, ContactSet& set, Workers& workers);
  bool approaches(const Substep& substep, ContactSet& set, Index index, Hit& hit, std::uint64_t& given_up) const;
  Meeting meeting_of(const Substep& substep, const ContactSet& set, const Hit& hit);
  void find_neighbours(const ContactSet& set);
  void gather_next(ContactSet& set);
  std::uint8_t& mark_of(ContactSet& set, Index index) const;
  void keep_first();
  void split_into_sets();
  std::uint32_t root(std::uint32_t slot);
  void reflect(std::size_t first, std::size_t last);
  /// Marks the contacts of a set as reflected, and counts what that cost its bodies.
  void spend(ContactSet& set, std::size_t first, std::size_t last);
  Real update(Meeting& meeting);
  /// Velocity of b over a (a body or a wall) without any kick.
  static Vector3<Real> start_over(const Substep& substep, const Contact& contact, bool wall);
  bool is_wall(Index index) const { return index >= pair_count_; }
  void touch(std::uint32_t slot, Real approach);

  const ContactBodies* bodies_ = nullptr;
  std::vector<Mover>* movers_ = nullptr;
  std::vector<std::uint32_t> touched_;
  std::size_t pair_count_ = 0;
  std::vector<Meeting> meetings_;
  std::vector<Found> found_;
  std::vector<Hit> hits_;
  std::vector<std::uint32_t> sorted_;  ///< meetings in the order of their sets
  std::vector<Index> next_, later_;
  std::vector<float> earliest_;  ///< moment at which each body of a round meets another
  std::vector<std::uint8_t> is_touched_;
  std::vector<float> scale_;          ///< of each touched body: the fastest approach that it took part in
  std::vector<std::uint32_t> spent_;  ///< by each touched body, see most_spent
  std::vector<std::uint32_t> changed_, parent_, set_of_root_, set_begin_;
  bool neighbours_known_ = false;
  std::vector<std::uint32_t> before_begin_, before_;  ///< pairs in which a rank is b
};

}  // namespace ballpark::BALLPARK_PRECISION
