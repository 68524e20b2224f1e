#include <zip.h>

#include <cstring>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "scenarios/command/csv.h"
#include "scenarios/command/errors.h"
#include "tests/catch.h"
#include "tests/unit/command/falling.h"
#include "tests/unit/command/scratch_folder.h"

using namespace ballpark::command;
using ballpark::Vector3d;

namespace {

struct Array {
  std::string header;
  std::vector<double> values;
};

std::map<std::string, Array> read_npz(const std::string& path) {
  std::map<std::string, Array> arrays;
  int error = 0;
  zip_t* archive = zip_open(path.c_str(), ZIP_RDONLY, &error);
  REQUIRE(archive);
  for (zip_int64_t i = 0; i < zip_get_num_entries(archive, 0); ++i) {
    zip_stat_t info;
    const auto index = static_cast<zip_uint64_t>(i);
    REQUIRE(zip_stat_index(archive, index, 0, &info) == 0);
    std::string text(info.size, ' ');
    zip_file_t* file = zip_fopen_index(archive, index, 0);
    REQUIRE(zip_fread(file, text.data(), text.size()) == static_cast<zip_int64_t>(text.size()));
    zip_fclose(file);
    REQUIRE(text.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
    Array array{text.substr(10, 118), std::vector<double>((text.size() - 128) / sizeof(double))};
    if (!array.values.empty()) std::memcpy(array.values.data(), text.data() + 128, text.size() - 128);
    arrays[info.name] = array;
  }
  zip_close(archive);
  return arrays;
}

std::vector<float> floats(const Array& array) {
  std::vector<float> values(2 * array.values.size());
  std::memcpy(values.data(), array.values.data(), array.values.size() * sizeof(double));
  return values;
}

bool has_shape(const Array& array, const std::string& shape) {
  return array.header.find("'shape': " + shape + ",") != std::string::npos && array.header.back() == '\n';
}

}  // namespace

TEST_CASE("an npz holds one array a quantity, frame by frame, to the last bit", "[command]") {
  const ScratchFolder folder;
  const std::string path = folder.file("series.npz");
  const ballpark::Scene scene = falling(true);
  ballpark::World world(scene);
  Filming film(request_of(path), scene, world);
  film.add(world);
  world.step(3);
  film.add(world);
  film.file->finish();
  CHECK(folder.entries() == 1);
  const auto arrays = read_npz(path);
  REQUIRE(arrays.size() == 6);
  CHECK(has_shape(arrays.at("time.npy"), "(2,)"));
  CHECK(has_shape(arrays.at("id.npy"), "(4,)"));
  CHECK(has_shape(arrays.at("position.npy"), "(2, 4, 3)"));
  CHECK(has_shape(arrays.at("velocity.npy"), "(2, 4, 3)"));
  CHECK(has_shape(arrays.at("orientation.npy"), "(2, 4, 4)"));
  CHECK(has_shape(arrays.at("angular_velocity.npy"), "(2, 4, 3)"));
  CHECK(arrays.at("time.npy").values == std::vector<double>{0, 3 * falling_step});
  const std::vector<double>& positions = arrays.at("position.npy").values;
  REQUIRE(positions.size() == 2 * 4 * 3);
  for (std::size_t id = 0; id < 4; ++id) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      CHECK(positions[12 + 3 * id + axis] == world.body(id).position[static_cast<Eigen::Index>(axis)]);
    }
  }
  const std::vector<double>& orientations = arrays.at("orientation.npy").values;
  CHECK(orientations[16 + 4 * 3] == world.body(3).orientation.w);
  CHECK(orientations[16 + 4 * 0] == 1);  // a point has none: identity
}

TEST_CASE("what no body carries is not in the npz", "[command]") {
  const ScratchFolder folder;
  const ballpark::Scene scene = falling(false);
  const ballpark::World world(scene);
  Filming film(request_of(folder.file("series.npz")), scene, world);
  film.add(world);
  film.file->finish();
  const auto arrays = read_npz(folder.file("series.npz"));
  CHECK(arrays.size() == 4);
  CHECK(arrays.count("orientation.npy") == 0);
}

TEST_CASE("equal runs give equal npz files, and no frame is a valid file too", "[command]") {
  const ScratchFolder folder;
  const ballpark::Scene scene = falling(true);
  for (const char* name : {"a.npz", "b.npz"}) {
    const ballpark::World world(scene);
    Filming film(request_of(folder.file(name)), scene, world);
    film.add(world);
    film.file->finish();
  }
  CHECK(contents(folder.file("a.npz")) == contents(folder.file("b.npz")));
  const auto none = request_of(folder.file("none.npz"));
  const auto file = open_frame_file(none, scene);
  file->begin(layout_without_bodies(none));
  file->finish();
  CHECK(has_shape(read_npz(folder.file("none.npz")).at("position.npy"), "(0, 0, 3)"));
}

TEST_CASE("a series that is given up leaves nothing", "[command]") {
  const ScratchFolder folder;
  const ballpark::Scene scene = falling(false);
  const ballpark::World world(scene);
  for (const char* name : {"a.npz", "a.csv", "a.xyz"}) Filming(request_of(folder.file(name)), scene, world).add(world);
  CHECK(folder.entries() == 0);
}

