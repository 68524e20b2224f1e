// What contacts do to each body, on demand: nothing of it is kept, and no bit of the motion depends on it.
#include "engine/contact/impulse_solver.h"
#include "engine/contact/penalty.h"

namespace ballpark::BALLPARK_PRECISION {

std::vector<BodyLoad> ImpulseSolver::loads() const {
  std::vector<BodyLoad> all(bodies.count);
  if (!(last_substep_ > 0)) return all;  // no step yet
  const auto force = [&](const Contact& contact) {
    const ContactImpulse impulse = contact.sum();
    return (1 / last_substep_) * (impulse.normal * contact.normal + impulse.tangent);
  };
  for (std::size_t rank = 0; rank + 1 < set_.first_of_rank.size(); ++rank) {
    for (std::uint32_t i = set_.first_of_rank[rank]; i < set_.first_of_rank[rank + 1]; ++i) {
      const Contact& contact = set_.pairs[set_.place[i]];
      if (!contact.loaded()) continue;
      all[rank].add(Real(-1) * force(contact));
      all[set_.other_rank(i)].add(force(contact));
    }
  }
  for (std::size_t rank = 0; rank + 1 < set_.first_wall_of_rank.size(); ++rank) {
    for (std::uint32_t i = set_.first_wall_of_rank[rank]; i < set_.first_wall_of_rank[rank + 1]; ++i) {
      if (set_.walls[i].loaded()) all[rank].add(force(set_.walls[i]));
    }
  }
  return all;
}

/// Forces, touches and loads are written anew in every phase: here they are scratch.
std::vector<BodyLoad> Penalty::loads(double time, Workers& workers) {
  keep_list(time, 0, workers);
  set_moments(time);
  for_meetings(0, bodies.count, [&](Contacts& contacts, std::size_t i, bool touching, const Meeting& meeting) {
    contacts.touches[i] = touching;
    if (!touching) return;
    const Vector3<Real> spring = contacts.slid.empty() ? Vector3<Real>{} : contacts.slid[i];
    bear(contacts, i, meeting, spring - dot(spring, meeting.touch.normal) * meeting.touch.normal);
  });
  std::vector<BodyLoad> all(bodies.count);
  for (std::size_t slot = 0; slot < bodies.count; ++slot) {
    sum(slot);
    all[bodies.rank_of(slot)] = {loads_[slot].contacts, force.at(slot)};
  }
  return all;
}

}  // namespace ballpark::BALLPARK_PRECISION
