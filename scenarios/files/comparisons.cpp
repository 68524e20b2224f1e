#include "scenarios/files/comparisons.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "ballpark/catalogue.h"
#include "scenarios/files/stress_check.h"
#include "scenarios/files/timetable.h"

namespace ballpark::scenes {

namespace {

/// To the time, or the step nearest to it.
void walk(World& world, const RunSettings& run, double time) {
  const Pace pace(run);
  if (!pace.by_steps()) return world.advance_to(time);
  const auto steps = static_cast<std::uint64_t>(pace.at(time));
  if (steps > world.steps()) world.step(steps - world.steps());
}

double position_difference(const BodyState& a, const BodyState& b, const Vector3d& shift) {
  return (b.position - shift - a.position).norm();
}

/// With Inf or NaN in it, infinite: the largest must not forget it.
double larger(double most, double next) {
  return std::isfinite(next) ? std::max(most, next) : std::numeric_limits<double>::infinity();
}

template <class Distance>
double largest(const std::vector<BodyState>& bodies, Distance distance) {
  double most = 0;
  for (std::size_t id = 0; id < bodies.size(); ++id) most = larger(most, distance(id));
  return most;
}

bool same_bits(const Vector3d& a, const Vector3d& b) {
  return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
}

bool same_bits(const BodyState& a, const BodyState& b) {
  const double p[] = {a.orientation.w, a.orientation.x, a.orientation.y, a.orientation.z};
  const double q[] = {b.orientation.w, b.orientation.x, b.orientation.y, b.orientation.z};
  return same_bits(a.position, b.position) && same_bits(a.velocity, b.velocity) &&
         same_bits(a.angular_velocity, b.angular_velocity) && std::memcmp(p, q, sizeof p) == 0;
}

class Comparison {
 public:
  Comparison(const SceneFile& file, const Options& options, const Ending& plain)
      : file_(file), scene_(file.scene), options_(options), plain_(plain) {}

  /// Of all runs that one quantity compares, the worst.
  double measured(const std::string& name) const {
    static const std::map<std::string, double (Comparison::*)() const> ways{
        {"repeat", &Comparison::repeat},
        {"threads", &Comparison::threads},
        {"targets", &Comparison::targets_of_machine},
        {"resume", &Comparison::resume},
        {"frame_pattern", &Comparison::frame_pattern},
        {"shift", &Comparison::shift},
        {"with_fault", &Comparison::with_fault},
        {"brute_force", &Comparison::brute_force},
        {"mirror", &Comparison::mirror},
        {"start", &Comparison::start},
        {"unit", &Comparison::unit},
    };
    return (this->*ways.at(name))();
  }
  const Status& status_of_shifted() const { return status_of_shifted_; }

 private:
  double as_plain(const World& world) const { return world.state_hash() == plain_.hash ? 1 : 0; }

  double ends_as_plain(const Options& options) const {
    World world(scene_, options);
    walk(world, scene_.run, scene_.run.duration);
    return as_plain(world);
  }

  double repeat() const { return ends_as_plain(options_); }

  double threads() const {
    double equal = 1;
    for (const int count : {1, 2, 4, 8, 16}) {
      Options options = options_;
      options.threads = count;
      equal = std::min(equal, ends_as_plain(options));
    }
    return equal;
  }

  double targets_of_machine() const {
    double equal = 1;
    for (const NamedDescription& target : targets()) {
      if (!target.available) continue;
      Options options = options_;
      options.target = target.name;
      equal = std::min(equal, ends_as_plain(options));
    }
    return equal;
  }

  double resume() const {
    World first(scene_, options_);
    first.step(plain_.steps / 2);
    World second(scene_, options_);
    second.restore(first.snapshot());
    walk(second, scene_.run, scene_.run.duration);
    return as_plain(second);
  }

  double frame_pattern() const {
    World world(scene_, options_);
    const std::vector<double>& frames = file_.stress->frames;
    double time = 0;
    for (std::size_t k = 0; time < scene_.run.duration; ++k) {
      time = std::min(time + frames[k % frames.size()], scene_.run.duration);
      world.advance_to(time);
    }
    return as_plain(world);
  }

  double shift() const {
    World world(shifted(scene_, file_.stress->shift), options_);
    walk(world, scene_.run, scene_.run.duration);
    const Ending moved = ending_of(world);
    status_of_shifted_ = world.status();
    return largest(plain_.bodies, [&](std::size_t id) {
      return position_difference(plain_.bodies[id], moved.bodies[id], file_.stress->shift);
    });
  }

  double with_fault() const {
    Scene without = scene_;
    without.impulses.clear();
    World world(without, options_);
    walk(world, scene_.run, scene_.run.duration);
    double changed = 0;
    for (std::size_t id = 0; id < plain_.bodies.size(); ++id) {
      const bool hit = std::any_of(scene_.impulses.begin(), scene_.impulses.end(),
                                   [&](const Impulse& impulse) { return impulse.id == id; });
      changed += !hit && !same_bits(plain_.bodies[id], world.body(id));
    }
    return changed;
  }

