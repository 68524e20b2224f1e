// Materials, boundaries and contact settings.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/nearest.h"
#include "engine/world/check.h"

namespace ballpark {

namespace {

std::vector<std::string> names_of(const std::vector<NamedDescription>& list) {
  std::vector<std::string> names;
  for (const NamedDescription& item : list) names.push_back(item.name);
  return names;
}

Material law_of(const MaterialPair& pair) {
  return {pair.restitution, pair.friction, pair.restitution_speed, pair.cohesion};
}

/// Of a dashpot that does not pull, at a damping ratio of 10: exp(-b/s ln((b + s)/(b - s))), s = sqrt(b^2 - 1).
constexpr double least_restitution = 0.0025;

struct ContactCheck {
  const Scene& scene;
  Problems& problems;
  std::vector<std::string> materials;

  void run() {
    for (const auto& [name, material] : scene.materials) {
      materials.push_back(name);
      check_law("materials." + name, material);
    }
    for (std::size_t i = 0; i < scene.material_pairs.size(); ++i) check_pair(i);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      check_material(path_of("bodies", i, "material"), scene.bodies[i].material);
    }
    for (std::size_t i = 0; i < scene.boundaries.size(); ++i) check_boundary(i);
    check_periods();
    check_settings();
    if (touches(scene)) check_bodies_in_contact();
  }

  void check_law(const std::string& path, const Material& law) {
    if (!(law.restitution >= 0 && law.restitution <= 1)) {
      problems.add(path + ".restitution", fmt::format("is {}, expected a number from 0 to 1", text(law.restitution)));
    }
    problems.not_negative(path + ".friction", law.friction, "1");
    problems.not_negative(path + ".restitution_speed", law.restitution_speed, "m/s");
    problems.not_negative(path + ".cohesion", law.cohesion, "J/m^2");
    const bool penalty = scene.contact.kind == "penalty";
    if (penalty && law.restitution_speed > 0) {
      problems.add(path + ".restitution_speed",
                   "is given, but springs and dashpots have one restitution for all speeds: expected contact.kind = "
                   "\"impulse\", or 0");
    }
    if (scene.contact.kind == "impulse" && law.cohesion > 0) {
      problems.add(path + ".cohesion",
                   "is given, but impulses do not hold surfaces together: expected contact.kind = \"penalty\", or 0");
    }
  }

  void check_material(const std::string& path, const std::string& name) {
    if (!name.empty()) problems.known(path, "material", name, materials);
  }

  void check_pair(std::size_t i) {
    const MaterialPair& pair = scene.material_pairs[i];
    const std::string path = path_of("material_pairs", i);
    check_law(path, law_of(pair));
    if (pair.between.size() != 2) return problems.add(path + ".between", "expected the names of two materials");
    for (std::size_t k = 0; k < 2; ++k) check_material(path_of(path + ".between", k, 2), pair.between[k]);
    for (std::size_t j = 0; j < i; ++j) {
      const auto& other = scene.material_pairs[j].between;
      if (std::is_permutation(other.begin(), other.end(), pair.between.begin(), pair.between.end())) {
        problems.add(path + ".between", "names the two materials of an earlier pair");
      }
    }
  }

