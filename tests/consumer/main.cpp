// Uses the installed library as a stranger would: a scene built in code, an impulse, positions read in place, a user
// effect, a scene file. It also computes with the Eigen types that the library may use inside: this file is compiled
// for a newer processor than the library, and their templates must not get in each other's way.
#include <ballpark/ballpark.h>
#include <ballpark/scenes.h>
#include <Eigen/Dense>

#include <cmath>
#include <cstdio>
#include <exception>

namespace {

int failures = 0;

void expect_near(const char* what, double found, double expected, double tolerance) {
  const bool near = std::abs(found - expected) <= tolerance;  // false for NaN
  std::printf("%-40s %.17g, expected %.17g: %s\n", what, found, expected, near ? "ok" : "WRONG");
  if (!near) ++failures;
}

ballpark::Scene two_throws() {
  ballpark::BodyGroup balls;
  balls.name = "balls";
  balls.mass = {0.5};
  balls.position = {{0, 0, 10}, {1, 0, 10}};
  balls.velocity = {{3, 0, 4}};
  ballpark::Scene scene;
  scene.bodies = {balls};
  scene.effects = {{.kind = "gravity", .groups = {}, .parameters = {}}};
  scene.run.duration = 2;
  scene.run.step = 1.0 / 128;  // a power of two: both throws end exactly at their times
  scene.run.integrator = "rk4";
  return scene;
}

void throw_two_balls() {
  ballpark::World world(two_throws());
  world.step(128);
  world.apply_impulse(1, {0, 2, 0});  // 2 N s on 0.5 kg: 4 m/s more
  world.step(128);
  const ballpark::View<double> position = world.view<double>("position");
  const ballpark::View<double> again = world.view<double>("position");
  if (position[2].data() != again[2].data()) ++failures;  // a copy would lie somewhere else
  const double z = 10 + 4 * 2.0 - 9.81 * 2.0 * 2.0 / 2;
  for (std::size_t id : {0, 1}) {
    const std::size_t row = world.row_of(id);
    expect_near("x after 2 s", position[0][row], double(id) + 6, 1e-12);
    expect_near("y after 2 s, 1 s after the impulse", position[1][row], id == 1 ? 4 : 0, 1e-12);
    expect_near("z after 2 s", position[2][row], z, 1e-12);
  }
  expect_near("status", static_cast<double>(world.status().code), 0, 0);
}

void push_with_own_effect() {
  ballpark::UserEffect wind;
  wind.name = "wind";
  wind.reads_velocity = false;
  wind.run_double = [](const ballpark::BodyBlock<double>& block) {
    for (std::size_t i = 0; i < block.count; ++i) block.force[1][i] += 0.25;
  };
  ballpark::World world(two_throws(), {}, {wind});
  world.advance_to(2);
  expect_near("y after 2 s of wind", world.body(0).position.y(), 0.5 * 2 * 2 / 2, 1e-12);
}

void load_scene_file(const char* path) {
  const ballpark::scenes::SceneFile file = ballpark::scenes::load(path);
  const ballpark::scenes::RunReport report = ballpark::scenes::run(file);
  expect_near("expectations in the scene file", static_cast<double>(report.verdicts.size()), 1, 0);
  for (const ballpark::scenes::Verdict& verdict : report.verdicts) {
    expect_near(verdict.sentence.c_str(), verdict.met, 1, 0);
  }
}

void compute_with_eigen() {
  Eigen::Vector4d diagonal(2, 4, 8, 16);
  Eigen::Matrix4d a = diagonal.asDiagonal();
  a.topRightCorner<2, 2>() = Eigen::Matrix2d::Ones();
  const Eigen::Vector4d x = a.inverse() * (a * Eigen::Vector4d::Ones());
  expect_near("4 x 4 solve", (x - Eigen::Vector4d::Ones()).norm(), 0, 1e-14);
  Eigen::Matrix3d inertia = Eigen::Vector3d(1, 2, 3).asDiagonal();
  const Eigen::AngleAxisd turn(0.5, Eigen::Vector3d(1, 2, 2) / 3);
  inertia = turn.toRotationMatrix() * inertia * turn.toRotationMatrix().transpose();
  const Eigen::Vector3d moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvalues();
  expect_near("principal moments", (moments - Eigen::Vector3d(1, 2, 3)).norm(), 0, 1e-13);
  Eigen::MatrixXd large = Eigen::MatrixXd::Identity(33, 33) * 3;
  large(0, 32) = 1;
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(33);
  expect_near("33 x 33 solve", (large.partialPivLu().solve(large * ones) - ones).norm(), 0, 1e-13);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fputs("usage: consumer SCENE_FILE\n", stderr), 2;
  try {
    compute_with_eigen();
    throw_two_balls();
    push_with_own_effect();
    load_scene_file(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return failures == 0 ? 0 : 1;
}
