// What the start of a scene tells of the step and of the precision it asks for.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/world/build.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

Vector3d in_double(const Vector3<Wide>& a) {
  return {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
}

/// r and v of one body about what attracts it by mu / r^2; softened or not, it comes about as near.
struct Orbit {
  std::size_t id = 0;
  Vector3d place, velocity;
  double mu = 0, softening = 0;

  double distance() const { return place.norm(); }
  double energy() const { return velocity.squaredNorm() / 2 - mu / distance(); }
  double eccentricity() const {
    const double l = place.cross(velocity).norm() / mu;
    return std::sqrt(std::max(0.0, 1 + 2 * energy() * l * l));
  }
  double pericentre() const { return place.cross(velocity).squaredNorm() / mu / (1 + eccentricity()); }

  /// Until it is there for the next time [s]. Bound: Kepler's equation, n t = E - e sin E. Unbound: at least so long
  /// as the way there takes at the speed of the start or of what it falls to.
  double time_to_pericentre() const {
    const double inward = place.dot(velocity);
    if (energy() >= 0) return inward < 0 ? distance() / top_speed() : std::numeric_limits<double>::infinity();
    const double a = -mu / (2 * energy());
    const double e_sin = inward / std::sqrt(mu * a), e_cos = 1 - distance() / a;
    const double mean = std::atan2(e_sin, e_cos) - e_sin;
    return (mean <= 0 ? -mean : 2 * std::numbers::pi - mean) * std::sqrt(a / mu) * a;
  }
  double top_speed() const { return std::sqrt(2 * (energy() + mu / pericentre())); }

  /// Nearest point that the run comes to [m]. What passes with hardly a turn needs no short steps there.
  double nearest(double duration) const {
    constexpr double hardly_turns = 10;  // eccentricity: by 2 asin(1 / e), 11 degrees
    if (energy() >= 0 && (pericentre() == 0 || eccentricity() > hardly_turns)) return distance();
    return time_to_pericentre() <= duration ? std::min(distance(), pericentre()) : distance();
  }
  /// Of the swing about a circle at this distance [1/s].
  double swing_rate(double at) const {
    const double square = at * at + softening * softening;
    return std::sqrt(mu / (square * std::sqrt(square)));
  }
};

struct StartingBody {
  std::size_t id;
  double mass;
  Vector3d place, velocity;
};

/// Bodies of the first copy that the effect acts on, in the order of ids.
std::vector<StartingBody> starts(const Scene& scene, const Effect& effect, double perturb) {
  std::vector<StartingBody> all;
  std::size_t first = 0;
  for (std::size_t g = 0; g < scene.bodies.size(); ++g) {
    const std::size_t count = body_count(scene.bodies[g]), acted_on = acts_on(effect, scene.bodies[g]) ? count : 0;
    for (std::size_t i = 0; i < acted_on; ++i) {
      const Start start = start_of(scene, g, i, scene.run.seed, perturb);
      all.push_back({first + i, mass_of(scene.bodies[g], i), in_double(start.position), in_double(start.velocity)});
    }
    first += count;
  }
  return all;
}

/// Orbits that the effect is known to hold bodies on: about a centre, or of two bodies about each other.
std::vector<Orbit> orbits(const Scene& scene, const Effect& effect, double perturb) {
  const bool central = effect.kind == "central_gravity";
  if (!central && effect.kind != "mutual_gravity") return {};
  const auto parameters = complete_parameters(effect, *find_effect(effect.kind));
  const double strength = std::get<double>(parameters.at("strength"));
  const double softening = std::get<double>(parameters.at("softening"));
  if (!(strength > 0)) return {};
  std::vector<Orbit> all;
  const std::vector<StartingBody> bodies = starts(scene, effect, perturb);
  if (central) {
    const auto centre = std::get<Vector3d>(parameters.at("centre"));
    for (const StartingBody& body : bodies) {
      all.push_back({body.id, body.place - centre, body.velocity, strength, softening});
    }
  } else if (bodies.size() == 2) {
    const StartingBody &a = bodies[0], &b = bodies[1];
    all.push_back({a.id, b.place - a.place, b.velocity - a.velocity, strength * (a.mass + b.mass), softening});
  }
  return all;
}

/// Farthest coordinate of the bodies at their start, and the width of the scene: how far apart bodies, boundaries and
/// places of effects are, how large bodies are, how far they fly and fall in the run.
struct Extent {
  Vector3d lower = Vector3d::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
  double largest = 0, farthest = 0;

  void add_place(const Vector3d& place) { lower = lower.cwiseMin(place), upper = upper.cwiseMax(place); }
  void add_body(const Vector3d& place, double size) {
    add_place(place);
    largest = std::max(largest, size), farthest = std::max(farthest, place.cwiseAbs().maxCoeff());
  }
  /// Places and accelerations among its parameters, whatever they are called.
  void add_effect(const Effect& effect, double duration) {
    const EffectDescription& description = *find_effect(effect.kind);
    const auto parameters = complete_parameters(effect, description);
    for (const ParameterInfo& info : description.parameters) {
      if (info.kind != ParameterKind::vector || !parameters.contains(info.name)) continue;
      const Vector3d& value = std::get<Vector3d>(parameters.at(info.name));
      if (info.unit == "m" && info.name != "offset" && info.name != "size") add_place(value);
      if (info.unit == "m/s^2") largest = std::max(largest, value.norm() * duration * duration / 2);
    }
  }
  double width() const { return farthest > 0 ? std::max(largest, (upper - lower).maxCoeff()) : 0; }
};

}  // namespace

