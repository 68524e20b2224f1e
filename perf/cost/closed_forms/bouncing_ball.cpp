// A ball that bounces on a plane under gravity: flights that shorten as a geometric series, then rest.
#include "perf/cost/closed_forms/acting.h"

namespace ballpark::cost {

namespace {

/// The law of a ball and the plane (as `Material` has it): of the pair, else geometric means.
template <class R>
struct Law {
  R restitution, friction, restitution_speed;

  Law(const Scene& scene, const std::string& one, const std::string& two) {
    const auto pair = std::find_if(scene.material_pairs.begin(), scene.material_pairs.end(), [&](const auto& p) {
      return p.between == std::vector{one, two} || p.between == std::vector{two, one};
    });
    const auto of = [&](const std::string& name) { return name.empty() ? Material{} : scene.materials.at(name); };
    const auto mean = [](double a, double b) { return a == b ? R(a) : std::sqrt(R(a) * R(b)); };
    const bool given = pair != scene.material_pairs.end();
    restitution = given ? R(pair->restitution) : mean(of(one).restitution, of(two).restitution);
    friction = given ? R(pair->friction) : mean(of(one).friction, of(two).friction);
    restitution_speed = given ? R(pair->restitution_speed) : mean(of(one).restitution_speed, of(two).restitution_speed);
  }
};

double radius_of(const LoneBody& ball) {
  const std::vector<double>& radius = ball.group.radius;
  return radius.size() == 1 ? radius.front() : radius.at(ball.index);
}

struct Bounce {
  const LoneBody& ball;
  const Boundary& plane;
  const Scene& scene;
};

template <class R>
struct Progress {
  R height, speed;  // over the plane, upwards
};

/// From impact at speed V, W = e V: flight n = 0, 1, .. begins with W e^n at 2 W/g (1 - e^n)/(1 - e) after it
/// (Bernstein, Am. J. Phys. 45 (1977) 41; numerics 2.2). At the moment of an impact: as before it.
template <class R>
class BouncingBall {
 public:
  explicit BouncingBall(const Bounce& given)
      : normal_(given.plane.normal.cast<R>().stableNormalized()),
        gravity_(-normal_.dot(gravity<R>(given.ball))),
        restitution_(Law<R>(given.scene, given.ball.group.material, given.plane.material).restitution),
        radius_(radius_of(given.ball)),
        spin_(given.ball) {
    const Vector<R> x = given.ball.start.position.cast<R>(), v = given.ball.start.velocity.cast<R>();
    const Vector<R> over = x - given.plane.point.cast<R>();
    const R distance = normal_.dot(over), gap = distance - radius_;
    fits_ = gap >= -R(geometry_tolerance) * (over.norm() + radius_);
    gap_ = std::max(gap, R(0));
    foot_ = x - distance * normal_;
    speed_ = normal_.dot(v);
    across_ = v - speed_ * normal_;
    const R impact = std::sqrt(speed_ * speed_ + 2 * gravity_ * gap_);
    first_ = speed_ < 0 ? 2 * gap_ / (impact - speed_) : (impact + speed_) / gravity_;
    after_ = restitution_ * impact;
    flight_ = 2 * after_ / gravity_;
    if (flight_ > 0) rest_ = restitution_ < 1 ? flight_ / (1 - restitution_) : std::numeric_limits<R>::infinity();
  }
  bool fits() const { return fits_; }
  ExactState<R> at(R t) const {
    const Progress<R> p = progress(t);
    return state_of<R>(foot_ + t * across_ + (radius_ + std::max(p.height, R(0))) * normal_,
                       across_ + p.speed * normal_, spin_.orientation(t), spin_.spin());
  }

