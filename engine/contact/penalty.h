// The `penalty` formulation: contacts push back by springs and dashpots, as forces in the integrator's own stages. How
// far surfaces have slid is state of the contact with a rate of its own, advanced by the same stages.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include "engine/collide/neighbour_list.h"
#include "engine/contact/contact_scene.h"
#include "engine/contact/penalty_law.h"

namespace ballpark::BALLPARK_PRECISION {

struct PenaltySettings {
  Real stiffness = 0;        ///< along the normal [N/m]
  Real slide_stiffness = 0;  ///< of the tangential spring [N/m]
  Real margin = Real(0.2);   ///< skin of the neighbour list, over the radii
  bool may_pull = false;     ///< dashpots: may they hold parting surfaces together?
};

struct PenaltyCounters {
  std::uint64_t pairs = 0, contacts = 0;  ///< summed over steps: neighbours; contacts that touch
  std::uint64_t peak_pairs = 0, peak_contacts = 0;
  std::uint64_t lists = 0;       ///< how often the neighbours were searched anew
  std::uint64_t stepped = 0;     ///< bodies with neighbours that went farther than their radius in a step
  Real deepest = 0;              ///< [m]
  Real spring = 0, damping = 0;  ///< per mass: bounds over the contact network, the most [1/s^2, 1/s]
};

class Penalty : public ContactScene {
 public:
  PenaltySettings settings;
  VectorColumn force;   ///< on each slot in the phase [N]
  VectorColumn moment;  ///< and its moment about the centre over the radius [N]

  /// What does not change after build: dampings of all pairs of materials.
  void prepare();
  /// Stiffness and damping per mass of the two bodies, or of the body and a wall, that swing fastest [1/s^2, 1/s].
  struct Bound {
    double spring = 0, damping = 0;
  };
  Bound stiffest_pair() const;
  /// Neighbours for a step of length h, from the bodies at its start.
  void begin(double time, Real h, Workers& workers);
  /// The step is not taken: tangential springs and counters are as begin() found them.
  void take_back();
  bool returns = false;  ///< may steps be taken back?
  /// Forces on bodies as `bodies` has them in a phase. Tangential springs have moved by the rates of the phases before
  /// it, each times its element of `stage` [s]; of a splitting, whose springs drift with the positions, by none.
  void find_forces(std::span<const Real> stage, bool first_phase, double time, Workers& workers);
  /// Tangential springs move by the rates of all phases, each times its weight [s].
  void finish(std::span<const Real> weights, Workers& workers);
  /// Tangential springs move for a time h [s] by the slip of bodies as `bodies` has them, in the middle of the drift.
  void drift(Real h, Workers& workers);
  /// Energy in all springs, of bodies as `bodies` has them [J].
  double energy(double time, Workers& workers);
  /// Of each body, by rank, as `bodies` has them.
  std::vector<BodyLoad> loads(double time, Workers& workers);
  /// State between steps as bytes; false if they do not fit these bodies and walls.
  std::vector<std::byte> save() const;
  bool restore(const std::vector<std::byte>& bytes);

  const PenaltyCounters& counters() const { return counters_; }
  PenaltyCounters& counters() { return counters_; }
  std::size_t bytes() const;

 private:
  /// Contacts of one kind: between bodies, or of bodies with walls.
  struct Contacts {
    std::vector<SpringDashpot> laws;
    std::vector<std::uint8_t> touches;
    std::vector<Vector3<Real>> forces, twists;  ///< on b [N]; times the normal, for a lever of the whole radius
    std::vector<Vector3<Real>> slid;            ///< tangential springs [m]
    std::vector<Vector3<Real>> before;          ///< and as they were when the step began
    std::vector<Vector3<Real>> rates;           ///< of phase p: from p times the contacts on [m/s]
    std::size_t size() const { return laws.size(); }
    void resize(std::size_t n, bool slides);
    std::size_t bytes() const;
  };
  /// What a contact remembers while lists change.
  struct Memory {
    std::uint32_t a, b;  ///< slots; of a wall's contact, a is the wall
    Vector3<Real> slid;
  };
  struct Memories {
    std::vector<Memory> pairs, walls;  ///< by a and b; by b and a
  };
  /// Sums over one block of slots.
  struct Part {
    std::uint64_t contacts = 0, stepped = 0;
    Real deepest = 0, spring = 0, damping = 0;
  };
  /// A contact in a phase, and what turns with it.
  struct Meeting {
    Touch touch;
    Real lever = 1;         ///< distance of the contact from a body's centre, in radii
    Vector3<Real> turning;  ///< rate of the normal [1/s]
    Vector3<Real> spin;     ///< of the spring about the normal [rad/s]
  };
  /// What friction holds on b, and how much of the spring remains when it slips.
  struct Held {
    Vector3<Real> force;
    Real share = 1;
  };
  struct Load {
    std::uint32_t contacts = 0;
    Real damping = 0;  ///< of all of them per mass, along or across the normal [1/s]
  };

