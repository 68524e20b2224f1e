#include "engine/store/columns.h"

#include <cstdint>
#include <utility>

#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;

namespace {

bool on_a_cache_line(const void* p) {
  return reinterpret_cast<std::uintptr_t>(p) % ballpark::cache_line == 0;
}

}  // namespace

TEST_CASE("Columns: rows are padded to whole vectors", "[store]") {
  CHECK(padded(0) == 0);
  CHECK(padded(1) == row_alignment);
  CHECK(padded(row_alignment) == row_alignment);
  CHECK(padded(row_alignment + 1) == 2 * row_alignment);
  CHECK(row_alignment * sizeof(float) % ballpark::cache_line == 0);
}

TEST_CASE("Columns: components are arrays of their own, zero at first, on cache lines", "[store]") {
  Columns columns;
  Column& column = columns.add({"position", "m", 3, Role::state, "test"}, 32, 48);
  for (int c = 0; c < 3; ++c) {
    CHECK(on_a_cache_line(column.at(c, 32)));
    for (std::size_t row = 32; row < 80; ++row) CHECK(*column.at(c, row) == 0);
  }
  *column.at(1, 40) = 7;
  CHECK(column.at(1, 32)[8] == 7);
  CHECK(*column.at(0, 40) == 0);
  CHECK(std::as_const(column).at(1, 40) == column.at(1, 40));
}

TEST_CASE("Columns: cover their rows and count their bytes", "[store]") {
  Columns columns;
  const Column& column = columns.add({"mass", "kg", 1, Role::constant, "test"}, 16, 16);
  CHECK_FALSE(column.covers(15));
  CHECK(column.covers(16));
  CHECK(column.covers(31));
  CHECK_FALSE(column.covers(32));
  columns.add({"velocity", "m/s", 3, Role::state, "test"}, 0, 32);
  CHECK(column.bytes() == 16 * sizeof(Real));
  CHECK(columns.bytes() == (16 + 3 * 32) * sizeof(Real));
}

TEST_CASE("Columns: are found by name and row, and stay where they are", "[store]") {
  Columns columns;
  const Column& first = columns.add({"mass", "kg", 1, Role::constant, "test"}, 0, 16);
  const Real* place = first.at(0, 0);
  const Column& second = columns.add({"mass", "kg", 1, Role::constant, "test"}, 16, 16);
  for (std::size_t i = 0; i < 100; ++i) columns.add({"more", "1", 1, Role::rate, "test"}, 32 + i, 1);
  CHECK(columns.find("mass", 3) == &first);
  CHECK(columns.find("mass", 16) == &second);
  CHECK(columns.find("mass", 32) == nullptr);
  CHECK(columns.find("radius", 3) == nullptr);
  CHECK(first.at(0, 0) == place);
  CHECK(columns.all().size() == 102);
}

TEST_CASE("Columns: an empty one is no trouble", "[store]") {
  Columns columns;
  const Column& column = columns.add({"position", "m", 3, Role::state, "test"}, 0, 0);
  CHECK(column.bytes() == 0);
  CHECK_FALSE(column.covers(0));
}

TEST_CASE("Columns: roles have names", "[store]") {
  CHECK(std::string(name(Role::state)) == "state");
  CHECK(std::string(name(Role::rate)) == "rate");
  CHECK(std::string(name(Role::sum)) == "sum");
  CHECK(std::string(name(Role::constant)) == "constant");
}
