#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "perf/cost/draw/chart.h"

namespace ballpark::cost::draw {

namespace {

constexpr double size = 12;

/// A row of samples, each with its words.
class Row {
 public:
  Row(Canvas& canvas, Spot at) : canvas_(canvas), at_(at) {}
  Spot sample() const { return {at_.x, at_.y - size * 0.35}; }
  void words(const std::string& text, double sample_width) {
    at_.x += sample_width + 7;
    canvas_.text(at_, text, size, fmt::format("fill=\"{}\"", medium));
    at_.x += text_width(text, size) + 12;
  }
  void stroke(const std::string& text, const std::string& attributes) {
    canvas_.line(sample(), {at_.x + 22, sample().y}, attributes);
    words(text, 22);
  }
  void shape(const std::string& text, int order, const std::string& attributes) {
    canvas_.open(attributes);
    canvas_.raw(marker({at_.x + 4, sample().y}, order, 4.2));
    canvas_.close();
    words(text, 6);
  }

 private:
  Canvas& canvas_;
  Spot at_;
};

/// Orders in words, those that share a marker together.
std::string order_text(const std::set<int>& orders, bool first) {
  std::string text = first ? "order " : "";
  for (const int order : orders) text += fmt::format("{}{}", order == *orders.begin() ? "" : ", ", order);
  return text;
}

}  // namespace

void draw_key(Canvas& canvas, const Result& result, Spot at) {
  bool single = false, all_claimed = true, front = false;
  std::set<int> orders, high;
  for (const Curve& curve : result.curves) {
    single = single || curve.precision == Precision::single_;
    if (curve.order > 0) orders.insert(curve.order);
  }
  for (const Point& point : result.points) {
    if (drawable(point)) all_claimed = all_claimed && point.claimed;
    front = front || point.front;
  }
  Row row(canvas, at);
  const std::string solid = fmt::format("stroke=\"{}\" stroke-width=\"2\"", medium);
  const std::string filled = fmt::format("fill=\"{}\"", medium);
  bool first = true;
  for (const int order : orders) {
    if (order > 6) {
      high.insert(order);
      continue;
    }
    row.shape(order_text({order}, first), order, filled);
    first = false;
  }
  if (!high.empty()) row.shape(order_text(high, first), 7, filled);
  if (single) {
    row.stroke("double", solid);
    row.stroke("single", solid + " stroke-dasharray=\"5 3\"");
  }
  if (!all_claimed) row.shape("not claimed", 1, fmt::format("fill=\"#ffffff\" stroke=\"{}\"", medium));
  if (front) row.stroke("Pareto front: none is as accurate and faster", "stroke=\"#c9d1d9\" stroke-width=\"7\"");
}

}  // namespace ballpark::cost::draw
