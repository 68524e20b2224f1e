#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "scenarios/view/drawing.h"
#include "scenarios/view/stripes.h"
#include "tests/catch.h"
#include "tests/unit/view/decoded.h"

using namespace ballpark;
using namespace ballpark::view;

namespace {

constexpr int width = 160, height = 100;
const Vector3d oblique(1, -1.6, 0.9);

/// A ball of radius 1, one behind it as seen along y, and one that turns.
Recording three_balls() {
  Recording recording;
  recording.bodies = recording.shown = 3;
  recording.times = {0};
  recording.groups = {{"one", 0, 2, {1}, false}, {"two", 2, 1, {1}, true}};
  recording.position = {0, 0, 0, 0, 5, 0, 4, 0, 0};
  recording.speed = {0, 1, 2};
  recording.orientation = {32768, 32768, 32768, 32768, 32768, 32768, 32768, 32768, 32768};
  return recording;
}

Colour at(const Image& image, const Seen& place) {
  const auto i = 3 * (static_cast<std::size_t>(place.y) * static_cast<std::size_t>(image.width) +
                      static_cast<std::size_t>(place.x));
  return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
}

/// By the parity of the edges to its right.
bool inside(const std::vector<cost::draw::Spot>& outline, double x, double y) {
  bool in = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const auto &a = outline[i], &b = outline[j];
    if ((a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
  }
  return in;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

}  // namespace

TEST_CASE("the camera has all of a box in view, and touches the frame") {
  const Box box{{-1, 2, 0}, {4, 3, 7}};
  const Camera camera = camera_on(box, oblique, width, height);
  double most = 0;
  for (int k = 0; k < 8; ++k) {
    const Vector3d corner(k & 1 ? 4 : -1, k & 2 ? 3 : 2, k & 4 ? 7 : 0);
    const Seen seen = camera.see(corner);
    CHECK(seen.depth > 0);
    most = std::max({most, std::abs(seen.x / width - 0.5), std::abs(seen.y / height - 0.5)});
  }
  CHECK(most == Approx(0.46));
  const Seen middle = camera.see(box.centre());
  CHECK(middle.x == Approx(80));
  CHECK(middle.y == Approx(50));
  CHECK(camera.see(box.centre() + Vector3d(0, 0, 1)).y < 50);  // z is up
  CHECK(camera.see(box.centre() + Vector3d(1, 0, 0)).x > 80);
  CHECK(camera_on({}, {0, 0, 1}, width, height).eye.allFinite());
}

TEST_CASE("the nearer ball hides the farther one, and the ground is white") {
  Recording recording = three_balls();
  const Drawing drawing = drawing_of(recording, 0, ColourBy::group);
  const Vector3d along_y(0, -1, 0);
  const Image image = picture(drawing, along_y, width, height);
  const Camera camera = camera_on(drawing.box, along_y, width, height);
  const Colour front = at(image, camera.see({0, 0, 0}));
  CHECK(front.blue > front.red + 60);  // of group one, 0072b2
  const Colour corner = at(image, {1, 1, 1});
  CHECK((corner.red == 255 && corner.green == 255 && corner.blue == 255));
  recording.groups = {{"one", 0, 1, {1}, false}, {"two", 1, 2, {1}, true}};
  const Image other = picture(drawing_of(recording, 0, ColourBy::group), along_y, width, height);
  const Colour still_front = at(other, camera.see({0, 0, 0}));
  CHECK((still_front.red == front.red && still_front.blue == front.blue));
}

TEST_CASE("a silhouette is where a sphere's is") {
  Drawing drawing;
  drawing.box = {{-1, -1, -1}, {1, 1, 1}};
  drawing.balls = {{{0, 0, 0}, 1, {0, 0, 0}, false, {}}};
  const Image image = picture(drawing, oblique, width, height);
  const Camera camera = camera_on(drawing.box, oblique, width, height);
  const double distance = camera.eye.norm(), radius = camera.focal / std::sqrt(distance * distance - 1);
  double area = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) area += image.pixels[i] < 128;
  CHECK(area == Approx(M_PI * radius * radius).epsilon(0.03));
}

TEST_CASE("stripes show how a body is turned") {
  Recording recording = three_balls();
  const Image before = picture(drawing_of(recording, 0, ColourBy::plain), oblique, width, height);
  recording.orientation[6] = 60000;
  const Image turned = picture(drawing_of(recording, 0, ColourBy::plain), oblique, width, height);
  CHECK(before.pixels != turned.pixels);
  recording.orientation[6] = 32768;
  recording.orientation[0] = 60000;  // of a group that does not turn
  CHECK(picture(drawing_of(recording, 0, ColourBy::plain), oblique, width, height).pixels == before.pixels);
}

TEST_CASE("stripes of vector pictures lie where those of pixels do") {
  constexpr int size = 200;
  for (int k = 0; k < 12; ++k) {
    const double angle = 0.5 * k;
    const Vector3d axis = Vector3d(std::sin(k), std::cos(2.0 * k), 0.3 * k - 1).normalized(),
                   v = std::sin(angle) * axis;
    Drawing drawing;
    drawing.box = {{-1, -1, -1}, {1, 1, 1}};
    drawing.balls = {{{0, 0, 0}, 1, {0, 0, 200}, true, {std::cos(angle), v.x(), v.y(), v.z()}}};
    const Image image = picture(drawing, oblique, size, size);
    const Camera camera = camera_on(drawing.box, oblique, size, size);
    const std::vector<Stripe> marks = stripes(drawing.balls[0], camera);
    REQUIRE(!marks.empty());
    const Seen middle = camera.see({0, 0, 0});
    const double radius = 0.97 * camera.focal / std::sqrt(middle.depth * middle.depth - 1);
    std::size_t marked = 0, missed = 0;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const double right = x + 0.5, down = y + 0.5;
        if (std::hypot(right - middle.x, down - middle.y) > radius) continue;
        const Colour colour = at(image, {right, down, 1});
        const bool grey = colour.red == colour.blue;
        const bool in = std::any_of(marks.begin(), marks.end(),
                                    [&](const Stripe& mark) { return inside(mark.outline, right, down); });
        marked += grey;
        missed += in != grey;
      }
    }
    CHECK(marked > 200);
    CHECK(static_cast<double>(missed) < 0.1 * static_cast<double>(marked));  // pixels of the edges are mixed
  }
  CHECK(stripes({{0, 0, 0}, 1, {}, false, {}}, camera_on({{-1, -1, -1}, {1, 1, 1}}, oblique, size, size)).empty());
}

