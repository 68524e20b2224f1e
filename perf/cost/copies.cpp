// An ensemble's copies: run one by one, and what is seen of each at its end.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perf/cost/ensemble.h"

namespace ballpark::cost {

namespace {

/// By observable; of all bodies.
std::vector<double> seen(const Track& end, const Totals& start) {
  const auto bodies = static_cast<double>(end.states.size());
  Vector3d centre = Vector3d::Zero();
  double speed = 0, squares = 0;
  for (const BodyState& body : end.states) {
    centre += body.position / bodies;
    speed += body.velocity.norm() / bodies;
  }
  for (const BodyState& body : end.states) squares += (body.position - centre).squaredNorm() / bodies;
  const Totals& totals = end.totals.back();
  const double scale = std::max({std::abs(start.energy()), start.kinetic, totals.kinetic});
  const double change = scale > 0 ? (totals.energy() - start.energy()) / scale : 0;
  return {totals.kinetic, change, speed, centre.x(), centre.y(), centre.z(), std::sqrt(squares), end.penetration};
}

bool finite(const std::vector<double>& values) {
  for (const double value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

}  // namespace

const std::vector<Observable>& observables() {
  static const std::vector<Observable> list{{"kinetic energy", "J"}, {energy_change, ""},     {"mean speed", "m/s"},
                                            {"centre x", "m"},       {"centre y", "m"},       {"centre z", "m"},
                                            {"spread", "m"},         {"deepest overlap", "m"}};
  return list;
}

std::optional<Copies> run_copies(const Scene& scene, const Setting& setting, const EnsembleRequest& request,
                                 const Options& options, const GoOn& go_on) {
  Copies copies;
  copies.values.resize(observables().size());
  Options perturbed = options;
  perturbed.perturb = request.perturb;
  Scene copy = scene;
  for (int k = 0; k < request.copies; ++k) {
    copy.run.seed = scene.run.seed + static_cast<std::uint64_t>(k);
    Subject subject(copy, setting, perturbed);
    const std::size_t bodies = subject.world().body_count();
    const Samples samples = samples_of(copy.run.duration, bodies, 1, bodies);
    Track end(samples);
    if (!subject.follow(samples, end, go_on)) return std::nullopt;
    copies.trouble = subject.trouble();
    if (copies.trouble.empty() && !end.known.back()) copies.trouble = "no step is small enough";
    const std::vector<double> values = seen(end, subject.start());
    if (copies.trouble.empty() && !finite(values)) copies.trouble = "it ends in numbers that are not finite";
    if (!copies.trouble.empty()) {
      copies.trouble = fmt::format("copy {}: {}", k, copies.trouble);
      break;
    }
    for (std::size_t o = 0; o < values.size(); ++o) copies.values[o].push_back(values[o]);
  }
  return copies;
}

}  // namespace ballpark::cost
