// Frames on their way to the thread that writes them.
#include "scenarios/command/series.h"

#include <filesystem>

#include "scenarios/command/errors.h"
#include "tests/catch.h"
#include "tests/unit/command/falling.h"
#include "tests/unit/command/scratch_folder.h"

using namespace ballpark::command;

namespace {

/// What the same frames give without a thread.
std::string written_at_once(const ballpark::scenes::OutputRequest& request, const ballpark::Scene& scene, int frames) {
  ballpark::World world(scene);
  Filming film(request, scene, world);
  for (int frame = 0; frame < frames; ++frame) {
    film.add(world);
    world.step();
  }
  film.file->finish();
  return contents(request.file);
}

ballpark::Scene many_bodies() {
  ballpark::Scene scene = falling(false);
  scene.bodies[0].position.clear();
  ballpark::Generate lattice;
  lattice.kind = "lattice";
  lattice.count = {20, 20, 20};
  lattice.spacing = 1;
  scene.bodies[0].generate = lattice;
  return scene;
}

}  // namespace

TEST_CASE("a series holds all frames in order, small ones and large ones", "[command]") {
  const ScratchFolder folder;
  for (const bool large : {false, true}) {
    const ballpark::Scene scene = large ? many_bodies() : falling(true);
    const int frames = large ? 20 : 5000;
    for (const char* ending : {".csv", ".npz", ".xyz"}) {
      const auto request = request_of(folder.file(std::string("a") + ending));
      Series series(request, scene);
      ballpark::World world(scene);
      for (int frame = 0; frame < frames; ++frame) {
        series.add(world);
        world.step();
      }
      CHECK(series.finish());
      CHECK_FALSE(series.news());
      CHECK(series.cost().frames == static_cast<std::size_t>(frames));
      CHECK(series.cost().bytes == std::filesystem::file_size(request.file));
      CHECK(series.cost().writing > 0);
      const std::string written = contents(request.file);
      CHECK(written == written_at_once(request_of(folder.file(std::string("b") + ending)), scene, frames));
    }
  }
}

TEST_CASE("a series without a frame is a valid file", "[command]") {
  const ScratchFolder folder;
  const ballpark::Scene scene = falling(false);
  for (const char* name : {"a.csv", "a.npz", "a.xyz", "a.pvd"}) {
    Series series(request_of(folder.file(name)), scene);
    CHECK(series.finish());
  }
  CHECK(contents(folder.file("a.csv")) == "time,id,x,y,z,vx,vy,vz\n");
  CHECK(contents(folder.file("a.pvd")).ends_with("<Collection>\n</Collection>\n</VTKFile>\n"));
}

TEST_CASE("a series that is given up leaves no file", "[command]") {
  const ScratchFolder folder;
  const ballpark::Scene scene = many_bodies();
  const ballpark::World world(scene);
  for (const char* name : {"a.csv", "a.npz", "a.xyz"}) {
    Series series(request_of(folder.file(name)), scene);
    for (int frame = 0; frame < 5; ++frame) series.add(world);
  }
  CHECK(folder.entries() == 0);
}

TEST_CASE("a full disk ends a series, is told once, and the run is not held up", "[command]") {
  if (!std::filesystem::exists("/dev/full")) return;
  const ScratchFolder folder;
  const ballpark::Scene scene = many_bodies();
  const ballpark::World world(scene);
  std::filesystem::create_symlink("/dev/full", folder.file("a.csv"));
  Series series(request_of(folder.file("a.csv")), scene);
  int told = 0;
  for (int frame = 0; frame < 50; ++frame) {
    series.add(world);
    if (const auto news = series.news()) {
      ++told;
      CHECK(news->find("No space left") != std::string::npos);
    }
  }
  CHECK_FALSE(series.finish());
  told += series.news().has_value();
  CHECK(told == 1);
}

TEST_CASE("a series that cannot be written is known before the run", "[command]") {
  const ScratchFolder folder;
  for (const char* name : {"no/such/a.pvd", "no/such/a.xyz", "a.tar"}) {
    CHECK_THROWS_AS(Series(request_of(folder.file(name)), falling(false)), DestinationError);
  }
}
