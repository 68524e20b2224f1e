#include "perf/cost/svg.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "perf/cost/page.h"
#include "tests/catch.h"

using namespace ballpark;
using namespace ballpark::cost;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Curves of orders 1 to `orders`, in both precisions, of eight points each.
Result sample(int orders = 8) {
  Result r;
  r.scenario = "a<b>&\"c\"";
  r.doc = "</text><script>alert(1)</script>";
  r.measure = "largest position error along the path";
  r.measure_unit = "m";
  r.reference = {"closed form", "exact", {1e-14, 0, 0, 0}, {1, 1, 0, 0}};
  r.floor = 1e-13;
  for (int curve = 0; curve < 2 * orders; ++curve) {
    const int order = curve / 2 + 1;
    const bool single = curve % 2 == 1;
    const std::string name = "order_" + std::to_string(order);
    const Precision precision = single ? Precision::single_ : Precision::double_;
    r.curves.push_back({name + (single ? ", single" : ""), name, "family", order, precision, {}});
    for (int k = 0; k < 8; ++k) {
      Point point;
      point.setting = {name, 0.1 / std::pow(2, k), 0, precision};
      point.curve = static_cast<std::size_t>(curve);
      point.error = std::pow(point.setting.step, order) + (single ? 1e-7 : 1e-15);
      point.claimed = point.error > r.floor;
      const double seconds = 1e-6 * (order + 1) / point.setting.step;
      point.seconds = {seconds, seconds, seconds, 9};
      r.curves.back().points.push_back(r.points.size());
      r.points.push_back(point);
    }
  }
  for (Point& p : r.points) {
    p.front = p.claimed && std::none_of(r.points.begin(), r.points.end(), [&](const Point& q) {
                return q.claimed && q.error < p.error && q.seconds.minimum <= p.seconds.minimum;
              });
  }
  return r;
}

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++n;
  return n;
}

/// Every tag that opens is closed, in order, and each & begins an entity.
bool well_formed(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos || text.substr(at + 1, end - at - 1).find('<') != std::string::npos) return false;
    const bool closes = text[at + 1] == '/';
    const std::size_t first = at + (closes ? 2 : 1);
    const std::string name = text.substr(first, text.find_first_of(" />", first) - first);
    if (closes) {
      if (open.empty() || open.back() != name) return false;
      open.pop_back();
    } else if (text[end - 1] != '/') {
      open.push_back(name);
    }
  }
  for (std::size_t at = text.find('&'); at != std::string::npos; at = text.find('&', at + 1)) {
    if (text.find(';', at) > at + 6) return false;
  }
  return open.empty();
}

void check_sound(const std::string& picture) {
  CHECK(well_formed(picture));
  CHECK(picture.find("nan") == std::string::npos);
  CHECK(picture.find("inf") == std::string::npos);
  CHECK(picture.find("<script") == std::string::npos);
}

}  // namespace

TEST_CASE("the figure names every curve and escapes what it is told", "[cost]") {
  const Result r = sample();
  const std::string picture = svg(r);
  check_sound(picture);
  for (const Curve& curve : r.curves) CHECK(picture.find(">" + curve.label + "</text>") != std::string::npos);
  CHECK(picture.find("a&lt;b&gt;&amp;&quot;c&quot;") != std::string::npos);
  CHECK(picture.find("no error below 1e-13 m is claimed") != std::string::npos);
  CHECK(occurrences(picture, "class=\"front\"") == 1);
  CHECK(occurrences(picture, "class=\"floor\"") == 1);
}

TEST_CASE("48 curves have their names too", "[cost]") {
  const Result r = sample(24);
  const std::string picture = svg(r);
  check_sound(picture);
  for (const Curve& curve : r.curves) CHECK(picture.find(curve.label + "</text>") != std::string::npos);
}

