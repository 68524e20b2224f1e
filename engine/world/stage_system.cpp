#include "engine/world/stage_system.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
/// Newton's method squares the error: after a change as small as this only rounding is left.
constexpr Real tolerance = 64 * epsilon, nearly = 1024 * epsilon;
constexpr int most_iterations = 25;
/// Below this many unknowns a matrix is taken for full.
constexpr int small_system = 64;

/// How a rate changes with a force at the centre that changes so.
Real along(const Real (&by_pull)[3], const Vector3<Real>& force) {
  return by_pull[0] * force.x + by_pull[1] * force.y + by_pull[2] * force.z;
}

}  // namespace

StageSystem::StageSystem(const std::vector<Group>& groups, std::vector<Member> members, std::vector<Bond> bonds,
                         int stages)
    : stages_(stages), solver_({0}, {}) {
  bodies_.resize(members.size());
  for (std::size_t b = 0; b < members.size(); ++b) {
    bodies_[b].member = members[b];
    bodies_[b].at = std::make_unique<BodyRates[]>(static_cast<std::size_t>(stages));
  }
  bonds_.resize(bonds.size());
  for (std::size_t i = 0; i < bonds.size(); ++i) bonds_[i].bond = bonds[i];
  arrange(groups);
}

/// Unknowns body by body, stage by stage; the matrix has a part for each two bodies that a bond joins.
void StageSystem::arrange(const std::vector<Group>& groups) {
  const std::size_t n = bodies_.size();
  int unknowns = 0;
  for (StageBody& body : bodies_) {
    body.motion = groups[body.member.group].motion;
    body.calls = &calls_of(body.motion);
    body.first = unknowns;
    unknowns += stages_ * body.size();
  }
  std::vector<std::vector<std::uint32_t>> joined(n);  // to each body, itself among them
  for (std::uint32_t c = 0; c < n; ++c) {
    for (std::uint32_t b = 0; b < (unknowns <= small_system ? n : 0); ++b) joined[c].push_back(b);
    joined[c].push_back(c);
  }
  for (const StageBond& bond : bonds_) {
    joined[bond.bond.a].push_back(bond.bond.b);
    joined[bond.bond.b].push_back(bond.bond.a);
  }
  starts_ = {0}, rows_.clear(), own_.assign(n, 0);
  std::vector<std::vector<std::size_t>> begins(n);  // of the parts in a body's columns
  for (std::size_t c = 0; c < n; ++c) {
    std::sort(joined[c].begin(), joined[c].end());
    joined[c].erase(std::unique(joined[c].begin(), joined[c].end()), joined[c].end());
    std::vector<int> column;
    for (const std::uint32_t b : joined[c]) {
      begins[c].push_back(rows_.size() + column.size());
      if (b == c) own_[c] = begins[c].back();
      for (int r = 0; r < stages_ * bodies_[b].size(); ++r) column.push_back(bodies_[b].first + r);
    }
    bodies_[c].entries = static_cast<int>(column.size());
    for (int q = 0; q < stages_ * bodies_[c].size(); ++q) {
      rows_.insert(rows_.end(), column.begin(), column.end());
      starts_.push_back(static_cast<int>(rows_.size()));
    }
  }
  for (StageBond& bond : bonds_) {
    const std::uint32_t ends[2] = {bond.bond.a, bond.bond.b};
    for (int row = 0; row < 2; ++row) {
      for (int column = 0; column < 2; ++column) {
        const auto& of_column = joined[ends[column]];
        const auto at = std::lower_bound(of_column.begin(), of_column.end(), ends[row]) - of_column.begin();
        bond.begin[row][column] = begins[ends[column]][static_cast<std::size_t>(at)];
      }
    }
  }
  solver_ = LinearSolver(starts_, rows_);
  for (auto* values : {&z_, &right_, &scale_}) values->resize(static_cast<std::size_t>(unknowns));
}

StageResult StageSystem::solve(const std::vector<Group>& groups, const Method& method) {
  begin_step(groups, method);
  StageResult result;
  for (Real before = std::numeric_limits<Real>::infinity(); result.iterations < most_iterations;
       before = result.residual) {
    result.residual = improve(method);
    ++result.iterations;
    if (!std::isfinite(result.residual)) break;
    // Where rounding of the forces themselves is larger than expected, changes stop shrinking.
    const bool stuck = result.residual < nearly && 4 * result.residual > before;
    result.converged = result.residual <= tolerance || stuck;
    if (result.converged) break;
  }
  return result;
}