TEST_CASE("a series has a row per time and body", "[command]") {
  const ScratchFolder folder;
  const ballpark::Scene scene = falling(false);
  ballpark::World world(scene);
  Filming film(request_of(folder.file("series.csv")), scene, world);
  film.add(world);
  world.step(2);
  film.add(world);
  film.file->finish();
  std::istringstream lines(contents(folder.file("series.csv")));
  std::vector<std::string> rows;
  for (std::string row; std::getline(lines, row);) rows.push_back(row);
  REQUIRE(rows.size() == 1 + 2 * 2);
  CHECK(rows[0] == "time,id,x,y,z,vx,vy,vz");
  CHECK(rows[1].find("0,0,0,0,0.33333333333333331,") == 0);
  CHECK(rows[4].find("0.03125,1,") == 0);
}

TEST_CASE("a state that is read back has the same bits", "[command]") {
  const ScratchFolder folder;
  const ballpark::Scene scene = falling(true);
  ballpark::World world(scene);
  world.step(7);
  OutputFile file(folder.file("state.csv"));
  write_state(world, scene, file);
  file.commit();
  std::istringstream lines(contents(folder.file("state.csv")));
  std::string header, row;
  std::getline(lines, header);
  CHECK(header == "id,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz");
  for (std::size_t id = 0; id < world.body_count(); ++id) {
    REQUIRE(std::getline(lines, row));
    std::istringstream cells(row);
    std::vector<double> values;
    for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
    REQUIRE(values.size() == 14);
    CHECK(values[0] == static_cast<double>(id));
    CHECK(Vector3d(values[1], values[2], values[3]) == world.body(id).position);
    CHECK(values[4] == world.body(id).orientation.w);
    CHECK(Vector3d(values[8], values[9], values[10]) == world.body(id).velocity);
    CHECK(Vector3d(values[11], values[12], values[13]) == world.body(id).angular_velocity);
  }
}

TEST_CASE("a series of another ending is refused", "[command]") {
  for (const char* name : {"a.txt", "a", "a.npz.gz", ""}) {
    CHECK_THROWS_AS(open_frame_file(request_of(name), falling(false)), DestinationError);
  }
}

TEST_CASE("chosen columns are all that an npz has, in single precision if that is asked for", "[command]") {
  const ScratchFolder folder;
  const ballpark::Scene scene = falling(true);
  ballpark::World world(scene);
  world.step(5);
  auto request = request_of(folder.file("series.npz"));
  request.columns = {"radius", "position"};
  request.precision = "single";
  Filming film(request, scene, world);
  film.add(world);
  film.file->finish();
  const auto arrays = read_npz(request.file);
  REQUIRE(arrays.size() == 4);
  CHECK(has_shape(arrays.at("radius.npy"), "(4,)"));
  CHECK(has_shape(arrays.at("position.npy"), "(1, 4, 3)"));
  CHECK(arrays.at("position.npy").header.find("'<f4'") != std::string::npos);
  CHECK(arrays.at("time.npy").header.find("'<f8'") != std::string::npos);
  const auto values = floats(arrays.at("position.npy"));
  REQUIRE(values.size() == 12);
  for (std::size_t id = 0; id < 4; ++id) {
    CHECK(values[3 * id + 2] == static_cast<float>(world.body(id).position.z()));
  }
  CHECK(floats(arrays.at("radius.npy")) == std::vector<float>{0, 0, 0.5f, 0.25f});
}

TEST_CASE("frames show the bodies by id, whatever their groups, copies and precision", "[command]") {
  const ballpark::Scene scene = falling(true);
  for (const auto precision :
       {ballpark::Precision::single_, ballpark::Precision::double_, ballpark::Precision::extended}) {
    ballpark::Options options;
    options.copies = 3;
    options.perturb = 1e-3;
    options.precision = precision;
    ballpark::World world(scene, options);
    world.step(4);
    const FrameReader reader(world, scene, request_of("x.pvd"));
    Frames frames;
    reader.add(world, frames);
    REQUIRE(reader.layout().columns.size() == 4);
    REQUIRE(frames.values(0, 0).size() == 12 * 3);
    for (std::size_t id = 0; id < 12; ++id) {
      const ballpark::BodyState body = world.body(id);
      const auto axis = [&](std::size_t column, std::size_t c) { return frames.values(column, 0)[3 * id + c]; };
      CHECK(Vector3d(axis(0, 0), axis(0, 1), axis(0, 2)) == body.position);
      CHECK(Vector3d(axis(2, 0), axis(2, 1), axis(2, 2)) == body.velocity);
      CHECK(Vector3d(axis(3, 0), axis(3, 1), axis(3, 2)) == body.angular_velocity);
      CHECK(frames.values(1, 0)[4 * id + 3] == body.orientation.z);
    }
    CHECK(reader.layout().radius[11] == 0.25);
    CHECK(reader.layout().radius[4] == 0);
  }
}
