// How the rows of the key table are written down: what a key is, and where its value goes.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ballpark/catalogue.h"
#include "scenarios/files/keys.h"

namespace ballpark::scenes {

class Row {
 public:
  Row(std::string name, KeyType type, std::string unit, Key::Store store, std::string help) {
    describe(std::move(name), type, std::move(help));
    key_.unit = std::move(unit);
    key_.store = std::move(store);
  }
  /// A table; `open` takes the object around it and returns the one that the table fills.
  template <class Around, class Inner>
  Row(std::string name, KeyType type, Inner* (*open)(Around&), std::string help) {
    describe(std::move(name), type, std::move(help));
    key_.open = [open](const Owner& owner, const std::string&) -> Owner { return open(*std::get<Around*>(owner)); };
  }
  template <class Around, class Inner>
  Row(std::string name, Inner* (*open)(Around&, const std::string&), std::string help) {
    describe(std::move(name), KeyType::named, std::move(help));
    key_.open = [open](const Owner& owner, const std::string& inner) -> Owner {
      return open(*std::get<Around*>(owner), inner);
    };
  }

  Row& in(const Range& range) { return key_.range = range, *this; }
  Row& one_of(std::vector<std::string> choices) { return key_.choices = std::move(choices), *this; }
  Row& otherwise(std::string fallback) { return key_.fallback = std::move(fallback), *this; }
  Row& must() { return key_.required = true, *this; }
  Row& of_effect(std::string kind) { return key_.effect = std::move(kind), *this; }

  Key in_table(const std::string& table) const {
    Key key = key_;
    key.table = table;
    return key;
  }

 private:
  void describe(std::string name, KeyType type, std::string help) {
    key_.name = std::move(name);
    key_.type = type;
    key_.help = std::move(help);
  }

  Key key_;
};

using Rows = std::vector<Row>;

/// Into that member of the object that the table fills.
template <class Object, class Member>
Key::Store into(Member Object::*member) {
  return [member](const Owner& owner, Parsed&& value) {
    std::get<Object*>(owner)->*member = std::get<Member>(std::move(value));
  };
}

template <class Member>
Key::Store into_bodies(Member BodyGroup::*member) {
  return into<BodyDraft, Member>(member);
}

template <class Object>
Key::Store into_optional(std::optional<double> Object::*member) {
  return [member](const Owner& owner, const Parsed& value) {
    std::get<Object*>(owner)->*member = std::get<double>(value);
  };
}

/// A whole number, cut to what an int holds.
template <class Object>
Key::Store into_int(int Object::*member) {
  return [member](const Owner& owner, const Parsed& value) {
    constexpr std::uint64_t most = std::numeric_limits<int>::max();
    std::get<Object*>(owner)->*member = static_cast<int>(std::min(std::get<std::uint64_t>(value), most));
  };
}

/// contact_keys.cpp: materials, boundaries and contacts, with the tables that they stand in.
struct TableRows {
  std::string table;
  Rows rows;
};
std::vector<TableRows> contact_tables();
Rows contact_top_rows();
/// stress_keys.cpp: what makes a scene a hard case.
std::vector<TableRows> stress_tables();
Rows stress_top_rows();

Key::Store on_draft(void (*action)(Draft&, std::string));

/// The key of an effect's parameter, from the catalogue.
Row parameter_row(const std::string& effect, const ParameterInfo& parameter);

template <class List>
std::vector<std::string> names_of(const List& list) {
  std::vector<std::string> names;
  for (const auto& item : list) names.push_back(item.name);
  return names;
}

}  // namespace ballpark::scenes
