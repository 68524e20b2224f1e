#include "scenarios/files/requests.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "scenarios/files/document.h"
#include "scenarios/files/keys.h"
#include "scenarios/files/output_formats.h"

namespace ballpark::scenes {

namespace {

class RequestCheck {
 public:
  explicit RequestCheck(const Scene& scene) : scene_(scene), run_(scene.run) {}

  void output(const OutputRequest& request, const std::string& path) {
    optional_number("output", "every", request.every, path);
    for (const double at : request.at) time("output", at, path);
    if (request.every && !request.at.empty()) add(path + ".at", "stands beside every, expected one of the two");
    if (!request.every && request.at.empty()) add(path, "has neither every nor at, expected one of the two");
    if (!output_format(request.file)) {
      add(path + ".file",
          fmt::format("is \"{}\", expected a file name with {}", printable(request.file), output_endings()));
    }
    if (lacks_position(request)) {
      add(path + ".columns", "lack \"position\", expected it among the columns of a file that is drawn");
    }
    if (const std::string column = lacking_contacts(request, scene_); !column.empty()) {
      add(path + ".columns",
          fmt::format("have \"{}\", but bodies do not touch, expected a scene with [contact]", column));
    }
  }

  void event(const EventRequest& request, const std::vector<EventRequest>& all, const std::string& path) {
    optional_number("event", "value", request.value, path);
    const auto in_word = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
    const bool word = !request.name.empty() && std::all_of(request.name.begin(), request.name.end(), in_word);
    if (!word) {
      add(path + ".name", fmt::format("is \"{}\", expected a word of letters, digits, - and _ (events.NAME.count)",
                                      printable(request.name)));
    }
    const auto first = std::find_if(all.begin(), all.end(), [&](auto& other) { return other.name == request.name; });
    if (&*first != &request) {
      add(path + ".name", fmt::format("\"{}\" is the name of an earlier event", printable(request.name)));
    }
  }

  void expectation(const Expectation& expectation, const std::string& path) {
    if (expectation.at) time("expect", *expectation.at, path);
    optional_number("expect", "min", expectation.minimum, path);
    optional_number("expect", "max", expectation.maximum, path);
    optional_number("expect", "value", expectation.value, path);
    optional_number("expect", "tolerance", expectation.tolerance, path);
    const bool bounds = expectation.minimum || expectation.maximum;
    if (bounds && (expectation.value || expectation.tolerance)) {
      add(path, "has bounds and a value, expected min, max or both, or value with tolerance");
    } else if (!bounds && !expectation.value) {
      add(path, "has nothing to compare with, expected min, max or both, or value with tolerance");
    } else if (expectation.value && !expectation.tolerance) {
      add(path + ".tolerance", "is missing, expected " + expected(key("expect", "tolerance")) + " beside value");
    }
    if (expectation.minimum && expectation.maximum && *expectation.minimum > *expectation.maximum) {
      add(path + ".max", fmt::format("is {}, expected at least min = {}", *expectation.maximum, *expectation.minimum));
    }
  }

  std::vector<Problem> problems;

 private:
  void add(const std::string& path, const std::string& message) { problems.push_back({path, message}); }

  bool number(const Key& key, double value, const std::string& path) {
    const Range& range = key.range;
    const bool inside = std::isfinite(value) && value <= range.maximum &&
                        (range.above_minimum ? value > range.minimum : value >= range.minimum);
    const std::string wanted = std::isfinite(value) ? expected(key) : "a finite number";
    if (!inside) add(path + "." + key.name, fmt::format("is {}, expected {}", value, wanted));
    return inside;
  }

  void optional_number(const char* table, const char* name, const std::optional<double>& value,
                       const std::string& path) {
    if (value) number(key(table, name), *value, path);
  }

  void time(const char* table, double at, const std::string& path) {
    if (!number(key(table, "at"), at, path)) return;
    if (at > run_.duration * (1 + 1e-9)) {
      add(path + ".at", fmt::format("is {} s, expected at most run.duration = {} s", at, run_.duration));
    }
  }

  const Scene& scene_;
  const RunSettings& run_;
};

}  // namespace

std::vector<Problem> check_requests(const SceneFile& file) {
  RequestCheck check(file.scene);
  for (std::size_t i = 0; i < file.outputs.size(); ++i) check.output(file.outputs[i], fmt::format("output[{}]", i));
  for (std::size_t i = 0; i < file.events.size(); ++i) {
    check.event(file.events[i], file.events, fmt::format("event[{}]", i));
  }
  for (std::size_t i = 0; i < file.expectations.size(); ++i) {
    check.expectation(file.expectations[i], fmt::format("expect[{}]", i));
  }
  return std::move(check.problems);
}

}  // namespace ballpark::scenes
