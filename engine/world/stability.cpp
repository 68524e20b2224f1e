// The largest stable step, measured on the code itself: a method's own kernel moves a damped oscillator from two
// independent starts, and the spectral radius of the resulting step matrix says whether it grows. Where a force turns
// the velocity, the oscillator moves in the plane across the axis, whose vectors are taken as complex numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

#include "engine/core/nearest.h"
#include "engine/world/build.h"
#include "engine/world/local_step.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

using Point = FreeMotion<Spin::none>;

using Number = std::complex<double>;

/// Forces of a damped oscillator, F = -k x - c v - g z x v, as the families see them; along x + i y: -k x - (c + i g)
/// v.
struct OscillatorForces {
  Real spring, damping, gyration;
  bool turning_apart = false;  ///< as in LocalForces
  static constexpr bool read_position = true;
  template <class V>
  Loads<V> loads(const Body<V>& b, double) const {
    const Vector3<V> rest = V(-spring) * b.position - V(damping) * b.velocity;
    return {turning_apart ? rest : rest - turned(b.velocity), {}};
  }
  template <class V>
  Loads<V> load_rates(const Body<V>& b, const Acceleration<V>& a) const {
    return {V(-spring) * b.velocity - V(damping) * a.linear - turned(a.linear), {}};
  }

  template <class V>
  Vector3<V> turning(const Body<V>&) const {
    return {V(Real(0)), V(Real(0)), V(-gyration)};
  }

 private:
  template <class V>
  Vector3<V> turned(const Vector3<V>& v) const {
    return {V(-gyration) * v.y, V(gyration) * v.x, V(Real(0))};
  }
};

/// The oscillator in units of the step: h = 1, m = 1.
struct Oscillator {
  OscillatorForces forces;
  Point::Constants<Real> constants;

  Oscillator(const Method& m, double spring, double damping, double gyration)
      : forces{static_cast<Real>(spring), static_cast<Real>(damping), static_cast<Real>(gyration), m.turns_velocity} {
    BodyConstants unit_mass;
    unit_mass.mass.value = unit_mass.effective_mass.value = 1;
    constants = Point::constants<Real>(unit_mass, 0);
  }
  /// (x, v) at n, n - 1, ...
  using Past = std::array<std::array<Number, 2>, max_history + 1>;

  /// (x, v) at n + 1 by the method.
  void step(const Method& m, const Past& past, Number (&next)[2]) const {
    constexpr std::size_t sets = max_history + 3;
    std::array<Real, sets * Point::size> rates{};
    std::array<Real*, sets * Point::size> columns;
    for (std::size_t i = 0; i < rates.size(); ++i) columns[i] = &rates[i];
    for (int j = 1; j <= m.history; ++j) {
      const State<Point, Real> earlier = at(past[static_cast<std::size_t>(j)]);
      evaluate<Point>(forces, constants, earlier.y, 0, rates.data() + (m.history_begin + j - 1) * Point::size);
    }
    const ColumnRates<Point, Real> kept{columns.data(), 0};
    State<Point, Real> state = at(past[0]);
    with_family(m.family, [&]<class F>() { whole_step<F>(m, constants, forces, kept, state); });
    next[0] = {static_cast<double>(state.y[0]), static_cast<double>(state.y[1])};
    next[1] = {static_cast<double>(state.y[3]), static_cast<double>(state.y[4])};
  }

 private:
  static State<Point, Real> at(const std::array<Number, 2>& xv) {
    State<Point, Real> state{};
    for (std::size_t i = 0; i < 2; ++i) {
      state.y[3 * i] = static_cast<Real>(xv[i].real());
      state.y[3 * i + 1] = static_cast<Real>(xv[i].imag());
    }
    return state;
  }
};

/// (x, v) of so many steps, and the matrix that takes them one step on: real if nothing turns, which is faster.
constexpr std::size_t most_values = 2 * (max_history + 1);
template <class T>
using Companion = std::array<T, most_values * most_values>;

