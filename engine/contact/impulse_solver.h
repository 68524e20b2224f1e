// The `impulse` formulation: what contacts make of one substep's smooth motion. First order, whatever the integrator:
// impacts are taken at the start of the substep in which the surfaces meet.
#pragma once

#include <algorithm>

#include "engine/contact/impacts.h"
#include "engine/contact/rows.h"

namespace ballpark::BALLPARK_PRECISION {

/// Numbers of a contact step that the scene chooses.
struct ImpulseSettings {
  std::size_t sort_from = 16384;  ///< bodies from which on their order in memory matters
  std::size_t sort_every = 32;    ///< steps
  int substeps = 1;               ///< of a step, for which contacts are found once
  int iterations = 12;
  int relax_iterations = 3;
  Real margin = Real(0.2);         ///< a contact: surfaces that pass at less than this share of their radii
  Real push_out = Real(0.2);       ///< share of an overlap that one substep takes away
  Real restitution_threshold = 0;  ///< [m/s]
};

/// What the contact passes counted, over the run.
struct ContactCounters {
  std::uint64_t pairs = 0, contacts = 0;  ///< summed over steps: candidates; contacts that bore a load
  std::uint64_t peak_pairs = 0, peak_contacts = 0;
  std::uint64_t impacts = 0;             ///< reflections
  std::uint64_t impact_rounds = 0;       ///< of generalised reflections, the most in a substep
  std::uint64_t unfinished_impacts = 0;  ///< left to the solver after the last round
  std::uint64_t held_back = 0;           ///< motions cut short, so that nothing is missed
  std::uint64_t missed = 0;              ///< overlaps that holding back could not prevent
  int colours = 0;                       ///< the most
  Real deepest = 0;                      ///< overlap at the start of a substep [m]
  Real residual = 0;  ///< largest error in a normal speed that the last update found [m/s], last substep
};

inline constexpr std::size_t slots_per_task = 2048;

class ImpulseSolver : public ContactScene {
 public:
  ImpulseSettings settings;

  /// Before a step, and before bodies are read: moves them to better slots, now and then.
  void sort_bodies();
  /// Contacts of a step of length `step`, from bodies at its start.
  void find(double time, Real step, Workers& workers);
  // Turn the trial of a substep (end_... of the bodies) into what contacts allow, in this order:
  /// Impacts: contacts that meet and approach are reflected.
  void reflect(double time, Real substep, Workers& workers);
  /// What still closes is stopped where it touches: positions at the end.
  void solve(Workers& workers);
  /// Loaded contacts hold velocities: velocities at the end.
  void relax(Workers& workers);
  /// Of each body, by rank, in the last substep: a mean force, without impacts, which take no time.
  std::vector<BodyLoad> loads() const;
  /// What the next step needs of the last one beside the bodies' state, as bytes.
  std::vector<std::byte> save() const;
  /// False if the bytes do not fit these bodies and walls; then nothing has changed.
  bool restore(const std::vector<std::byte>& bytes);

  const ContactCounters& counters() const { return counters_; }
  ContactCounters& counters() { return counters_; }
  std::size_t bytes() const;

 private:
  void set_moments(double time, Real substep);
  void prepare(Real substep, Workers& workers);
  Vector3<Real> mean_velocity(std::size_t slot) const;
  Vector3<Real> mean_surface(std::size_t slot) const;
  void start_movers(Workers& workers);
  /// Calls act(contact, side a, mover b) for all contacts, colour after colour; returns the largest result.
  template <class Act>
  Real sweep(Act act, Workers& workers);
  template <bool friction>
  void keep_apart(Workers& workers);
  Vector3<Real> end_velocity(std::size_t slot) const;
  bool settles(const Contact& contact, std::uint8_t mark, bool wall) const;
  void mark_approaches(Workers& workers);
  template <class Act>
  void for_contacts(Workers& workers, Act act);
  void choose_held(Workers& workers);
  void advance_bodies(Real substep, Workers& workers);
  /// act(slot) for all, on all threads.
  template <class Act>
  void for_slots(Workers& workers, Act act) const {
    const std::size_t count = bodies.count, tasks = (count + slots_per_task - 1) / slots_per_task;
    const auto task = [&](std::size_t t) {
      for (std::size_t i = t * slots_per_task; i < std::min((t + 1) * slots_per_task, count); ++i) act(i);
    };
    workers.for_each(tasks, task, tasks < 2 ? 1 : workers.threads());
  }
  template <bool friction>
  void settle(Workers& workers);
  void finish(Workers& workers);
  // hold_back.cpp
  void hold_back(Real substep, Workers& workers);
  bool find_deflected(Real substep, Workers& workers);
  bool shorten(Real substep);
  Real free_share(const WatchedPair& pair, Real substep) const;

  ContactSet set_;
  std::vector<std::uint32_t> nearby_;  ///< order of slots that the next step shall have; empty: as it is
  std::size_t found_ = 0;              ///< steps for which contacts were found
  Impacts impacts_;
  std::vector<WallMoment> moments_;
  std::vector<Mover> movers_;
  std::vector<WallSide> wall_sides_;  ///< mean velocity of each wall's surface over the substep; then at its end
  std::vector<std::vector<std::uint32_t>> closing_;  ///< contacts that impacts begin with, by block
  std::vector<Real> block_maximum_;
  VectorColumn start_, planned_;       ///< of several substeps: positions and velocities when contacts were found
  Real elapsed_ = 0;                   ///< since then, at the end of this substep [s]
  std::vector<Real> share_, shorter_;  ///< of its motion in the substep that each body does
  std::vector<std::uint8_t> deflected_, next_deflected_;
  Real last_substep_ = 0;
  ContactCounters counters_;
};

}  // namespace ballpark::BALLPARK_PRECISION
