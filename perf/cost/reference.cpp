#include "perf/cost/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "perf/cost/exact.h"
#include "perf/timing.h"

namespace ballpark::cost {

namespace {

using Bars = std::array<double, quantity_count>;
constexpr double half_ulp = std::numeric_limits<double>::epsilon() / 2;  // states are kept in double

using perf::seconds_now;

template <class R>
BodyState state_of(const ExactState<R>& exact, const BodyState& like) {
  const auto d = [](R value) { return static_cast<double>(value); };
  const auto vector_of = [&](const std::array<R, 3>& v) { return Vector3d(d(v[0]), d(v[1]), d(v[2])); };
  BodyState state = like;
  state.position = vector_of(exact.position);
  state.velocity = vector_of(exact.velocity);
  state.angular_velocity = vector_of(exact.angular_velocity);
  const auto& q = exact.orientation;
  state.orientation = {d(q[0]), d(q[1]), d(q[2]), d(q[3])};
  return state;
}

/// Largest distances of two tracks.
Bars apart(const Track& a, const Track& b) {
  const Errors errors = errors_of(a, b, {});
  Bars bars{};
  for (std::size_t q = 0; q < quantity_count; ++q) bars[q] = errors.of[q].maximum;
  return bars;
}

bool acts_on(const Effect& effect, const std::string& group) {
  return effect.groups.empty() || std::find(effect.groups.begin(), effect.groups.end(), group) != effect.groups.end();
}

/// One for all bodies or one for each.
template <class List>
const auto& row_of(const List& list, std::size_t index) {
  return list.size() == 1 ? list.front() : list[index];
}

/// The body of that id, with all effects on it.
LoneBody lone_body(const Scene& scene, const World& world, const std::vector<GroupReport>& counts, std::size_t id) {
  std::size_t index = id;
  for (const BodyGroup& group : scene.bodies) {
    const auto report = std::find_if(counts.begin(), counts.end(), [&](auto& g) { return g.name == group.name; });
    if (index >= report->bodies) {
      index -= report->bodies;
      continue;
    }
    LoneBody body{.group = group, .index = index, .effects = {}, .start = world.body(id), .mass = 0, .inertia = {}};
    for (const Effect& effect : scene.effects) {
      if (acts_on(effect, group.name)) body.effects.push_back(&effect);
    }
    const double radius = group.radius.empty() ? 0 : row_of(group.radius, index);
    const double ball = 4 * 3.14159265358979323846 / 3 * radius * radius * radius;
    body.mass = group.mass.empty() ? row_of(group.density, index) * ball : row_of(group.mass, index);
    if (!group.inertia.empty()) {
      body.inertia = row_of(group.inertia, index);
    } else if (radius > 0) {
      body.inertia = Vector3d::Constant(0.4 * body.mass * radius * radius);
    }
    return body;
  }
  return LoneBody{.group = scene.bodies.front(), .index = 0, .effects = {}, .start = {}, .mass = 0, .inertia = {}};
}

/// One for each id, or none at all.
std::vector<ExactMotion> exact_motions(const Scene& scene, const World& world, const std::vector<std::size_t>& ids) {
  const std::vector<GroupReport> counts = world.explain().groups;
  const bool touching = !scene.contact.kind.empty();
  TouchingBodies all{scene, {}};
  for (std::size_t id = 0; touching && id < world.body_count(); ++id) {
    all.bodies.push_back(lone_body(scene, world, counts, id));
  }
  std::vector<ExactMotion> motions;
  for (const std::size_t id : ids) {
    auto motion = touching ? exact_motion(all, id) : exact_motion(lone_body(scene, world, counts, id));
    if (!motion) return {};
    motions.push_back(std::move(*motion));
  }
  return motions;
}

/// A run that is to be looked at: nullopt if it can't be built, was stopped, or ended badly.
std::optional<Track> tracked(const Scene& scene, const Setting& setting, const Samples& samples, const Options& options,
                             const GoOn& go_on) {
  if (!check(scene_with(scene, setting)).empty()) return std::nullopt;
  std::optional<Subject> made;
  try {
    made.emplace(scene, setting, options);
  } catch (const SceneError&) {  // some limits of steps are known only now
    return std::nullopt;
  }
  Subject& subject = *made;
  Track track(samples);
  if (!subject.follow(samples, track, go_on) || !subject.trouble().empty() || !track.known.back()) return std::nullopt;
  if (!subject.find_events(samples, track, go_on)) return std::nullopt;
  return track;
}

/// States are kept in double.
void add_rounding(ReferenceTrack& reference) {
  const Bars size = size_of(reference.track);
  for (std::size_t q = 0; q < quantity_count; ++q) reference.about.error_bar[q] += half_ulp * size[q];
  reference.about.error_bar[2] += half_ulp * size[2];  // an angle is twice its chord
}

/// How sure the reference is of its events, of which `other` has less accurate times.
void add_event_bar(ReferenceTrack& reference, const Track& other, double share = 1) {
  const std::vector<scenes::EventTimes>& events = reference.track.events;
  reference.about.event_bar = share * event_errors(other.events, events).time + rounding_of(events);
}

/// On the exact motions of the events' bodies; false if there is none of one of them.
bool add_exact_events(const Scene& scene, const World& world, const Samples& samples, Track& track, Track& rounded) {
  constexpr std::size_t fewest = 2'000, most = 20'000;
  const std::size_t parts = std::clamp<std::size_t>(steps_in(scene.run.duration, scene.run.step), fewest, most);
  for (const scenes::BodyEvent& event : samples.events) {
    const std::vector<ExactMotion> motions = exact_motions(scene, world, {event.body});
    if (motions.empty()) return false;
    const BodyState begin = world.body(event.body);
    const auto in_extended = [&](long double t) { return state_of(motions[0].in_extended(t), begin); };
    const auto in_double = [&](long double t) { return state_of(motions[0].in_double(static_cast<double>(t)), begin); };
    track.events.push_back(exact_times(event, begin, in_extended, scene.run.duration, parts));
    rounded.events.push_back(exact_times(event, begin, in_double, scene.run.duration, parts));
  }
  return true;
}

/// Have two runs come as near as rounding lets them, in all that moves?
bool converged(const Track& a, const Track& b) {
  const Bars between = apart(a, b), size = size_of(b);
  for (std::size_t q = 0; q < quantity_count; ++q) {
    if (between[q] > 4 * half_ulp * size[q]) return false;
  }
  return true;
}

constexpr const char* extrapolation = "gragg_bulirsch_stoer10";
constexpr const char* for_springs = "dormand_prince8";  ///< where extrapolation would not see that contacts begin
constexpr double loose = 1e-16, tight = 1e-18;

std::optional<ReferenceTrack> by_extrapolation(Scene scene, const Samples& samples, const Options& options,
                                               const GoOn& go_on) {
  scene.run.absolute_tolerance = 0;
  const bool springs = scene.contact.kind == "penalty";
  const char* const integrator = springs ? for_springs : extrapolation;
  const auto at = [&](double tolerance) {  // a tree would be an error of its own
    Setting setting{integrator, 0, tolerance, Precision::extended};
    if (may_use_tree(scene)) setting.opening_angle = 0;
    return allowed(scene, setting);
  };
  const Setting coarse = at(loose), fine = at(tight);
  const std::optional<Track> first = tracked(scene, coarse, samples, options, go_on);
  if (!first) return std::nullopt;
  const double begin = seconds_now();
  std::optional<Track> second = tracked(scene, fine, samples, options, go_on);
  if (!second) return std::nullopt;
  ReferenceTrack reference{{springs ? "adaptive runs in extended precision" : "extrapolation in extended precision",
                            fmt::format("{}, tolerances {:g} and {:g}", integrator, loose, tight),
                            apart(*first, *second), scale_of(*second, samples), 0, fine, seconds_now() - begin},
                           std::move(*second)};
  add_event_bar(reference, *first);
  add_rounding(reference);
  return reference;
}

/// What the two finest runs use: contacts ask for more iterations.
Setting finest_setting(const Scene& scene) {
  Setting setting = setting_of(scene);
  setting.tolerance = 0;
  setting.precision = Precision::double_;
  setting.contact.iterations *= 4;
  if (setting.opening_angle > 0) setting.opening_angle = 0;  // a tree would be an error of its own
  for (const char* accurate : {"dormand_prince8", "rk4"}) {
    setting.step = scene.run.duration / 100;
    Setting other = setting;
    other.integrator = accurate;
    other = allowed(scene, other);
    if (scene.contact.kind == "impulse" || !check(scene_with(scene, other)).empty()) continue;
    setting = other;
    break;
  }
  return setting;
}

}  // namespace

std::optional<ReferenceTrack> closed_form(const Scene& scene, const Samples& samples, const Options& options) {
  if (!scene.impulses.empty()) return std::nullopt;
  Scene start = scene;
  start.run.precision = Precision::double_;
  Options plain = options;
  plain.precision.reset();
  const World world(start, plain);
  const std::vector<ExactMotion> motions = exact_motions(scene, world, samples.ids);
  if (motions.empty()) return std::nullopt;
  ReferenceTrack reference{{"closed form", "", {}, {}, 0}, Track(samples)};
  Track rounded(samples);
  for (std::size_t b = 0; b < samples.ids.size(); ++b) {
    const ExactMotion& motion = motions[b];
    const BodyState begin = world.body(samples.ids[b]);
    if (reference.about.what.find(motion.what) == std::string::npos) {
      reference.about.what += (reference.about.what.empty() ? "" : "; ") + motion.what;
    }
    for (std::size_t k = 0; k < samples.times.size(); ++k) {
      const std::size_t place = k * samples.ids.size() + b;
      reference.track.states[place] = state_of(motion.in_extended(samples.times[k]), begin);
      rounded.states[place] = state_of(motion.in_double(samples.times[k]), begin);
      reference.track.known[k] = rounded.known[k] = 1;
    }
  }
  if (!add_exact_events(scene, world, samples, reference.track, rounded)) return std::nullopt;
  constexpr double ulps = std::numeric_limits<long double>::epsilon() / std::numeric_limits<double>::epsilon();
  reference.about.scale = scale_of(reference.track, samples);
  reference.about.error_bar = apart(reference.track, rounded);
  for (double& bar : reference.about.error_bar) bar *= 2 * static_cast<double>(ulps);
  add_event_bar(reference, rounded, 2 * static_cast<double>(ulps));
  add_rounding(reference);
  return reference;
}

/// Steps halved while there is time; the last run is the reference, and how far it is from the one before its bar.
std::optional<ReferenceTrack> finest_runs(const Scene& scene, const Samples& samples, const Options& options,
                                          double seconds, const GoOn& go_on) {
  Setting setting = finest_setting(scene);
  std::optional<Track> before, last;
  double taken = 0, last_taken = 0;
  std::uint64_t steps = samples.times.size();
  for (; steps <= 20'000'000 && taken * 2.2 < seconds; steps *= 2) {
    const double begin = seconds_now();
    setting.step = scene.run.duration / static_cast<double>(steps);
    std::optional<Track> track = tracked(scene, setting, samples, options, go_on);
    if (!go_on()) return std::nullopt;
    last_taken = seconds_now() - begin;
    taken = std::max(last_taken, 2 * taken);
    seconds -= last_taken;
    before = std::exchange(last, std::move(track));
    if (before && last && converged(*before, *last)) break;
  }
  if (!last || !before) return std::nullopt;
  ReferenceTrack reference{{"two finest runs", text(setting) + " and twice that", apart(*before, *last),
                            scale_of(*last, samples), 0, setting, last_taken},
                           std::move(*last)};
  add_event_bar(reference, *before);
  add_rounding(reference);
  return reference;
}

std::optional<ReferenceTrack> numerical_reference(const Scene& scene, const Samples& samples, const Options& options,
                                                  double seconds, const GoOn& go_on) {
  constexpr std::size_t many = 10'000;  // extended precision would not get far
  if (World(scene, options).body_count() > many) return finest_runs(scene, samples, options, seconds, go_on);
  const double end = seconds_now() + seconds / 2;
  const GoOn in_time = [&] { return go_on() && seconds_now() < end; };
  if (auto reference = by_extrapolation(scene, samples, options, in_time)) return reference;
  return go_on() ? finest_runs(scene, samples, options, seconds / 2, go_on) : std::nullopt;
}

}  // namespace ballpark::cost