TEST_CASE("the recommended point and the scene's own have their marks, if there are any", "[cost]") {
  Result r = sample();
  CHECK(svg(r).find("recommended") == std::string::npos);
  CHECK(svg(r).find("class=\"own\"") == std::string::npos);
  r.recommended = Recommendation{50, 1e-6, 2, 1e-7, "take it"};
  r.scene_setting = r.points[3].setting;
  const std::string picture = svg(r);
  check_sound(picture);
  CHECK(picture.find("class=\"recommended\"") != std::string::npos);
  CHECK(picture.find("recommended: order_4, step 0.025 s") != std::string::npos);
  CHECK(picture.find("as the scene has it: order_1, step 0.0125 s") != std::string::npos);
}

TEST_CASE("points in trouble or without numbers are not drawn", "[cost]") {
  Result r = sample(1);
  const std::size_t all = occurrences(svg(r), "<circle");
  r.points[0].trouble = "a step that is too large";
  r.points[1].error = std::nan("");
  r.points[2].error = infinity;
  r.points[4].seconds.minimum = 0;
  const std::string picture = svg(r);
  check_sound(picture);
  CHECK(occurrences(picture, "<circle") == all - 4);
}

TEST_CASE("no points, one, equal errors and errors of zero make a figure", "[cost]") {
  check_sound(svg(Result{}));
  Result r = sample(2);
  r.floor = 0;
  for (Point& point : r.points) point.error = 1e-3;
  check_sound(svg(r));
  for (Point& point : r.points) point.error = 0;
  check_sound(svg(r));
  CHECK(svg(r).find(">order_2</text>") != std::string::npos);
  for (Point& point : r.points) point.trouble = "none";
  r.points[0].trouble = "";
  check_sound(svg(r));
  r.floor = infinity;
  r.reference.error_bar[0] = r.reference.scale[0] = std::nan("");
  r.points[0].error = 1e300;
  check_sound(svg(r));
}

TEST_CASE("paths that rest, run away or are no numbers leave the figure sound", "[cost]") {
  Result r = sample(2);
  const double nan = std::nan("");
  r.paths = {{"reference", 0, {{0, 0, 0, 0}, {1, 1, 1, 0}}},
             {"order_1, step <0.1> s", 0, {{0, 0, 0, 0}, {1, 1e300, 1, 0}, {2, nan, 0, 0}, {3, infinity, 0, 0}}}};
  check_sound(svg(r));
  CHECK(svg(r).find("order_1, step &lt;0.1&gt; s") != std::string::npos);
  r.paths = {{"reference", 0, {{0, 1, 1, 1}}}, {"empty", 1, {}}};
  check_sound(svg(r));
  r.paths = {{"falls", 0, {{0, 0, 0, 2}, {1, 0, 0, 1}, {2, 0, 0, 0}}}};
  check_sound(svg(r));
  CHECK(svg(r).find(">t [s]</text>") != std::string::npos);
}

TEST_CASE("nothing in the data breaks out of the page", "[cost]") {
  const std::string json = R"({"doc":"</script><script>alert(1)</script><!--<script>","scenario":"@SCRIPT@ @TITLE@"})";
  const std::string plain = page("{}", "t"), html = page(json, "</title><script>alert(2)</script>");
  CHECK(occurrences(html, "<script") == occurrences(plain, "<script"));
  CHECK(occurrences(html, "</script") == occurrences(plain, "</script"));
  CHECK(html.find("\\u003c/script>\\u003cscript>alert(1)") != std::string::npos);
  CHECK(html.find("<title>&lt;/title&gt;&lt;script&gt;") != std::string::npos);
  CHECK(html.find("@SCRIPT@ @TITLE@") != std::string::npos);
}

TEST_CASE("the page is whole and asks no network for anything", "[cost]") {
  const std::string html = page("{}", "title");
  CHECK(occurrences(html, "<script") == 2);
  CHECK(occurrences(html, "</script>") == 2);
  for (const char* mark : {"@TITLE@", "@STYLE@", "@RESULT@", "@SCRIPT@"}) CHECK(html.find(mark) == std::string::npos);
  CHECK(html.find("default-src 'none'") != std::string::npos);
  for (const char* outside : {" src=", "<link", "@import"}) CHECK(html.find(outside) == std::string::npos);
  CHECK(html.size() > 100000);
}
