#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/nearest.h"
#include "engine/world/check.h"

namespace ballpark {

namespace {

constexpr double pi = 3.141592653589793;
constexpr std::size_t most_bodies = 1000000000;  // of one group

bool generates_spin(const BodyGroup& group) {
  return group.generate && group.generate->angular_velocity_spread != Vector3d::Zero();
}

/// Checks one group's lists; knows its path and its number of bodies.
struct GroupCheck {
  const Scene& scene;
  const BodyGroup& group;
  std::size_t index;
  Problems& problems;
  std::size_t bodies = body_count(group);

  std::string path(const char* key) const { return path_of("bodies", index, key); }

  template <class T, class F>
  void each(const char* key, const std::vector<T>& rows, F check_row) {
    if (rows.size() > 1 && rows.size() != bodies) {
      problems.add(path(key),
                   fmt::format("has {} rows, expected one, or one for each of the {} bodies", rows.size(), bodies));
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!check_row(path_of(path(key), i, rows.size()), rows[i])) return;  // one message a list
    }
  }

  void run() {
    check_size();
    check_generate();
    const auto vector = [this](const char* unit) {
      return [this, unit](const std::string& at, const Vector3d& v) { return problems.finite(at, v, unit); };
    };
    each("position", group.position, vector("m"));
    each("velocity", group.velocity, vector("m/s"));
    each("angular_velocity", group.angular_velocity, vector("rad/s"));
    check_matter();
    each("inertia", group.inertia, [this](const std::string& at, const Vector3d& v) { return good_inertia(at, v); });
    each("orientation", group.orientation, [this](const std::string& at, const Quaternion& q) { return unit(at, q); });
    check_rotation();
  }

  void check_size() {
    if (!group.position.empty() && group.generate) {
      problems.add(path("generate"), "stands beside position, expected one of the two");
    }
    if (group.position.empty() && !group.generate && bodies > 1) {
      problems.add(path("position"), fmt::format("is missing, though other lists have {} rows", bodies));
    }
    if (bodies > most_bodies)
      problems.add(path("generate"), fmt::format("makes {} bodies, expected at most {}", bodies, most_bodies));
  }

  void check_generate() {
    if (!group.generate) return;
    const Generate& g = *group.generate;
    const auto at = [this](const char* key) { return path("generate") + "." + key; };
    if (!problems.known(at("kind"), "generator", g.kind, {"lattice", "random", "rack", "plummer"})) return;
    const bool lattice = g.kind == "lattice";
    if (g.count.size() != (lattice ? 3u : 1u)) {
      problems.add(at("count"), lattice ? "expected three numbers, [nx, ny, nz]" : "expected one number");
    }
    if (lattice || g.kind == "rack") {
      problems.positive(at("spacing"), g.spacing, "m");
      problems.finite(at("origin"), g.origin, "m");
    } else if (g.kind == "plummer") {
      problems.positive(at("scale"), g.scale, "m");
      problems.finite(at("origin"), g.origin, "m");
      problems.not_negative(at("strength"), g.strength, "m^3/s^2");
    } else if (problems.finite(at("lower"), g.lower, "m") && problems.finite(at("upper"), g.upper, "m") &&
               (g.upper - g.lower).minCoeff() < 0) {
      problems.add(at("upper"), "is below lower in a component, expected a box");
    }
    problems.finite(at("velocity_spread"), g.velocity_spread, "m/s");
    problems.finite(at("angular_velocity_spread"), g.angular_velocity_spread, "rad/s");
  }

  void check_matter() {
    if (!group.shape.empty()) problems.known(path("shape"), "shape", group.shape, {"sphere"});
    const auto positive = [this](const char* unit) {
      return [this, unit](const std::string& at, double v) { return problems.positive(at, v, unit); };
    };
    each("radius", group.radius, positive("m"));
    each("mass", group.mass, positive("kg"));
    each("density", group.density, positive("kg/m^3"));
    if (!group.shape.empty() && group.radius.empty()) problems.add(path("radius"), "is missing, a sphere needs one");
    if (!group.mass.empty() && !group.density.empty()) {
      problems.add(path("density"), "stands beside mass, expected one of the two");
    }
    if (group.mass.empty() && group.density.empty()) {
      problems.add(path("mass"), "is missing, expected mass [kg], or density [kg/m^3] with a shape");
    }
    check_derived();
    if (!group.density.empty() && group.shape.empty()) problems.add(path("density"), "needs a shape, expected mass");
  }