/// Largest |eigenvalue| of an n x n matrix, from norms of the powers 2, 4, 8, ...: ||A^n||^(1/n).
template <class T>
double spectral_radius(Companion<T> a, std::size_t n) {
  constexpr int squarings = 48;
  double logarithm = 0, weight = 1;
  for (int k = 0; k <= squarings; ++k, weight /= 2) {
    double norm = 0;
    for (std::size_t i = 0; i < n * n; ++i) norm = std::max(norm, std::abs(a[i]));
    if (norm == 0) return 0;
    logarithm += weight * std::log(norm);
    Companion<T> square{};
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t l = 0; l < n; ++l) {
        const T factor = a[i * n + l] / norm;
        for (std::size_t j = 0; j < n; ++j) square[i * n + j] += factor * (a[l * n + j] / norm);
      }
    }
    a = square;
  }
  return std::exp(logarithm);
}

/// Of a multistep method: of the matrix that takes (x, v) at n, n - 1, ... to those one step on.
template <class T>
double companion_radius(const Method& m, const Oscillator& oscillator, bool free) {
  const std::size_t steps = static_cast<std::size_t>(m.history) + 1, first = free ? 1 : 0, values = free ? 1 : 2;
  const std::size_t n = steps * values;  // a free position keeps an eigenvalue of 1: of v alone
  Companion<T> matrix{};
  for (std::size_t column = 0; column < n; ++column) {
    Oscillator::Past past{};
    past[column / values][first + column % values] = 1;
    Number next[2];
    oscillator.step(m, past, next);
    for (std::size_t v = 0; v < values; ++v) {
      if constexpr (std::is_same_v<T, Number>) {
        matrix[v * n + column] = next[first + v];
      } else {
        matrix[v * n + column] = next[first + v].real();
      }
    }
    if (column + values < n) matrix[(column + values) * n + column] = 1;
  }
  return spectral_radius(matrix, n);
}

/// R(w) of an implicit row on y' = lambda y, w = h lambda: 1 + w b^T k, (1 - w A) k = 1. (Hairer & Wanner, Solving
/// ODEs II, eq. IV.3.2)
Number stability_function(const Row& row, Number w) {
  const int n = row.phases;
  Number m[max_stages][max_stages + 1];
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) m[i][j] = (i == j ? 1.0 : 0.0) - w * static_cast<double>(row.a[i][j]);
    m[i][n] = 1;
  }
  Number sum = 1;
  for (int k = 0; k < n; ++k) {
    for (int i = 0; i < n; ++i) {
      const Number factor = i == k ? 0 : m[i][k] / m[k][k];
      for (int j = k; j <= n; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  for (int i = 0; i < n; ++i) sum += w * static_cast<double>(row.b[i]) * (m[i][n] / m[i][i]);
  return sum;
}

/// Eigenvalues of the oscillator: lambda^2 + (c + i g) lambda + k = 0.
std::array<Number, 2> eigenvalues(double spring, double damping, double gyration) {
  const Number turn = {damping, gyration}, root = std::sqrt(turn * turn - 4 * spring);
  return {(-turn + root) / 2.0, (-turn - root) / 2.0};
}

/// Largest |R| at them.
double implicit_radius(const Row& row, double spring_h2, double damping_h, double gyration_h) {
  if (spring_h2 == 0) return std::abs(stability_function(row, {-damping_h, -gyration_h}));  // 0 is a free position's
  const auto ends = eigenvalues(spring_h2, damping_h, gyration_h);
  return std::max(std::abs(stability_function(row, ends[0])), std::abs(stability_function(row, ends[1])));
}

/// Rounding, for radii near 1: in Real, or of the radius itself.
constexpr double tolerance =
    64 * std::max(static_cast<double>(std::numeric_limits<Real>::epsilon()), std::numeric_limits<double>::epsilon());

/// Largest |eigenvalue| of the step matrix in (x, v h): scaled so that entries are of one size.
double spectral_radius(const Row& row, double spring_h2, double damping_h, double gyration_h) {
  if (row.family == Family::implicit_runge_kutta) return implicit_radius(row, spring_h2, damping_h, gyration_h);
  const Method m = method_for(row, 1);
  const Oscillator oscillator(m, spring_h2, damping_h, gyration_h);
  const bool free = spring_h2 == 0;  // its position keeps an eigenvalue of 1
  if (m.history > 0 && gyration_h == 0) return companion_radius<double>(m, oscillator, free);
  if (m.history > 0) return companion_radius<Number>(m, oscillator, free);
  Number matrix[2][2];
  for (std::size_t column = 0; column < 2; ++column) {
    Oscillator::Past start{};
    start[0][column] = 1;
    Number next[2];
    oscillator.step(m, start, next);
    for (std::size_t r = 0; r < 2; ++r) matrix[r][column] = next[r];
  }
  if (free) return std::abs(matrix[1][1]);
  const Number half_trace = (matrix[0][0] + matrix[1][1]) / 2.0;
  Number square = half_trace * half_trace - (matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0]);
  // Two eigenvalues that rounding alone parts are one: the root would make much of it.
  if (std::abs(square) <= tolerance * std::norm(half_trace)) square = 0;
  const Number root = std::sqrt(square);
  return std::max(std::abs(half_trace + root), std::abs(half_trace - root));
}

/// Growth so weak that it counts as none at small steps: a method of high order may grow at all of them.
constexpr double faint = 1e-9;

/// Largest s such that radius(t) <= 1 for all t in (0, s]; 0 if it already grows at small t.
template <class F>
double boundary(F radius, double scale) {
  const double small = 0.05 * scale;
  if (radius(small) > 1 + tolerance) return 0;
  double low = small, high = small;
  while (radius(high) <= 1 + tolerance) {
    low = high;
    high *= 1.02;
    if (high > 1e3 * scale) return std::numeric_limits<double>::infinity();
  }
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (radius(middle) <= 1 + tolerance ? low : high) = middle;
  }
  // Where growth rises so slowly that rounding alone hides it below, it was there all along.
  double most = 0;
  for (const double beyond : {1.1, 1.2, 1.3, 1.4, 1.5}) most = std::max(most, radius(beyond * low));
  return most <= 1 + faint ? 0 : low;
}

}  // namespace

