#include "scenarios/command/output_file.h"

#include <unistd.h>

#include <filesystem>
#include <string>

#include "scenarios/command/errors.h"
#include "tests/catch.h"
#include "tests/unit/command/scratch_folder.h"

using namespace ballpark::command;
namespace fs = std::filesystem;

TEST_CASE("a file appears only when it is whole", "[command]") {
  const ScratchFolder folder;
  OutputFile file(folder.file("a.csv"));
  file.write("one,");
  CHECK_FALSE(fs::exists(folder.file("a.csv")));
  file.write("two\n");
  file.commit();
  CHECK(contents(folder.file("a.csv")) == "one,two\n");
  CHECK(folder.entries() == 1);
}

TEST_CASE("what is not committed leaves nothing, and an old file as it was", "[command]") {
  const ScratchFolder folder;
  std::ofstream(folder.file("old.csv")) << "old";
  {
    OutputFile fresh(folder.file("fresh.csv")), old(folder.file("old.csv"));
    fresh.write("new");
    old.write("new");
  }
  CHECK(folder.entries() == 1);
  CHECK(contents(folder.file("old.csv")) == "old");
}

TEST_CASE("a bad destination is refused when it is opened", "[command]") {
  const ScratchFolder folder;
  CHECK_THROWS_AS(OutputFile(""), DestinationError);
  CHECK_THROWS_AS(OutputFile(folder.path.string()), DestinationError);
  CHECK_THROWS_AS(OutputFile(folder.file("no/such/a.csv")), DestinationError);
  CHECK_THROWS_AS(OutputFile("/dev/null", true), DestinationError);
}

TEST_CASE("a read-only file is refused, not replaced", "[command]") {
  if (geteuid() == 0) return;  // root may write anything
  const ScratchFolder folder;
  std::ofstream(folder.file("a.csv")) << "kept";
  fs::permissions(folder.file("a.csv"), fs::perms::owner_read);
  CHECK_THROWS_AS(OutputFile(folder.file("a.csv")), DestinationError);
}

TEST_CASE("a link stays a link: what it points to is replaced", "[command]") {
  const ScratchFolder folder;
  std::ofstream(folder.file("real.csv")) << "old";
  fs::create_symlink("real.csv", folder.file("link.csv"));
  OutputFile file(folder.file("link.csv"));
  file.write("new");
  file.commit();
  CHECK(fs::is_symlink(folder.file("link.csv")));
  CHECK(contents(folder.file("real.csv")) == "new");
}

TEST_CASE("a device is written in place, and a full one is an error", "[command]") {
  if (!fs::exists("/dev/full")) return;
  OutputFile file("/dev/full");
  file.write("x");
  CHECK_THROWS_AS(file.commit(), WriteError);
  CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("a folder that goes away while a file is written is an error", "[command]") {
  const ScratchFolder folder;
  fs::create_directory(folder.file("sub"));
  OutputFile file(folder.file("sub/a.csv"));
  file.write("x");
  fs::remove_all(folder.file("sub"));
  CHECK_THROWS_AS(file.commit(), WriteError);
}