/// A fixed step must resolve the nearest point of the orbits that bodies start on: a swing there is to take more than
/// two steps, and to be stable.
void Builder::check_orbits() {
  if (world_.adaptive_ || world_.status_.code != Status::Code::ok) return;
  double rate = 0, near = 0;
  std::size_t id = 0;
  for (const Effect& effect : scene_.effects) {
    for (const Orbit& orbit : orbits(scene_, effect, options_.perturb)) {
      if (!(orbit.place.norm() > 0)) continue;
      const double distance = orbit.nearest(scene_.run.duration), its = orbit.swing_rate(distance);
      if (its > rate) rate = its, near = distance, id = orbit.id;
    }
  }
  if (rate == 0) return;
  const double stable = world_.limit_of({.spring = rate * rate}).largest, resolved = std::numbers::pi / rate;
  const double limit = stable > 0 ? std::min(stable, resolved) : 1 / rate;
  if (world_.step_ <= limit) return;
  world_.status_ = {Status::Code::stability,
                    "a step of " + text(world_.step_) + " s exceeds " + text(limit) + " s, what " + world_.row_->name +
                        " needs at the nearest point of the orbit of body " + std::to_string(id) + ", at " +
                        text(near) + " m",
                    id};
}

/// Far from the origin coordinates are coarse: they must resolve the scene to at least half of the precision's digits.
void Builder::check_resolution() {
  Extent extent;
  for (const Group& group : world_.groups_) {
    if (group.pivots()) continue;  // whose places follow from their rotation
    const StateColumns& state = group.kernel.state;
    const BodyGroup& body = scene_.bodies[group.scene_index];
    for (std::size_t row = 0; row < group.live; ++row) {
      if (!group.presence.has(row) || !is_finite(group, row)) continue;
      const auto at = [row](Real* const(&columns)[3]) {
        return Vector3d(static_cast<double>(columns[0][row]), static_cast<double>(columns[1][row]),
                        static_cast<double>(columns[2][row]));
      };
      const double radius = row_or(body.radius, group.copies.index_of(row), 0.0);
      extent.add_body(at(state.position), std::max(2 * radius, at(state.velocity).norm() * scene_.run.duration));
    }
  }
  for (const Boundary& boundary : scene_.boundaries) extent.add_place(boundary.point);
  for (const Effect& effect : scene_.effects) extent.add_effect(effect, scene_.run.duration);
  const double epsilon = static_cast<double>(std::numeric_limits<Real>::epsilon());
  const double spacing = std::exp2(std::floor(std::log2(extent.farthest))) * epsilon;
  if (!(extent.width() > 0) || !(spacing > std::sqrt(epsilon) * extent.width())) return;
  std::string sentence = "coordinates near " + text(extent.farthest) + " m are " + text(spacing) +
                         " m apart in this precision, too coarse for a scene " + text(extent.width()) + " m wide";
  if (world_.status_.code != Status::Code::ok) sentence += "; " + world_.status_.sentence;
  world_.status_ = {Status::Code::accuracy, std::move(sentence)};
}

}  // namespace ballpark::BALLPARK_PRECISION
