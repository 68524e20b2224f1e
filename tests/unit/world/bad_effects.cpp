// Bad effects, options and user effects: refused with the nearest choice, before anything is built.
#include <limits>

#include "tests/catch.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::ParameterInfo;
using ballpark::ParameterKind;
using ballpark::Path;
using ballpark::Precision;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// The one problem of a scene of two balls, two bricks and two particles under the effect.
Problem problem_of(const Effect& made) {
  const Scene scene = scene_of({balls("s", 2), bricks("b", 2), particles("p", 2)}, {made});
  const std::vector<Problem> found = check(scene);
  CAPTURE(made.kind, found.size());
  REQUIRE(found.size() == 1);
  CHECK(problems_of(scene).size() == 1);
  return found[0];
}

void check_problem(const Effect& made, const std::string& path, const std::string& words) {
  const Problem problem = problem_of(made);
  CAPTURE(problem.message, words);
  CHECK(problem.path == path);
  CHECK(contains(problem.message, words));
}

/// A value of another type than the parameter's.
Value wrong_type(ParameterKind kind) {
  if (kind == ParameterKind::word) return 1.0;
  return kind == ParameterKind::number ? Value(Vector3d(1, 2, 3)) : Value(std::string("up"));
}

Effect on_bricks(const ballpark::EffectDescription& description) {
  Effect made = sample(description);
  made.groups = {"b"};
  return made;
}

}  // namespace

TEST_CASE("Bad effects: every parameter of every effect is required, typed and finite", "[check]") {
  for (const ballpark::EffectDescription& description : ballpark::effects()) {
    const bool of_balls = description.name == "table";  // which bodies of unequal moments do not roll on
    const BodyGroup bodies = of_balls ? round_bricks("b", 2) : bricks("b", 2);
    CHECK(check(scene_of({sized(bodies)}, {on_bricks(description)})).empty());
    for (const ParameterInfo& parameter : description.parameters) {
      const std::string path = "effects[0]." + parameter.name;
      CAPTURE(description.name, parameter.name);
      Effect made = on_bricks(description);
      if (!parameter.fallback) {
        made.parameters.erase(parameter.name);
        check_problem(made, path, "is missing, expected ");
      }
      made.parameters[parameter.name] = wrong_type(parameter.kind);
      if (parameter.kind == ParameterKind::word) {
        check_problem(made, path, "expected one of \"" + parameter.choices.front() + "\"");
        made.parameters[parameter.name] = parameter.choices.front() + "x";
        check_problem(made, path, "did you mean \"" + parameter.choices.front() + "\"?");
        continue;
      }
      check_problem(made, path, "[" + parameter.unit + "]");
      if (parameter.kind == ParameterKind::pairs) continue;  // whole numbers
      const bool vectors = parameter.kind == ParameterKind::vector || parameter.kind == ParameterKind::vectors;
      made.parameters[parameter.name] = vectors ? Value(Vector3d(0, not_a_number, 0)) : Value(not_a_number);
      check_problem(made, path, "is nan");
      if (std::isinf(parameter.minimum)) continue;
      made.parameters[parameter.name] = parameter.minimum - 1;
      check_problem(made, path, ">= ");
    }
  }
}

TEST_CASE("Bad effects: unknown kinds, parameters and groups name the nearest", "[check]") {
  check_problem(effect("gravty"), "effects[0].kind", "unknown effect \"gravty\"; did you mean \"gravity\"?");
  check_problem(effect("xyz"), "effects[0].kind", "expected one of gravity");
  check_problem(effect("gravity", {{"acceleraton", Vector3d(0, 0, 0)}}), "effects[0].acceleraton", "\"acceleration\"?");
  check_problem(effect("gravity", {}, {"bb"}), "effects[0].groups", "unknown group \"bb\"");
  check_problem(effect("gravity", {}, {"b", "nobody"}), "effects[0].groups[1]", "expected one of s, b, p");
}

