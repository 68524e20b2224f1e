#include "engine/store/columns.h"

namespace ballpark::BALLPARK_PRECISION {

Column& Columns::add(ColumnInfo info, std::size_t first_row, std::size_t rows) {
  return columns_.emplace_back(std::move(info), first_row, rows);
}

const Column* Columns::find(const std::string& name, std::size_t row) const {
  for (const Column& column : columns_) {
    if (column.info.name == name && column.covers(row)) return &column;
  }
  return nullptr;
}

Column* Columns::find(const std::string& name, std::size_t row) {
  return const_cast<Column*>(static_cast<const Columns*>(this)->find(name, row));
}

std::size_t Columns::bytes() const {
  std::size_t sum = 0;
  for (const Column& column : columns_) sum += column.bytes();
  return sum;
}

const char* name(Role role) {
  switch (role) {
    case Role::state:
      return "state";
    case Role::kept:
      return "kept";
    case Role::rate:
      return "rate";
    case Role::sum:
      return "sum";
    case Role::constant:
      return "constant";
  }
  return "";
}

}  // namespace ballpark::BALLPARK_PRECISION
