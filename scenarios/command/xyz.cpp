#include "scenarios/command/xyz.h"

#include <algorithm>
#include <map>

#include "scenarios/command/number_text.h"

namespace ballpark::command {
namespace {

/// OVITO's names, with which its properties Position, Velocity and so on are filled.
const std::map<std::string, std::string>& property_names() {
  static const std::map<std::string, std::string> names = {{"position", "pos"},
                                                           {"velocity", "velo"},
                                                           {"orientation", "orientation"},
                                                           {"angular_velocity", "angular_velocity"},
                                                           {"contacts", "contacts"},
                                                           {"contact_force", "contact_force"}};
  return names;
}

const Boundary* periodic(const Scene& scene) {
  const auto repeats = [](const Boundary& boundary) { return boundary.shape == "periodic"; };
  const auto found = std::find_if(scene.boundaries.begin(), scene.boundaries.end(), repeats);
  return found == scene.boundaries.end() ? nullptr : &*found;
}

}  // namespace

// An axis along which space is open still needs a length: the longest of the others.
std::string xyz_cell(const Scene& scene) {
  const Boundary* space = periodic(scene);
  if (!space) return "pbc=\"F F F\"";
  const double longest = space->size.maxCoeff();
  Vector3d size = space->size;
  std::string repeats;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    repeats += std::string(axis > 0 ? " " : "") + (size[axis] > 0 ? "T" : "F");
    if (size[axis] == 0) size[axis] = longest;
  }
  const Vector3d origin = space->point - size / 2;
  return fmt::format("Lattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"{}\"", size.x(), size.y(), size.z(),
                     origin.x(), origin.y(), origin.z(), repeats);
}

// X is no element: bodies are none, and ASE takes only names that it knows.
void XyzFrames::begin(const FrameLayout& layout) {
  layout_ = layout;
  properties_ = "Properties=species:S:1:id:I:1";
  for (const FrameColumn& column : layout.columns) {
    properties_ += fmt::format(":{}:R:{}", property_names().at(column.name), column.components());
  }
  if (!layout.radius.empty()) properties_ += ":radius:R:1";
}

void XyzFrames::add(const Frames& frames) {
  for (std::size_t frame = 0; frame < frames.count(); ++frame) add_frame(frames, frame);
}

void XyzFrames::add_frame(const Frames& frames, std::size_t frame) {
  constexpr std::size_t piece = 1 << 16;
  fmt::memory_buffer text;
  const auto append = [&](double value) {
    text.push_back(' ');
    append_shortest(text, value, single_);
  };
  const std::vector<std::int32_t> here = present(layout_, frames, frame);
  fmt::format_to(fmt::appender(text), "{}\n{} {} Time={}\n", here.size(), cell_, properties_, frames.times[frame]);
  for (const std::int32_t body : here) {
    const auto id = static_cast<std::size_t>(body);
    fmt::format_to(fmt::appender(text), "X {}", id);
    for (std::size_t c = 0; c < layout_.columns.size(); ++c) {
      const std::size_t n = layout_.columns[c].components();
      const auto values = frames.values(c, frame).subspan(n * id, n);
      const std::size_t first = n == 4 ? 1 : 0;  // quaternions are x, y, z, w here
      for (std::size_t k = 0; k < n; ++k) append(values[(first + k) % n]);
    }
    if (!layout_.radius.empty()) append(layout_.radius[id]);
    text.push_back('\n');
    if (text.size() < piece) continue;
    file_.write({text.data(), text.size()});
    text.clear();
  }
  file_.write({text.data(), text.size()});
}

}  // namespace ballpark::command
