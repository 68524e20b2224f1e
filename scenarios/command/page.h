// Text for a terminal: headings, paragraphs, aligned fields and tables, within a width, with or without colour.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ballpark::command {

enum class Style { plain, strong, faint, good, bad };

struct Cell {
  std::string text;
  Style style = Style::plain;
  Cell(std::string cell_text, Style cell_style = Style::plain) : text(std::move(cell_text)), style(cell_style) {}
  Cell(const char* cell_text) : text(cell_text) {}
};

struct Column {
  enum class Align { left, right, wrap };  ///< wrap: left, and broken into lines when the page is too narrow
  std::string heading;
  Align align = Align::left;
};

struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as `columns`
};

class Page {
 public:
  Page(std::size_t page_width, bool colour) : width_(page_width), colour_(colour) {}

  void heading(const std::string& text);  ///< after an empty line, unless first
  void line(const std::string& text, Style style = Style::plain);
  void paragraph(const std::string& text, std::size_t indent = 2);
  /// One line, spaces kept; what is too long goes on below, under the last thing that stands apart in it.
  void aligned_line(const std::string& text, std::size_t indent = 2);
  void list(const std::vector<std::string>& items);              ///< "- item" each
  void fields(std::vector<std::pair<std::string, Cell>> pairs);  ///< label and value, aligned
  void table(const Table& table);                                ///< headings are left out if all are empty
  void blank();
  const std::string& text() const { return text_; }

 private:
  std::string painted(const std::string& text, Style style) const;
  void row(const std::vector<Column>& columns, const std::vector<Cell>& cells, const std::vector<std::size_t>& widths);

  std::size_t width_;
  bool colour_;
  std::string text_;
};

}  // namespace ballpark::command
