#include "engine/store/columns.h"

#include <algorithm>

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

void Columns::save(Role role, std::vector<Real>& to) const {
  to.clear();
  for (const Column& column : columns_) {
    for (int c = 0; column.info.role == role && c < column.info.components; ++c) {
      const Real* values = column.at(c, column.first_row);
      to.insert(to.end(), values, values + column.rows);
    }
  }
}

void Columns::restore(Role role, const std::vector<Real>& from) {
  const Real* next = from.data();
  for (Column& column : columns_) {
    for (int c = 0; column.info.role == role && c < column.info.components; ++c, next += column.rows) {
      std::copy(next, next + column.rows, column.at(c, column.first_row));
    }
  }
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
