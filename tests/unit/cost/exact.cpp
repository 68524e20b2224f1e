// Closed forms against published and independently computed values. Where decimal numbers are no doubles, units are
// chosen so that the start is exact; values are known to 16 digits or more.
#include <numbers>

#include "tests/catch.h"
#include "tests/unit/cost/lone_bodies.h"

using namespace lone_bodies;
namespace cost = ballpark::cost;

namespace {

const double degree = std::numbers::pi / 180;

ExactMotion motion_of(ClosedForm& form, const Made& body) {
  const auto motion = form(body.lone());
  REQUIRE(motion);
  CHECK(!motion->what.empty());
  return *motion;
}

void check(Real found, Real expected, Real tolerance = 2e-15L) {
  INFO("found " << found << ", expected " << expected << ", off by " << found - expected);
  CHECK(std::abs(found - expected) <= tolerance * std::max(Real(1), std::abs(expected)));
}

void check(const Vector& found, const Vector& expected, Real tolerance = 2e-15L) {
  for (int c = 0; c < 3; ++c) check(found[c], expected[c], tolerance);
}

/// Of the same sign: orientations have none.
void check(const Rotation& found, const Rotation& expected, Real tolerance) {
  const Real sign = found.dot(expected) < 0 ? -1 : 1;
  for (int c = 0; c < 4; ++c) check(sign * found.coeffs()[c], expected.coeffs()[c], tolerance);
}

/// A point mass 1 m from the origin, let go from an angle to the vertical in the plane of x and z.
ExactMotion pendulum_from(double angle) {
  const Vector3d at =
      angle == 90 ? Vector3d(1, 0, 0) : Vector3d(std::sin(angle * degree), 0, -std::cos(angle * degree));
  return motion_of(
      cost::pendulum,
      particle(at, Vector3d::Zero()).turned(Eigen::Quaterniond::Identity()).with(effect("gravity")).with(pivot()));
}

Real angle_of(const State& s) {
  return std::atan2(s.x.x(), -s.x.z());
}

/// q0 about x by 30 degrees, spin about the axis alone (P-R3).
ExactMotion reference_top() {
  const Eigen::Quaterniond q(Eigen::AngleAxisd(30 * degree, Vector3d::UnitX()));
  Made top = rigid({0.01, 0.01, 0.005}, q * Vector3d(0, 0, 60), q * Vector3d(0, 0, 0.1)).turned(q);
  return motion_of(cost::symmetric_top, top.with(effect("gravity")).with(pivot()));
}

}  // namespace

TEST_CASE("Closed forms: a fall and a throw with quadratic drag (P-D1)", "[cost]") {
  const Effect drag = effect("quadratic_drag", {{"coefficient", 0.05}});
  const Made still = particle({0, 0, 0}, {0, 0, 0}).with(effect("gravity")).with(drag);
  const ExactMotion fall = motion_of(cost::vertical_drag, still);
  check(-state_at(fall, 2).v.z(), 12.4034061120283488L);
  check(-state_at(fall, 2).x.z(), 15.330358672185977L);
  check(-state_at(fall, 10).v.z(), 14.0071179070091195L);
  check(-state_at(fall, 10).x.z(), 126.20848326017718L);

  Made thrown = still;
  thrown.start.velocity = {0, 0, 30};
  const ExactMotion flight = motion_of(cost::vertical_drag, thrown);
  const Real rise = 1.61913657554119766L, back = 2.14932469859823933L;
  check(state_at(flight, rise).v.z(), 0);
  check(state_at(flight, rise).x.z(), 17.2047038548075332L);
  check(state_at(flight, rise + back).x.z(), 0, 1e-14L);
  check(state_at(flight, rise + back).v.z(), -12.6918770811241523L);
}

TEST_CASE("Closed forms: damped and stiff oscillators (P-O1, P-O2)", "[cost]") {
  const Made mass = particle({1, 0, 0}, {0, 0, 0});
  const State damped = state_at(motion_of(cost::oscillator, mass.with(spring(25, 0.4))), 10);
  check(damped.x.x(), 0.127439385220689954L);
  check(damped.v.x(), 0.203686033903173761L);
  check(state_at(motion_of(cost::oscillator, mass.with(spring(1000, 1001))), 1).x.x(), 0.368247688860302624L);
}

