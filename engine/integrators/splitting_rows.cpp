// Splittings into kicks and drifts. HLW: Hairer, Lubich & Wanner, Geometric Numerical Integration.
#include <initializer_list>

#include "engine/integrators/rows.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// Kicks and drifts of velocity Verlet with steps of these shares one after the other: of even order if they read the
/// same from both ends. (Yoshida 1990; HLW II.4, eq. 4.4.)
Row composed(Row row, std::initializer_list<long double> shares) {
  int i = 0;
  for (const long double share : shares) {
    row.kick[i] += share / 2;
    row.drift[i] = share;
    row.kick[++i] = share / 2;
  }
  row.family = Family::splitting;
  row.symplectic = true;
  row.phases = i + 1;
  return row;
}

constexpr long double triple_jump = 1.3512071919596576340476878089715L;  // 1 / (2 - 2^(1/3))

Row forest_ruth() {
  constexpr long double t = triple_jump;
  return {.name = "forest_ruth",
          .doc = "fourth-order symplectic: drifts before and after three kicks",
          .source = "Forest & Ruth 1990, Physica D 43, 105",
          .family = Family::splitting,
          .order = 4,
          .phases = 3,
          .symplectic = true,
          .lead = t / 2,
          .kick = {t, 1 - 2 * t, t},
          .drift = {(1 - t) / 2, (1 - t) / 2, t / 2}};
}

Row pefrl() {
  constexpr long double xi = 0.1786178958448091L, lambda = -0.2123418310626054L, chi = -0.06626458266981849L;
  constexpr long double outer = (1 - 2 * lambda) / 2;
  return {.name = "pefrl",
          .doc = "position-extended Forest-Ruth-like: four kicks, error terms 26 times smaller than forest_ruth's",
          .source = "Omelyan, Mryglod & Folk 2002, Comput. Phys. Commun. 146, 188",
          .family = Family::splitting,
          .order = 4,
          .phases = 4,
          .symplectic = true,
          .lead = xi,
          .kick = {outer, lambda, lambda, outer},
          .drift = {chi, 1 - 2 * (chi + xi), chi, xi}};
}

}  // namespace

std::vector<Row> splitting_rows() {
  constexpr long double t = triple_jump;
  constexpr long double w1 = -1.17767998417887100694641568096L, w2 = 0.23557321335935813368479318298L,
                        w3 = 0.78451361047755726381949763386L, w0 = 1 - 2 * (w1 + w2 + w3);
  return {
      {.name = "semi_implicit_euler",
       .doc = "symplectic Euler: velocity first, then position with the new velocity",
       .source = "de Vogelaere 1956",
       .family = Family::splitting,
       .order = 1,
       .phases = 1,
       .symplectic = true,
       .kick = {1},
       .drift = {1}},
      composed({.name = "velocity_verlet",
                .doc = "half kick, drift, half kick: time-reversible, energy error bounded",
                .source = "Swope, Andersen, Berens & Wilson 1982, J. Chem. Phys. 76, 637",
                .order = 2},
               {1}),
      {.name = "boris",
       .doc = "half drift, kick with velocities turned by magnetic and Coriolis forces, half drift: keeps the speed "
              "in a magnetic field",
       .source = "Boris 1970, Proc. 4th Conf. Num. Sim. Plasmas, 3; Birdsall & Langdon, Plasma Physics via Computer "
                 "Simulation, 4-4",
       .family = Family::splitting,
       .order = 2,
       .phases = 1,
       .symplectic = true,
       .lead = 0.5L,
       .kick = {1},
       .drift = {0.5L},
       .turns_velocity = true},
      {.name = "ruth3",
       .doc = "third-order symplectic: three kicks, not time-reversible",
       .source = "Ruth 1983, IEEE Trans. Nucl. Sci. 30, 2669",
       .family = Family::splitting,
       .order = 3,
       .phases = 3,
       .symplectic = true,
       .kick = {7.0L / 24, 3.0L / 4, -1.0L / 24},
       .drift = {2.0L / 3, -2.0L / 3, 1}},
      forest_ruth(),
      composed({.name = "yoshida4",
                .doc = "fourth-order symplectic: three steps of velocity Verlet, the middle one backwards",
                .source = "Yoshida 1990, Phys. Lett. A 150, 262",
                .order = 4},
               {t, 1 - 2 * t, t}),
      pefrl(),
      composed({.name = "yoshida6",
                .doc = "sixth-order symplectic: seven steps of velocity Verlet",
                .source = "Yoshida 1990, solution A; HLW eq. V.3.11",
                .order = 6},
               {w3, w2, w1, w0, w1, w2, w3})};
}

}  // namespace ballpark::BALLPARK_PRECISION