/// What pushes away (a centrifugal force) and is held neither by turning nor against drag grows by itself, which is not
/// the method's doing: of that force, as much counts as does not grow.
StepLimit step_limit(std::string_view integrator, double h, double k, double c, double g) {
  if (k == 0 && c == 0 && g == 0) return {std::numeric_limits<double>::infinity(), 1};
  const Row& row = *find_row(integrator);
  const double spring = std::max(k, c > 0 ? 0 : -g * g / 4);
  const auto radius = [&](double step) { return spectral_radius(row, spring * step * step, c * step, g * step); };
  return {boundary(radius, 1 / std::max({std::sqrt(std::abs(spring)), c, g})), radius(h)};
}

std::vector<IntegratorDescription> describe_integrators() {
  std::vector<IntegratorDescription> all;
  for (const Row& row : rows()) {
    const int evaluations = row.phases;
    const bool blind = row.family == Family::splitting && (row.order > 2 || row.turns_velocity);  // refuses drag
    const double real = blind ? 0 : boundary([&](double t) { return spectral_radius(row, 0, t, 0); }, 1);
    const double imaginary = boundary([&](double t) { return spectral_radius(row, t * t, 0, 0); }, 1);
    all.push_back({row.name, row.doc, row.source, name(row.family), row.order, evaluations, row.embeds(), row.history,
                   row.symplectic, row.turns_velocity, real, imaginary, row.family == Family::implicit_runge_kutta});
  }
  return all;
}

/// Does its error hold a force at the end of the step?
bool estimates_at_end(std::string_view integrator) {
  const Method pair = pair_for(*find_row(integrator), 1, 1);
  for (int p = 0; p < pair.phases; ++p) {
    for (int e = 0; e < pair.errors; ++e) {
      if (pair.error[e][p] != 0 && std::abs(pair.offset[p] - 1) < 1e-6) return true;
    }
  }
  return false;
}

