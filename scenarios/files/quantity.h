// What an expectation measures or an event follows: a column of one body, or a number of the run's JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/files/report_json.h"

namespace ballpark::scenes {

class Quantity {
 public:
  explicit Quantity(const std::string& path);

  bool reads_report() const { return !is_state_; }
  /// "" if the world and the run's JSON have it, else what is wrong with it.
  std::string problem(const World& world, const Json& report) const;
  /// The same of what must be a body's.
  std::string state_problem(const World& world) const;
  /// Of the world as it is; not for quantities of the report.
  double measured(const World& world) const;
  /// NaN where the report has null, or no such time of an event.
  double measured(const Json& report) const;

  /// Not for quantities of the report.
  std::size_t body() const { return *id_; }
  double (*column() const)(const BodyState&);

 private:
  std::string report_problem(const Json& report) const;

  std::vector<std::string> segments_;
  bool is_state_ = false;
  std::optional<std::size_t> id_;
};

}  // namespace ballpark::scenes
