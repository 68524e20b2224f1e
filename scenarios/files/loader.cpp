// load and parse: document, overrides, tables, files of rows, checks.
#include <fmt/format.h>

#include <filesystem>

#include "scenarios/files/body_file.h"
#include "scenarios/files/findings.h"
#include "scenarios/files/overrides.h"
#include "scenarios/files/requests.h"
#include "scenarios/files/stress_check.h"
#include "scenarios/files/tables.h"
#include "scenarios/files/whole_file.h"

namespace ballpark::scenes {

namespace {

constexpr std::uintmax_t largest_scene = std::uintmax_t{64} << 20;
constexpr std::uintmax_t largest_rows = std::uintmax_t{16} << 30;

[[noreturn]] void fail(const Location& location, const std::string& message) {
  std::vector<LocatedProblem> problems(1);
  problems[0].location = location;
  problems[0].message = message;
  throw SceneFileError(std::move(problems));
}

Node document_of(const std::string& text, const std::string& name) {
  try {
    return parse_document(text);
  } catch (const SyntaxError& error) {
    fail({name, error.place().line, error.place().column}, error.what());
  }
}

/// Moves the rows that a file gave into the group, unless the scene gives them as well.
class Fill {
 public:
  Fill(const BodyDraft& body, std::string path, Findings& findings)
      : file_(body.file), path_(std::move(path)), findings_(findings) {}

  template <class List>
  void operator()(const char* name, List& into, List& rows) {
    if (rows.empty()) return;
    const std::string path = path_ + "." + name;
    if (!into.empty()) {
      findings_.add(
          {path, fmt::format("stands beside \"{}\", which gives it too: expected one of the two", printable(file_))});
    } else {
      findings_.mark_like(path, path_ + ".file");
    }
    into = std::move(rows);
  }

 private:
  const std::string& file_;
  std::string path_;
  Findings& findings_;
};

void fill(BodyDraft& body, BodyGroup rows, const std::string& path, Findings& findings) {
  Fill into(body, path, findings);
  into("mass", body.mass, rows.mass);
  into("radius", body.radius, rows.radius);
  into("position", body.position, rows.position);
  into("velocity", body.velocity, rows.velocity);
  into("angular_velocity", body.angular_velocity, rows.angular_velocity);
  into("orientation", body.orientation, rows.orientation);
}

void fill_from_files(Draft& draft, const std::filesystem::path& folder, Findings& findings) {
  for (std::size_t i = 0; i < draft.bodies.size(); ++i) {
    BodyDraft& body = draft.bodies[i];
    if (body.file.empty()) continue;
    const std::string path = fmt::format("bodies[{}]", i);
    try {
      fill(body, rows_from_file(folder / body.file), path, findings);
      draft.file.body_files.push_back((folder / body.file).string());
    } catch (const std::runtime_error& error) {
      findings.add({path + ".file", fmt::format("\"{}\": {}", printable(body.file), error.what())});
    }
  }
}

void add_new(const std::vector<Problem>& problems, Findings& findings) {
  std::vector<Problem> news;
  for (const Problem& problem : problems) {
    if (!findings.covers(problem.path)) news.push_back(problem);
  }
  for (const Problem& problem : news) findings.add(problem);
}

/// step = "auto" as a number.
void find_step(Scene& scene, Findings& findings) {
  if (!scene.run.automatic_step) return;
  try {
    scene.run.step = automatic_step(scene);
    scene.run.automatic_step = false;
  } catch (const SceneError& error) {
    add_new(error.problems(), findings);
  }
}

}  // namespace

BodyGroup rows_from_file(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".npy") return rows_from_npy(whole_file(path, largest_rows));
  if (extension == ".csv") return rows_from_csv(whole_file(path, largest_rows));
  throw std::runtime_error("expected a file name with .npy or .csv");
}

SceneFile parse(const std::string& text, const std::string& name, const std::vector<Override>& overrides) {
  Findings findings(name, overrides);
  Node document = document_of(text, name);
  apply(overrides, document, findings);
  Draft draft;
  read_tables(document, draft, findings);
  fill_from_files(draft, std::filesystem::path(name).parent_path(), findings);
  SceneFile file = std::move(draft.file);
  for (BodyDraft& body : draft.bodies) file.scene.bodies.push_back(std::move(body));
  if (file.scene.name.empty()) file.scene.name = std::filesystem::path(name).stem().string();
  add_new(check(file.scene), findings);
  add_new(check_requests(file), findings);
  add_new(check_stress(file), findings);
  findings.fail_if_any();
  find_step(file.scene, findings);
  findings.fail_if_any();
  file.path = name;
  file.locations = findings.locations();
  return file;
}

SceneFile load(const std::string& path, const std::vector<Override>& overrides) {
  std::string text;
  try {
    text = whole_file(path, largest_scene);
  } catch (const std::runtime_error& error) {
    fail({path, 0, 0}, error.what());
  }
  return parse(text, path, overrides);
}

}  // namespace ballpark::scenes