  /// Mass and inertia that follow from a radius must be in range as well.
  void check_derived() {
    const std::size_t rows = std::max({group.radius.size(), group.mass.size(), group.density.size()});
    const bool complete = !group.radius.empty() && group.mass.empty() != group.density.empty();
    for (std::size_t i = 0; complete && !group.shape.empty() && i < rows && i < bodies; ++i) {
      const double given = group.mass.empty() ? row_or(group.density, i, 0.0) : row_or(group.mass, i, 0.0);
      if (!problems.holds(given) || !problems.holds(row_or(group.radius, i, 0.0))) return;  // said already
      const double mass = mass_of(group, i), moment = inertia_of(group, i).x();
      if (problems.holds(mass) && problems.holds(moment) && problems.holds(1 / moment)) continue;
      problems.add(
          path(group.mass.empty() ? "density" : "radius"),
          fmt::format("gives a mass of {:g} kg and a moment of inertia of {:g} kg m^2, beyond this precision's range",
                      mass, moment));
      return;
    }
  }

  bool good_inertia(const std::string& at, const Vector3d& moments) {
    for (int c = 0; c < 3; ++c) {
      if (!problems.positive(at, moments[c], "kg m^2")) return false;
    }
    const double largest = moments.maxCoeff();
    if (2 * largest <= moments.sum() * (1 + 1e-12)) return true;
    problems.add(
        at, fmt::format("[{:g}, {:g}, {:g}] is no body's inertia: the largest exceeds the sum of the other two, {:g}",
                        moments.x(), moments.y(), moments.z(), moments.sum() - largest));
    return false;
  }

  bool unit(const std::string& at, const Quaternion& q) {
    const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    if (std::abs(norm - 1) <= 1e-6) return true;
    problems.add(at, fmt::format("has length {:g}, expected a unit quaternion [w, x, y, z] to 1e-6", norm));
    return false;
  }

  void check_rotation() {
    problems.known(path("angular_velocity_frame"), "frame", group.angular_velocity_frame, {"world", "body"});
    const bool pivoted = pivot_of(scene, group) != nullptr;
    const bool asks = !group.angular_velocity.empty() || generates_spin(group);
    if (asks && !rotates(group) && !pivoted) {
      problems.add(path("angular_velocity"),
                   "given for particles, which do not rotate: expected a shape or an inertia");
    }
  }
};

}  // namespace

std::size_t body_count(const BodyGroup& group) {
  std::size_t most =
      std::max({group.position.size(), group.velocity.size(), group.angular_velocity.size(), group.orientation.size(),
                group.mass.size(), group.density.size(), group.radius.size(), group.inertia.size()});
  if (group.generate) {
    std::size_t made = group.generate->count.empty() ? 0 : 1;
    for (const std::size_t n : group.generate->count) {
      if (n != 0 && made > std::size_t(-1) / n) return std::size_t(-1);
      made *= n;
    }
    if (group.generate->kind == "rack") return made < most_bodies ? made * (made + 1) / 2 : made;
    return made;
  }
  return group.position.empty() && most <= 1 ? 0 : most;
}

bool rotates(const BodyGroup& group) {
  return !group.shape.empty() || !group.inertia.empty();
}

double mass_of(const BodyGroup& group, std::size_t body) {
  if (!group.mass.empty()) return row_or(group.mass, body, 0.0);
  const double r = row_or(group.radius, body, 0.0);
  return row_or(group.density, body, 0.0) * (4.0 / 3.0) * pi * r * r * r;
}

/// A solid sphere has 2/5 m R^2 about every axis.
Vector3d inertia_of(const BodyGroup& group, std::size_t body) {
  if (!group.inertia.empty()) return row_or(group.inertia, body, Vector3d(0, 0, 0));
  const double r = row_or(group.radius, body, 0.0);
  const double moment = group.shape.empty() ? 0 : 0.4 * mass_of(group, body) * r * r;
  return {moment, moment, moment};
}

void check_bodies(const Scene& scene, Problems& problems) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const BodyGroup& group = scene.bodies[i];
    GroupCheck{scene, group, i, problems}.run();
    for (std::size_t j = 0; j < i; ++j) {
      if (group.name == scene.bodies[j].name) {
        problems.add(path_of("bodies", i, "name"), "\"" + group.name + "\" is the name of an earlier group");
      }
    }
  }
}

}  // namespace ballpark
