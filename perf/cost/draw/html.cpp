#include "perf/cost/draw/html.h"

namespace ballpark::cost::draw {

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

std::string filled(std::string_view page_template,
                   std::initializer_list<std::pair<std::string_view, std::string_view>> parts) {
  std::string_view rest = page_template;
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

}  // namespace ballpark::cost::draw
