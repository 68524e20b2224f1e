// Springs and dampers between bodies, from a list. Each is evaluated once into a column of its own; then every body
// sums those that hold it in a fixed order.
#pragma once

#include "engine/effects/pair_effect.h"

namespace ballpark::BALLPARK_PRECISION {

class Bonds : public PairEffect {
 public:
  static constexpr bool weaves = false;
  explicit Bonds(const PairInput& input);
  void add_forces(const PairBodies& bodies, Workers& workers) override;
  double energy(const PairBodies& bodies, Workers& workers) override;
  Stiffness per_mass() const override { return per_mass_; }
  PairCost cost() const override;
  std::vector<Link> links() const override;
  LinkForce force_of(std::size_t copy, const Link& link, const Vector3<Real>& r, const Vector3<Real>& v) const override;
  static EffectDescription description();

 private:
  struct Bond {
    std::uint32_t a, b;                    ///< slots of a copy, a < b
    Real stiffness, damping, rest_length;  ///< negative: as at the start
  };
  struct End {
    std::uint32_t bond, is_a;
  };
  /// On b of bond i, counted over all copies.
  template <class V>
  Vector3<V> force_on_b(std::size_t i, const Vector3<V>& r, const Vector3<V>& v) const;
  /// From a to b, or to its nearest image.
  Vector3<Real> apart(const PairBodies& bodies, std::size_t a, std::size_t b) const;
  void list_ends(const PairBodies& bodies);
  void bound_stiffness(const PairBodies& bodies);

  std::vector<Bond> bonds_;  ///< of one copy, by slots and then by constants, whatever the order in the scene
  std::vector<std::uint32_t> first_end_;  ///< of each slot, and the end
  std::vector<End> ends_;                 ///< by slot, in the order of bonds
  std::vector<Vector3<Real>> forces_;     ///< on b, of every copy's bonds
  std::vector<Real> rest_lengths_;        ///< likewise [m]
  Stiffness per_mass_;
  Period period_;
};

}  // namespace ballpark::BALLPARK_PRECISION
