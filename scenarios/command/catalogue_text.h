// Entries of the catalogue as JSON and as words: `list` and `describe` show the same facts.
#pragma once

#include <string>

#include "ballpark/catalogue.h"
#include "scenarios/command/deliver.h"

namespace ballpark::command {

Json to_json(const EffectDescription& effect);
Json to_json(const IntegratorDescription& integrator);
Json to_json(const NamedDescription& entry);

std::string kind_name(ParameterKind kind);
/// A value as a scene file has it: 1.0, [0.0, 0.0, -9.81], "word".
std::string toml(const Value& value);
/// A table for a scene file that uses the effect with all its parameters.
std::string example(const EffectDescription& effect);
std::string range(const ParameterInfo& parameter);  ///< "at least 0", "0 to 1", "" for any

}  // namespace ballpark::command
