#include "perf/baselines/effects.h"

#include <cmath>

namespace ballpark::perf {

namespace {

#if defined(__AVX512F__)
constexpr std::size_t lanes = 8;
#elif defined(__AVX__)
constexpr std::size_t lanes = 4;
#else
constexpr std::size_t lanes = 2;
#endif
typedef double V __attribute__((vector_size(lanes * sizeof(double))));

template <class F>
inline V each(V a, F f) {
  V r;
  for (std::size_t l = 0; l < lanes; ++l) r[l] = f(a[l]);
  return r;
}
inline V root(V a) {
  return each(a, [](double x) { return std::sqrt(x); });
}
inline V all(double x) {
  return V{} + x;
}

struct Three {
  V x, y, z;
};
inline Three operator+(Three a, Three b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Three operator-(Three a, Three b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Three operator*(V s, Three a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline Three operator*(double s, Three a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline V dot(Three a, Three b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Three cross(Three a, Three b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Three three(const double (&a)[3]) {
  return {all(a[0]), all(a[1]), all(a[2])};
}

struct Body {
  Three x, v, l;
};
struct Load {
  Three force, torque;
};

template <bool spins, class F>
void rk4(double* const* columns, std::size_t count, double h, F load_of) {
  const auto load = [&](std::size_t c, std::size_t i) { return *reinterpret_cast<const V*>(columns[c] + i); };
  const auto store = [&](std::size_t c, std::size_t i, V v) { *reinterpret_cast<V*>(columns[c] + i) = v; };
  const auto rate = [&](const Body& y) {
    const Load all_loads = load_of(y);
    return Body{y.v, (1 / hand::mass) * all_loads.force, all_loads.torque};
  };
  const auto moved = [](const Body& y, double t, const Body& k) {
    return Body{y.x + t * k.x, y.v + t * k.v, spins ? y.l + t * k.l : y.l};
  };
  for (std::size_t i = 0; i < count; i += lanes) {
    Body y{{load(0, i), load(1, i), load(2, i)}, {load(3, i), load(4, i), load(5, i)}, {}};
    if (spins) y.l = {load(6, i), load(7, i), load(8, i)};
    const Body k1 = rate(y), k2 = rate(moved(y, h / 2, k1)), k3 = rate(moved(y, h / 2, k2)), k4 = rate(moved(y, h, k3));
    const auto sum = [&](Three a, Three b, Three c, Three d) { return (h / 6) * (a + 2.0 * (b + c) + d); };
    const Three x = y.x + sum(k1.x, k2.x, k3.x, k4.x), v = y.v + sum(k1.v, k2.v, k3.v, k4.v);
    store(0, i, x.x), store(1, i, x.y), store(2, i, x.z);
    store(3, i, v.x), store(4, i, v.y), store(5, i, v.z);
    if (!spins) continue;
    const Three l = y.l + sum(k1.l, k2.l, k3.l, k4.l);
    store(6, i, l.x), store(7, i, l.y), store(8, i, l.z);
  }
}

const auto weight = [](const Body&) { return Load{{V{}, V{}, all(-hand::gravity * hand::mass)}, {}}; };
const auto weight_and_drag = [](const Body& y) {
  Load load = weight(y);
  load.force = load.force - hand::linear * y.v;
  return load;
};
void without(double* const* columns, std::size_t count, double h) {
  rk4<false>(columns, count, h, weight);
}
void without_but_drag(double* const* columns, std::size_t count, double h) {
  rk4<false>(columns, count, h, weight_and_drag);
}

/// A load beside weight.
template <bool spins, class F>
void beside_weight(double* const* columns, std::size_t count, double h, F more) {
  rk4<spins>(columns, count, h, [&](const Body& y) {
    Load load = weight(y);
    more(y, load);
    return load;
  });
}

void linear_drag(double* const* columns, std::size_t count, double h) {
  rk4<false>(columns, count, h, weight_and_drag);
}
void quadratic_drag(double* const* columns, std::size_t count, double h) {
  beside_weight<false>(columns, count, h, [](const Body& y, Load& load) {
    load.force = load.force - (hand::quadratic * root(dot(y.v, y.v))) * y.v;
  });
}
void magnus(double* const* columns, std::size_t count, double h) {
  beside_weight<true>(columns, count, h, [](const Body& y, Load& load) {
    load.force = load.force + hand::magnus * cross((1 / hand::inertia) * y.l, y.v);
  });
}
void spring(double* const* columns, std::size_t count, double h) {
  const V a = all(hand::anchor);
  beside_weight<false>(columns, count, h, [a](const Body& y, Load& load) {
    const Three r = y.x - Three{a, a, a};
    const V tension = hand::stiffness * (1 - hand::rest_length / root(dot(r, r)));
    load.force = load.force - tension * r - hand::damping * y.v;
  });
}
void central_gravity(double* const* columns, std::size_t count, double h) {
  beside_weight<false>(columns, count, h, [](const Body& y, Load& load) {
    const V square = dot(y.x, y.x) + hand::softening * hand::softening;
    load.force = load.force - (hand::mass * hand::strength / (square * root(square))) * y.x;
  });
}
void electric_field(double* const* columns, std::size_t count, double h) {
  beside_weight<false>(columns, count, h,
                       [](const Body&, Load& load) { load.force = load.force + hand::charge * three(hand::field); });
}
void magnetic_field(double* const* columns, std::size_t count, double h) {
  beside_weight<false>(columns, count, h, [](const Body& y, Load& load) {
    load.force = load.force + hand::charge * cross(y.v, three(hand::field));
  });
}
void rotating_frame(double* const* columns, std::size_t count, double h) {
  beside_weight<false>(columns, count, h, [](const Body& y, Load& load) {
    const Three w = three(hand::turning);
    load.force = load.force - hand::mass * cross(w, 2.0 * y.v + cross(w, y.x));
  });
}
void force(double* const* columns, std::size_t count, double h) {
  beside_weight<false>(columns, count, h, [](const Body&, Load& load) { load.force = load.force + three(hand::push); });
}
void torque(double* const* columns, std::size_t count, double h) {
  beside_weight<true>(columns, count, h, [](const Body&, Load& load) { load.torque = three(hand::twist); });
}
void harmonic_trap(double* const* columns, std::size_t count, double h) {
  beside_weight<false>(columns, count, h, [](const Body& y, Load& load) {
    load.force = load.force - Three{hand::trap[0] * y.x.x, hand::trap[1] * y.x.y, hand::trap[2] * y.x.z};
  });
}
void buoyancy(double* const* columns, std::size_t count, double h) {
  constexpr double lift = hand::air * 4.1887902047863905 * hand::radius * hand::radius * hand::radius * hand::gravity;
  beside_weight<false>(columns, count, h, [](const Body&, Load& load) { load.force.z = load.force.z + lift; });
}
void reynolds_drag(double* const* columns, std::size_t count, double h) {
  beside_weight<false>(columns, count, h, [](const Body& y, Load& load) {
    constexpr double stokes = 18.849555921538759 * hand::viscosity * hand::radius;
    const V re = (2 * hand::radius * hand::air / hand::viscosity) * root(dot(y.v, y.v));
    const V factor = each(re, [](double r) { return r < 1000 ? 1 + 0.15 * std::pow(r, 0.687) : 0.44 / 24 * r; });
    load.force = load.force - (stokes * factor) * y.v;
  });
}
void spin_decay(double* const* columns, std::size_t count, double h) {
  beside_weight<true>(columns, count, h, [](const Body& y, Load& load) {
    load.torque = Three{} - (hand::spin_decay / hand::inertia) * y.l;
  });
}
void wind(double* const* columns, std::size_t count, double h) {
  rk4<false>(columns, count, h, [](const Body& y) {
    const Three u = three(hand::wind) + y.x.z * three(hand::shear);
    Load load = weight(y);
    load.force = load.force - hand::linear * (y.v - u);
    return load;
  });
}
/// Eight waves, of any numbers.
void gusts(double* const* columns, std::size_t count, double h) {
  rk4<false>(columns, count, h, [](const Body& y) {
    Three u{};
    for (int n = 0; n < 8; ++n) {
      const Three q = (0.1 + 0.02 * n) * three(hand::field);
      u = u + each(dot(q, y.x) + all(n), [](double phase) { return std::cos(phase); }) * q;
    }
    Load load = weight(y);
    load.force = load.force - hand::linear * (y.v - u);
    return load;
  });
}
/// Level and at rest.
void table(double* const* columns, std::size_t count, double h) {
  using namespace hand;
  beside_weight<true>(columns, count, h, [](const Body& y, Load& load) {
    constexpr double pressed = gravity * mass, rate = 1 / settling, both = inertia + mass * radius * radius;
    constexpr double responding = mass / (1 + mass * radius * radius / inertia);
    const auto capped = [](V k, V most, V size) { return k * size > most ? most / size : k; };
    load.force.z = V{};
    const Three w = (1 / inertia) * y.l, slip = {y.v.x - radius * w.y, y.v.y + radius * w.x, V{}};
    const V speed = root(dot(slip, slip)), spread = 1 - responding * rate / (sliding * pressed) * speed;
    const V rolls = spread > 0 ? spread : V{};
    const Three roll = {w.x, w.y, V{}};
    const V size = root(dot(roll, roll)), up = w.z < 0 ? -w.z : w.z;
    const V slows = capped(all(both * rate), rolls * (rolling * pressed * both / (mass * radius)), size);
    load.torque = {-slows * w.x, -slows * w.y,
                   -capped(all(inertia * rate), all(spinning * pressed * radius), up) * w.z};
    const Three changing = {-radius / inertia * load.torque.y, radius / inertia * load.torque.x, V{}};
    const Three hold = responding * (changing + rate * slip);
    const Three friction = capped(all(1.0), all(sliding * pressed), root(dot(hold, hold))) * hold;
    load.force = load.force - friction;
    load.torque.x = load.torque.x - radius * friction.y;
    load.torque.y = load.torque.y + radius * friction.x;
  });
}

constexpr HandWrittenEffect effects[] = {
    {"linear_drag", false, false, without, linear_drag},
    {"quadratic_drag", false, false, without, quadratic_drag},
    {"magnus", true, false, without, magnus},
    {"spring", false, false, without, spring},
    {"central_gravity", false, false, without, central_gravity},
    {"electric_field", false, false, without, electric_field},
    {"magnetic_field", false, false, without, magnetic_field},
    {"rotating_frame", false, false, without, rotating_frame},
    {"force", false, false, without, force},
    {"torque", true, false, without, torque},
    {"harmonic_trap", false, false, without, harmonic_trap},
    {"buoyancy", false, false, without, buoyancy},
    {"reynolds_drag", false, false, without, reynolds_drag},
    {"spin_decay", true, false, without, spin_decay},
    {"wind", false, true, without_but_drag, wind},
    {"gusts", false, true, without_but_drag, gusts, false},
    {"table", true, false, without, table},
};

}  // namespace

std::span<const HandWrittenEffect> hand_written_effects() {
  return effects;
}

}  // namespace ballpark::perf
