#include "scenarios/view/encode.h"

#include <cmath>
#include <random>

#include "scenarios/view/deflate.h"
#include "scenarios/view/page.h"
#include "tests/catch.h"
#include "tests/unit/view/decoded.h"

using namespace ballpark;
using namespace ballpark::view;

namespace {

/// Bodies that wander, far from the origin of space.
Recording wandering(std::size_t bodies, std::size_t frames) {
  std::mt19937 random(7);
  const auto unit = [&] { return static_cast<float>(random() / 4294967296.0); };
  Recording recording;
  recording.scenario = "wandering";
  recording.label = "by hand";
  recording.doc = "</script> is no end";
  recording.bodies = recording.shown = bodies;
  recording.groups = {{"few", 0, 1, {0.5}, true}, {"many", 1, bodies - 1, {}, false}};
  recording.origin = {1e6, 0, -3};
  for (std::size_t f = 0; f < frames; ++f) {
    recording.times.push_back(0.5 * static_cast<double>(f));
    for (std::size_t b = 0; b < bodies; ++b) {
      for (int c = 0; c < 3; ++c) {
        recording.position.push_back(static_cast<float>(c) + unit() * (c == 2 ? 100.0F : 2.0F));
        recording.orientation.push_back(static_cast<std::uint16_t>(random() % 65536));
      }
      recording.speed.push_back(4 * unit());
      recording.contacts.push_back(static_cast<std::uint8_t>(random() % 256));
    }
  }
  recording.series = {{"energy", "J", std::vector<double>(frames, std::nan(""))}};
  return recording;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("positions come back to half a quantum, all else as it was quantised") {
  const Recording recording = wandering(5, 40);
  const Decoded run = decoded(encode(recording));
  REQUIRE(run.bytes == 40 * 5 * (6 + 6 + 1 + 1));
  const std::vector<unsigned>& position = run.columns.at("position");
  double worst = 0, widest_error = 0;
  for (std::size_t i = 0; i < recording.position.size(); ++i) {
    const auto c = static_cast<Eigen::Index>(i % 3);
    const double low = run.header["box"]["min"][i % 3], high = run.header["box"]["max"][i % 3];
    const double place = low + position[i] / 65535.0 * (high - low);
    const double off = std::abs(place - (recording.origin[c] + recording.position[i])) / ((high - low) / 65535);
    worst = std::max(worst, off);
    widest_error = std::max(widest_error, off * (high - low) / 65535);
  }
  CHECK(worst <= 0.5 + 1e-3);  // 1e6 m away: double rounds, too
  CHECK(worst > 0.45);
  CHECK(widest_error < 0.5 * 100 / 65535 * 1.001);
  CHECK(run.columns.at("orientation") ==
        std::vector<unsigned>(recording.orientation.begin(), recording.orientation.end()));
  CHECK(run.columns.at("contacts") == std::vector<unsigned>(recording.contacts.begin(), recording.contacts.end()));
  const double fastest = run.header["columns"][2]["max"];
  for (std::size_t i = 0; i < recording.speed.size(); ++i) {
    CHECK(std::abs(run.columns.at("speed")[i] / 255.0 * fastest - recording.speed[i]) <= 0.5001 * fastest / 255);
  }
}

TEST_CASE("even motion takes nearly no bytes, which is what second differences are for") {
  Recording recording = wandering(64, 200);
  recording.orientation.clear();
  recording.speed.clear();
  recording.contacts.clear();
  for (std::size_t f = 0; f < 200; ++f) {
    for (std::size_t i = 0; i < 192; ++i)
      recording.position[192 * f + i] = static_cast<float>(i) + static_cast<float>(f) * 327.675F;
  }
  const Encoded even = encode(recording);
  CHECK(even.columns[0].bytes < 64 * 200 * 6 / 20);
  CHECK(decoded(even).columns.at("position").size() == 64 * 200 * 3);
}

TEST_CASE("a body that stays where it is has a box of no size") {
  Recording recording = wandering(2, 3);
  std::fill(recording.position.begin(), recording.position.end(), 0.25F);
  const Decoded run = decoded(encode(recording));
  CHECK(run.columns.at("position") == std::vector<unsigned>(18, 0));
  CHECK(run.header["box"]["min"] == run.header["box"]["max"]);
  CHECK(run.header["box"]["min"][0] == 1e6 + 0.25);
}

TEST_CASE("the header says what the page needs") {
  Recording recording = wandering(5, 3);
  recording.position[2] = 2;
  recording.position[5] = 102;
  Boundary box, tube;
  box.shape = "box";
  box.point = {1, 2, 3};
  box.size = {2, 2, 2};
  box.motion = Motion{};
  tube.shape = "tube";
  tube.radius = 0.25;
  recording.boundaries = {box, tube};
  const nlohmann::json header = nlohmann::json::parse(encode(recording).header);
  CHECK(header["format"] == 1);
  CHECK(header["times"] == std::vector<double>{0, 0.5, 1});
  CHECK(header["groups"][0] ==
        nlohmann::json{{"name", "few"}, {"first", 0}, {"count", 1}, {"radius", 0.5}, {"turns", true}});
  CHECK_FALSE(header["groups"][1].contains("radius"));
  CHECK(header["boundaries"][0]["min"] == std::vector<double>{0, 1, 2});
  CHECK(header["boundaries"][0].contains("motion"));
  CHECK(header["boundaries"][1]["radius"] == 0.25);
  CHECK(header["columns"][0] ==
        nlohmann::json{{"name", "position"}, {"components", 3}, {"bits", 16}, {"differences", 2}});
  CHECK(header["columns"][2]["unit"] == "m/s");
  CHECK(header["series"][0]["values"][0].is_null());
  CHECK(holds(header["notes"][0].get<std::string>(), "rounded to 1.53 mm"));
}

TEST_CASE("bodies are left out to keep a limit, the first of each group never") {
  const Recording recording = wandering(6000, 4);
  const std::size_t whole = encode(recording).bytes();
  const auto runs = encode_within({&recording, &recording}, whole);
  REQUIRE(runs);
  REQUIRE(runs->size() == 2);
  for (const Encoded& run : *runs) {
    CHECK(run.bytes() <= whole / 2);
    CHECK(run.bytes() > whole / 5);
    CHECK(run.stride > 1);
    const Decoded read = decoded(run);
    CHECK(read.header["stride"] == run.stride);
    CHECK(read.header["groups"][0]["count"] == 1);
    CHECK(read.header["groups"][1]["first"] == 1);
    CHECK(read.header["groups"][1]["count"] == (5999 + run.stride - 1) / run.stride);
    CHECK(run.notes.size() == 2);
    // The second body of the page is the first of its group.
    CHECK(read.columns.at("contacts")[1] == recording.contacts[1]);
    CHECK(read.columns.at("contacts")[2] == recording.contacts[1 + run.stride]);
  }
  CHECK_FALSE(encode_within({&recording}, 500));
  CHECK_FALSE(encode_within({&recording}, 0));
}

TEST_CASE("base64 and zlib's checksum have the values of their standards") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe\xfd") == "//79");
  CHECK(crc("123456789") == 0xCBF43926);
}

TEST_CASE("no text of a run becomes markup in its page") {
  const std::string text = page("a < b", {encode(wandering(2, 2))});
  CHECK(holds(text, "a &lt; b"));
  CHECK(holds(text, "\\u003c/script> is no end"));
  CHECK(holds(text, "id=\"data-0\""));
  CHECK_FALSE(holds(text, "{{runs}}"));
}
