#include "tests/physics/problems.h"

namespace ballpark::tests {

namespace {

ReferenceProblem point_problem(const std::string& name, Scene made, Numbers x, Numbers v) {
  return {name, std::move(made), {{"position", position, std::move(x)}, {"velocity", velocity, std::move(v)}}};
}

Scene thrown(const Vector3d& velocity, double drag, double duration, double step) {
  return scene(particle(Vector3d::Zero(), velocity), {gravity(), effect("quadratic_drag", drag)}, duration, step);
}

ReferenceProblem rigid_problem(const std::string& name, const Vector3d& spin, double step, Numbers w, Numbers q) {
  const Vector3d inertia(1, 2, 3);
  return {name,
          scene(rigid_body(inertia, spin), {}, 10, step),
          {{"spin", [=](const World& world) { return body_spin(world, inertia); }, std::move(w)},
           {"orientation", orientation, one_sign(std::move(q))}}};
}

}  // namespace

ReferenceProblem p_d1_from_rest(double duration) {
  const bool early = duration == 2;
  const long double speed = early ? 12.4034061120283488L : 14.0071179070091195L;
  const long double drop = early ? 15.330358672185977L : 126.20848326017718L;
  return point_problem("P-D1", thrown(Vector3d::Zero(), 0.05, duration, 1e-3), {0, 0, -drop}, {0, 0, -speed});
}

ReferenceProblem p_d2_throw() {
  const double angle = 35 * pi / 180;
  return point_problem("P-D2", thrown({40 * std::cos(angle), 0, 40 * std::sin(angle)}, 0.02, 3, 1e-3),
                       {52.1250704508110414L, 0, 4.68004363794871736L},
                       {10.1541529990439372L, 0, -11.8648616108535336L});
}

ReferenceProblem p_o1_damped_oscillator() {
  return point_problem("P-O1", scene(particle({1, 0, 0}), {spring(25, 0.4)}, 10, 1e-3), {0.127439385220689954L, 0, 0},
                       {0.203686033903173761L, 0, 0});
}

ReferenceProblem p_o2_stiff_oscillator() {
  ReferenceProblem problem{"P-O2", scene(particle({1, 0, 0}), {spring(1000, 1001)}, 1, 1e-3), {}};
  problem.quantities = {{"position", position, {0.368247688860302624L, 0, 0}}};
  return problem;
}

ReferenceProblem p_k1_kepler(double eccentricity) {
  if (eccentricity == 0.6) {
    return point_problem("P-K1, e = 0.6", orbit(0.6, 20, 1e-3), {-0.77007557841124045L, 0.78834481699442439L, 0},
                         {-0.8941837319886915L, -0.12346176415844096L, 0});
  }
  ReferenceProblem problem =
      point_problem("P-K1, e = 0.9", orbit(0.9, 10, 1e-4), {-1.8538537094055792L, -0.13088540483992555L, 0},
                    {0.16156945255843134L, -0.22371927679189709L, 0});
  problem.tolerance = 1e-8L;
  return problem;
}

ReferenceProblem p_m1_magnus() {
  BodyGroup group = ball();
  group.velocity = {{1, 0, 0.5}};
  group.angular_velocity = {{0, 0, -2}};
  return point_problem("P-M1", scene(std::move(group), {effect("magnus", 3)}, 4, 1e-3),
                       {-0.15092972700110397L, -0.095970165443833837L, 2},
                       {0.42417900733699698L, 0.90557836200662385L, 0.5L});
}

ReferenceProblem p_b1_charge() {
  return point_problem("P-B1", scene(particle({0, 0, 0}, {1, 0, 0.5}), {magnetic_field(3, {0, 0, 2})}, 4, 1e-3),
                       {-0.15092972700110397L, -0.095970165443833837L, 2},
                       {0.42417900733699698L, 0.90557836200662385L, 0.5L});
}

/// An hour of Foucault's pendulum of 67 m at 48.8462 degrees; the velocity is the closed form's derivative.
ReferenceProblem p_f1_foucault() {
  const Vector3d earth(0, 0, 7.292115e-5 * std::sin(48.8462 * pi / 180));
  return point_problem(
      "P-F1", scene(particle({1, 0, 0}), {spring(9.81 / 67), rotating_frame(earth, "off")}, 3600, 6e-3),
      {0.0617642022346189478L, -0.012223806231802991L, 0}, {-0.374450898444361646L, 0.0749933306397396830L, 0});
}

ReferenceProblem p_n1_pendulum(double degrees) {
  const bool small = degrees == 30;
  const long double angle = small ? 0.423644515500648239L : 0.278680673569982948L;
  const long double rate = small ? 0.94557421856406367L : -4.34316069286468305L;
  return {"P-N1",
          pendulum(degrees * pi / 180, 10, 1e-3),
          {{"angle", [](const World& world) { return Numbers{pendulum_angle(world)}; }, {angle}},
           {"rate", [](const World& world) { return Numbers{pendulum_rate(world)}; }, {rate}}}};
}

ReferenceProblem p_r1_torque_free() {
  return rigid_problem("P-R1", {1, 0.5, -0.7}, 1e-3,
                       {0.451359518401040584L, 1.02287564500714392L, -0.473893593841212169L},
                       {0.401006595702115135L, -0.367493469174623553L, -0.583785903125753275L, 0.602773821287096871L});
}

/// In plain sums it misses its tolerance by rounding alone: the state is carried with its rounding errors.
ReferenceProblem p_r2_tennis_racket() {
  ReferenceProblem problem = rigid_problem(
      "P-R2", {0.001, 5, 0.001}, 4e-5, {4.51062712401165273L, -2.15736968276889587L, 2.60421191225993445L},
      {0.20320052058628315L, -0.670231878449195148L, -0.492842339601163567L, -0.516338266875870996L});
  problem.scene.run.compensated = true;
  problem.tolerance = 1e-8L;
  return problem;
}

ReferenceProblem p_r3_top() {
  const auto lean = [](const World& world) { return Numbers{position(world)[2] / 0.1L}; };
  return {"P-R3",
          top(pi / 6, {0, 0, 60}, 0.5, 1e-4),
          {{"cosine of the lean", lean, {0.761912197041726022L}},
           {"orientation", orientation,
            one_sign({-0.891076172017708621L, 0.288233137648652829L, -0.189645880103812801L, 0.294854801865477453L})}}};
}

std::vector<ReferenceProblem> reference_problems() {
  return {p_d1_from_rest(2),       p_d1_from_rest(10),   p_d2_throw(),      p_o1_damped_oscillator(),
          p_o2_stiff_oscillator(), p_k1_kepler(0.6),     p_k1_kepler(0.9),  p_m1_magnus(),
          p_b1_charge(),           p_f1_foucault(),      p_n1_pendulum(30), p_n1_pendulum(90),
          p_r1_torque_free(),      p_r2_tennis_racket(), p_r3_top()};
}

}  // namespace ballpark::tests
