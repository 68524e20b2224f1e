// The reference problems end where they must, in each precision.
#include "tests/catch.h"
#include "tests/physics/problems.h"

using namespace ballpark::tests;

namespace {

/// The problem's error is below its tolerance, and halving the step changes the end by less than it.
void holds(const ReferenceProblem& problem) {
  INFO(problem.name << ", step " << problem.scene.run.step << " s");
  ReferenceProblem finer = problem;
  finer.scene.run.step /= 2;
  const Outcome coarse = run(problem), fine = run(finer);
  CHECK(coarse.status.sentence == "ok");
  for (std::size_t i = 0; i < problem.quantities.size(); ++i) {
    INFO(problem.quantities[i].name);
    CHECK(coarse.errors[i] <= problem.tolerance);
    CHECK(largest_difference(coarse.end[i], fine.end[i]) / coarse.scale[i] < problem.tolerance);
  }
}

}  // namespace

TEST_CASE("P-D1: fall with quadratic drag, from rest", "[physics]") {
  holds(p_d1_from_rest(2));
  holds(p_d1_from_rest(10));
}

TEST_CASE("P-D2: throw with quadratic drag", "[physics]") {
  holds(p_d2_throw());
}

TEST_CASE("P-O1: damped oscillator", "[physics]") {
  holds(p_o1_damped_oscillator());
}

TEST_CASE("P-O2: stiff oscillator, with a step inside the limit", "[physics]") {
  holds(p_o2_stiff_oscillator());
}

TEST_CASE("P-K1: Kepler, e = 0.6", "[physics]") {
  holds(p_k1_kepler(0.6));
}

TEST_CASE("P-K1: Kepler, e = 0.9", "[physics]") {
  holds(p_k1_kepler(0.9));
}

TEST_CASE("P-M1: Magnus lift on a spinning ball", "[physics]") {
  holds(p_m1_magnus());
}

TEST_CASE("P-B1: charge in a magnetic field", "[physics]") {
  holds(p_b1_charge());
}

TEST_CASE("P-F1: Foucault's pendulum, an hour of it", "[physics]") {
  holds(p_f1_foucault());
}

TEST_CASE("P-N1: pendulum on a pivot from 30 and 90 degrees", "[physics]") {
  holds(p_n1_pendulum(30));
  holds(p_n1_pendulum(90));
}

TEST_CASE("P-R1: torque-free body", "[physics]") {
  holds(p_r1_torque_free());
}

TEST_CASE("P-R2: tennis-racket flips", "[physics]") {
  holds(p_r2_tennis_racket());
}

TEST_CASE("P-R3: heavy symmetric top", "[physics]") {
  holds(p_r3_top());
}
