// The passes of contacts, and what they cost a body that touches nothing.
#include <algorithm>

#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

void ImpulseStep::explain(const std::vector<Group>& groups, Explanation& all) const {
  all.contact = report;
  all.contact.bytes = solver.bytes();
  const std::vector<PassReport> smooth = std::move(all.passes);
  all.passes.clear();
  std::vector<PassReport> before, after;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!holds(g)) continue;
    const bool spins = solver.bodies.spins && groups[g].spins();
    std::vector<std::string> state{"position", "velocity"};
    if (spins) state.push_back("angular_momentum");
    const double bytes = (spins ? 9 : 6) * static_cast<double>(sizeof(Real));
    before.push_back({"read_contacts",
                      groups[g].name,
                      state,
                      {"slots"},
                      2 * bytes,
                      0,
                      2 * substeps,
                      "the start of a substep, and its trial, in the order of ids"});
    after.push_back({"write_contacts",
                     groups[g].name,
                     {"slots"},
                     state,
                     2 * bytes,
                     0,
                     substeps,
                     "what contacts have made of the trial"});
  }
  const std::string everyone = "all that touch";
  before.push_back({"find_contacts",
                    everyone,
                    {"slots"},
                    {"pairs", "contacts"},
                    0,
                    0,
                    1,
                    "uniform grid, swept distances, colours; its bytes depend on the pairs"});
  const std::string depends = "; its bytes depend on the contacts";
  after.insert(after.begin(), {{"reflect_impacts",
                                everyone,
                                {"slots", "contacts"},
                                {"contacts"},
                                0,
                                0,
                                substeps,
                                "generalised reflections of what meets and approaches" + depends},
                               {"solve_contacts",
                                everyone,
                                {"contacts"},
                                {"contacts", "slots"},
                                0,
                                0,
                                substeps,
                                "coloured Gauss-Seidel: surfaces stay apart" + depends},
                               {"relax_contacts",
                                everyone,
                                {"contacts"},
                                {"contacts", "slots"},
                                0,
                                0,
                                substeps,
                                "loaded contacts hold velocities" + depends}});
  for (const auto* part : std::initializer_list<const std::vector<PassReport>*>{&before, &smooth, &after})
    all.passes.insert(all.passes.end(), part->begin(), part->end());
}

void PenaltyStep::explain(const std::vector<Group>& groups, Explanation& all) const {
  all.contact = report;
  all.contact.bytes = penalty.bytes();
  const std::string everyone = "all that touch";
  all.passes.insert(all.passes.begin(), {"keep_neighbours",
                                         everyone,
                                         {"position", "velocity"},
                                         {"neighbours"},
                                         0,
                                         0,
                                         1,
                                         "pairs within a skin; searched anew in a uniform grid when a body has used up "
                                         "its share of it"});
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!holds(g)) continue;
    const bool spins = penalty.bodies.spins && groups[g].spins();
    std::vector<std::string> state{"trial_position", "trial_velocity"}, sums{"force"};
    if (spins) state.push_back("trial_angular_momentum"), sums.push_back("torque");
    const double values = (spins ? 9 : 6) * 2 + (spins ? 6 : 3) * 3;
    all.passes.push_back({"press_contacts", groups[g].name, state, sums, values * sizeof(Real), 0, phases,
                          "springs and dashpots, each once, then summed by every body in the order of ids; beside "
                          "these bytes, those of the neighbours"});
  }
  all.passes.push_back({"finish_contacts",
                        everyone,
                        {"contacts"},
                        {"contacts"},
                        0,
                        0,
                        1,
                        "tangential springs move on by the rates of the phases"});
}

}  // namespace ballpark::BALLPARK_PRECISION