void StageSystem::begin_step(const std::vector<Group>& groups, const Method& method) {
  const auto changed = [&](const StageBody& body) { return groups[body.member.group].motion != body.motion; };
  if (std::any_of(bodies_.begin(), bodies_.end(), changed)) arrange(groups);
  for (StageBody& body : bodies_) {
    body.group = &groups[body.member.group].kernel;
    body.calls->load(*body.group, body.member.row, body.y);
    body.calls->units(*body.group, body.member.row, method.step, body.unit);
  }
  std::fill(z_.begin(), z_.end(), Real(0));
}

bool StageSystem::move(const Real* weights) {
  bool finite = true;
  for (const StageBody& body : bodies_) {
    Real change[max_state_size] = {};
    for (int i = 0; i < stages_; ++i) {
      const Real* z = &z_[static_cast<std::size_t>(body.first + i * body.size())];
      for (int p = 0; p < body.size(); ++p) change[p] += weights[i] * z[p];
    }
    finite = body.calls->move(*body.group, body.member.row, change) && finite;
  }
  return finite;
}

void StageSystem::stage_of(const StageBody& body, int stage, Real* y) const {
  const Real* z = &z_[static_cast<std::size_t>(body.first + stage * body.size())];
  for (int p = 0; p < body.size(); ++p) y[p] = body.y[p] + z[p];
}

/// One iteration: the change of the stages over their scale.
Real StageSystem::improve(const Method& method) {
  for (int j = 0; j < stages_; ++j) find_rates(j, method.offset[j]);
  assemble(method);
  find_right_side(method);
  const auto finite = [](Real value) { return std::isfinite(value); };
  const Real* values = solver_.values();
  if (!std::all_of(right_.begin(), right_.end(), finite) || !std::all_of(values, values + rows_.size(), finite)) {
    std::fill(z_.begin(), z_.end(), std::numeric_limits<Real>::quiet_NaN());
    return std::numeric_limits<Real>::quiet_NaN();
  }
  find_scales();
  if (!solver_.solve(right_.data())) return std::numeric_limits<Real>::infinity();
  return change_stages();
}

void StageSystem::find_rates(int stage, double after) {
  if (!bonds_.empty()) pull_at(stage);
  for (StageBody& body : bodies_) {
    Real y[max_state_size];
    stage_of(body, stage, y);
    if (bonds_.empty()) {
      body.calls->rates(*body.group, body.member.row, y, after, body.at[stage]);
    } else {
      body.calls->pulled_rates(*body.group, body.member.row, y, after, body.pull, body.at[stage]);
    }
  }
}

void StageSystem::pull_at(int stage) {
  for (StageBody& body : bodies_) {
    Real y[max_state_size];
    stage_of(body, stage, y);
    body.calls->place(*body.group, body.member.row, y, body.place);
    body.pull = {};
  }
  for (StageBond& bond : bonds_) {
    StageBody &a = bodies_[bond.bond.a], &b = bodies_[bond.bond.b];
    LinkForce& force = bond.force[stage];
    force = bond.bond.effect->force_of(bond.bond.copy, bond.bond.link, vector_from(b.place) - vector_from(a.place),
                                       vector_from(b.place + 3) - vector_from(a.place + 3));
    const Vector3<Real> on_b = {force.x.value, force.y.value, force.z.value};
    b.pull += on_b;
    a.pull -= on_b;
  }
}

/// 1 - h a_ij df/dy at stage j, in the bodies' units.
void StageSystem::assemble(const Method& method) {
  Real* values = solver_.values();
  std::fill_n(values, rows_.size(), Real(0));
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const StageBody& body = bodies_[b];
    for (int j = 0; j < stages_; ++j) {
      for (int q = 0; q < body.size(); ++q) {
        Real* column = values + own_[b] + static_cast<std::size_t>((j * body.size() + q) * body.entries);
        column[j * body.size() + q] = 1;
        for (int i = 0; i < stages_; ++i) {
          for (int p = 0; p < body.size(); ++p) {
            column[i * body.size() + p] -= method.a[i][j] * body.at[j].by_state[p][q] * (body.unit[q] / body.unit[p]);
          }
        }
      }
    }
  }
  for (const StageBond& bond : bonds_) add_bond(method, bond);
}

