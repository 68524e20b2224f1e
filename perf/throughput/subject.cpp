#include "perf/throughput/subject.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "perf/bandwidth.h"
#include "perf/throughput/bare_arrays.h"

namespace ballpark::perf {

namespace {

constexpr double bytes_of_a_particle_step = 6 * 2 * sizeof(double);  // position and velocity, read and written

using Loop = decltype(&hand_written_rk4);

Subject bare_subject(std::string name, const Start& start, Loop loop) {
  const auto arrays = std::make_shared<BareArrays>(start.columns);
  const std::size_t count = arrays->count(), steps = steps_per_run(count);
  return {.name = std::move(name),
          .bodies = count,
          .units = static_cast<double>(count * steps),
          .bytes_per_unit = bytes_of_a_particle_step,
          .run =
              [arrays, problem = start.problem, loop, steps] {
                const BareArrays& a = *arrays;
                for (std::size_t i = 0; i < steps; ++i) loop(problem, a[0], a[1], a[2], a[3], a[4], a[5], a.count());
              },
          .state = [arrays] { return arrays->columns(); }};
}

void touch_all(const DragProblem&, double* x, double* y, double* z, double* vx, double* vy, double* vz,
               std::size_t count) {
  touch(x, y, z, vx, vy, vz, count);
}

}  // namespace

std::size_t steps_per_run(std::size_t bodies) {
  return std::max<std::size_t>(1, 250'000 / std::max<std::size_t>(bodies, 1));
}

StateColumns state_of(const World& world) {
  StateColumns columns;
  for (const char* name : {"position", "velocity"}) {
    const View<double> view = world.view<double>(name);
    for (const auto& component : view.components) {
      std::vector<double>& column = columns.emplace_back(world.body_count());
      for (std::size_t id = 0; id < column.size(); ++id) column[id] = component[world.row_of(id) - view.first_row];
    }
  }
  return columns;
}

Subject world_subject(std::string name, const Scene& scene, const Options& options) {
  const auto world = std::make_shared<World>(scene, options);
  const std::size_t steps = steps_per_run(world->body_count());
  Subject subject{.name = name,
                  .bodies = world->body_count(),
                  .units = static_cast<double>(world->body_count() * steps),
                  .bytes_per_unit = world->explain().bytes_per_body_step,
                  .run =
                      [world, steps, name] {
                        world->step(steps);
                        const Status& status = world->status();
                        if (status.code != Status::Code::ok) throw std::runtime_error(name + ": " + status.sentence);
                      },
                  .state = nullptr};
  if (world->precision() == Precision::double_) subject.state = [world] { return state_of(*world); };
  return subject;
}

Subject hand_written_subject(std::string name, const Start& start) {
  return bare_subject(std::move(name), start, hand_written_rk4);
}

Subject touch_subject(std::string name, const Start& start) {
  return bare_subject(std::move(name), start, touch_all);
}

Subject odeint_subject(std::string name, const Start& start, const OdeintMethod& method) {
  const std::size_t count = start.columns.front().size(), steps = steps_per_run(count);
  const auto bodies = std::make_shared<std::vector<OdeintState>>(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < 6; ++c) (*bodies)[i][c] = start.columns[c][i];
  }
  return {.name = std::move(name),
          .bodies = count,
          .units = static_cast<double>(count * steps),
          .bytes_per_unit = bytes_of_a_particle_step,
          .run =
              [bodies, problem = start.problem, step = method.step, steps] {
                for (std::size_t i = 0; i < steps; ++i) step(problem, bodies->data(), bodies->size());
              },
          .state =
              [bodies] {
                StateColumns columns(6, std::vector<double>(bodies->size()));
                for (std::size_t i = 0; i < bodies->size(); ++i) {
                  for (std::size_t c = 0; c < 6; ++c) columns[c][i] = (*bodies)[i][c];
                }
                return columns;
              }};
}

Subject triad_subject(std::string name, int threads) {
  constexpr int sweeps = 4;  // several at a time: starting the threads must not count
  const auto triad = std::make_shared<Triad>(threads);
  return {.name = std::move(name),
          .bodies = 0,
          .units = sweeps * static_cast<double>(triad->elements()),
          .bytes_per_unit = Triad::bytes_per_element,
          .run = [triad] { triad->sweep(sweeps); },
          .state = nullptr};
}

}  // namespace ballpark::perf
