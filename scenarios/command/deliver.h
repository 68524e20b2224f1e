// A command's result: text to standard output, and JSON where --json wants it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "scenarios/command/arguments.h"
#include "scenarios/command/output_file.h"

namespace ballpark::command {

using Json = nlohmann::ordered_json;

/// Where a command's result goes. Built before anything is done, so that a bad --json file is known at once.
class Delivery {
 public:
  explicit Delivery(const Arguments& arguments);
  /// Text unless JSON takes its place on standard output, or --quiet.
  bool wants_text() const { return !quiet_ && !(json_ && !file_); }
  bool wants_json() const { return json_; }
  void text(const std::string& text) const;
  void json(const std::string& json);

 private:
  bool quiet_, json_;
  std::optional<OutputFile> file_;
};

}  // namespace ballpark::command