/// By the chain rule: rates by pull, pull by the places of both bodies, places by their states.
void StageSystem::add_bond(const Method& method, const StageBond& bond) {
  StageBody* const ends[2] = {&bodies_[bond.bond.a], &bodies_[bond.bond.b]};
  for (int c = 0; c < 2; ++c) {
    const StageBody& source = *ends[c];
    for (int j = 0; j < stages_; ++j) {
      const LinkForce& force = bond.force[j];
      for (int q = 0; q < source.size(); ++q) {
        Vector3<Real> change;  // of the force on b by value q of the source
        for (int k = 0; k < 6; ++k) {
          const Real moved = c == 1 ? source.at[j].place_by_state[k][q] : -source.at[j].place_by_state[k][q];
          change += moved * Vector3<Real>{force.x.by[k], force.y.by[k], force.z.by[k]};
        }
        for (int r = 0; r < 2; ++r) {
          const StageBody& pulled = *ends[r];
          const Real side = (r == 1 ? source.unit[q] : -source.unit[q]);
          Real* column =
              solver_.values() + bond.begin[r][c] + static_cast<std::size_t>((j * source.size() + q) * source.entries);
          for (int p = 0; p < pulled.size(); ++p) {
            const Real rate = along(pulled.at[j].by_pull[p], change) * (side / pulled.unit[p]);
            for (int i = 0; i < stages_; ++i) column[i * pulled.size() + p] -= method.a[i][j] * rate;
          }
        }
      }
    }
  }
}

void StageSystem::find_right_side(const Method& method) {
  for (const StageBody& body : bodies_) {
    for (int i = 0; i < stages_; ++i) {
      for (int p = 0; p < body.size(); ++p) {
        const auto at = static_cast<std::size_t>(body.first + i * body.size() + p);
        Real sum = -z_[at];
        for (int j = 0; j < stages_; ++j) sum += method.a[i][j] * body.at[j].rate[p];
        right_[at] = sum / body.unit[p];
      }
    }
  }
}

/// Of each quantity of a body: the largest sum of the sizes of the terms that must cancel, as rounding is of their
/// size.
void StageSystem::find_scales() {
  std::fill(scale_.begin(), scale_.end(), Real(0));
  const Real* value = solver_.values();
  for (const StageBody& body : bodies_) {
    for (int j = 0; j < stages_; ++j) {
      Real y[max_state_size];
      stage_of(body, j, y);
      for (int q = 0; q < body.size(); ++q) {
        const auto column = static_cast<std::size_t>(body.first + j * body.size() + q);
        const Real size = std::abs(y[q] / body.unit[q]);
        for (int e = starts_[column]; e < starts_[column + 1]; ++e) {
          scale_[static_cast<std::size_t>(rows_[static_cast<std::size_t>(e)])] += std::abs(*value++) * size;
        }
        scale_[column] += std::abs(z_[column] / body.unit[q]);
      }
    }
  }
}

Real StageSystem::change_stages() {
  Real most = 0;
  for (const StageBody& body : bodies_) {
    Real scale[max_state_size] = {}, change[max_state_size] = {};  // by quantity
    for (int at = 0; at < stages_ * body.size(); ++at) {
      const auto unknown = static_cast<std::size_t>(body.first + at);
      const int p = at % body.size(), quantity = body.calls->quantity_begin[p];
      const Real delta = right_[unknown] * body.unit[p];
      z_[unknown] += delta;
      scale[quantity] = std::max(scale[quantity], scale_[unknown] + std::abs(right_[unknown]));
      change[quantity] = std::max(change[quantity], std::abs(right_[unknown]));
      if (!std::isfinite(delta)) most = delta;
    }
    for (int p = 0; p < body.size(); ++p) {
      if (change[p] > 0) most = std::isfinite(most) ? std::max(most, change[p] / scale[p]) : most;
    }
  }
  return most;
}

}  // namespace ballpark::BALLPARK_PRECISION
