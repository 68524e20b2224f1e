// Rows of bodies from .npy and .csv files.
#include "scenarios/files/body_file.h"

#include <cstring>

#include "tests/catch.h"
#include "tests/unit/files/scene_texts.h"

using namespace scene_texts;
using ballpark::Vector3d;
using ballpark::scenes::rows_from_csv;
using ballpark::scenes::rows_from_npy;

namespace {

/// A .npy file of version 1 as NumPy writes it.
std::string npy(const std::string& type, const std::string& shape, const std::string& data,
                const std::string& order = "False") {
  std::string header = "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
  while ((10 + header.size() + 1) % 64 != 0) header += ' ';
  header += '\n';
  const char size[2] = {static_cast<char>(header.size() & 0xff), static_cast<char>(header.size() >> 8)};
  return std::string("\x93NUMPY\x01\x00", 8) + std::string(size, 2) + header + data;
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

const std::string scene_with_file = run_table + "[[bodies]]\nname = \"a\"\nmass = 1.0\nfile = ";

}  // namespace

TEST_CASE("Body files: .npy gives positions, in double or single", "[files]") {
  const auto from_double = rows_from_npy(npy("<f8", "(2, 3)", bytes_of<double>({1, 2, 3, 4, 5, 6.5})));
  CHECK(from_double.position == std::vector<Vector3d>{{1, 2, 3}, {4, 5, 6.5}});
  CHECK(from_double.mass.empty());
  const auto from_single = rows_from_npy(npy("<f4", "(1, 3)", bytes_of<float>({1, 2, 0.25f})));
  CHECK(from_single.position == std::vector<Vector3d>{{1, 2, 0.25}});
  CHECK(rows_from_npy(npy("<f8", "(0, 3)", "")).position.empty());
}

TEST_CASE("Body files: what is no n by 3 array is refused", "[files]") {
  const std::string data = bytes_of<double>({1, 2, 3, 4, 5, 6});
  const auto npy_refusal = [](const std::string& bytes) { return refusal([&] { rows_from_npy(bytes); }); };
  CHECK(contains(npy_refusal(npy("<f8", "(3, 2)", data)), "its shape is (3, 2), expected (n, 3)"));
  CHECK(contains(npy_refusal(npy("<f8", "(6,)", data)), "its shape is (6,)"));
  CHECK(contains(npy_refusal(npy("<f8", "(1, 2, 3)", data)), "its shape is"));
  CHECK(contains(npy_refusal(npy("<i8", "(2, 3)", data)), "its type is '<i8'"));
  CHECK(contains(npy_refusal(npy("<f8", "(2, 3)", data, "True")), "Fortran order"));
  CHECK(contains(npy_refusal(npy("<f8", "(3, 3)", data)), "ends after 2 of 3 rows"));
  CHECK(contains(npy_refusal(npy("<f8", "(99999999999999999999, 3)", data)), "its shape is"));
  CHECK(contains(npy_refusal(npy("<f8", "(9223372036854775807, 3)", data)), "ends after 2 of"));
  CHECK(contains(npy_refusal("x,y,z\n1,2,3\n"), "no .npy file"));
  CHECK(contains(npy_refusal(std::string("\x93NUMPY\x01\x00\xff\xff{}", 12)), "ends inside its header"));
  CHECK(contains(npy_refusal(""), "no .npy file"));
}

TEST_CASE("Body files: .csv has named columns in any order", "[files]") {
  const auto rows = rows_from_csv("id,mass,z,y,x,vx,vy,vz\r\n0, 2.5,3,2,1,4,5,6\r\n1,1e-3,6,5,4,0,0,-1\r\n\r\n");
  CHECK(rows.mass == std::vector<double>{2.5, 1e-3});
  CHECK(rows.position == std::vector<Vector3d>{{1, 2, 3}, {4, 5, 6}});
  CHECK(rows.velocity == std::vector<Vector3d>{{4, 5, 6}, {0, 0, -1}});
  CHECK(rows.orientation.empty());
  const auto turned = rows_from_csv("x,y,z,qw,qx,qy,qz,wx,wy,wz,radius\n0,0,0,0.5,0.5,-0.5,0.5,1,2,3,0.1\n");
  CHECK(turned.orientation.at(0).y == -0.5);
  CHECK(turned.angular_velocity.at(0) == Vector3d(1, 2, 3));
  CHECK(turned.radius == std::vector<double>{0.1});
}

TEST_CASE("Body files: what a .csv cannot mean is refused with line and column", "[files]") {
  const auto csv_refusal = [](const std::string& text) { return refusal([&] { rows_from_csv(text); }); };
  CHECK(contains(csv_refusal("x,y\n1,2\n"), "has no column z, expected all of x, y, z or none"));
  CHECK(contains(csv_refusal("x,y,z,mas\n1,2,3,4\n"), "unknown column \"mas\""));
  CHECK(contains(csv_refusal("x,y,z,mas\n1,2,3,4\n"), "did you mean \"mass\"?"));
  CHECK(contains(csv_refusal("x,y,z,x\n1,2,3,4\n"), "twice"));
  CHECK(contains(csv_refusal("x,y,z\n1,2,3\n1,two,3\n"), "line 3, column y: \"two\" given, expected a number"));
  CHECK(contains(csv_refusal("x,y,z\n1,2\n"), "line 2: expected 3 numbers"));
  CHECK(contains(csv_refusal("x,y,z\n1,2,3,4\n"), "line 2: expected 3 numbers"));
  CHECK(contains(csv_refusal("id,x,y,z\n1,0,0,0\n0,0,0,0\n"), "not in the order of id"));
  CHECK(contains(csv_refusal(""), "is empty"));
}

TEST_CASE("Body files: found beside the scene file, and problems point at the key", "[files]") {
  const ScratchFolder folder;
  written(folder, "rows.csv", "x,y,z,vx,vy,vz\n1,2,3,0,0,0\n4,5,6,0,0,nan\n");
  written(folder, "good.csv", "x,y,z\n1,2,3\n4,5,6\n");
  const auto problem = [&](const std::string& name, const std::string& more = "") {
    const std::string path = written(folder, "scene.toml", scene_with_file + "\"" + name + "\"\n" + more);
    try {
      ballpark::scenes::load(path);
    } catch (const ballpark::scenes::SceneFileError& error) {
      return error.problems().at(0);
    }
    return LocatedProblem{};
  };
  CHECK(problem("good.csv").message.empty());
  CHECK(ballpark::scenes::load(folder.file("scene.toml")).scene.bodies[0].position.size() == 2);
  CHECK(problem("rows.csv").key == "bodies[0].velocity[1]");
  CHECK(problem("rows.csv").location.line == 7);
  CHECK(problem("rows.csv").location.column == 8);
  CHECK(problem("absent.csv").key == "bodies[0].file");
  CHECK(contains(problem("absent.csv").message, "\"absent.csv\": no such file"));
  CHECK(contains(problem("rows.txt").message, "expected a file name with .npy or .csv"));
  const LocatedProblem twice = problem("good.csv", "position = [0, 0, 0]\n");
  CHECK(twice.key == "bodies[0].position");
  CHECK(twice.location.line == 8);
  CHECK(contains(twice.message, "good.csv"));
}