  /// By id.
  std::vector<double> radii(const World& world) const {
    std::vector<double> list;
    const std::vector<GroupReport> groups = world.explain().groups;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const std::vector<double>& rows = scene_.bodies[g].radius;
      for (std::size_t i = 0; i < groups[g].bodies; ++i) {
        list.push_back(rows.empty() ? 0 : rows[rows.size() == 1 ? 0 : i]);
      }
    }
    return list;
  }

  double brute_force() const {
    World world(scene_, options_);
    walk(world, scene_.run, scene_.run.duration);
    const std::vector<double> radius = radii(world);
    std::vector<std::uint32_t> overlaps(radius.size());
    for (std::size_t a = 0; a < radius.size(); ++a) {
      for (std::size_t b = a + 1; b < radius.size(); ++b) {
        const double reach = radius[a] + radius[b];
        if ((plain_.bodies[a].position - plain_.bodies[b].position).squaredNorm() >= reach * reach) continue;
        ++overlaps[a];
        ++overlaps[b];
      }
    }
    const std::vector<ContactLoad> loads = world.contact_loads();
    double errors = 0;
    for (std::size_t id = 0; id < radius.size(); ++id) errors += loads[id].contacts != overlaps[id];
    return errors;
  }

  double mirror() const {
    return largest(plain_.bodies, [&](std::size_t id) {
      const Vector3d& place = plain_.bodies[id].position;
      const Vector3d image(place.x(), -place.y(), place.z());
      double nearest = std::numeric_limits<double>::infinity();
      for (const BodyState& body : plain_.bodies) nearest = std::min(nearest, (body.position - image).norm());
      return nearest;
    });
  }

  double start() const {
    World world(scene_, options_);
    walk(world, scene_.run, file_.stress->from);
    return largest(plain_.bodies, [&](std::size_t id) {
      return position_difference(world.body(id), plain_.bodies[id], Vector3d::Zero());
    });
  }

  double unit() const {
    return largest(plain_.bodies, [&](std::size_t id) {
      const Quaternion& q = plain_.bodies[id].orientation;
      return std::abs(std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z) - 1);
    });
  }

  const SceneFile& file_;
  const Scene& scene_;
  const Options& options_;
  const Ending& plain_;
  mutable Status status_of_shifted_;
};

/// Where an effect is. An offset from a body is no place, nor are lengths.
bool is_place(const ParameterInfo& info) {
  const bool vector = info.kind == ParameterKind::vector || info.kind == ParameterKind::vectors;
  return vector && info.unit == "m" && info.name != "offset" && info.name != "size";
}

void shift_places(Effect& effect, const Vector3d& by) {
  for (const EffectDescription& description : effects()) {
    if (description.name != effect.kind) continue;
    for (const ParameterInfo& info : description.parameters) {
      if (!is_place(info)) continue;
      Value& value = effect.parameters.try_emplace(info.name, info.fallback.value_or(Vector3d::Zero())).first->second;
      if (auto* one = std::get_if<Vector3d>(&value)) *one += by;
      if (auto* rows = std::get_if<std::vector<Vector3d>>(&value)) {
        for (Vector3d& row : *rows) row += by;
      }
    }
  }
}

}  // namespace

Ending ending_of(const World& world) {
  Ending ending{world.state_hash(), world.steps(), {}};
  for (std::size_t id = 0; id < world.body_count(); ++id) ending.bodies.push_back(world.body(id));
  return ending;
}

Scene shifted(Scene scene, const Vector3d& by) {
  for (BodyGroup& group : scene.bodies) {
    if (group.generate) {
      group.generate->origin += by;
      group.generate->lower += by;
      group.generate->upper += by;
    } else if (group.position.empty()) {
      group.position = {by};
    } else {
      for (Vector3d& place : group.position) place += by;
    }
  }
  for (Boundary& boundary : scene.boundaries) boundary.point += by;
  for (Effect& effect : scene.effects) shift_places(effect, by);
  return scene;
}

Compared compared(const SceneFile& file, const Options& options, const Ending& plain) {
  const Comparison comparison(file, options, plain);
  Compared found;
  for (const ComparisonInfo& info : comparisons()) {
    const auto& wanted = file.stress->compare;
    if (std::find(wanted.begin(), wanted.end(), info.name) == wanted.end()) continue;
    const double measured = comparison.measured(info.name);
    const auto [known, first] = found.measures.try_emplace(info.measure, measured);
    if (!first) known->second = std::min(known->second, measured);  // hashes: one that differs is enough
  }
  found.shifted = comparison.status_of_shifted();
  return found;
}

}  // namespace ballpark::scenes
