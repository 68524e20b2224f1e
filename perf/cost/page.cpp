#include "perf/cost/page.h"

#include <string_view>

#include "perf/cost/draw/canvas.h"
#include "perf/cost/draw/html.h"

namespace ballpark::cost {

// Made from the files of perf/cost/figure when the program is built.
namespace figure {
extern const std::string_view template_html, figure_css, figure_bundle_js;
}  // namespace figure

std::string page(const std::string& json, const std::string& title) {
  const std::string heading = draw::escaped(title), data = draw::inert(json);
  return draw::filled(figure::template_html, {{"@TITLE@", heading},
                                              {"@STYLE@", figure::figure_css},
                                              {"@RESULT@", data},
                                              {"@SCRIPT@", figure::figure_bundle_js}});
}

}  // namespace ballpark::cost