 private:
  Progress<R> progress(R t) const {
    if (t <= first_) return {gap_ + t * (speed_ - gravity_ * t / 2), speed_ - gravity_ * t};
    const R since = t - first_;
    if (since >= rest_) return {0, 0};
    const R n = flight_at(since), share = std::pow(restitution_, n), up = share * after_;
    const R own = std::clamp(since - begin_of(n), R(0), share * flight_);
    return {own * (up - gravity_ * own / 2), up - gravity_ * own};
  }
  /// Rounding may miss by one; where it would by more, flights are too short to tell.
  R flight_at(R since) const {
    const R passed = restitution_ < 1 ? std::log1p(-since / rest_) / std::log(restitution_) : since / flight_;
    const R n = std::max(R(0), std::ceil(passed) - 1);
    if (n > 0 && begin_of(n) >= since) return n - 1;
    return begin_of(n + 1) < since ? n + 1 : n;
  }
  R begin_of(R n) const {
    if (restitution_ == 1) return n * flight_;
    const R left = std::pow(restitution_, n);
    return rest_ * (left < R(0.9) ? 1 - left : -std::expm1(n * std::log(restitution_)));
  }

  Vector<R> normal_, foot_, across_;
  R gravity_, restitution_, radius_;
  UniformSpin<R> spin_;
  R gap_ = 0, speed_ = 0, first_ = 0, after_ = 0, flight_ = 0;
  R rest_ = 0;  // from the first impact on [s]
  bool fits_ = false;
};

/// Where [m] or how fast [m/s] along the plane.
Vector3d along(const Boundary& plane, const Vector3d& a) {
  const Vector3d normal = plane.normal.stableNormalized();
  return a - normal.dot(a) * normal;
}

bool drifts(const Boundary& plane, const LoneBody& ball) {
  return along(plane, ball.start.velocity).norm() > geometry_tolerance * ball.start.velocity.norm();
}

/// A ball that falls straight towards the plane, and that friction will never turn.
bool only_bounces(const Scene& scene, const Boundary& plane, const LoneBody& ball) {
  if (ball.group.shape != "sphere" || !only_these_act(ball, {"gravity"}) || !spins_uniformly(ball)) return false;
  const Vector3d pull = gravity<double>(ball);
  if (!(plane.normal.dot(pull) < 0) || along(plane, pull).norm() > geometry_tolerance * pull.norm()) return false;
  const bool slips = drifts(plane, ball) || !ball.start.angular_velocity.isZero(0);
  return !slips || Law<double>(scene, ball.group.material, plane.material).friction == 0;
}

/// Unless each stays on its own line, and the lines are far enough apart.
bool may_meet(const TouchingBodies& all, const LoneBody& ball, const LoneBody& other) {
  const Boundary& plane = all.scene.boundaries.front();
  if (drifts(plane, ball) || drifts(plane, other) || !only_bounces(all.scene, plane, other)) return true;
  const double apart = along(plane, ball.start.position - other.start.position).norm();
  return !(apart > (1 + geometry_tolerance) * (radius_of(ball) + radius_of(other)));
}

}  // namespace

std::optional<ExactMotion> bouncing_ball(const TouchingBodies& all, std::size_t id) {
  const Scene& scene = all.scene;
  if (scene.contact.kind != "impulse" || scene.contact.restitution_threshold != 0) return std::nullopt;
  if (scene.boundaries.size() != 1) return std::nullopt;
  const Boundary& plane = scene.boundaries.front();
  if (plane.shape != "plane" || plane.motion || !plane.surface_velocity.isZero(0)) return std::nullopt;
  const LoneBody& ball = all.bodies.at(id);
  if (!only_bounces(scene, plane, ball)) return std::nullopt;
  if (Law<double>(scene, ball.group.material, plane.material).restitution_speed > 0) return std::nullopt;
  for (std::size_t i = 0; i < all.bodies.size(); ++i) {
    const LoneBody& other = all.bodies[i];
    if (i != id && !other.group.shape.empty() && may_meet(all, ball, other)) return std::nullopt;
  }
  return motion_of<BouncingBall>("bounces on a plane (geometric series: Bernstein 1977)", Bounce{ball, plane, scene});
}

}  // namespace ballpark::cost
