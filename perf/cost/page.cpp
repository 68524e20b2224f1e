#include "perf/cost/page.h"

#include <array>
#include <string_view>
#include <utility>

#include "perf/cost/draw/canvas.h"

namespace ballpark::cost {

// Made from the files of perf/cost/figure when the program is built.
namespace figure {
extern const std::string_view template_html, figure_css, figure_bundle_js;
}  // namespace figure

namespace {

/// JSON that holds no "<": nothing in it can end a script element or begin a comment. In JSON a "<" stands in strings
/// alone, where its escape is the same.
std::string inert(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

std::string page(const std::string& json, const std::string& title) {
  const std::string heading = draw::escaped(title), data = inert(json);
  const std::array<std::pair<std::string_view, std::string_view>, 4> parts{{{"@TITLE@", heading},
                                                                            {"@STYLE@", figure::figure_css},
                                                                            {"@RESULT@", data},
                                                                            {"@SCRIPT@", figure::figure_bundle_js}}};
  // In the order of the template, so that what is put in is never searched.
  std::string_view rest = figure::template_html;
  std::string out;
  for (const auto& [mark, text] : parts) {
    const std::size_t at = rest.find(mark);
    if (at == std::string_view::npos) continue;
    out += rest.substr(0, at);
    out += text;
    rest.remove_prefix(at + mark.size());
  }
  out += rest;
  return out;
}

}  // namespace ballpark::cost
