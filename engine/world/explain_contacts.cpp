// The passes of contacts, and what they cost a body that touches nothing.
#include <algorithm>

#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

void ContactStep::explain(const std::vector<Group>& groups, Explanation& all) const {
  all.contact = report;
  all.contact.bytes = solver.bytes();
  const std::vector<PassReport> smooth = std::move(all.passes);
  all.passes.clear();
  std::vector<PassReport> before, after;
  const auto touching = [&](std::size_t g) {
    return std::any_of(ranges.begin(), ranges.end(), [g](const SlotRange& range) { return range.group == g; });
  };
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!touching(g)) continue;
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

}  // namespace ballpark::BALLPARK_PRECISION