TEST_CASE("Closed forms: orbits of eccentricity 0.6 and 0.9 (P-K1)", "[cost]") {
  // Half axis a and strength mu are such that start and speed are whole numbers; n = sqrt(mu/a^3) scales time.
  struct Case {
    double a, strength, near, speed;
    Real t;
    Vector x, v;
  };
  const Case wide{5,
                  5,
                  2,
                  2,
                  20,
                  {-0.77007557841124045L, 0.78834481699442439L, 0},
                  {-0.8941837319886915L, -0.12346176415844096L, 0}};
  const Case narrow{10,
                    190,
                    1,
                    19,
                    10,
                    {-1.8538537094055792L, -0.13088540483992555L, 0},
                    {0.16156945255843134L, -0.22371927679189709L, 0}};
  for (const Case& c : {wide, narrow}) {
    const Made planet = particle({c.near, 0, 0}, {0, c.speed, 0});
    const ExactMotion orbit =
        motion_of(cost::kepler, planet.with(effect("central_gravity", {{"strength", c.strength}})));
    const Real n = std::sqrt(Real(c.strength) / (Real(c.a) * c.a * c.a));
    const State s = state_at(orbit, c.t / n);
    check(s.x / c.a, c.x);
    check(s.v / (c.a * n), c.v);
  }
}

TEST_CASE("Closed forms: the pendulum from 30 and 90 degrees (P-N1)", "[cost]") {
  struct Case {
    double angle;
    Real period, theta, speed;
  };
  for (const Case& c : {Case{30, 2.04098988951913041L, 0.423644515500648239L, 0.94557421856406367L},
                        Case{90, 2.36784194757623745L, 0.278680673569982948L, -4.34316069286468305L}}) {
    const ExactMotion swing = pendulum_from(c.angle);
    check(angle_of(state_at(swing, 10)), c.theta, 1e-14L);
    check(-state_at(swing, 10).w.y(), c.speed, 1e-14L);
    check(angle_of(state_at(swing, c.period / 4)), 0);
    check(angle_of(state_at(swing, c.period / 2)), -c.angle * std::numbers::pi_v<Real> / 180);
    check(angle_of(state_at(swing, c.period)), c.angle * std::numbers::pi_v<Real> / 180);
    check(state_at(swing, c.period).w.norm(), 0, 1e-14L);
  }
}

TEST_CASE("Closed forms: a free body with three moments (P-R1)", "[cost]") {
  const ExactMotion spin = motion_of(cost::torque_free, rigid({1, 2, 3}, {1, 0.5, -0.7}));
  const State s = state_at(spin, 10);
  check(s.q.conjugate() * s.w, {0.451359518401040584L, 1.02287564500714392L, -0.473893593841212169L});
  check(s.q, {0.401006595702115135L, -0.367493469174623553L, -0.583785903125753275L, 0.602773821287096871L}, 2e-15L);
  const Real period = 11.1823954296029494L;
  const State one = state_at(spin, 1.25L), later = state_at(spin, 1.25L + period);
  check(later.q.conjugate() * later.w, one.q.conjugate() * one.w);
}

TEST_CASE("Closed forms: the tennis racket (P-R2)", "[cost]") {
  const ExactMotion flip = motion_of(cost::torque_free, rigid({1, 2, 3}, {0.001, 5, 0.001}));
  const State s = state_at(flip, 10);
  check(s.q.conjugate() * s.w, {4.51062712401165273L, -2.15736968276889587L, 2.60421191225993445L}, 1e-14L);
  check(s.q, {0.20320052058628315L, -0.670231878449195148L, -0.492842339601163567L, -0.516338266875870996L}, 1e-14L);
  const State one = state_at(flip, 1), half = state_at(flip, 1 + 6.6212239813406808L);
  const Vector spin = one.q.conjugate() * one.w;  // about the first two axes it alternates
  check(half.q.conjugate() * half.w, {-spin.x(), -spin.y(), spin.z()}, 1e-13L);
  const State full = state_at(flip, 1 + 13.2424479626813616L);
  check(full.q.conjugate() * full.w, spin, 1e-13L);
}

