#include "scenarios/command/page.h"

#include <algorithm>
#include <numeric>

#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

constexpr std::size_t indent = 2, gap = 2, narrowest = 14;

/// Natural widths, then wrapping columns give way, the widest first, until the page holds them.
std::vector<std::size_t> column_widths(const Table& table, std::size_t page_width) {
  std::vector<std::size_t> widths;
  for (const Column& column : table.columns) widths.push_back(width(column.heading));
  for (const auto& cells : table.rows) {
    for (std::size_t c = 0; c < cells.size(); ++c) widths[c] = std::max(widths[c], width(cells[c].text));
  }
  const auto total = [&] { return std::accumulate(widths.begin(), widths.end(), indent + gap * (widths.size() - 1)); };
  while (total() > page_width) {
    std::size_t* widest = nullptr;
    for (std::size_t c = 0; c < widths.size(); ++c) {
      const bool gives = table.columns[c].align == Column::Align::wrap && widths[c] > narrowest;
      if (gives && (!widest || widths[c] > *widest)) widest = &widths[c];
    }
    if (!widest) break;
    --*widest;
  }
  return widths;
}

const char* code(Style style) {
  switch (style) {
    case Style::plain:
      break;
    case Style::strong:
      return "\033[1m";
    case Style::faint:
      return "\033[2m";
    case Style::good:
      return "\033[32m";
    case Style::bad:
      return "\033[1;31m";
  }
  return "";
}

}  // namespace

std::string Page::painted(const std::string& text, Style style) const {
  if (!colour_ || style == Style::plain || text.empty()) return text;
  return code(style) + text + "\033[0m";
}

void Page::blank() {
  text_ += '\n';
}

void Page::heading(const std::string& text) {
  if (!text_.empty()) blank();
  line(text, Style::strong);
}

void Page::line(const std::string& text, Style style) {
  text_ += painted(text, style) + '\n';
}

void Page::paragraph(const std::string& text, std::size_t paragraph_indent) {
  for (const std::string& each : wrapped(text, width_ - paragraph_indent)) {
    text_ += std::string(paragraph_indent, ' ') + each + '\n';
  }
}

void Page::aligned_line(const std::string& text, std::size_t line_indent) {
  const std::size_t start = std::min(text.find_first_not_of(' '), text.size());
  const std::size_t apart = text.rfind("  ");
  const std::size_t column = apart == std::string::npos || apart < start ? start : apart + 2;
  const bool fits = width(text) + line_indent <= width_ || column + line_indent + narrowest > width_;
  std::string before = std::string(text.empty() ? 0 : line_indent, ' ') + text.substr(0, column);
  const std::string rest = text.substr(column);
  for (const std::string& part : fits ? std::vector{rest} : wrapped(rest, width_ - line_indent - column)) {
    text_ += before + part + '\n';
    before.assign(line_indent + column, ' ');
  }
}

void Page::list(const std::vector<std::string>& items) {
  Table table{{{"", Column::Align::left}, {"", Column::Align::wrap}}, {}};
  for (const std::string& item : items) table.rows.push_back({"-", item});
  this->table(table);
}

void Page::fields(std::vector<std::pair<std::string, Cell>> pairs) {
  Table table{{{"", Column::Align::left}, {"", Column::Align::wrap}}, {}};
  for (auto& [label, value] : pairs) table.rows.push_back({Cell(std::move(label)), std::move(value)});
  this->table(table);
}

void Page::table(const Table& table) {
  const std::vector<std::size_t> widths = column_widths(table, width_);
  std::vector<Cell> headings;
  bool any_heading = false;
  for (const Column& column : table.columns) {
    headings.emplace_back(column.heading, Style::faint);
    any_heading |= !column.heading.empty();
  }
  if (any_heading) row(table.columns, headings, widths);
  for (const auto& cells : table.rows) row(table.columns, cells, widths);
}

void Page::row(const std::vector<Column>& columns, const std::vector<Cell>& cells,
               const std::vector<std::size_t>& widths) {
  std::vector<std::vector<std::string>> lines;
  std::size_t height = 1;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const bool fits = width(cells[c].text) <= widths[c] && cells[c].text.find('\n') == std::string::npos;
    lines.push_back(fits ? std::vector<std::string>{cells[c].text} : wrapped(cells[c].text, widths[c]));
    height = std::max(height, lines.back().size());
  }
  for (std::size_t l = 0; l < height; ++l) {
    std::size_t pending = indent;  // spaces are written only before something: no line ends in them
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const std::string part = l < lines[c].size() ? lines[c][l] : "";
      const std::size_t spare = widths[c] - std::min(widths[c], width(part));
      const bool right = columns[c].align == Column::Align::right;
      if (right) pending += spare;
      if (!part.empty()) {
        text_ += std::string(pending, ' ') + painted(part, cells[c].style);
        pending = 0;
      }
      pending += gap + (right ? 0 : spare);
    }
    text_ += '\n';
  }
}

}  // namespace ballpark::command
