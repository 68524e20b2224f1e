#include "scenarios/command/deliver.h"

#include "scenarios/command/terminal.h"

namespace ballpark::command {

Delivery::Delivery(const Arguments& arguments) : quiet_(arguments.quiet), json_(arguments.json.has_value()) {
  if (json_ && !arguments.json->empty()) file_.emplace(*arguments.json);
}

void Delivery::text(const std::string& text) const {
  if (wants_text()) print(text);
}

void Delivery::json(const std::string& json) {
  const std::string whole = json.ends_with("\n") ? json : json + "\n";
  if (!json_) return;
  if (!file_) return print(whole);
  file_->write(whole);
  file_->commit();
}

}  // namespace ballpark::command