TEST_CASE("Closed forms: the heavy top (P-R3)", "[cost]") {
  const ExactMotion top = reference_top();
  const Real period = 0.636778291502150703L, radian = std::numbers::pi_v<Real> / 180;
  const auto upright = [&](Real t) { return state_at(top, t).x.z() / state_at(top, t).x.norm(); };
  check(upright(0.5L), 0.761912197041726022L);
  check(upright(period / 2), std::cos(55.0155875609507462L * radian));
  check(upright(period), std::cos(30 * radian));
  check(state_at(top, 0.5L).q,
        {-0.891076172017708621L, 0.288233137648652829L, -0.189645880103812801L, 0.294854801865477453L}, 2e-15L);
  // From y < 0 the axis goes round upwards of z by the mean rate.
  const Vector end = state_at(top, period).x;
  check(std::atan2(end.x(), -end.y()), 3.85098384174106405L * period, 1e-14L);
}

TEST_CASE("Closed forms: a charge in a magnetic field (P-B1)", "[cost]") {
  const Effect field = effect("magnetic_field", {{"charge", 3.0}, {"field", Vector3d(0, 0, 2)}});
  const Made charge = particle({0, 0, 0}, {1, 0, 0.5});
  const State s = state_at(motion_of(cost::charged_particle, charge.with(field)), 4);
  check(s.x, {-0.15092972700110397L, -0.095970165443833837L, 2});
  check(s.v, {0.42417900733699698L, 0.90557836200662385L, 0.5L});
  // Crossed fields, from rest: a cycloid that drifts by E x B / B^2 = (-2, 0, 0), W = 6.
  const Effect across = effect("electric_field", {{"charge", 3.0}, {"field", Vector3d(0, -4, 0)}});
  const Made still = particle({0, 0, 0}, {0, 0, 0});
  const State c = state_at(motion_of(cost::charged_particle, still.with(field).with(across)), 4);
  check(c.x, {-8 + std::sin(Real(24)) / 3, (std::cos(Real(24)) - 1) / 3, 0});
}

TEST_CASE("Closed forms: Foucault's pendulum (P-F1)", "[cost]") {
  // In units of the pendulum's own time, w0 = 1, and with the frame's rate a power of two: z'' + 2 i W z' + z = 0.
  const auto frame = [](double rate) {
    return effect("rotating_frame", {{"angular_velocity", Vector3d(0, 0, rate)}, {"centrifugal", std::string("off")}});
  };
  const Made bob = particle({1, 0, 0}, {0, 0, 0});
  const State s = state_at(motion_of(cost::foucault, bob.with(spring(1, 0)).with(frame(0.75))), 8);
  check(s.x, {-0.7144467927555664600913L, -0.5478613329133295421412L, 0});
  const double rate = 7.292115e-5 * std::sin(48.8462 * degree), stiffness = 9.81 / 67;  // as doubles
  const State hour = state_at(motion_of(cost::foucault, bob.with(spring(stiffness, 0)).with(frame(rate))), 3600);
  check(hour.x, {0.0617642022346189478L, -0.012223806231802991L, 0}, 3e-13L);
}

TEST_CASE("Closed forms: steady lift (P-M1)", "[cost]") {
  const Made ball = rigid({1, 1, 1}, {0, 0, -2}, {0, 0, 0}, {1, 0, 0.5});
  const State s = state_at(motion_of(cost::constant_spin_lift, ball.with(effect("magnus", {{"coefficient", 3.0}}))), 4);
  // P-B1's charge, v' = 3 v x B, B = (0, 0, 2): the same equation.
  check(s.x, {-0.15092972700110397L, -0.095970165443833837L, 2});
  check(s.v, {0.42417900733699698L, 0.90557836200662385L, 0.5L});
}
