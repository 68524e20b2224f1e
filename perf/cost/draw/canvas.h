// SVG being written: numbers that a viewer can read, text that cannot break out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ballpark::cost::draw {

struct Spot {
  double x = 0, y = 0;
};

struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

/// With &, <, > and quotes as entities; characters that XML does not know are left out.
std::string escaped(std::string_view text);
/// At most two decimals; 0 if x is not finite.
std::string coordinate(double x);
/// How wide a common sans-serif sets it, rather more than less.
double text_width(std::string_view text, double size);
/// Lines of at most `width`, broken between words.
std::vector<std::string> lines_of(const std::string& text, double size, double width);

/// Attributes are written as they are: they hold no foreign text.
class Canvas {
 public:
  void open(const std::string& attributes) { text_ += "<g " + attributes + ">\n"; }
  void close() { text_ += "</g>\n"; }
  void raw(const std::string& text) { text_ += text; }
  void line(Spot from, Spot to, const std::string& attributes);
  void polyline(const std::vector<Spot>& spots, const std::string& attributes) {
    points("polyline", spots, attributes);
  }
  void polygon(const std::vector<Spot>& spots, const std::string& attributes) { points("polygon", spots, attributes); }
  void box(const Box& box, const std::string& attributes);
  void circle(Spot centre, double radius, const std::string& attributes);
  /// `size` also goes into the attributes.
  void text(Spot at, std::string_view words, double size, const std::string& attributes);
  /// A base with its exponent raised.
  void power(Spot at, std::string_view base, std::string_view exponent, double size, const std::string& attributes);
  const std::string& text() const { return text_; }

 private:
  void points(const char* element, const std::vector<Spot>& spots, const std::string& attributes);
  std::string text_;
};

}  // namespace ballpark::cost::draw