TEST_CASE("colours by speed run from viridis' first to its last") {
  const Drawing drawing = drawing_of(three_balls(), 0, ColourBy::speed);
  CHECK(hex(drawing.balls[0].colour) == "#440154");
  CHECK(hex(drawing.balls[1].colour) == "#21908d");
  CHECK(hex(drawing.balls[2].colour) == "#fde725");
}

TEST_CASE("PNG: a signature, sound checksums, and the pixels as they were") {
  const Image image = picture(drawing_of(three_balls(), 0, ColourBy::speed), oblique, width, height);
  const std::string bytes = png(image);
  REQUIRE(bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  std::string data;
  for (std::size_t at = 8; at < bytes.size();) {
    const std::size_t length = number_at(bytes, at);
    const std::string body = bytes.substr(at + 4, 4 + length);
    CHECK(crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())) ==
          number_at(bytes, at + 8 + length));
    if (body.starts_with("IHDR")) CHECK((number_at(body, 4) == width && number_at(body, 8) == height));
    if (body.starts_with("IDAT")) data = inflated(body.substr(4));
    at += 12 + length;
  }
  REQUIRE(data.size() == (1 + 3 * width) * height);
  std::vector<std::uint8_t> pixels;
  for (std::size_t y = 0; y < height; ++y) {
    const std::size_t row = y * (1 + 3 * width);
    CHECK(data[row] == 1);
    for (std::size_t i = 0; i < 3 * width; ++i) {
      const int left = i < 3 ? 0 : pixels[pixels.size() - 3];
      pixels.push_back(static_cast<std::uint8_t>(static_cast<unsigned char>(data[row + 1 + i]) + left));
    }
  }
  CHECK(pixels == image.pixels);
}

TEST_CASE("SVG: circles from far to near, above the lines") {
  Recording recording = three_balls();
  Boundary box;
  box.shape = "box";
  box.size = {10, 10, 10};
  recording.boundaries = {box};
  const std::string text = svg(drawing_of(recording, 0, ColourBy::speed), oblique, width, height);
  const auto place = [&](const std::string& part) { return text.find(part); };
  CHECK(text.starts_with("<svg"));
  CHECK(place("<line") < place("<circle"));
  CHECK(place("#21908d") < place("#440154"));  // y = 5 is behind
  CHECK(place("#440154") < place("#fde725"));
  CHECK(place("<polygon") < text.size());  // the stripes of the one that turns
  CHECK(place(">speed [m/s]<") < text.size());
  CHECK(place(">2<") < text.size());
  CHECK(place(">0 s<") < text.size());
  recording.groups[0].name = "a<b";
  const std::string by_group = svg(drawing_of(recording, 0, ColourBy::group), oblique, width, height);
  CHECK(by_group.find(">a&lt;b<") < by_group.size());
  CHECK(by_group.find(">two<") < by_group.size());
  CHECK(by_group.find("speed") > by_group.size());
}

TEST_CASE("boundaries move, and what has no end is drawn near the bodies") {
  Boundary plane;
  plane.shape = "plane";
  plane.point = {1000, 0, -1};
  plane.motion = Motion{{0, 0, 2}, {0, 0, 0.5}, 0.25, 0};
  CHECK(displacement(plane, 1) == Vector3d(0, 0, 2.5));
  const Box bodies{{0, 0, 0}, {2, 2, 2}};
  for (const Line& line : outline(plane, 1, bodies)) {
    CHECK(line.from.z() == Approx(1.5));
    CHECK((line.from - bodies.centre()).norm() < 2 * bodies.diagonal());
  }
  Boundary tube;
  tube.shape = "tube";
  tube.radius = 3;
  for (const Line& line : outline(tube, 0, bodies)) CHECK(line.from.head<2>().norm() == Approx(3));
  Boundary repeating;
  repeating.shape = "periodic";
  repeating.size = {4, 0, 4};
  double highest = 0;
  for (const Line& line : outline(repeating, 0, bodies)) highest = std::max(highest, line.to.y());
  CHECK(highest == 2);  // as far as the bodies where nothing repeats
  CHECK(outline(repeating, 0, bodies).size() == 12);
}
