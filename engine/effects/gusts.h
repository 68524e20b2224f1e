// Turbulence as a sum of plane waves across their directions, which the mean wind carries along unchanged:
//   u(x, t) = sum of a_n cos 2 pi (q_n.(x - U t) + p_n),  a_n.q_n = 0
// Directions and phases are random, by counter. (Kraichnan 1970, Phys. Fluids 13, 22; frozen turbulence: Taylor 1938.)
#pragma once

#include "engine/effects/effect_info.h"
#include "engine/kernels/wave.h"

#ifndef BALLPARK_TARGET
#include <bit>
#include <cmath>

#include "engine/core/random.h"
#endif

namespace ballpark::BALLPARK_PRECISION {

struct Gusts {
  static constexpr int count = 8;
  struct PlaneWave {
    Vector3<Real> number;     ///< q [turns/m]
    Vector3<Real> amplitude;  ///< a [m/s]
    double frequency, phase;  ///< q.U [turns/s], p [turns]
  };
  struct Constants {
    PlaneWave waves[count];
  };

  template <class V>
  BALLPARK_INLINE static Vector3<V> lanes_of(const Vector3<Real>& a) {
    return {V(a.x), V(a.y), V(a.z)};
  }
  template <class V>
  BALLPARK_INLINE static Wave<V> at(const PlaneWave& w, const Body<V>& body, double time) {
    constexpr double shift = 0x1.8p52;  // whole turns are taken off before a number of few digits holds the rest
    const double turns = w.phase - w.frequency * time, rest = turns - ((turns + shift) - shift);
    return wave(dot(lanes_of<V>(w.number), body.position) + V(static_cast<Real>(rest)));
  }

  template <class V>
  BALLPARK_INLINE static Vector3<V> flow(const Constants& c, const Body<V>& body, double time) {
    Vector3<V> sum;
    for (const PlaneWave& w : c.waves) sum += at(w, body, time).cosine * lanes_of<V>(w.amplitude);
    return sum;
  }

  template <class V>
  BALLPARK_INLINE static Vector3<V> flow_rate(const Constants& c, const Body<V>& body, double time) {
    constexpr Real two_pi = Real(6.28318530717958647692528676655900577L);
    Vector3<V> sum;
    for (const PlaneWave& w : c.waves) {
      const V turned = dot(lanes_of<V>(w.number), body.velocity) - V(static_cast<Real>(w.frequency));
      sum -= (V(two_pi) * turned * at(w, body, time).sine) * lanes_of<V>(w.amplitude);
    }
    return sum;
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {
        .name = "gusts",
        .doc =
            "gusts of the wind: eight random plane waves of lengths from L to L/11, as strong as turbulence has "
            "them (k^-5/3), that the mean wind carries along; drag and lift read velocity relative to them",
        .source = "Kraichnan 1970, Phys. Fluids 13, 22; Taylor 1938, Proc. R. Soc. A 164, 476; Kolmogorov 1941",
        .parameters = {{.name = "speed",
                        .unit = "m/s",
                        .fallback = {},
                        .minimum = 0,
                        .doc = "root mean square of each component, over all directions"},
                       {.name = "length", .unit = "m", .fallback = 10.0, .minimum = 1e-6, .doc = "L"},
                       {.name = "velocity",
                        .kind = ParameterKind::vector,
                        .unit = "m/s",
                        .fallback = Vector3d(0, 0, 0),
                        .doc = "U that carries them, in most scenes the wind's own"},
                       {.name = "seed", .unit = "1", .fallback = 1.0, .doc = "which gusts, the same in all copies"}},
        .reads = {"position"},
        .exerts = {"flow"},
        .flops = 560};
  }
  static Constants pack(const EffectInput& input) {
    constexpr double root_two = 1.4142135623730951;
    Constants c;
    double number = 1 / input.exact("length"), all = 0;
    for (int n = 0; n < count; ++n) all += maths::pow(2.0, -n / 3.0);
    for (int n = 0; n < count; ++n, number *= root_two) {
      const double share = maths::pow(2.0, -n / 3.0) / all;  // energy of k^-5/3 in an interval as wide as k: k^-2/3
      const double amplitude = input.exact("speed") * std::sqrt(6 * share);
      c.waves[n] = plane_wave(input, static_cast<std::uint64_t>(n), number, amplitude);
    }
    return c;
  }

 private:
  static PlaneWave plane_wave(const EffectInput& input, std::uint64_t n, double number, double amplitude) {
    constexpr std::uint64_t stream = 0x67757374;  // "gust"
    constexpr double two_pi = 6.283185307179586;
    const auto seed = std::bit_cast<std::uint64_t>(input.exact("seed"));
    const auto [up, round] = random::bits({seed, stream, 2 * n});
    const auto [across, phase] = random::bits({seed, stream, 2 * n + 1});
    const double z = 2 * random::fraction<53>(up) - 1, flat = std::sqrt(1 - z * z);
    const double azimuth = two_pi * random::fraction<53>(round), turn = two_pi * random::fraction<53>(across);
    const double c = maths::cos(azimuth), s = maths::sin(azimuth);
    const Vector3d direction(flat * c, flat * s, z), one(z * c, z * s, -flat), other(-s, c, 0);
    const Vector3d q = number * direction, a = amplitude * (maths::cos(turn) * one + maths::sin(turn) * other);
    const auto real = [](const Vector3d& v) {
      return Vector3<Real>{static_cast<Real>(v.x()), static_cast<Real>(v.y()), static_cast<Real>(v.z())};
    };
    return {real(q), real(a), q.dot(input.exact_vector("velocity")), random::fraction<53>(phase)};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
