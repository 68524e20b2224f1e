// Energy and momenta: one pass over all bodies, summed per block and then over the blocks in their order.
#include <cmath>

#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

template <class V>
Vector3d to_double(const Vector3<V>& a) {
  return {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
}

Real potential(const Group& group, const Body<Real>& body) {
  Real sum = 0;
  for (std::size_t e = 0; e < group.effects.size(); ++e) {
    const EffectInfo& info = local_effects()[e];
    if (!info.energy) continue;
    const std::vector<std::byte>& instances = group.effects[e];
    for (std::size_t at = 0; at < instances.size(); at += info.constants_size) {
      sum += info.energy(instances.data() + at, body);
    }
  }
  return sum;
}

template <class M>
void add_body(const Group& group, std::size_t row, Totals& sum) {
  if (!is_finite(group, row)) {
    ++(group.presence.has(row) ? sum.non_finite_bodies : sum.absent_bodies);
    return;
  }
  const auto c = M::template constants<Real>(group.kernel.constants, row);
  Real y[M::size];
  M::load(group.kernel.state, row, y);
  const Body<Real> b = M::body(c, y);
  const Real half = Real(0.5);
  const Vector3d momentum = to_double(b.mass * b.velocity);
  Vector3d angular = to_double(b.mass * cross(b.position, b.velocity));
  if constexpr (M::size == PivotedMotion::size) {
    // L is about the pivot p: about the origin, L + p x m v; and w.L is all of the kinetic energy.
    sum.kinetic += static_cast<double>(half * dot(b.spin, vector_from(y)));
    angular = to_double(vector_from(y) + b.mass * cross(c.pivot, b.velocity));
  } else {
    sum.kinetic += static_cast<double>(half * b.mass * dot(b.velocity, b.velocity));
    if constexpr (M::spins) {
      const Vector3<Real> own = M::angular_momentum(y);
      sum.kinetic += static_cast<double>(half * dot(b.spin, own));
      angular += to_double(own);
    }
  }
  sum.potential += static_cast<double>(potential(group, b));
  sum.momentum += momentum;
  sum.momentum_scale += momentum.norm();
  sum.angular_momentum += angular;
  sum.angular_momentum_scale += angular.norm();
}

void add(const Totals& part, Totals& sum) {
  sum.kinetic += part.kinetic;
  sum.potential += part.potential;
  sum.momentum += part.momentum;
  sum.momentum_scale += part.momentum_scale;
  sum.angular_momentum += part.angular_momentum;
  sum.angular_momentum_scale += part.angular_momentum_scale;
  sum.non_finite_bodies += part.non_finite_bodies;
  sum.absent_bodies += part.absent_bodies;
}

}  // namespace

Totals World::totals() const {
  const std::vector<Block>& blocks = whole_.blocks;
  std::vector<Totals> parts(blocks.size());
  workers_.for_each(blocks.size(), [&](std::size_t b) {
    const Group& group = groups_[blocks[b].group];
    with_carried(group.carried, [&]<class M>() {
      for (std::size_t row = blocks[b].first; row < blocks[b].last; ++row) {
        add_body<M>(group, row, parts[b]);
      }
    });
  });
  Totals sum;
  for (const Totals& part : parts) add(part, sum);
  for (PairSystem& system : pair_systems_) sum.potential += system.energy(groups_, workers_);
  if (penalty_) sum.potential += penalty_->energy(groups_, time(), workers_);
  if (contacts_) sum.bodies_outside = contacts_->count_outside(groups_, time());
  return sum;
}

}  // namespace ballpark::BALLPARK_PRECISION