void Builder::check_stability() {
  if (world_.adaptive_) return;  // the tolerance keeps steps small enough
  for (const auto& [group, per_mass] : local_stiffness_) check_stability("group " + group->name, per_mass);
  for (const auto& [group, rate] : spin_damping_)
    check_stability("the spin of group " + group->name, {.damping = rate});
  Stiffness all;  // bonds pull beside each other and beside what holds their bodies in place
  std::string names;
  for (const PairSystem& system : world_.pair_systems_) {
    const Stiffness per_mass = system.effect->per_mass();
    if (!per_mass.any()) continue;
    Stiffness held;
    for (const auto& [group, local] : local_stiffness_) {
      if (!system.acts_on(static_cast<std::size_t>(group - world_.groups_.data()))) continue;
      held = larger(held, local);
    }
    all = all + per_mass + held;
    names += (names.empty() ? "" : ", ") + std::string(system.name());
  }
  if (!names.empty()) check_stability(names, all);
}

/// A step beyond the limit is said, never silent. A method that grows at every step is reported when the growth over
/// the run is more than a tenth.
void Builder::check_stability(const std::string& whose, const Stiffness& per_mass) {
  world_.stiffnesses_.emplace_back(whose, per_mass);
  if (world_.status_.code != Status::Code::ok) return;
  const double h = world_.step_;
  const StepLimit limit = world_.limit_of(per_mass);
  const std::string group_and_method = world_.row_->name + std::string(" on ") + whose;
  if (limit.largest > 0 && h > limit.largest * (1 + 1e-6)) {
    world_.status_ = {Status::Code::stability, "a step of " + text(h) + " s exceeds " + text(limit.largest) +
                                                   " s, the stability limit of " + group_and_method};
  } else if (limit.largest == 0) {
    const double growth = std::exp(std::log(limit.growth) * scene_.run.duration / h);
    if (growth > 1.1) {
      world_.status_ = {Status::Code::stability, "no step is stable for " + group_and_method +
                                                     ": this oscillation grows by a factor of " + text(growth) +
                                                     " over the run"};
    }
  }
}

/// An iteration leaves the share h |lambda| |alpha| of the stages' error, at the largest eigenvalues of the oscillator
/// and of the row's a.
double FixedPoint::largest_step(const Row& row, const Stiffness& per_mass) {
  Companion<double> a{};
  const auto n = static_cast<std::size_t>(row.phases);
  for (std::size_t i = 0; i < n * n; ++i) a[i] = static_cast<double>(row.a[i / n][i % n]);
  const auto [one, other] = eigenvalues(per_mass.spring, per_mass.damping, per_mass.gyration);
  return most_left / (spectral_radius(a, n) * std::max(std::abs(one), std::abs(other)));
}

/// What else holds the bodies that touch, at most.
Stiffness World::beside_contacts() const {
  Stiffness most;
  for (const auto& [name, per_mass] : stiffnesses_) {
    most = larger(most, per_mass);
  }
  return most;
}

StepLimit World::limit_of(const Stiffness& per_mass) const {
  StepLimit limit = f64::step_limit(row_->name, step_, per_mass.spring, per_mass.damping, per_mass.gyration);
  if (fixed_point_) limit.largest = std::min(limit.largest, FixedPoint::largest_step(*row_, per_mass));
  return limit;
}

/// A contact swings for half a turn: what grows at every step is reported when that is more than a tenth of it.
void World::judge_contacts(const Stiffness& of_contacts) {
  if (adaptive_) return;
  const Stiffness all = of_contacts + beside_contacts();  // stages that are iterated tell of themselves
  const StepLimit limit = f64::step_limit(row_->name, step_, all.spring, all.damping, all.gyration);
  const double steps = 3.14159 / (std::sqrt(all.spring) * step_);
  const bool exceeded = limit.largest > 0 && step_ > limit.largest * (1 + 1e-6);
  const bool grows = limit.largest == 0 && std::exp(std::log(limit.growth) * steps) > 1.1;
  if (!exceeded && !grows) return;
  const std::string contacts = std::string(row_->name) + " on contacts (contact.stiffness)";
  std::string sentence = exceeded ? "a step of " + text(step_) + " s exceeds " + text(limit.largest) +
                                        " s, the stability limit of " + contacts
                                  : "no step is stable for " + contacts + ": one of " + text(step_) +
                                        " s gains more than a tenth of its speed in each impact";
  if (status_.code != Status::Code::ok) sentence += "; " + status_.sentence;
  status_ = {Status::Code::stability, std::move(sentence), 0, counters_.steps, time()};
}

}  // namespace ballpark::BALLPARK_PRECISION
