#include "engine/world/implicit_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// d of A^T d = b. (Hairer & Wanner, Solving ODEs II, eq. IV.8.2b; A has leading minors other than zero.)
std::vector<Real> weights_of(const Row& row) {
  const auto n = static_cast<std::size_t>(row.phases);
  std::vector<std::vector<long double>> a(n, std::vector<long double>(n));
  std::vector<long double> d(row.b, row.b + n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) a[i][j] = row.a[j][i];
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const long double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      d[i] -= factor * d[k];
    }
  }
  std::vector<Real> weights;
  for (std::size_t i = 0; i < n; ++i) weights.push_back(static_cast<Real>(d[i] / a[i][i]));
  return weights;
}

/// Sets that grow together.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[of(a)] = of(b); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

void StageTally::add(const StageResult& result, std::size_t id) {
  iterations += static_cast<std::uint64_t>(result.iterations);
  most = std::max(most, result.iterations);
  const bool known = !std::isnan(result.residual);
  residual = std::max(residual, known ? static_cast<double>(result.residual) : std::numeric_limits<double>::infinity());
  if (!result.converged && (!failed || id < failed_id)) failed = result, failed_id = id;
}

void StageTally::add(const StageTally& other) {
  iterations += other.iterations;
  most = std::max(most, other.most);
  residual = std::max(residual, other.residual);
  finite = finite && other.finite;
  if (other.failed && (!failed || other.failed_id < failed_id)) failed = other.failed, failed_id = other.failed_id;
}

ImplicitStep::ImplicitStep(const Row& row, const std::vector<Group>& groups, const std::vector<PairSystem>& pairs,
                           std::size_t block_rows, IdOf id_of)
    : stages_(row.phases), weights_(weights_of(row)) {
  for (const Group& group : groups) joined_.emplace_back(group.live, false);
  join(groups, pairs, id_of);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (std::size_t first = 0; first < groups[g].live; first += block_rows) {
      const std::size_t last = std::min(first + block_rows, groups[g].live);
      const auto rows = joined_[g].begin();
      const auto begin = static_cast<std::ptrdiff_t>(first), end = static_cast<std::ptrdiff_t>(last);
      if (std::all_of(rows + begin, rows + end, [](bool joined) { return joined; })) continue;
      tasks_.push_back({StageSystem(groups, {{g, first}}, {}, stages_), g, first, last, false, {}});
    }
  }
}

/// Bodies that pull at each other, directly or through others, are one system: its bodies in the order of ids, its
/// bonds in that of the effects.
void ImplicitStep::join(const std::vector<Group>& groups, const std::vector<PairSystem>& pairs, IdOf id_of) {
  struct Found {
    StageSystem::Bond bond;
    std::size_t a, b;  ///< ids
  };
  std::vector<Found> bonds;
  std::map<std::size_t, StageSystem::Member> members;  // by id
  for (const PairSystem& system : pairs) {
    const std::vector<Link> links = system.effect->links();
    std::vector<StageSystem::Member> of_slot(system.count() * system.copies());
    for (const SlotRange& range : system.ranges) {
      for (std::size_t i = 0; i < range.count; ++i) of_slot[range.first_slot + i] = {range.group, range.first_row + i};
    }
    for (std::size_t copy = 0; copy < system.copies(); ++copy) {
      for (const Link& link : links) {
        std::size_t ids[2];
        for (int end = 0; end < 2; ++end) {
          const auto& member = of_slot[copy * system.count() + (end == 0 ? link.a : link.b)];
          ids[end] = id_of(groups[member.group], member.row);
          members.emplace(ids[end], member);
          joined_[member.group][member.row] = true;
        }
        bonds.push_back({{system.effect.get(), copy, link, 0, 0}, ids[0], ids[1]});
      }
    }
  }
  std::map<std::size_t, std::size_t> rank;
  for (const auto& [id, member] : members) rank.emplace(id, rank.size());
  DisjointSets sets(rank.size());
  for (const Found& found : bonds) sets.join(rank[found.a], rank[found.b]);
  std::vector<std::vector<StageSystem::Member>> members_of(rank.size());
  std::vector<std::vector<StageSystem::Bond>> bonds_of(rank.size());
  std::vector<std::uint32_t> place(rank.size());
  for (const auto& [id, member] : members) {
    auto& list = members_of[sets.of(rank[id])];
    place[rank[id]] = static_cast<std::uint32_t>(list.size());
    list.push_back(member);
  }
  for (Found& found : bonds) {
    found.bond.a = place[rank[found.a]], found.bond.b = place[rank[found.b]];
    bonds_of[sets.of(rank[found.a])].push_back(found.bond);
  }
  for (std::size_t s = 0; s < members_of.size(); ++s) {
    if (members_of[s].empty()) continue;
    const auto [group, row] = members_of[s].front();
    tasks_.push_back({StageSystem(groups, members_of[s], bonds_of[s], stages_), group, row, row + 1, true, {}});
  }
}

StageTally ImplicitStep::step(const std::vector<Group>& groups, const Method& method, Workers& workers, IdOf id_of) {
  const auto task = [&](std::size_t t) { run(tasks_[t], groups, method, id_of); };
  workers.for_each(tasks_.size(), task, tasks_.size() < 2 ? 1 : workers.threads());
  StageTally all;
  for (const Task& done : tasks_) all.add(done.tally);
  return all;
}

void ImplicitStep::run(Task& task, const std::vector<Group>& groups, const Method& method, IdOf id_of) const {
  task.tally = {};
  for (std::size_t row = task.first; row < task.last; ++row) {
    if (!task.joined) {
      if (joined_[task.group][row]) continue;
      task.system.look_at(row);
    }
    const StageResult result = task.system.solve(groups, method);
    task.tally.finite = task.system.move(weights_.data()) && task.tally.finite;
    task.tally.add(result, id_of(groups[task.group], row));
  }
}

Moved World::implicit_step(const Method& method) {
  StageTally tally;
  timed("implicit_step", [&] {
    tally = implicit_->step(groups_, method, workers_,
                            [this](const Group& group, std::size_t row) { return id_of(group, row); });
  });
  count_iterations(tally, method.phases);
  return {tally.finite, 0};
}

void World::count_iterations(const StageTally& tally, int stages) {
  counters_.force_evaluations += static_cast<std::uint64_t>(stages * tally.most);
  counters_.newton_iterations += tally.iterations;
  counters_.newton_residual = std::max(counters_.newton_residual, tally.residual);
  if (tally.failed && status_.code < Status::Code::unconverged) report_unconverged(tally);
}

void World::report_unconverged(const StageTally& tally) {
  const double change = static_cast<double>(tally.failed->residual);
  const char* method = fixed_point_ ? "fixed-point iteration" : "Newton's method";
  const char* why = fixed_point_ ? "it diverges" : "its equations have no one solution";
  std::string sentence =
      std::isfinite(change)
          ? fmt::format("{} has not converged for body {}: its last change is {:.2g} of the state after {} iterations",
                        method, tally.failed_id, change, tally.failed->iterations)
          : fmt::format("{} finds no stages for body {}: {} after {} iterations", method, tally.failed_id, why,
                        tally.failed->iterations);
  if (status_.code != Status::Code::ok) sentence += "; " + status_.sentence;
  status_ = {Status::Code::unconverged, std::move(sentence), tally.failed_id, counters_.steps + 1, time() + step_};
}

}  // namespace ballpark::BALLPARK_PRECISION
