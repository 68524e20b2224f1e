// ballpark: the program. Reads the command line, hands over to a command, turns errors into exit codes.
#include <fmt/format.h>

#include <csignal>
#include <exception>
#include <map>
#include <new>

#include "ballpark/scenes.h"
#include "scenarios/command/arguments.h"
#include "scenarios/command/commands.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

Exit dispatch(const CommandLine& line) {
  if (line.answer) {
    print(line.answer->text);
    return done;
  }
  using Command = Exit (*)(const Arguments&);
  static const std::map<std::string, Command> commands{{"list", list},
                                                       {"describe", describe},
                                                       {"run", run},
                                                       {"explain", explain},
                                                       {"check", check_scene},
                                                       {"view", view_motion},
                                                       {"profile", profile},
                                                       {"cost", cost_of_accuracy},
                                                       {"order", order_of_accuracy},
                                                       {"ablate", ablate_effects},
                                                       {"prices", prices_of_effects},
                                                       {"stress", stress}};
  return commands.at(line.arguments.command)(line.arguments);
}

void complain_about(const SceneError& error) {
  for (const Problem& problem : error.problems()) {
    complain(problem.path.empty() ? problem.message : problem.path + ": " + problem.message);
  }
}

/// A line each, as compilers write them: editors find the place.
void complain_about(const scenes::SceneFileError& error) {
  std::fprintf(stderr, "%s\n", error.what());
  complain(counted(error.problems().size(), "problem", "problems") + "; nothing was run");
}

Exit guarded(int argc, char** argv) {
  try {
    return dispatch(read_command_line(argc, argv));
  } catch (const UsageError& error) {
    complain(error.what());
  } catch (const DestinationError& error) {
    complain(error.what());
  } catch (const scenes::SceneFileError& error) {
    complain_about(error);
  } catch (const SceneError& error) {
    complain_about(error);
  } catch (const std::bad_alloc&) {
    complain("not enough memory for this scene");
  } catch (const std::exception& error) {
    complain(error.what());
    return check_failed;
  }
  return bad_usage;
}

}  // namespace
}  // namespace ballpark::command

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that has gone must not stop a run that also writes files
  return ballpark::command::guarded(argc, argv);
}