TEST_CASE("Bad effects: what the group cannot have", "[check]") {
  check_problem(effect("magnus", {{"coefficient", 1.0}}, {"p"}), "effects[0].groups", "magnus needs spin");
  check_problem(effect("torque", {{"torque", Vector3d(1, 0, 0)}}, {"p", "s"}), "effects[0].groups", "particles");
  check_problem(effect("force", {{"force", Vector3d(1, 0, 0)}, {"offset", Vector3d(1, 0, 0)}}, {"p"}),
                "effects[0].offset", "expected an offset of zero");
}

TEST_CASE("Bad effects: what fluids need to know of bodies", "[check]") {
  for (const char* kind : {"buoyancy", "added_mass", "reynolds_drag"}) {
    Effect made = effect(kind, {{"density", 1000.0}}, {"p"});
    if (std::string(kind) == "reynolds_drag") made.parameters["viscosity"] = 1e-3;
    check_problem(
        made, "effects[0].groups",
        std::string(kind) + " needs the radius of the bodies, but group p gives none: expected bodies.radius");
  }
  check_problem(effect("reynolds_drag", {{"density", 1.0}, {"viscosity", 0.0}}, {"s"}), "effects[0].viscosity",
                "expected a number >= 1e-12 [Pa s]");
  check_problem(effect("gusts", {{"speed", 1.0}, {"length", 0.0}}, {"s"}), "effects[0].length", ">= 1e-06 [m]");
  const Effect added = effect("added_mass", {{"density", 1000.0}});
  const auto message = [](const Scene& scene) {
    const std::vector<Problem> found = check(scene);
    return found.size() == 1 ? found[0].path + " " + found[0].message : std::to_string(found.size()) + " problems";
  };
  CHECK(contains(message(scene_of({balls("s", 1)}, {added, effect("pivot", {{"point", Vector3d(0, 0, 9)}})})),
                 "effects[0].groups group s turns about a pivot, where added_mass does not act"));
  Scene boris = scene_of({balls("s", 1)}, {added});
  boris.run.integrator = "boris";
  CHECK(contains(message(boris), "run.integrator boris turns velocities by a body's own mass"));
}

