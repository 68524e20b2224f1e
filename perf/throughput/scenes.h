// The scenes that the suite runs, built in code.
#pragma once

#include "perf/throughput/subject.h"

namespace ballpark::perf {

/// Particles of one mass under gravity and quadratic drag; positions and velocities differ from body to body.
Scene falling_particles(std::size_t bodies, const std::string& integrator = "rk4");

/// A force on all bodies that ended before the start.
Effect force_that_is_over();

/// Asymmetric tumbling bodies under gravity.
Scene tumbling_bodies(std::size_t bodies);

/// Spheres under gravity: particles, until an effect asks for their rotation.
Scene falling_spheres(std::size_t bodies);

/// The bodies of `falling_particles` as bare columns.
Start start_of_falling_particles(std::size_t bodies);

}  // namespace ballpark::perf
