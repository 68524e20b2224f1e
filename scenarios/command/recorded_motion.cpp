#include "scenarios/command/recorded_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ballpark/world.h"
#include "scenarios/command/errors.h"
#include "scenarios/command/frame_source.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

/// Bodies of a frame as states of a world.
class FrameBodies {
 public:
  explicit FrameBodies(const FrameLayout& layout)
      : position(place(layout, "position")),
        velocity(place(layout, "velocity")),
        orientation(place(layout, "orientation")),
        angular_velocity(place(layout, "angular_velocity")),
        contacts(place(layout, "contacts")) {}

  const std::optional<std::size_t> position, velocity, orientation, angular_velocity,
      contacts;  ///< columns that there are

  BodyState body(const Frames& frame, std::size_t id) const {
    BodyState state;
    read(frame, position, id, state.position);
    read(frame, velocity, id, state.velocity);
    read(frame, angular_velocity, id, state.angular_velocity);
    if (orientation) {
      const double* q = frame.columns[*orientation].data() + 4 * id;
      state.orientation = {q[0], q[1], q[2], q[3]};
    }
    return state;
  }

  std::uint8_t contacts_of(const Frames& frame, std::size_t id) const {
    return contacts ? static_cast<std::uint8_t>(std::max(0.0, std::min(255.0, frame.columns[*contacts][id]))) : 0;
  }

 private:
  static std::optional<std::size_t> place(const FrameLayout& layout, const std::string& name) {
    for (std::size_t c = 0; c < layout.columns.size(); ++c) {
      if (layout.columns[c].name == name) return c;
    }
    return std::nullopt;
  }
  static void read(const Frames& frame, std::optional<std::size_t> column, std::size_t id, Vector3d& vector) {
    if (column) vector = Eigen::Map<const Vector3d>(frame.columns[*column].data() + 3 * id);
  }
};

view::Columns columns_of(const MotionRequest& request, const FrameBodies& bodies) {
  const auto offered = [&](bool asked, bool there, const char* column, const char* why) {
    if (asked && !there && request.columns_asked) {
      throw UsageError(fmt::format("--columns: '{}' has no {}: {}", request.path, column, why));
    }
    return asked && there;
  };
  view::Columns columns = request.columns;
  columns.orientation =
      offered(columns.orientation, bodies.orientation.has_value(), "orientation", "it was not written");
  columns.speed = offered(columns.speed, bodies.velocity.has_value(), "speed", "velocity was not written");
  columns.energy = offered(columns.energy, request.scene && bodies.velocity.has_value(), "energy",
                           "it needs velocity, and masses from --scene SCENE");
  columns.contacts = offered(columns.contacts, bodies.contacts.has_value(), "contacts", "they were not written");
  return columns;
}

/// One group, of what the file alone tells.
view::ShownBodies shown_of(const FrameLayout& layout, std::size_t most) {
  view::ShownBodies shown;
  shown.stride = std::max<std::size_t>(1, (layout.bodies + most - 1) / most);
  view::ShownGroup group{"bodies", 0, 0, {}, false};
  for (std::size_t id = 0; id < layout.bodies; id += shown.stride) {
    shown.ids.push_back(id);
    if (!layout.radius.empty()) group.radius.push_back(layout.radius[id]);
  }
  const auto differs = [&](double radius) { return radius != group.radius[0]; };
  if (std::none_of(group.radius.begin(), group.radius.end(), differs)) {
    group.radius.resize(std::min<std::size_t>(group.radius.size(), 1));
  }
  group.count = shown.ids.size();
  shown.groups = {group};
  shown.inertias.resize(shown.ids.size());
  return shown;
}

/// The scene's groups, over as many copies as the file holds.
view::ShownBodies shown_of(const FrameLayout& layout, std::size_t most, const Scene& scene, const std::string& path) {
  const std::size_t each = body_count(scene);
  if (each == 0 || layout.bodies % each != 0) {
    throw UsageError(fmt::format("--scene: '{}' has {}, the scene {}", path, counted(layout.bodies, "body", "bodies"),
                                 grouped(each)));
  }
  Options options;
  options.copies = static_cast<int>(layout.bodies / each);
  return view::shown_bodies(scene, World(scene, options), options.copies, most);
}

/// Is the frame before, at `last`, nearer to the wanted time than the one at `time`?
bool is_past(const std::optional<double>& wanted, double last, double time) {
  return wanted && time > *wanted && time - *wanted >= std::abs(*wanted - last);
}

}  // namespace

view::Recording recorded_motion(const MotionRequest& request, const std::function<bool()>& go_on) {
  const std::unique_ptr<FrameSource> source = open_frame_source(request.path);
  const FrameLayout& layout = source->layout();
  const FrameBodies bodies(layout);
  if (!bodies.position) refuse_frames(request.path, "it has no positions");
  const view::Columns columns = columns_of(request, bodies);
  const std::size_t most = request.limits.shown(columns, source->frames());
  view::ShownBodies shown =
      request.scene ? shown_of(layout, most, *request.scene, request.path) : shown_of(layout, most);
  for (view::ShownGroup& group : shown.groups) group.turns = columns.orientation;
  view::Film film;
  double last = 0;
  bool passed = false;
  for (Frames frame; go_on() && source->next(frame);) {
    const double time = frame.times[0];
    passed = film.frames() > 0 && is_past(request.until, last, time);
    if (passed) break;
    if (film.frames() == 0) {
      film.begin(shown, columns, source->frames(), layout.bodies, bodies.body(frame, shown.ids[0]).position);
    }
    for (const std::size_t id : shown.ids) film.add(bodies.body(frame, id), bodies.contacts_of(frame, id));
    film.end_frame(last = time);
  }
  if (request.until && !passed && *request.until > last * (1 + 1e-12)) {
    throw UsageError(
        fmt::format("--still: {} s is beyond the last frame at {} s", number(*request.until), number(last)));
  }
  view::Recording recording = film.take();
  const std::filesystem::path path(request.path);
  recording.scenario = request.scene ? request.scene->name : path.stem().string();
  recording.label = path.filename().string();
  if (request.scene) {
    recording.doc = request.scene->doc;
    recording.boundaries = request.scene->boundaries;
  }
  return recording;
}

}  // namespace ballpark::command
