#include "scenarios/command/text.h"

#include <cmath>
#include <string>
#include <vector>

#include "tests/catch.h"

using namespace ballpark::command;

TEST_CASE("numbers are written as people read them", "[command]") {
  CHECK(grouped(0) == "0");
  CHECK(grouped(999) == "999");
  CHECK(grouped(1000) == "1,000");
  CHECK(grouped(1234567890) == "1,234,567,890");
  CHECK(counted(1, "body", "bodies") == "1 body");
  CHECK(counted(0, "body", "bodies") == "0 bodies");
  CHECK(number(1.0 / 3, 3) == "0.333");
  CHECK(number(-std::nan(""), 3) == "nan");
}

TEST_CASE("a quantity takes the largest unit that it reaches", "[command]") {
  CHECK(seconds(0) == "0 s");
  CHECK(seconds(1.234e-9) == "1.23 ns");
  CHECK(seconds(0.0125) == "12.5 ms");
  CHECK(seconds(0.99996) == "1 s");  // not "1e+03 ms"
  CHECK(seconds(125) == "2 min 5 s");
  CHECK(bytes(96) == "96 B");
  CHECK(bytes(48e6) == "48 MB");
  CHECK(bytes(999.8e6) == "1 GB");
  CHECK(rate(1234) == "1.23e+03");
  CHECK(rate(12.34e6) == "12.3 million");
  CHECK(rate(5e9) == "5 billion");
}

TEST_CASE("text wraps between words, and inside a word only if it is longer than a line", "[command]") {
  using Lines = std::vector<std::string>;
  CHECK(wrapped("", 10) == Lines{""});
  CHECK(wrapped("one two three", 7) == Lines{"one two", "three"});
  CHECK(wrapped("one  two\nthree", 80) == Lines{"one two three"});
  CHECK(wrapped("a bcdefghij k", 4) == Lines{"a", "bcde", "fghi", "j k"});
}

TEST_CASE("widths count characters, not bytes", "[command]") {
  CHECK(width("kg") == 2);
  CHECK(width("\u00b5s") == 2);
  CHECK(wrapped("\u00e4\u00e4\u00e4\u00e4", 2) == std::vector<std::string>{"\u00e4\u00e4", "\u00e4\u00e4"});
}

TEST_CASE("a wrong name is answered with the nearest one and with all", "[command]") {
  const std::string message = no_such("integrator", "rk5", {"euler", "rk4"});
  CHECK(message == "no integrator 'rk5'; did you mean 'rk4'? (euler, rk4)");
  CHECK(no_such("integrator", "bicycle", {"euler", "rk4"}) == "no integrator 'bicycle' (euler, rk4)");
}
