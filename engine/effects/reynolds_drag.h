// Drag of a sphere by its Reynolds number: F = -6 pi eta R f(Re) v, Re = 2 R rho |v| / eta, f = Cd Re / 24.
#pragma once

#include "engine/effects/effect_info.h"
#include "engine/kernels/power.h"

#ifndef BALLPARK_TARGET
#include <algorithm>
#include <limits>

#include "engine/core/maths.h"
#endif

namespace ballpark::BALLPARK_PRECISION {

/// What the drag coefficient is more than Stokes', Cd = 24 / Re f: Schiller & Naumann's 1 + 0.15 Re^0.687 below Re
/// 1000, and what makes it 0.44 above. Called, so that effects beside it keep their registers.
template <class V>
[[gnu::noinline]] static void more_than_stokes(const V& reynolds, V& factor) {
  const V slow = V(Real(1)) + V(Real(0.15)) * power(reynolds, Real(0.687));
  factor = select(V(Real(1000)) > reynolds, slow, V(Real(0.44) / Real(24)) * reynolds);
}

struct ReynoldsDrag {
  static constexpr bool feels_flow = true;
  struct Constants {
    PerBody radius;
    Real reynolds;  ///< 2 rho / eta
    Real stokes;    ///< 6 pi eta
  };

  template <class V>
  BALLPARK_INLINE static V factor(const V& reynolds) {
    V factor;
    const V number = reynolds;
    more_than_stokes(number, factor);
    return factor;
  }

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    const V r = c.radius.at<V>(body.row);
    loads.force -= (V(c.stokes) * r * factor(V(c.reynolds) * r * length(body.velocity))) * body.velocity;
  }

  /// F' = -6 pi eta R (f a + Re f'(Re) (v.a / v^2) v), Re f' = 0.687 (f - 1), above Re 1000 f.
  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants& c, const Body<V>& body, const Acceleration<V>& a,
                                         Loads<V>& rate) {
    const V zero = V(Real(0)), r = c.radius.at<V>(body.row), square = dot(body.velocity, body.velocity);
    const V reynolds = V(c.reynolds) * r * square_root(square), f = factor(reynolds);
    const V rise = select(V(Real(1000)) > reynolds, V(Real(0.687)) * (f - V(Real(1))), f);
    const V along = select(square > zero, rise * (dot(body.velocity, a.linear) / square), zero);
    rate.force -= (V(c.stokes) * r) * (f * a.linear + along * body.velocity);
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "reynolds_drag",
            .doc =
                "drag of a sphere of the bodies' radius, F = -Cd rho pi R^2 |v| v / 2, Cd = 24/Re (1 + 0.15 Re^0.687) "
                "below Re = 2 R rho |v| / eta of 1000, 0.44 above (where it steps by 0.4 %)",
            .source = "Schiller & Naumann 1933; Clift, Grace & Weber, Bubbles, Drops and Particles, table 5.1",
            .parameters = {{.name = "density",
                            .unit = "kg/m^3",
                            .fallback = {},
                            .minimum = 0,
                            .doc = "rho of the fluid, e.g. 998 of water, 1.2 of air"},
                           {.name = "viscosity",
                            .unit = "Pa s",
                            .fallback = {},
                            .minimum = 1e-12,
                            .doc = "eta of the fluid, e.g. 1.0e-3 of water, 1.8e-5 of air"}},
            .reads = {"velocity", "radius"},
            .exerts = {"force"},
            .flops = 75};
  }
  static Constants pack(const EffectInput& input) {
    const double density = input.exact("density"), viscosity = input.exact("viscosity");
    return {input.radius, static_cast<Real>(2 * density / viscosity), static_cast<Real>(six_pi * viscosity)};
  }
  /// dF/dv along v at the fastest body of the start, for the body that it slows fastest.
  static Stiffness stiffness(const EffectInput& input) {
    double fastest = 0, least_mass = std::numeric_limits<double>::infinity();
    for (const EffectInput::Size& size : input.sizes) {
      const double reynolds = 2 * size.radius * input.exact("density") * input.largest_speed / input.exact("viscosity");
      const double slow = 1 + 1.687 * 0.15 * maths::pow(reynolds, 0.687), fast = 2 * 0.44 / 24 * reynolds;
      const double damping = six_pi * input.exact("viscosity") * size.radius * (reynolds < 1000 ? slow : fast);
      fastest = std::max(fastest, damping / size.mass);
      least_mass = std::min(least_mass, size.mass);
    }
    return {0, fastest * least_mass};
  }

 private:
  static constexpr double six_pi = 4.5 * four_thirds_pi;
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
