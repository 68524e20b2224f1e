// The rows of the key table for what touches: materials, boundaries, contacts.
#include "scenarios/files/key_rows.h"

namespace ballpark::scenes {

namespace {

using enum KeyType;

constexpr Range positive{.minimum = 0, .above_minimum = true};
constexpr Range not_negative{.minimum = 0};
constexpr Range share{.minimum = 0, .maximum = 1};
constexpr const char* zero = "[0, 0, 0]";

template <class Law>
Rows law_rows() {
  return {
      Row("restitution", number, "1", into(&Law::restitution), "Speed of parting over speed of approach.")
          .in(share)
          .otherwise("1"),
      Row("friction", number, "1", into(&Law::friction), "Coulomb's coefficient.").in(not_negative).otherwise("0"),
      Row("restitution_speed", number, "m/s", into(&Law::restitution_speed),
          "impulse: speed of approach at which restitution is that: slower impacts are more elastic (1 - (1 - e) "
          "(v/v0)^(1/5)), faster ones less (e (v0/v)^(1/4)). 0: the same at all speeds.")
          .in(not_negative)
          .otherwise("0"),
      Row("cohesion", number, "J/m^2", into(&Law::cohesion),
          "penalty: work of adhesion w; surfaces that touch pull with 2 pi w R1 R2 / (R1 + R2).")
          .in(not_negative)
          .otherwise("0"),
  };
}

Rows pair_rows() {
  Rows rows = law_rows<MaterialPair>();
  rows.insert(rows.begin(), Row("between", words, "", into(&MaterialPair::between), "Two names of materials.").must());
  return rows;
}

Rows boundary_rows() {
  return {
      Row("name", text, "", into(&Boundary::name), "How --set addresses it."),
      Row("shape", word, "", into(&Boundary::shape), "Of its surface (`ballpark list shapes`).")
          .one_of(names_of(boundary_shapes()))
          .must(),
      Row("point", vector, "m", into(&Boundary::point), "plane: on it. tube: on its axis. box, periodic: the centre.")
          .otherwise(zero),
      Row("normal", vector, "1", into(&Boundary::normal),
          "plane: towards the bodies. tube: along its axis. Of any length.")
          .otherwise("[0, 0, 1]"),
      Row("size", vector, "m", into(&Boundary::size),
          "box: lengths of its edges. periodic: lengths after which space repeats, 0 where it does not.")
          .in(not_negative)
          .otherwise(zero),
      Row("radius", number, "m", into(&Boundary::radius), "tube: of its surface; its ends are open.").in(positive),
      Row("side", word, "", into(&Boundary::side), "box: where the bodies are.")
          .one_of({"inside", "outside"})
          .otherwise("\"inside\""),
      Row("open", words, "", into(&Boundary::open), "box from inside: faces that it does not have.")
          .one_of({"-x", "+x", "-y", "+y", "-z", "+z"})
          .otherwise("[]"),
      Row("material", text, "", into(&Boundary::material),
          "A name of [materials]; without one, restitution is 1 and friction 0."),
      Row(
          "motion", table, +[](Boundary& b) { return &b.motion.emplace(); }, "How it moves, whatever hits it."),
      Row("surface_velocity", vector, "m/s", into(&Boundary::surface_velocity),
          "How the surface runs over it: a conveyor.")
          .otherwise(zero),
  };
}

Rows motion_rows() {
  return {
      Row("velocity", vector, "m/s", into(&Motion::velocity), "Steady.").otherwise(zero),
      Row("amplitude", vector, "m", into(&Motion::amplitude), "Of a sinusoid: its direction and largest displacement.")
          .otherwise(zero),
      Row("frequency", number, "Hz", into(&Motion::frequency), "Of the sinusoid.").in(not_negative).otherwise("0"),
      Row("phase", number, "rad", into(&Motion::phase),
          "Of the sinusoid at the start, where the boundary stands as given.")
          .otherwise("0"),
  };
}

Rows contact_rows() {
  return {
      Row("kind", word, "", into(&ContactSettings::kind), "The formulation (`ballpark list contacts`).")
          .one_of(names_of(contacts()))
          .must(),
      Row("substeps", whole, "", into_int(&ContactSettings::substeps),
          "impulse: of a step, each with its own contact solve.")
          .otherwise("1"),
      Row("iterations", whole, "", into_int(&ContactSettings::iterations),
          "impulse: sweeps over all contacts that keep surfaces apart.")
          .otherwise("12"),
      Row("relax_iterations", whole, "", into_int(&ContactSettings::relax_iterations),
          "impulse: sweeps that settle velocities.")
          .otherwise("3"),
      Row("margin", number, "1", into(&ContactSettings::margin),
          "impulse: contacts are surfaces that will pass each other at less than this share of both radii together. "
          "penalty: likewise for the skin of the list of neighbours.")
          .in({.minimum = 0.01, .maximum = 10})
          .otherwise("0.2"),
      Row("restitution_threshold", number, "m/s", into(&ContactSettings::restitution_threshold),
          "impulse: slower approaches end at restitution 0.")
          .in(not_negative)
          .otherwise("0"),
      Row("stiffness", number, "N/m", into(&ContactSettings::stiffness),
          "penalty: of the spring along the normal; must be given.")
          .in(positive),
      Row("tangential_stiffness", number, "1", into(&ContactSettings::tangential_stiffness),
          "penalty: of the spring across it, over stiffness.")
          .in(positive)
          .otherwise("0.2857142857142857"),
      Row("pull", flag, "", into(&ContactSettings::pull),
          "penalty: may the dashpot hold parting surfaces together? It changes which damping gives a restitution.")
          .otherwise("false"),
  };
}

}  // namespace

Rows contact_top_rows() {
  return {
      Row(
          "materials", +[](Draft& d, const std::string& name) { return &d.file.scene.materials[name]; },
          "What surfaces do when they touch; of two materials, the geometric mean of each value."),
      Row(
          "material_pairs", tables, +[](Draft& d) { return &d.file.scene.material_pairs.emplace_back(); },
          "The law of two materials each, instead of their mean."),
      Row(
          "boundaries", tables, +[](Draft& d) { return &d.file.scene.boundaries.emplace_back(); },
          "One surface each that bodies bounce off or lie on."),
      Row(
          "contact", table, +[](Draft& d) { return &d.file.scene.contact; },
          "How bodies with a shape touch; without it they pass through each other."),
  };
}

std::vector<TableRows> contact_tables() {
  return {{"materials", law_rows<Material>()},
          {"material_pairs", pair_rows()},
          {"boundaries", boundary_rows()},
          {"boundaries.motion", motion_rows()},
          {"contact", contact_rows()}};
}

}  // namespace ballpark::scenes