  void check_boundary(std::size_t i) {
    const Boundary& wall = scene.boundaries[i];
    const auto path = [i](const char* key) { return path_of("boundaries", i, key); };
    if (!problems.known(path("shape"), "boundary", wall.shape, names_of(boundary_shapes()))) return;
    problems.finite(path("point"), wall.point, "m");
    check_material(path("material"), wall.material);
    problems.finite(path("surface_velocity"), wall.surface_velocity, "m/s");
    if (problems.finite(path("normal"), wall.normal, "1") && !(wall.normal.norm() > 1e-100)) {
      problems.add(path("normal"), "has length 0, expected a direction");
    }
    const bool box = wall.shape == "box", periodic = wall.shape == "periodic";
    for (int c = 0; c < 3; ++c) {
      if (box && !problems.positive(path("size"), wall.size[c], "m")) break;
      if (periodic && !problems.not_negative(path("size"), wall.size[c], "m")) break;
    }
    if (periodic && wall.size == Vector3d::Zero()) problems.add(path("size"), "is zero, expected a length to repeat");
    if (wall.shape == "tube") problems.positive(path("radius"), wall.radius, "m");
    problems.known(path("side"), "side", wall.side, {"inside", "outside"});
    for (const std::string& face : wall.open) {
      problems.known(path("open"), "face", face, {"-x", "+x", "-y", "+y", "-z", "+z"});
    }
    if (!wall.open.empty() && !(box && wall.side == "inside")) {
      problems.add(path("open"), "leaves out faces, which only a box has that is seen from inside");
    }
    if (wall.motion) check_motion(i, *wall.motion);
    if (scene.contact.kind.empty() && !(periodic && acts_between_bodies())) {
      problems.add(path("shape"), fmt::format("needs contacts{}, expected [contact] with a kind, e.g. \"impulse\"",
                                              periodic ? " or an effect between bodies" : ""));
    }
  }

  /// Such effects reach for nearest images.
  bool acts_between_bodies() const {
    return std::any_of(scene.effects.begin(), scene.effects.end(), [](const Effect& effect) {
      const EffectDescription* description = find_effect(effect.kind);
      return description && description->between_bodies;
    });
  }

  void check_motion(std::size_t i, const Motion& motion) {
    const auto path = [i](const char* key) { return path_of("boundaries", i, "motion.") + key; };
    problems.finite(path("velocity"), motion.velocity, "m/s");
    problems.finite(path("amplitude"), motion.amplitude, "m");
    problems.not_negative(path("frequency"), motion.frequency, "Hz");
    problems.finite(path("phase"), motion.phase, "rad");
    if (scene.boundaries[i].shape == "periodic")
      problems.add(path("velocity"), "given for a boundary without a surface");
    const double turns = motion.frequency * scene.run.step;
    if (motion.amplitude != Vector3d::Zero() && turns > 0.5) {
      problems.add(path("frequency"), fmt::format("is {} Hz: a step of {} s skips more than half a swing",
                                                  text(motion.frequency), text(scene.run.step)));
    }
  }

  /// A pair must be near in one way only.
  void check_periods() {
    double largest = 0;
    for (const BodyGroup& group : scene.bodies) {
      for (const double radius : group.radius) largest = std::max(largest, radius);
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < scene.boundaries.size(); ++i) {
      const Boundary& wall = scene.boundaries[i];
      if (wall.shape != "periodic") continue;
      if (++count > 1) problems.add(path_of("boundaries", i, "shape"), "is periodic for a second time");
      const double least = 4 * largest * (1 + scene.contact.margin);
      for (int c = 0; c < 3; ++c) {
        if (wall.size[c] == 0 || wall.size[c] >= least) continue;
        problems.add(path_of("boundaries", i, "size"),
                     fmt::format("is {} m, expected at least {} m, or a body would touch another and its image",
                                 text(wall.size[c]), text(least)));
        break;
      }
    }
  }

  void check_settings() {
    const ContactSettings& contact = scene.contact;
    if (!contact.kind.empty()) problems.known("contact.kind", "formulation", contact.kind, names_of(contacts()));
    const auto count = [&](const char* path, int n, int least) {
      if (n < least || n > 100000)
        problems.add(path, fmt::format("is {}, expected a number from {} to 100000", n, least));
    };
    check_formulation();
    count("contact.substeps", contact.substeps, 1);
    count("contact.iterations", contact.iterations, 1);
    count("contact.relax_iterations", contact.relax_iterations, 1);
    problems.not_negative("contact.restitution_threshold", contact.restitution_threshold, "m/s");
    if (!(contact.margin >= 0.01 && contact.margin <= 10)) {
      problems.add("contact.margin",
                   fmt::format("is {}, expected a share of the radii from 0.01 to 10", text(contact.margin)));
    }
  }

