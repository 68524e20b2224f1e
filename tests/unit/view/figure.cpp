#include "scenarios/view/figure.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "scenarios/view/history.h"
#include "tests/catch.h"

using namespace ballpark;
using namespace ballpark::view;

namespace {

struct Place {
  double x, y;
};

/// The points of each polyline of a class.
std::vector<std::vector<Place>> lines_of(const std::string& text, const std::string& name) {
  std::vector<std::vector<Place>> lines;
  const std::string open = "<polyline points=\"";
  for (std::size_t at = 0; (at = text.find(open, at)) != std::string::npos; ++at) {
    const std::size_t first = at + open.size(), last = text.find('"', first);
    if (text.compare(last, name.size() + 10, "\" class=\"" + name + "\"") != 0) continue;
    std::istringstream points(text.substr(first, last - first));
    lines.emplace_back();
    char comma = 0;
    for (Place p{}; points >> p.x >> comma >> p.y;) lines.back().push_back(p);
  }
  return lines;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("a curve is drawn to scale, with gaps where a value is not finite") {
  Figure figure;
  figure.title = "a < b";
  figure.times = {0, 1, 2, 4, 5, 6};
  figure.series = {{"height", "m", {0, 10, 20, 40, missing, 60}}};
  const std::string text = svg(figure);
  const auto lines = lines_of(text, "alone");
  REQUIRE(lines.size() == 2);
  REQUIRE(lines[0].size() == 4);
  const std::vector<Place>& line = lines[0];
  const double per_second = line[1].x - line[0].x, per_metre = (line[0].y - line[1].y) / 10;
  CHECK(per_second > 50);
  CHECK(per_metre > 0);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(std::abs(line[i].x - line[0].x - per_second * figure.times[i]) < 0.05);
    CHECK(std::abs(line[0].y - line[i].y - per_metre * figure.series[0].values[i]) < 0.05);
  }
  CHECK(std::abs(lines[1][0].x - line[0].x - 6 * per_second) < 0.05);
  CHECK(holds(text, ">height [m]<"));
  CHECK(holds(text, ">a &lt; b<"));
  CHECK(holds(text, "prefers-color-scheme: dark"));
}

TEST_CASE("series of one unit share a scale, and what barely changes shows its change") {
  Figure figure;
  figure.times = {0, 1, 2};
  figure.series = {{"energy", "J", {10, 10 + 1e-9, 10 + 2e-9}},
                   {"kinetic energy", "J", {10, 5, 0}},
                   {"potential energy", "J", {0, 5, 10}},
                   {"momentum", "kg m/s", {7, 7 + 1e-6, 7 - 1e-6}},
                   {"contacts", "", {3, 3, 3}}};
  const std::string text = svg(figure);
  const auto energy = lines_of(text, "curve-0"), kinetic = lines_of(text, "curve-1");
  REQUIRE(energy.size() == 1);
  REQUIRE(kinetic.size() == 1);
  CHECK(std::abs(energy[0][2].y - energy[0][0].y) < 0.02);
  CHECK(std::abs(kinetic[0][0].y - energy[0][0].y) < 0.02);
  CHECK(kinetic[0][2].y > kinetic[0][0].y + 50);
  CHECK(lines_of(text, "curve-2").size() == 1);
  CHECK(holds(text, ">energy: change since the start at 10 [J]<"));
  CHECK(holds(text, ">2e-9<"));
  CHECK(holds(text, ">momentum: change since the start at 7 [kg m/s]<"));
  CHECK_FALSE(holds(text, ">momentum [kg m/s]<"));
  CHECK(holds(text, ">contacts<"));
  const auto alone = lines_of(text, "alone");
  REQUIRE(alone.size() == 3);  // changes of energy and momentum, and contacts
  const double up = alone[0][1].y - alone[0][2].y;
  CHECK(up > 20);
  CHECK(std::abs(alone[0][0].y - alone[0][1].y - up) < 0.1);
}

TEST_CASE("an outlier of measured times does not flatten the rest, and is told") {
  Figure figure;
  figure.series = {{"time per body-step", "ns", {}}};
  for (int i = 0; i < 100; ++i) {
    figure.times.push_back(i);
    figure.series[0].values.push_back(i == 40 ? 54321 : 100 + i % 2);
  }
  const std::string text = svg(figure);
  CHECK(holds(text, ">time per body-step [ns], once 54321<"));
  const auto line = lines_of(text, "alone").at(0);
  CHECK(line[39].y - line[40].y > 30);
  CHECK(line[0].y < line[40].y + 70);
}

TEST_CASE("a figure of nothing, or of one moment, is a picture all the same") {
  Figure figure;
  CHECK(svg(figure).ends_with("</svg>\n"));
  figure.times = {0};
  figure.series = {{"energy", "J", {1}}, {"momentum", "kg m/s", {missing}}};
  const std::string text = svg(figure);
  CHECK(lines_of(text, "alone").size() == 1);
  CHECK_FALSE(holds(text, "nan"));
}

TEST_CASE("a history has the sums of a fall as the theory has them") {
  Scene scene;
  scene.run.duration = 1;
  scene.run.step = 1.0 / 64;
  BodyGroup ball;
  ball.name = "ball";
  ball.mass = {2};
  ball.position = {{3, 0, 0}};
  scene.bodies = {ball};
  scene.effects = {{"gravity", {}, {{"acceleration", Vector3d(0, 0, -10)}}}};
  World world(scene);
  History history(scene);
  for (int i = 0; i < 5; ++i) {
    history.add(world);
    world.step(16);
  }
  const std::vector<double> times = history.times();
  const std::vector<Series> series = history.take();
  REQUIRE(series.size() == 6);
  const auto value = [&](const char* name, std::size_t i) {
    for (const Series& each : series) {
      if (each.name == name) return each.values.at(i);
    }
    return missing;
  };
  for (std::size_t i = 0; i < 5; ++i) {
    const double t = 0.25 * static_cast<double>(i);
    CHECK(times[i] == t);
    CHECK(std::abs(value("energy", i)) < 1e-10);
    CHECK(value("kinetic energy", i) == Approx(100 * t * t));
    CHECK(value("potential energy", i) == Approx(-100 * t * t));
    CHECK(value("momentum", i) == Approx(20 * t));
    CHECK(value("angular momentum", i) == Approx(60 * t));
    CHECK(value("time per body-step", i) > 0);
  }
}

TEST_CASE("a history of balls that touch counts contacts and tells the deepest overlap") {
  Scene scene;
  scene.run.duration = 1;
  scene.run.step = 1.0 / 64;
  scene.contact.kind = "impulse";
  scene.contact.substeps = 4;
  BodyGroup balls;
  balls.name = "balls";
  balls.shape = "sphere";
  balls.radius = {0.5};
  balls.mass = {1};
  balls.position = {{0, 0, 0.5}, {3, 0, 0.5 - 1e-3}};
  scene.bodies = {balls};
  Boundary ground;
  ground.shape = "plane";
  scene.boundaries = {ground};
  scene.effects = {{"gravity", {}, {}}};
  World world(scene);
  History history(scene);
  history.add(world);
  world.step(32);
  history.add(world);
  const std::vector<Series> series = history.take();
  REQUIRE(series.size() == 8);
  CHECK(series[5].name == "deepest penetration so far");
  CHECK(series[5].values[0] == 0);
  CHECK(series[5].values[1] == Approx(1e-3).epsilon(0.01));
  CHECK(series[6].name == "contacts");
  CHECK(series[6].values[1] == Approx(2).epsilon(0.1));
}
