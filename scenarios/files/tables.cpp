#include "scenarios/files/tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenarios/files/keys.h"
#include "scenarios/files/values.h"

namespace ballpark::scenes {

namespace {

class TableReader {
 public:
  explicit TableReader(Findings& findings) : findings_(findings) {}

  /// `name`: in the key table; `path`: in problems, "" or ending with a dot.
  void read(const Table& table, const Place& place, const std::string& name, const std::string& path,
            const Owner& owner) {
    const std::string* kind = name == "effects" ? text_of(table, "kind") : nullptr;
    const std::vector<const Key*> known = keys_of(name, kind ? *kind : "");
    for (const Entry& entry : table) {
      const auto found = std::find_if(known.begin(), known.end(), [&](const Key* k) { return k->name == entry.key; });
      if (found != known.end()) {
        read_key(**found, entry, path, owner);
      } else if (name != "effects" || is_kind(kind)) {
        unknown(entry, path, known);
      }
    }
    for (const Key* key : known) {
      if (key->required && !find(table, key->name)) {
        findings_.add(path + key->name, place, "is missing, expected " + expected(*key));
      }
    }
  }

 private:
  static bool is_kind(const std::string* kind) {
    const std::vector<std::string>& kinds = key("effects", "kind").choices;
    return kind && std::find(kinds.begin(), kinds.end(), *kind) != kinds.end();
  }

  void unknown(const Entry& entry, const std::string& path, const std::vector<const Key*>& known) {
    std::vector<std::string> names;
    for (const Key* key : known) names.push_back(key->name);
    findings_.add(
        path + printable(entry.key), entry.place,
        fmt::format("is an unknown key, expected one of {}{}", fmt::join(names, ", "), hint(entry.key, names)));
  }

  void read_key(const Key& key, const Entry& entry, const std::string& table_path, const Owner& owner) {
    const std::string path = table_path + key.name;
    findings_.mark(path, entry.node);
    if (key.type == KeyType::table) return read_one_table(key, entry.node, path, owner);
    if (key.type == KeyType::tables) return read_each_table(key, entry.node, path, owner);
    if (key.type == KeyType::named) return read_named_tables(key, entry.node, path, owner);
    std::variant<Parsed, Mismatch> value = parsed_value(key, entry.node);
    if (const auto* mismatch = std::get_if<Mismatch>(&value)) {
      findings_.add(path, mismatch->place, mismatch->message);
    } else {
      key.store(owner, std::get<Parsed>(std::move(value)));
    }
  }

  void read_one_table(const Key& key, const Node& node, const std::string& path, const Owner& owner,
                      const std::string& name = "") {
    const auto* table = std::get_if<Table>(&node.value);
    if (!table) return findings_.add(path, node.place, "is " + describe(node) + ", expected " + expected(key));
    findings_.mark(path, node);
    read(*table, node.place, key.path(), path + ".", key.open(owner, name));
  }

  void read_each_table(const Key& key, const Node& node, const std::string& path, const Owner& owner) {
    const auto* array = std::get_if<Array>(&node.value);
    if (!array) return findings_.add(path, node.place, "is " + describe(node) + ", expected " + expected(key));
    for (std::size_t i = 0; i < array->size(); ++i) {
      read_one_table(key, (*array)[i], fmt::format("{}[{}]", path, i), owner);
    }
  }

  void read_named_tables(const Key& key, const Node& node, const std::string& path, const Owner& owner) {
    const auto* table = std::get_if<Table>(&node.value);
    if (!table) return findings_.add(path, node.place, "is " + describe(node) + ", expected " + expected(key));
    for (const Entry& entry : *table) read_one_table(key, entry.node, path + "." + entry.key, owner, entry.key);
  }

  Findings& findings_;
};

}  // namespace

void read_tables(const Node& document, Draft& draft, Findings& findings) {
  TableReader(findings).read(std::get<Table>(document.value), {1, 1}, "", "", &draft);
}

}  // namespace ballpark::scenes
