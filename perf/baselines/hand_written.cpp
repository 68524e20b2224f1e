#include "perf/baselines/hand_written.h"

#include <cmath>

namespace ballpark::perf {

namespace {

inline double speed(double vx, double vy, double vz) {
  return std::sqrt(vx * vx + vy * vy + vz * vz);
}

}  // namespace

// Scalars and restrict parameters throughout: with components in structs or restrict locals g++ 12 does not vectorise.
void hand_written_rk4(const DragProblem& problem, double* __restrict x, double* __restrict y, double* __restrict z,
                      double* __restrict vx, double* __restrict vy, double* __restrict vz, std::size_t count) {
  const double g = problem.gravity, k = -problem.drag_over_mass;
  const double h = problem.step, half = h / 2, sixth = h / 6;
  for (std::size_t i = 0; i < count; ++i) {
    const double vx1 = vx[i], vy1 = vy[i], vz1 = vz[i];
    const double k1 = k * speed(vx1, vy1, vz1);
    const double ax1 = k1 * vx1, ay1 = k1 * vy1, az1 = k1 * vz1 - g;
    const double vx2 = vx1 + half * ax1, vy2 = vy1 + half * ay1, vz2 = vz1 + half * az1;
    const double k2 = k * speed(vx2, vy2, vz2);
    const double ax2 = k2 * vx2, ay2 = k2 * vy2, az2 = k2 * vz2 - g;
    const double vx3 = vx1 + half * ax2, vy3 = vy1 + half * ay2, vz3 = vz1 + half * az2;
    const double k3 = k * speed(vx3, vy3, vz3);
    const double ax3 = k3 * vx3, ay3 = k3 * vy3, az3 = k3 * vz3 - g;
    const double vx4 = vx1 + h * ax3, vy4 = vy1 + h * ay3, vz4 = vz1 + h * az3;
    const double k4 = k * speed(vx4, vy4, vz4);
    const double ax4 = k4 * vx4, ay4 = k4 * vy4, az4 = k4 * vz4 - g;
    x[i] += sixth * (vx1 + 2 * (vx2 + vx3) + vx4);
    y[i] += sixth * (vy1 + 2 * (vy2 + vy3) + vy4);
    z[i] += sixth * (vz1 + 2 * (vz2 + vz3) + vz4);
    vx[i] = vx1 + sixth * (ax1 + 2 * (ax2 + ax3) + ax4);
    vy[i] = vy1 + sixth * (ay1 + 2 * (ay2 + ay3) + ay4);
    vz[i] = vz1 + sixth * (az1 + 2 * (az2 + az3) + az4);
  }
}

void hand_written_attraction(const AttractionProblem& problem, const double* mass, double* const* position,
                             double* const* velocity, std::size_t count) {
  constexpr std::size_t lanes = 16;
  const double *x = position[0], *y = position[1], *z = position[2];
  const double softening = problem.softening * problem.softening;
  for (std::size_t i = 0; i < count; i += lanes) {
    double ax[lanes] = {}, ay[lanes] = {}, az[lanes] = {};
    for (std::size_t j = 0; j < count; ++j) {
      const double xj = x[j], yj = y[j], zj = z[j], m = mass[j];
      for (std::size_t k = 0; k < lanes; ++k) {
        const double dx = xj - x[i + k], dy = yj - y[i + k], dz = zj - z[i + k];
        const double square = dx * dx + dy * dy + dz * dz + softening;
        const double pull = m / (square * std::sqrt(square));
        ax[k] += pull * dx;
        ay[k] += pull * dy;
        az[k] += pull * dz;
      }
    }
    for (std::size_t k = 0; k < lanes && i + k < count; ++k) {
      velocity[0][i + k] += problem.step * ax[k];
      velocity[1][i + k] += problem.step * ay[k];
      velocity[2][i + k] += problem.step * az[k];
    }
  }
  for (int c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < count; ++i) position[c][i] += problem.step * velocity[c][i];
  }
}

void touch(double* __restrict x, double* __restrict y, double* __restrict z, double* __restrict vx,
           double* __restrict vy, double* __restrict vz, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    x[i] += 1;
    y[i] += 1;
    z[i] += 1;
    vx[i] += 1;
    vy[i] += 1;
    vz[i] += 1;
  }
}

}  // namespace ballpark::perf