  /// Settings of one formulation mean nothing to the other.
  void check_formulation() {
    const ContactSettings& contact = scene.contact;
    const ContactSettings unset;
    const bool penalty = contact.kind == "penalty";
    const std::string own = penalty ? "stiffness, tangential_stiffness, pull or margin"
                                    : "substeps, iterations, relax_iterations, margin or restitution_threshold";
    const auto foreign = [&](const char* key, bool given) {
      if (given)
        problems.add(std::string("contact.") + key,
                     "is given, which contact.kind = \"" + contact.kind + "\" does not have; expected " + own);
    };
    if (contact.kind.empty()) return;
    foreign(penalty ? "substeps" : "stiffness", penalty ? contact.substeps != unset.substeps : contact.stiffness != 0);
    foreign("iterations", penalty && contact.iterations != unset.iterations);
    foreign("relax_iterations", penalty && contact.relax_iterations != unset.relax_iterations);
    foreign("restitution_threshold", penalty && contact.restitution_threshold != unset.restitution_threshold);
    foreign("tangential_stiffness", !penalty && contact.tangential_stiffness != unset.tangential_stiffness);
    foreign("pull", !penalty && contact.pull);
    if (penalty) check_penalty();
  }

  void check_penalty() {
    const ContactSettings& contact = scene.contact;
    if (contact.stiffness == 0) {
      problems.add("contact.stiffness", "is 0 or missing, expected a number > 0 [N/m]: of the spring along the normal");
    } else {
      problems.positive("contact.stiffness", contact.stiffness, "N/m");
    }
    problems.positive("contact.tangential_stiffness", contact.tangential_stiffness, "1");
    const double least = contact.pull ? 0 : least_restitution;
    const std::vector<std::string> names = materials_in_use(scene);
    for (std::size_t i = 0; i < names.size(); ++i) {
      for (std::size_t j = i; j < names.size(); ++j) {
        const double e = law_between(scene, names[i], names[j]).restitution;
        const bool met = std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const BodyGroup& body) {
          return !body.shape.empty() && (body.material == names[i] || body.material == names[j]);
        });
        if (e >= least || !met) continue;
        problems.add("contact.kind",
                     fmt::format("penalty: restitution {} of {} on {} is less than {}, the least that a dashpot gives "
                                 "which does not pull; expected more, or contact.pull = true",
                                 text(e), names[i], names[j], text(least)));
      }
    }
  }

  void check_bodies_in_contact() {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const BodyGroup& group = scene.bodies[i];
      if (group.shape.empty()) continue;
      if (pivot_of(scene, group)) {
        problems.add(path_of("bodies", i, "shape"), "is given for bodies on a pivot, which contacts cannot move");
      }
      for (const Vector3d& moments : group.inertia) {
        if (moments.x() == moments.y() && moments.y() == moments.z()) continue;
        problems.add(path_of("bodies", i, "inertia"), "has three moments, expected equal ones for balls in contact");
        break;
      }
    }
  }
};

}  // namespace

bool touches(const Scene& scene) {
  return !scene.contact.kind.empty();
}

Material law_between(const Scene& scene, const std::string& a, const std::string& b) {
  for (const MaterialPair& pair : scene.material_pairs) {
    const bool these = pair.between.size() == 2 && ((pair.between[0] == a && pair.between[1] == b) ||
                                                    (pair.between[0] == b && pair.between[1] == a));
    if (these) return law_of(pair);
  }
  const auto of = [&](const std::string& name) {
    const auto found = scene.materials.find(name);
    return found == scene.materials.end() ? Material{} : found->second;
  };
  const Material one = of(a), two = of(b);
  const auto mean = [](double x, double y) { return x == y ? x : std::sqrt(x * y); };
  return {mean(one.restitution, two.restitution), mean(one.friction, two.friction),
          mean(one.restitution_speed, two.restitution_speed), mean(one.cohesion, two.cohesion)};
}

std::vector<std::string> materials_in_use(const Scene& scene) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const BodyGroup& group : scene.bodies) {
    if (!group.shape.empty()) add(group.material);
  }
  for (const Boundary& wall : scene.boundaries) {
    if (wall.shape != "periodic") add(wall.material);
  }
  return names;
}

void check_contacts(const Scene& scene, Problems& problems) {
  ContactCheck{scene, problems, {}}.run();
}

}  // namespace ballpark
