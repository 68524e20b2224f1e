// Frames for programs that draw them: .vtp with .pvd, and extended XYZ.
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <vector>

#include "tests/catch.h"
#include "tests/unit/command/falling.h"
#include "tests/unit/command/scratch_folder.h"

using namespace ballpark::command;

namespace {

std::size_t times(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++n;
  return n;
}

/// The numbers of an array, as the offset in the file's XML says.
template <class T>
std::vector<T> vtk_array(const std::string& file, const std::string& name) {
  const std::size_t tag = file.find("Name=\"" + name + "\"");
  REQUIRE(tag != std::string::npos);
  const std::size_t offset = std::stoul(file.substr(file.find("offset=\"", tag) + 8));
  const std::size_t block = file.find("encoding=\"raw\">\n_") + 17 + offset;
  std::uint64_t size = 0;
  std::memcpy(&size, file.data() + block, sizeof size);
  REQUIRE(block + sizeof size + size <= file.size());
  std::vector<T> values(size / sizeof(T));
  std::memcpy(values.data(), file.data() + block + sizeof size, size);
  return values;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

void film(const ballpark::scenes::OutputRequest& request, const ballpark::Scene& scene, ballpark::World& world) {
  Filming film(request, scene, world);
  film.add(world);
  world.step(4);
  film.add(world);
  film.file->finish();
}

}  // namespace

TEST_CASE("vtp: a file each frame, and an index with their times", "[command]") {
  const ScratchFolder folder;
  const ballpark::Scene scene = falling(true);
  ballpark::World world(scene);
  film(request_of(folder.file("a&b.vtp")), scene, world);
  CHECK(folder.entries() == 3);
  const std::string index = contents(folder.file("a&b.pvd"));
  CHECK(times(index, "<DataSet ") == 2);
  CHECK(index.find("timestep=\"0\" part=\"0\" file=\"a&amp;b_0000.vtp\"") != std::string::npos);
  CHECK(index.find("timestep=\"0.0625\" part=\"0\" file=\"a&amp;b_0001.vtp\"") != std::string::npos);
  const std::string frame = contents(folder.file("a&b_0001.vtp"));
  CHECK(vtk_array<std::int32_t>(frame, "id") == std::vector<std::int32_t>{0, 1, 2, 3});
  CHECK(vtk_array<std::int32_t>(frame, "connectivity") == std::vector<std::int32_t>{0, 1, 2, 3});
  CHECK(vtk_array<std::int32_t>(frame, "offsets") == std::vector<std::int32_t>{1, 2, 3, 4});
  CHECK(vtk_array<float>(frame, "radius") == std::vector<float>{0, 0, 0.5f, 0.25f});
  const auto position = vtk_array<float>(frame, "position"), spin = vtk_array<float>(frame, "angular_velocity");
  REQUIRE(position.size() == 12);
  REQUIRE(spin.size() == 12);
  CHECK(vtk_array<float>(frame, "orientation").size() == 16);
  for (std::size_t id = 0; id < 4; ++id) {
    CHECK(position[3 * id + 2] == static_cast<float>(world.body(id).position.z()));
    CHECK(spin[3 * id + 1] == static_cast<float>(world.body(id).angular_velocity.y()));
  }
}

TEST_CASE("vtp: in double precision numbers have all bits", "[command]") {
  const ScratchFolder folder;
  const ballpark::Scene scene = falling(false);
  ballpark::World world(scene);
  auto request = request_of(folder.file("a.pvd"));
  request.precision = "double";
  request.columns = {"position"};
  film(request, scene, world);
  const std::string frame = contents(folder.file("a_0001.vtp"));
  const auto position = vtk_array<double>(frame, "position");
  REQUIRE(position.size() == 6);
  for (std::size_t id = 0; id < 2; ++id) CHECK(position[3 * id + 2] == world.body(id).position.z());
  CHECK(frame.find("velocity") == std::string::npos);
  CHECK(frame.find("radius") == std::string::npos);
}

TEST_CASE("vtp: the index is whole at any time, and lists only frames of this run", "[command]") {
  const ScratchFolder folder;
  const ballpark::Scene scene = falling(false);
  ballpark::World world(scene);
  film(request_of(folder.file("a.pvd")), scene, world);
  Filming again(request_of(folder.file("a.pvd")), scene, world);
  CHECK(times(contents(folder.file("a.pvd")), "<DataSet ") == 0);
  for (int frame = 0; frame < 40; ++frame) {
    again.add(world);
    const std::string index = contents(folder.file("a.pvd"));
    CHECK(index.ends_with("</Collection>\n</VTKFile>\n"));
    CHECK(static_cast<int>(times(index, "<DataSet ")) * 5 / 4 >= frame);
    CHECK(static_cast<int>(times(index, "<DataSet ")) <= frame + 1);
  }
}

TEST_CASE("xyz: frame after frame, a line per body, to the last bit", "[command]") {
  const ScratchFolder folder;
  const ballpark::Scene scene = falling(true);
  ballpark::World world(scene);
  film(request_of(folder.file("a.xyz")), scene, world);
  const auto lines = lines_of(contents(folder.file("a.xyz")));
  REQUIRE(lines.size() == 2 * (2 + 4));
  CHECK(lines[6] == "4");
  CHECK(lines[7] ==
        "pbc=\"F F F\" Properties=species:S:1:id:I:1:pos:R:3:orientation:R:4:velo:R:3:angular_velocity:R:3:radius:R:1 "
        "Time=0.0625");
  for (std::size_t id = 0; id < 4; ++id) {
    std::istringstream words(lines[8 + id]);
    std::string species;
    words >> species;
    CHECK(species == "X");
    std::vector<double> values;
    for (std::string word; words >> word;) values.push_back(std::stod(word));
    REQUIRE(values.size() == 15);
    const ballpark::BodyState body = world.body(id);
    CHECK(values[0] == static_cast<double>(id));
    CHECK(values[3] == body.position.z());
    CHECK(values[4] == body.orientation.x);  // the real part is the last one here
    CHECK(values[7] == body.orientation.w);
    CHECK(values[10] == body.velocity.z());
    CHECK(values[13] == body.angular_velocity.z());
  }
}

TEST_CASE("xyz: single precision has as many digits as it needs", "[command]") {
  const ScratchFolder folder;
  const ballpark::Scene scene = falling(false);
  ballpark::World world(scene);
  auto request = request_of(folder.file("a.xyz"));
  request.precision = "single";
  request.columns = {"position"};
  film(request, scene, world);
  CHECK(lines_of(contents(request.file))[2] == "X 0 0 0 0.33333334");
}

TEST_CASE("xyz: the cell of periodic space, with a length where space is open", "[command]") {
  ballpark::Scene scene = falling(false);
  ballpark::Boundary space;
  space.shape = "periodic";
  space.point = {1, 2, 3};
  space.size = {2, 4, 0};
  scene.boundaries = {space};
  const ScratchFolder folder;
  const ballpark::scenes::OutputRequest request = request_of(folder.file("a.xyz"));
  const auto file = open_frame_file(request, scene);
  file->begin({1, {}, {0.5}});
  Frames frames;
  frames.times = {2};
  file->add(frames);
  file->finish();
  CHECK(contents(request.file) ==
        "1\nLattice=\"2 0 0 0 4 0 0 0 4\" Origin=\"0 0 1\" pbc=\"T T F\" "
        "Properties=species:S:1:id:I:1:radius:R:1 Time=2\nX 0 0.5\n");
}