  /// radius: R1 R2 / (R1 + R2) of a pair.
  SpringDashpot law_of(std::uint16_t material, std::uint16_t other, Real inverse_mass, Real mobility,
                       Real radius) const;
  Real stiffness_per_mass(std::size_t slot) const;
  Real damping_per_mass(const SpringDashpot& law, std::size_t slot) const;
  void keep_list(double time, Real h, Workers& workers);
  void list(double time, Workers& workers);
  void set_laws();
  void list_walls(double time);
  void remember(Memories& all) const;
  void recall();
  void set_moments(double time);
  bool meets(std::size_t a, std::size_t b, Meeting& meeting) const;
  bool meets_wall(std::size_t wall, std::size_t slot, Meeting& meeting) const;
  /// Calls act(contacts, index, does it touch?, meeting) for the contacts that slots have as a, and with walls.
  template <class Act>
  void for_meetings(std::size_t first, std::size_t last, Act act);
  static Vector3<Real> slide_rate(const Meeting& meeting, const Vector3<Real>& slid);
  Held bear(Contacts& contacts, std::size_t i, const Meeting& meeting, const Vector3<Real>& slid);
  void press(Contacts& contacts, std::size_t i, std::span<const Real> stage, bool touching, const Meeting& meeting);
  void touch_all(std::span<const Real> stage, std::size_t first, std::size_t last, Part& part);
  void sum(std::size_t slot);
  void bound(std::size_t first, std::size_t last, Part& part) const;
  /// act(first slot, last slot, part) for blocks of slots.
  template <class Act>
  void for_blocks(Workers& workers, Act act) {
    constexpr std::size_t length = 1024;
    const std::size_t blocks = (bodies.count + length - 1) / length;
    parts_.assign(blocks, {});
    const auto task = [&](std::size_t b) { act(b * length, std::min((b + 1) * length, bodies.count), parts_[b]); };
    workers.for_each(blocks, task, blocks < 2 ? 1 : workers.threads());
  }

  NeighbourList list_;
  Contacts pairs_, walls_;
  std::vector<std::uint32_t> first_wall_, wall_;  ///< of each slot: the walls near it
  std::vector<WallMoment> moments_;
  std::vector<Real> allowance_, ahead_;  ///< [m]
  std::vector<double> ratios_;           ///< damping ratio of each pair of materials, as in `laws`
  std::vector<Load> loads_;              ///< of each slot
  std::vector<Part> parts_;
  Memories known_;  ///< while the list changes
  bool was_restored_ = false;
  double listed_at_ = 0;
  PenaltyCounters counters_, counters_before_;
};

template <class Act>
void Penalty::for_meetings(std::size_t first, std::size_t last, Act act) {
  for (std::size_t slot = first; slot < last; ++slot) {
    for (std::uint32_t i = list_.first[slot]; i < list_.first[slot + 1]; ++i) {
      Meeting meeting;
      const bool touching = meets(slot, list_.other[i], meeting);
      act(pairs_, i, touching, meeting);
    }
    for (std::uint32_t i = first_wall_[slot]; i < first_wall_[slot + 1]; ++i) {
      Meeting meeting;
      const bool touching = meets_wall(wall_[i], slot, meeting);
      act(walls_, i, touching, meeting);
    }
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
