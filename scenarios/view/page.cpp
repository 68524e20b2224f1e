#include "scenarios/view/page.h"

#include <fmt/format.h>

#include <string_view>

#include "perf/cost/draw/canvas.h"
#include "perf/cost/draw/html.h"

namespace ballpark::view {

// Made from the files of scenarios/view/page when the program is built.
namespace files {
extern const std::string_view template_html, view_css, view_bundle_js;
}  // namespace files

std::string page(const std::string& title, const std::vector<Encoded>& runs) {
  std::string headers = "[", data;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    headers += (k > 0 ? ",\n" : "") + runs[k].header;
    data += fmt::format("<script type=\"text/plain\" id=\"data-{}\">{}</script>\n", k, runs[k].data);
  }
  const std::string heading = cost::draw::escaped(title), safe = cost::draw::inert(headers + "]");
  return cost::draw::filled(files::template_html, {{"{{title}}", heading},
                                                   {"{{css}}", files::view_css},
                                                   {"{{runs}}", safe},
                                                   {"{{data}}", data},
                                                   {"{{bundle}}", files::view_bundle_js}});
}

std::size_t page_size(const std::string& title) {
  return page(title, {}).size();
}

}  // namespace ballpark::view
