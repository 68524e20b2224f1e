#include "perf/cost/draw/canvas.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

namespace ballpark::cost::draw {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= ' ' || c == '\t' || c == '\n') out += c;
    }
  }
  return out;
}

std::string coordinate(double x) {
  if (!std::isfinite(x)) return "0";
  std::string text = fmt::format("{:.2f}", x);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

double text_width(std::string_view text, double size) {
  constexpr std::string_view narrow = " .,:;|!'()[]ijltfrI", wide = "mwMW%@";
  double ems = 0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) continue;  // goes on with a character of UTF-8
    if (narrow.find(c) != std::string_view::npos) {
      ems += 0.36;
    } else if (wide.find(c) != std::string_view::npos) {
      ems += 0.95;
    } else {
      ems += c >= 'A' && c <= 'Z' ? 0.7 : 0.6;
    }
  }
  return ems * size;
}

std::vector<std::string> lines_of(const std::string& text, double size, double width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (lines.empty() || text_width(lines.back() + " " + word, size) > width) {
      lines.push_back(word);
    } else {
      lines.back() += " " + word;
    }
  }
  return lines;
}

void Canvas::line(Spot from, Spot to, const std::string& attributes) {
  text_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", coordinate(from.x), coordinate(from.y),
                       coordinate(to.x), coordinate(to.y), attributes);
}

void Canvas::points(const char* element, const std::vector<Spot>& spots, const std::string& attributes) {
  text_ += fmt::format("<{} points=\"", element);
  for (const Spot& spot : spots) {
    if (&spot != &spots.front()) text_ += ' ';
    text_ += coordinate(spot.x) + "," + coordinate(spot.y);
  }
  text_ += "\" " + attributes + "/>\n";
}

void Canvas::box(const Box& b, const std::string& attributes) {
  text_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", coordinate(b.left),
                       coordinate(b.top), coordinate(b.width()), coordinate(b.height()), attributes);
}

void Canvas::circle(Spot centre, double radius, const std::string& attributes) {
  text_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", coordinate(centre.x), coordinate(centre.y),
                       coordinate(radius), attributes);
}

void Canvas::text(Spot at, std::string_view words, double size, const std::string& attributes) {
  text_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" {}>{}</text>\n", coordinate(at.x), coordinate(at.y),
                       coordinate(size), attributes, escaped(words));
}

void Canvas::power(Spot at, std::string_view base, std::string_view exponent, double size,
                   const std::string& attributes) {
  text_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" {}>{}", coordinate(at.x), coordinate(at.y),
                       coordinate(size), attributes, escaped(base));
  if (!exponent.empty()) {
    text_ += fmt::format("<tspan dy=\"{}\" font-size=\"{}\">{}</tspan>", coordinate(-0.4 * size),
                         coordinate(0.72 * size), escaped(exponent));
  }
  text_ += "</text>\n";
}

}  // namespace ballpark::cost::draw
