#include "scenarios/files/keys.h"

#include <fmt/format.h>

#include "ballpark/catalogue.h"
#include "scenarios/files/key_rows.h"
#include "scenarios/files/output_formats.h"

namespace ballpark::scenes {

namespace {

using enum KeyType;

constexpr Range positive{.minimum = 0, .above_minimum = true};
constexpr Range not_negative{.minimum = 0};
constexpr const char* zero = "[0, 0, 0]";

Rows top_rows() {
  Rows rows = {
      Row("name", text, "", on_draft([](Draft& d, std::string v) { d.file.scene.name = std::move(v); }),
          "What the scene is called; the file's name if left out."),
      Row("doc", text, "", on_draft([](Draft& d, std::string v) { d.file.scene.doc = std::move(v); }),
          "What the scene shows and how it is judged."),
      Row(
          "run", table, +[](Draft& d) { return &d.file.scene.run; }, "How long and by which method.")
          .must(),
      Row(
          "bodies", tables, +[](Draft& d) { return &d.bodies.emplace_back(); },
          "One group of bodies each; ids count through the groups in their order."),
      Row(
          "effects", tables, +[](Draft& d) { return &d.file.scene.effects.emplace_back(); },
          "One effect each: its kind, that kind's parameters, and the groups it acts on."),
      Row(
          "impulse", tables, +[](Draft& d) { return &d.file.scene.impulses.emplace_back(); },
          "One sudden change of a body's momentum each."),
      Row(
          "output", tables, +[](Draft& d) { return &d.file.outputs.emplace_back(); },
          "One file with the state over time each: give every or at."),
      Row(
          "event", tables, +[](Draft& d) { return &d.file.events.emplace_back(); },
          "One kind of moment each: a number of a body's state passes a value. Found between steps, no bit changes."),
      Row(
          "expect", tables, +[](Draft& d) { return &d.file.expectations.emplace_back(); },
          "One number of the run each and what it must be: min, max or both; or value with tolerance."),
  };
  for (const Rows& part : {contact_top_rows(), stress_top_rows()}) rows.insert(rows.end(), part.begin(), part.end());
  return rows;
}

Rows run_rows() {
  return {
      Row("duration", number, "s", into(&RunSettings::duration), "Simulated time.").in(not_negative).must(),
      Row(
          "step", number, "s",
          [](const Owner& owner, const Parsed& value) {
            RunSettings& run = *std::get<RunSettings*>(owner);
            run.automatic_step = std::holds_alternative<std::string>(value);
            if (!run.automatic_step) run.step = std::get<double>(value);
          },
          "Length of one step; or give a tolerance. auto: a tenth of the largest stable one.")
          .in(positive)
          .one_of({"auto"}),
      Row("tolerance", number, "", into(&RunSettings::tolerance),
          "Error of a step over the size of what it moves, instead of a step: for integrators with an estimate of it.")
          .in(positive),
      Row("absolute_tolerance", number, "m, m/s, rad/s", into(&RunSettings::absolute_tolerance),
          "What a step may err by where bodies are at or near zero; the tolerance itself if left out.")
          .in(positive),
      Row("integrator", word, "", into(&RunSettings::integrator), "The method (`ballpark list integrators`).")
          .one_of(names_of(integrators()))
          .otherwise("\"rk4\""),
      Row("rotation", word, "", into(&RunSettings::rotation), "How orientations follow from spins.")
          .one_of(names_of(rotations()))
          .otherwise("\"renormalise\""),
      Row("accept", words, "", into(&RunSettings::accept), "Limits that may be exceeded; it is still reported.")
          .one_of({"stability"})
          .otherwise("[]"),
      Row("compensated", flag, "", into(&RunSettings::compensated),
          "Compensated summation of the state: long runs lose less to rounding, for more memory.")
          .otherwise("false"),
      Row(
          "precision", word, "",
          [](const Owner& owner, const Parsed& value) {
            const bool single = std::get<std::string>(value) == "single";
            std::get<RunSettings*>(owner)->precision = single ? Precision::single_ : Precision::double_;
          },
          "Arithmetic of the run.")
          .one_of({"single", "double"})
          .otherwise("\"double\""),
      Row("seed", whole, "", into(&RunSettings::seed), "Of all that is random.").otherwise("1"),
  };
}

Rows body_rows() {
  return {
      Row("name", text, "", into_bodies(&BodyGroup::name), "Unique: how effects and --set address the group."),
      Row("shape", word, "", into_bodies(&BodyGroup::shape),
          "None for particles and for bodies whose inertia is given.")
          .one_of(names_of(shapes())),
      Row("material", text, "", into_bodies(&BodyGroup::material),
          "A name of [materials]; without one, restitution is 1 and friction 0."),
      Row("radius", numbers, "m", into_bodies(&BodyGroup::radius), "Of a sphere.").in(positive),
      Row("mass", numbers, "kg", into_bodies(&BodyGroup::mass), "Or give density.").in(positive),
      Row("density", numbers, "kg/m^3", into_bodies(&BodyGroup::density), "With a shape, instead of mass.")
          .in(positive),
      Row("inertia", vectors, "kg m^2", into_bodies(&BodyGroup::inertia),
          "Principal moments about the centre of mass; each at most the sum of the other two.")
          .in(positive),
      Row("position", vectors, "m", into_bodies(&BodyGroup::position), "Of the centre of mass."),
      Row("velocity", vectors, "m/s", into_bodies(&BodyGroup::velocity), "Of the centre of mass.").otherwise(zero),
      Row("angular_velocity", vectors, "rad/s", into_bodies(&BodyGroup::angular_velocity),
          "Along the axes that angular_velocity_frame names.")
          .otherwise(zero),
      Row("angular_velocity_frame", word, "", into_bodies(&BodyGroup::angular_velocity_frame),
          "Axes of angular_velocity.")
          .one_of({"world", "body"})
          .otherwise("\"world\""),
      Row("orientation", quaternions, "", into_bodies(&BodyGroup::orientation),
          "Unit quaternion [w, x, y, z], body to world.")
          .otherwise("[1, 0, 0, 0]"),
      Row(
          "generate", table, +[](BodyDraft& d) { return &d.generate.emplace(); },
          "Makes the rows, instead of a list of positions."),
      Row("file", text, "", into(&BodyDraft::file),
          "Rows from x.npy (n by 3: positions) or x.csv (columns named by a header, as --state writes them: id, x,y,z, "
          "qw,qx,qy,qz, vx,vy,vz, wx,wy,wz, and mass, radius), relative to the scene file."),
      Row(
          "ids", word, "", [](const Owner&, const Parsed&) {}, "Bodies are numbered from 0 in their order.")
          .one_of({"from order"})
          .otherwise("\"from order\""),
  };
}

Rows generate_rows() {
  return {
      Row("kind", word, "", into(&Generate::kind),
          "lattice: a cubic grid, x fastest. random: uniform in the box from lower to upper. rack: a triangle of "
          "balls, row after row along x. plummer: a cluster of stars, the inner 99 % of its mass.")
          .one_of({"lattice", "random", "rack", "plummer"})
          .must(),
      Row("count", wholes, "", into(&Generate::count),
          "lattice: [nx, ny, nz]. random, plummer: how many bodies. rack: how many rows.")
          .must(),
      Row("origin", vector, "m", into(&Generate::origin), "lattice, rack: position of the first body. plummer: centre.")
          .otherwise(zero),
      Row("spacing", number, "m", into(&Generate::spacing), "lattice, rack: distance between neighbours.").in(positive),
      Row("lower", vector, "m", into(&Generate::lower), "random: lowest corner of the box.").otherwise(zero),
      Row("upper", vector, "m", into(&Generate::upper), "random: highest corner of the box.").otherwise(zero),
      Row("scale", number, "m", into(&Generate::scale), "plummer: a of its density, as (1 + r^2 / a^2)^(-5/2).")
          .in(positive),
      Row("strength", number, "m^3/s^2", into(&Generate::strength),
          "plummer: G times the mass of all, with which velocities are in balance; 0: at rest.")
          .in(not_negative)
          .otherwise("0"),
      Row("velocity_spread", vector, "m/s", into(&Generate::velocity_spread),
          "Adds a uniform value in [-s, s] to each component of the velocity.")
          .in(not_negative)
          .otherwise(zero),
      Row("angular_velocity_spread", vector, "rad/s", into(&Generate::angular_velocity_spread),
          "Likewise for the angular velocity.")
          .in(not_negative)
          .otherwise(zero),
      Row("random_orientation", flag, "", into(&Generate::random_orientation),
          "Orientations uniform over all rotations.")
          .otherwise("false"),
  };
}

Rows effect_rows() {
  Rows rows = {
      Row("kind", word, "", into(&Effect::kind), "Which effect (`ballpark list effects`).")
          .one_of(names_of(effects()))
          .must(),
      Row("groups", words, "", into(&Effect::groups), "Names of the groups it acts on; all if empty.").otherwise("[]"),
  };
  for (const EffectDescription& effect : effects()) {
    for (const ParameterInfo& parameter : effect.parameters) rows.push_back(parameter_row(effect.name, parameter));
  }
  return rows;
}

Rows impulse_rows() {
  return {
      Row("at", number, "s", into(&Impulse::at), "When; the step that holds this time is split there.")
          .in(not_negative)
          .must(),
      Row("id", whole, "", into(&Impulse::id), "Which body.").must(),
      Row("J", vector, "N s", into(&Impulse::J), "Change of momentum.").must(),
      Row("offset", vector, "m", into(&Impulse::offset), "Point of application minus centre of mass.").otherwise(zero),
  };
}

Rows output_rows() {
  return {
      Row("every", number, "s", into_optional(&OutputRequest::every), "Time between frames, the first at 0.")
          .in(positive),
      Row("at", times, "s", into(&OutputRequest::at), "The times of the frames.").in(not_negative),
      Row("file", text, "", into(&OutputRequest::file),
          "Relative to where the program runs; the ending is " + output_endings() + ".")
          .must(),
      Row("columns", words, "", into(&OutputRequest::columns),
          "What is written beside time and id; all that bodies carry if left out (radius: where it is drawn). "
          "contacts and contact_force [N]: how many contacts each body has, and the force of all of them.")
          .one_of(output_columns()),
      Row("precision", word, "", into(&OutputRequest::precision),
          "Of the numbers; if left out single in .pvd and .vtp, else double.")
          .one_of({"single", "double"}),
  };
}

Rows event_rows() {
  return {
      Row("name", text, "", into(&EventRequest::name),
          "Unique, a word: where the run's JSON has its times, and how [[expect]] addresses them.")
          .must(),
      Row("quantity", text, "", into(&EventRequest::quantity), "state.ID.COLUMN, as in [[expect]].").must(),
      Row("value", number, "", into(&EventRequest::value), "What the quantity passes.").otherwise("0"),
      Row("crossing", word, "", into(&EventRequest::crossing), "The way it passes.")
          .one_of({"rising", "falling", "any"})
          .otherwise("\"any\""),
  };
}

Rows expect_rows() {
  return {
      Row("quantity", text, "", into(&Expectation::quantity),
          "A path in the JSON of the run (energy.drift_relative, events.NAME.count, events.NAME.times.0), or "
          "state.ID.COLUMN (state.0.x) with the columns x,y,z, vx,vy,vz, qw,qx,qy,qz, wx,wy,wz; in a hard case also "
          "what "
          "[stress] compares, stress.MEASURE.")
          .must(),
      Row("at", number, "s", into_optional(&Expectation::at), "When; at the end if left out.").in(not_negative),
      Row("min", number, "", into_optional(&Expectation::minimum), "The least it may be."),
      Row("max", number, "", into_optional(&Expectation::maximum), "The most it may be."),
      Row("value", number, "", into_optional(&Expectation::value), "What it should be, within tolerance."),
      Row("tolerance", number, "", into_optional(&Expectation::tolerance), "Largest |measured - value|.")
          .in(not_negative),
  };
}

std::vector<Key> all_keys() {
  std::vector<Key> list;
  const auto add = [&](const std::string& table_name, const Rows& rows) {
    for (const Row& row : rows) list.push_back(row.in_table(table_name));
  };
  add("", top_rows());
  add("run", run_rows());
  add("bodies", body_rows());
  add("bodies.generate", generate_rows());
  add("effects", effect_rows());
  add("impulse", impulse_rows());
  add("output", output_rows());
  add("event", event_rows());
  add("expect", expect_rows());
  for (const auto& parts : {contact_tables(), stress_tables()}) {
    for (const TableRows& part : parts) add(part.table, part.rows);
  }
  return list;
}

}  // namespace

const std::vector<Key>& keys() {
  static const std::vector<Key> table = all_keys();
  return table;
}

}  // namespace ballpark::scenes