TEST_CASE("Bad effects: rows for each body, windows and pivots", "[check]") {
  const std::vector<Vector3d> three{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  check_problem(effect("spring", {{"anchor", three}, {"stiffness", 1.0}}, {"b"}), "effects[0].anchor",
                "has 3 rows, expected one, or one for each of the 2 bodies of b");
  check_problem(effect("spring", {{"anchor", std::vector<Vector3d>{}}, {"stiffness", 1.0}}, {"b"}), "effects[0].anchor",
                "has 0 rows");
  check_problem(
      effect("spring", {{"anchor", std::vector<Vector3d>{{1, 1, 1}, {1, not_a_number, 1}}}, {"stiffness", 1.0}}, {"b"}),
      "effects[0].anchor[1]", "is nan");
  for (const char* kind : {"force", "torque"}) {
    check_problem(effect(kind, {{kind, Vector3d(1, 0, 0)}, {"at", 2.0}, {"until", 2.0}}, {"b"}), "effects[0].until",
                  "is 2 s, expected a time after at = 2 s");
  }
  const Effect pivot = effect("pivot", {{"point", Vector3d(0, 0, 9)}}, {"b"});
  const std::vector<Problem> twice = check(scene_of({bricks("b", 2)}, {pivot, pivot}));
  REQUIRE(twice.size() == 1);
  CHECK(twice[0].path == "effects[1].kind");
  CHECK(contains(twice[0].message, "group b has a pivot already"));
}

TEST_CASE("Bad effects: pairs of bodies that there are not, and numbers that do not fit them", "[check]") {
  const auto bonds = [](std::vector<ballpark::IdPair> pairs, const Value& stiffness,
                        std::vector<std::string> groups = {}) {
    return effect("bonds", {{"pairs", std::move(pairs)}, {"stiffness", stiffness}}, std::move(groups));
  };
  const std::vector<BodyGroup> groups{particles("p", 2), bricks("b", 2)};
  const auto message = [&](const Effect& made) {
    const std::vector<Problem> found = check(scene_of(groups, {made}));
    return found.size() == 1 ? found[0].path + " " + found[0].message : std::to_string(found.size()) + " problems";
  };
  CHECK(check(scene_of(groups, {bonds({{0, 3}, {3, 1}}, 1.0)})).empty());
  CHECK(message(bonds({{0, 1}, {0, 4}}, 1.0)) == "effects[0].pairs[1] body 4 does not exist, expected an id below 4");
  CHECK(message(bonds({{2, 2}}, 1.0)) == "effects[0].pairs joins body 2 with itself, expected two bodies");
  CHECK(message(bonds({{0, 2}}, 1.0, {"b"})) ==
        "effects[0].pairs body 0 is of group p, on which this effect does not act");
  CHECK(message(bonds({{0, 1}, {0, 2}, {0, 3}}, std::vector<double>{1, 2})) ==
        "effects[0].stiffness has 2 numbers, expected one, or one for each of the 3 pairs");
  CHECK(message(bonds({{0, 1}, {0, 2}}, std::vector<double>{1, -2})) ==
        "effects[0].stiffness[1] is -2, expected a number >= 0 [N/m]");
  CHECK(message(bonds({}, 1.0)) == "effects[0].pairs is empty, expected a list of pairs of ids [[a, b], ...]");
  Scene taylor = scene_of(groups, {bonds({{0, 1}}, 1.0)});
  taylor.run.integrator = "taylor2";
  const std::vector<Problem> refused = check(taylor);
  REQUIRE(refused.size() == 1);
  CHECK(contains(refused[0].message, "needs the time derivative of every force, which bonds does not give"));
}

TEST_CASE("Bad effects: forces that end at a cut-off want lengths, and reach no body and its image", "[check]") {
  const auto message_of = [](const Effect& made) {
    Scene scene = scene_of({particles("p", 2)}, {made});
    ballpark::Boundary space;
    space.shape = "periodic", space.size = {9, 0, 5};
    scene.boundaries = {space};
    const std::vector<Problem> found = check(scene);
    return found.empty() ? "" : found[0].path + " " + found[0].message;
  };
  const auto message = [&](double sigma, double cutoff) {
    return message_of(effect("lennard_jones", {{"epsilon", 1.0}, {"sigma", sigma}, {"cutoff", cutoff}}));
  };
  CHECK(message(1, 2.5) == "");
  CHECK(message(0, 2.5) == "effects[0].sigma is 0, expected a number >= 1e-15 [m]");
  CHECK(message(1, -1) == "effects[0].cutoff is -1, expected a number >= 1e-15 [m]");
  CHECK(message(1, 2.6) ==
        "effects[0].cutoff is 2.6 m, expected at most 2.5 m, half of the length after which space repeats");
  CHECK(message_of(effect("gravity")) ==
        "boundaries[0].shape needs contacts or an effect between bodies, expected [contact] with a kind, e.g. "
        "\"impulse\"");
}

TEST_CASE("Bad effects: a splitting of order above 2 refuses forces that read velocity, and only those", "[check]") {
  const auto problems = [](const std::string& integrator, const Effect& force) {
    Scene scene = scene_of({particles("p", 2)}, {effect("gravity"), force});
    scene.run.integrator = integrator;
    return check(scene);
  };
  const auto spring = [](double damping) {
    return effect("spring", {{"anchor", Vector3d(1, 1, 1)}, {"stiffness", 3.0}, {"damping", damping}});
  };
  const Effect drag = effect("linear_drag", {{"coefficient", 0.2}});
  const Effect field = effect("magnetic_field", {{"charge", 1.0}, {"field", Vector3d(0, 0, 2)}});
  const Effect frame = effect("rotating_frame", {{"angular_velocity", Vector3d(0, 0, 2)}});
  const Effect blind = effect("electric_field", {{"charge", 1.0}, {"field", Vector3d(0, 0, 2)}});
  for (const char* splitting : {"ruth3", "forest_ruth", "yoshida4", "pefrl", "yoshida6"}) {
    CAPTURE(splitting);
    CHECK(problems(splitting, spring(0)).empty());
    CHECK(problems(splitting, blind).empty());
    for (const Effect& reader : {drag, spring(0.1), field, frame}) {
      const std::vector<Problem> found = problems(splitting, reader);
      REQUIRE(found.size() == 1);
      CHECK(found[0].path == "run.integrator");
      CHECK(contains(found[0].message, reader.kind + " reads it; expected another integrator"));
    }
  }
  for (const char* taken : {"velocity_verlet", "semi_implicit_euler", "rk4"}) CHECK(problems(taken, drag).empty());
}

TEST_CASE("Bad effects: a particle at its own pivot has no inertia about it", "[check]") {
  BodyGroup group = particles("p", 2);
  const auto problem = [&](const Value& point) {
    const std::vector<Problem> found = check(scene_of({group}, {effect("pivot", {{"point", point}})}));
    return found.size() == 1 ? found[0] : Problem{};
  };
  CHECK(problem(group.position[1]).path == "effects[0].point");
  CHECK(problem(std::vector<Vector3d>{{9, 9, 9}, group.position[1]}).path == "effects[0].point");
  CHECK(contains(problem(std::vector<Vector3d>{}).message, "has 0 rows"));
  group.position.resize(1);
  group.mass = {1, 2};
  CHECK(problem(std::vector<Vector3d>{{9, 9, 9}, group.position[0]}).path == "effects[0].point");
}

TEST_CASE("Bad options: each is named", "[check]") {
  const Scene scene = scene_of({particles("p", 2)});
  const auto refused = [&](const Options& options, const std::string& path, const std::string& words) {
    const std::vector<Problem> found = problems_of(scene, options);
    CAPTURE(path, words);
    REQUIRE(found.size() == 1);
    CHECK(found[0].path == path);
    CHECK(contains(found[0].message, words));
  };
  refused({.threads = -1}, "threads", "is negative");
  refused({.copies = 0}, "copies", "is 0, expected at least 1");
  refused({.copies = -3}, "copies", "is -3");
  refused({.perturb = not_a_number}, "perturb", "is not finite");
  refused({.target = "bas"}, "target", "unknown target \"bas\"; did you mean \"base\"?");
  refused({.target = ""}, "target", "expected one of auto, base");
  for (const ballpark::NamedDescription& target : ballpark::targets()) {
    if (!target.available) refused({.target = target.name}, "target", "this machine cannot run");
  }
}

TEST_CASE("Bad user effects: no function for the precision, a path or method that cannot have them, no such group",
          "[check]") {
  UserEffect user = user_effect("wind", [](const ballpark::BodyBlock<double>&) {});
  Scene scene = scene_of({particles("p", 2)});
  const auto first = [&](const Options& options) {
    const std::vector<Problem> found = problems_of(scene, options, {user});
    return found.size() == 1 ? found[0] : Problem{};
  };
  CHECK(first({}).path.empty());
  CHECK(contains(first({.precision = Precision::single_}).message, "\"wind\" has no function for this precision"));
  CHECK(contains(first({.precision = Precision::extended}).message, "has no function"));
  CHECK(first({.path = Path::fused}).path == "path");
  scene.run.integrator = "taylor2";
  CHECK(first({}).path == "run.integrator");
  CHECK(contains(first({}).message, "user effect \"wind\" cannot give"));
  scene.run.integrator = "pefrl";
  CHECK(contains(first({}).message, "but user effect \"wind\" reads it"));
  user.reads_velocity = false;
  CHECK(first({}).path.empty());
  scene.run.integrator = "rk4";
  user.groups = {"q"};
  CHECK(contains(first({}).message, "unknown group \"q\""));
}
