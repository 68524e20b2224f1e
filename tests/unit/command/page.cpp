#include "scenarios/command/page.h"

#include <sstream>
#include <string>

#include "scenarios/command/text.h"
#include "tests/catch.h"

using namespace ballpark::command;

namespace {

constexpr Column::Align right = Column::Align::right, wrap = Column::Align::wrap;

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, width(line));
  return widest;
}

}  // namespace

TEST_CASE("tables align their columns and end no line in spaces", "[command]") {
  Page page(80, false);
  page.table({{{"name"}, {"n", right}, {"doc", wrap}}, {{"a", "1", "first"}, {"long", "1000", ""}}});
  CHECK(page.text() ==
        "  name     n  doc\n"
        "  a        1  first\n"
        "  long  1000\n");
}

TEST_CASE("a wrapping column gives way so that the page holds the table", "[command]") {
  const std::string doc = "a sentence that is much longer than what is left of the line after the name";
  Page page(40, false);
  page.table({{{""}, {"", wrap}}, {{"name", doc.c_str()}, {"x", "short"}}});
  CHECK(widest_line(page.text()) <= 40);
  CHECK(page.text().find("  name  a sentence that is much longer\n        than") == 0);
  CHECK(page.text().find("\n  x     short\n") != std::string::npos);
}

TEST_CASE("a table that cannot shrink is left whole", "[command]") {
  Page page(10, false);
  page.table({{{""}, {""}}, {{"0123456789", "0123456789"}}});
  CHECK(page.text() == "  0123456789  0123456789\n");
}

TEST_CASE("a table without headings has no heading line", "[command]") {
  Page page(80, false);
  page.fields({{"bodies", "3"}, {"steps", "10"}});
  CHECK(page.text() == "  bodies  3\n  steps   10\n");
}

TEST_CASE("colour changes no alignment and is absent when it is off", "[command]") {
  const Table table{{{"verdict"}, {"quantity"}}, {{Cell("met", Style::good), "x"}, {Cell("MISSED", Style::bad), "y"}}};
  Page plain(80, false), coloured(80, true);
  plain.table(table);
  coloured.table(table);
  CHECK(plain.text().find('\033') == std::string::npos);
  std::string stripped = coloured.text();
  REQUIRE(stripped.find('\033') != std::string::npos);
  for (std::size_t at; (at = stripped.find('\033')) != std::string::npos;) {
    stripped.erase(at, stripped.find('m', at) + 1 - at);
  }
  CHECK(stripped == plain.text());
}

TEST_CASE("headings stand apart from what is above them", "[command]") {
  Page page(80, false);
  page.heading("one");
  page.paragraph("text");
  page.heading("two");
  CHECK(page.text() == "one\n  text\n\ntwo\n");
}

TEST_CASE("a line that is too long goes on under its last column", "[command]") {
  Page page(40, false);
  page.aligned_line("");
  page.aligned_line("  kept  as it is   x");
  page.aligned_line("  name   a text that is longer than the page is wide");
  page.aligned_line("  prose that is longer than the page is wide");
  CHECK(page.text() ==
        "\n"
        "    kept  as it is   x\n"
        "    name   a text that is longer than\n"
        "           the page is wide\n"
        "    prose that is longer than the page\n"
        "    is wide\n");
}
