#include "scenarios/files/output_formats.h"

#include <algorithm>

namespace ballpark::scenes {

const std::vector<OutputFormat>& output_formats() {
  static const std::vector<OutputFormat> formats = {
      {".npz", "NumPy"},
      {".csv", ""},
      {".xyz", "OVITO, ASE", false, true},
      {".pvd", "ParaView", true, true},
      {".vtp", "ParaView", true, true},
  };
  return formats;
}

const OutputFormat* output_format(const std::string& path) {
  for (const OutputFormat& format : output_formats()) {
    if (path.ends_with(format.ending)) return &format;
  }
  return nullptr;
}

std::string output_endings() {
  std::string text;
  const std::vector<OutputFormat>& formats = output_formats();
  for (const OutputFormat& format : formats) {
    if (!text.empty()) text += &format == &formats.back() ? " or " : ", ";
    text += format.ending + (format.read_by.empty() ? "" : " (" + format.read_by + ")");
  }
  return text;
}

const std::vector<std::string>& output_columns() {
  static const std::vector<std::string> names = {"position", "orientation",   "velocity", "angular_velocity",
                                                 "contacts", "contact_force", "radius"};
  return names;
}

bool lacks_position(const OutputRequest& request) {
  const OutputFormat* format = output_format(request.file);
  const std::vector<std::string>& chosen = request.columns;
  return format && format->drawn && !chosen.empty() &&
         std::find(chosen.begin(), chosen.end(), "position") == chosen.end();
}

std::string lacking_contacts(const OutputRequest& request, const Scene& scene) {
  if (!scene.contact.kind.empty()) return "";
  for (const char* name : {"contacts", "contact_force"}) {
    const std::vector<std::string>& chosen = request.columns;
    if (std::find(chosen.begin(), chosen.end(), name) != chosen.end()) return name;
  }
  return "";
}

}  // namespace ballpark::scenes
