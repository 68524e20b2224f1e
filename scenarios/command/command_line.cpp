// The only file that includes CLI11: it costs seconds to compile.
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "ballpark/catalogue.h"
#include "scenarios/command/arguments.h"
#include "scenarios/command/commands.h"
#include "scenarios/command/errors.h"
#include "scenarios/command/help_text.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

constexpr std::size_t help_width = 80, option_column = 24;

struct Option {
  const char *name, *value, *doc;
  std::optional<std::string> Arguments::*member;
};

constexpr Option scene_options[] = {
    {"--threads", "N", "worker threads (default: all cores); no bit depends on it", &Arguments::threads},
    {"--precision", "P", "single, double or extended, instead of the scene's", &Arguments::precision},
    {"--target", "T", "instruction set, see `list targets` (default: auto, the fastest)", &Arguments::target},
    {"--copies", "K", "run K independent copies as one batch; copy k has seed + k", &Arguments::copies},
    {"--perturb", "E", "move each copy's start by relative E", &Arguments::perturb},
    {"--path", "PATH", "automatic, fused or staged (default: automatic)", &Arguments::path},
};
constexpr Option run_options[] = {
    {"--state", "FILE", "write the state at the end as CSV", &Arguments::state},
    {"--figure", "FILE", "energy, momenta, contacts and speed over time, as .svg", &Arguments::figure},
    {"--every", "S", "with --out: a frame every S seconds of simulated time", &Arguments::every},
    {"--out", "FILE", "write the frames: .npz, .csv, .xyz, or .pvd with .vtp", &Arguments::out},
    {"--columns", "LIST",
     "of position, velocity, orientation, angular_velocity, radius, contacts, contact_force (default: what bodies "
     "carry)",
     &Arguments::columns},
    {"--out-precision", "P", "single or double, of the numbers in --out (default: single in .vtp, else double)",
     &Arguments::out_precision},
};
constexpr Option view_options[] = {
    {"--out", "FILE", "what is written (default: SCENE.html, with --still SCENE.png)", &Arguments::out},
    {"--frames", "N", "frames, from the start to the end (default: 301)", &Arguments::frames},
    {"--every", "S", "or one every S seconds of simulated time", &Arguments::every},
    {"--max-size", "SIZE", "of the page (default: 30M); bodies are left out to keep it", &Arguments::max_size},
    {"--columns", "LIST", "of position, orientation, speed, energy, contacts (default: the first three)",
     &Arguments::columns},
    {"--with", "SCENE", "this one too, in step with it", &Arguments::with},
    {"--scene", "SCENE", "of a recorded file: what was run, for radii, groups and boundaries", &Arguments::scene},
    {"--compare", "KEY=LIST", "a run for each value, for example integrator=euler,rk4", &Arguments::compare},
};
constexpr Option still_options[] = {
    {"--still", "T", "a picture of the moment T [s] instead of a page, .png or .svg", &Arguments::still},
    {"--size", "WxH", "pixels (default: 1280x800)", &Arguments::size},
    {"--colour", "WORD", "by speed, group or plain (default: speed)", &Arguments::colour},
    {"--from", "X,Y,Z", "direction to look from (default: obliquely, or before the plane of a flat motion)",
     &Arguments::from},
};
constexpr Option profile_options[] = {
    {"--steps", "N", "steps of each repeat (default: as many as the time allows)", &Arguments::steps},
    {"--seconds", "S", "time for all measuring, about (default: 5)", &Arguments::seconds},
};

constexpr Option cost_options[] = {
    {"--integrators", "LIST", "only these, for example rk4,velocity_verlet", &Arguments::integrators},
    {"--steps", "LIST", "only these fixed steps [s], for example 1e-2,1e-3", &Arguments::axis_steps},
    {"--tolerances", "LIST", "only these tolerances of adaptive integrators", &Arguments::tolerances},
    {"--precisions", "LIST", "of single, double, extended (default: single,double)", &Arguments::precisions},
    {"--rotations", "LIST", "of renormalise, exponential, splitting, body, where bodies turn (default: all)",
     &Arguments::rotations},
    {"--contacts", "LIST",
     "of impulse, penalty, iterations x substeps (12x4) and penalty:STIFFNESS [N/m], where bodies touch (default: "
     "both)",
     &Arguments::axis_contacts},
    {"--openings", "LIST",
     "opening angles of mutual_gravity's tree, where 256 bodies or more attract each other; 0: every pair (default: "
     "the scene's, 0, 0.3, 0.5, 0.7 and 1)",
     &Arguments::openings},
    {"--error", "E",
     "what an error is: position, velocity, orientation or spin, and .maximum along the path, .rms or "
     ".end (default: position.maximum, or orientation)",
     &Arguments::error},
    {"--reference", "R", "best, numerical (no closed form) or runs (the two finest runs)", &Arguments::reference},
    {"--seconds", "S", "time for all measuring, about (default: 60)", &Arguments::seconds},
};
constexpr Option order_options[] = {
    {"--integrators", "LIST", "only these, for example rk4,velocity_verlet", &Arguments::integrators},
    {"--error", "E", "what an error is, see `cost` (default: position.maximum, or orientation)", &Arguments::error},
    {"--reference", "R", "best, numerical (no closed form) or runs (the two finest runs)", &Arguments::reference},
    {"--seconds", "S", "time for all measuring, about (default: 20)", &Arguments::seconds},
};
constexpr Option ablate_options[] = {
    {"--tolerance", "E", "a change of at most E is worth losing an effect (default: 1 % of how far things go)",
     &Arguments::tolerance},
    {"--error", "E", "what is held against the full scene, see `cost` (default: position.end, or orientation.end)",
     &Arguments::error},
    {"--reference", "R", "of the full scene's own error: best, numerical or runs, see `cost`", &Arguments::reference},
    {"--seconds", "S", "time for all measuring, about (default: 30)", &Arguments::seconds},
};
constexpr Option prices_options[] = {
    {"--bodies", "N", "of the large scenes (default: 1000000)", &Arguments::bodies},
    {"--seconds", "S", "time for all measuring, about (default: 60)", &Arguments::seconds},
};
constexpr Option stress_options[] = {
    {"--threads", "N", "worker threads (default: all cores); no bit depends on it", &Arguments::threads},
};
constexpr Option cost_choices[] = {
    {"--tolerance", "E", "name the cheapest setting whose error is at most E", &Arguments::tolerance},
    {"--budget", "T", "name the most accurate setting of at most T (2ms) a simulated second", &Arguments::budget},
    {"--svg", "FILE", "the work-precision figure", &Arguments::svg},
    {"--html", "FILE", "the same as an interactive page that opens offline", &Arguments::html},
    {"--csv", "FILE", "all points", &Arguments::csv},
};

struct Command {
  const char *name, *word, *word_doc, *doc, *footer;
  bool takes_scene;
  std::span<const Option> own_options;
  const char* own_group;
  std::span<const Option> more_options = {};
  const char* more_group = "";
};

/// Commands whose word may be left out.
bool takes_no_word(const std::string& command) {
  return command == "list" || command == "prices" || command == "stress";
}

constexpr const char* scene_doc = "a scene file, or a scenario's name";

const Command commands[] = {
    {"list",
     "WHAT",
     "scenarios, integrators, effects, shapes, contacts, targets or stress (default: all)",
     "Show what there is.",
     help::list,
     false,
     {},
     ""},
    {"describe",
     "NAME",
     "a name that `ballpark list` shows, or: scene",
     "Explain one thing by its name.",
     help::describe,
     false,
     {},
     ""},
    {"run", "SCENE", scene_doc, "Simulate a scene and print what happened.", help::run, true, run_options, "Files"},
    {"explain", "SCENE", scene_doc, "Show what a scene makes the engine do, and why.", help::explain, true, {}, ""},
    {"check", "SCENE", scene_doc, "Validate a scene without running it.", help::check, true, {}, ""},
    {"view", "SCENE", "a scene file, a scenario's name, or a recorded .npz or .csv",
     "Write a page that plays a scene's motion, or a picture of a moment.", help::view, true, view_options, "Page",
     still_options, "Picture"},
    {"profile", "SCENE", scene_doc, "Measure where the time goes, and thread scaling.", help::profile, true,
     profile_options, "Measuring"},
    {"cost", "SCENE", scene_doc, "Measure error against wall time over the ways to run a scene.", help::cost, true,
     cost_options, "What to try", cost_choices, "What to name and write"},
    {"order", "SCENE", scene_doc, "Measure the order that each integrator shows on a scene.", help::order, true,
     order_options, "Measuring"},
    {"ablate", "SCENE", scene_doc, "Drop each effect in turn: time saved, error added.", help::ablate, true,
     ablate_options, "Measuring"},
    {"prices", "SCENE", "a scene file, or a scenario's name (default: none, only effects by themselves)",
     "Measure the time that each effect adds to a step.", help::prices, true, prices_options, "Measuring"},
    {"stress", "NAME", "hard cases, see `list stress`, or scene files with [stress] (default: all quick ones)",
     "Run the hard cases, and say which of their limits hold.", help::stress, false, stress_options, "Running"},
};

/// CLI11's help, with descriptions wrapped to the page and usage lines that name the word.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const std::string name = make_option_name(option, is_positional);
    return entry(name + (is_positional ? "" : make_option_opts(option)), option->get_description());
  }
  std::string make_subcommand(const CLI::App* command) const override {
    return entry(command->get_name(), command->get_description());
  }
  std::string make_description(const CLI::App* app) const override { return app->get_description() + "\n\n"; }
  std::string make_usage(const CLI::App* app, std::string) const override {
    return app->get_parent() ? fmt::format("Usage: ballpark {} {} [options]\n", app->get_name(), word_of(app))
                             : "Usage: ballpark COMMAND ... [options]      (ballpark COMMAND --help for more)\n";
  }

 private:
  static std::string word_of(const CLI::App* app) {
    const auto words = app->get_options([](const CLI::Option* option) { return option->get_positional(); });
    const std::string word = words.front()->get_name(true);
    return takes_no_word(app->get_name()) ? "[" + word + "]" : word;
  }
  static std::string entry(const std::string& name, const std::string& doc) {
    std::string text = "  " + name;
    for (const std::string& line : wrapped(doc, help_width - option_column)) {
      text.resize(std::max(text.size() + 2, text.rfind('\n') + 1 + option_column), ' ');
      text += line + '\n';
    }
    return text;
  }
};

void add_option(CLI::App& app, const Option& option, Arguments& arguments, const char* group) {
  const auto store = [&arguments, member = option.member](const std::string& text) { arguments.*member = text; };
  app.add_option_function<std::string>(option.name, store, option.doc)
      ->option_text(option.value)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->group(group);
}

void add_common(CLI::App& app, Arguments& arguments) {
  const auto json = [&arguments](const std::string& file) { arguments.json = file == "-" ? "" : file; };
  app.add_option_function<std::string>("--json", json, "JSON to FILE, or to standard output instead of the text")
      ->expected(0, 1)
      ->option_text("[FILE]")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->group("Output");
  app.add_flag("--quiet", arguments.quiet, "no text, no progress, no warnings: errors and the exit code")
      ->group("Output");
  app.set_help_flag("-h,--help", "this text")->group("Output");
}

void add_command(CLI::App& program, const Command& command, Arguments& arguments) {
  CLI::App& app = *program.add_subcommand(command.name, command.doc)->group("Commands");
  app.allow_extras();
  const bool several = command.name == std::string("stress");
  several ? app.add_option(command.word, arguments.names, command.word_doc)
          : app.add_option(command.word, arguments.name, command.word_doc);
  if (command.takes_scene) {
    app.add_option("--set", arguments.overrides, "override a key of the scene; may be repeated")
        ->allow_extra_args(false)
        ->option_text("KEY=VALUE")
        ->group("Scene");
    for (const Option& option : scene_options) add_option(app, option, arguments, "Scene");
  }
  for (const Option& option : command.own_options) add_option(app, option, arguments, command.own_group);
  for (const Option& option : command.more_options) add_option(app, option, arguments, command.more_group);
  if (command.name == std::string("cost")) {
    app.add_flag("--write", arguments.write, "write the named setting into the scene file")->group(command.more_group);
  }
  if (several) {
    app.add_flag("--long", arguments.long_cases, "the long cases too, which take hours")->group(command.own_group);
  }
  if (command.name == std::string("run")) {
    app.add_flag("--ledger", arguments.ledger, "who did work on the bodies, and what the integrator lost; takes longer")
        ->group("Output");
  }
  add_common(app, arguments);
  app.footer(command.footer + std::string(command.takes_scene ? "\n" : "\n\n") +
             (command.takes_scene ? help::scene_word : "") + help::exit_codes);
}

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

[[noreturn]] void refuse_extra(const CLI::App& app, const std::vector<std::string>& extras) {
  for (const std::string& word : extras) {
    if (word.starts_with("-")) {
      const std::string near = nearest(word.substr(0, word.find('=')), option_names(app));
      const std::string hint = near.empty() ? "" : "; did you mean " + near + "?";
      const std::string command = app.get_parent() ? app.get_name() + " " : "";
      throw UsageError(fmt::format("unknown option {}{} (`ballpark {}--help` shows all)", word, hint, command));
    }
  }
  if (!app.get_parent()) throw UsageError(no_such("command", extras.front(), command_names()));
  throw UsageError(fmt::format("'{}' is one argument too many", extras.front()));
}

/// `--json projectile` means the scene, not a file to write: a word that stands alone is the command's own word.
void untangle_json(Arguments& arguments) {
  const std::vector<std::string>& sections = list_sections();
  const bool named = !arguments.name.empty() || !arguments.names.empty();
  if (named || !arguments.json || arguments.json->ends_with(".json")) return;
  if (arguments.command == "stress" && !arguments.json->empty()) {
    arguments.names = {std::exchange(*arguments.json, "")};
    return;
  }
  const bool section = std::find(sections.begin(), sections.end(), *arguments.json) != sections.end();
  if (arguments.command != "list" || section) arguments.name = std::exchange(*arguments.json, "");
}

/// CLI11 leaves two empty lines between groups of options.
std::string without_gaps(std::string text) {
  for (std::size_t at; (at = text.find("\n\n\n")) != std::string::npos;) text.erase(at, 1);
  return text;
}

void finish(const CLI::App& program, Arguments& arguments) {
  if (const auto extras = program.remaining(); !extras.empty()) refuse_extra(program, extras);
  const auto chosen = program.get_subcommands();
  if (chosen.empty()) throw UsageError("a command is missing (" + joined(command_names()) + "); try `ballpark --help`");
  if (const auto extras = chosen.front()->remaining(); !extras.empty()) refuse_extra(*chosen.front(), extras);
  arguments.command = chosen.front()->get_name();
  untangle_json(arguments);
  if (!arguments.name.empty() || takes_no_word(arguments.command)) return;
  const bool describe = arguments.command == "describe";
  throw UsageError(describe ? "NAME is missing: what shall be described? (`ballpark list` shows all names)"
                            : "SCENE is missing: a scene file or a scenario's name (`ballpark list scenarios`)");
}

}  // namespace

CommandLine read_command_line(int argc, char** argv) {
  CommandLine line;
  CLI::App program(help::program, "ballpark");
  auto formatter = std::make_shared<HelpFormatter>();
  formatter->label("Positionals", "Argument");
  program.formatter(formatter);
  program.allow_extras();
  program.require_subcommand(0, 1);
  program.set_version_flag("--version", "ballpark " + version(), "print the version");
  program.set_help_flag("-h,--help", "this text");
  for (const Command& command : commands) add_command(program, command, line.arguments);
  program.footer(std::string(help::scene_word) + help::exit_codes);
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    line.answer = Answer{without_gaps(program.help())};
    return line;
  } catch (const CLI::CallForVersion& answer) {
    line.answer = Answer{answer.what() + std::string("\n")};
    return line;
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string text = error.what();
    throw UsageError(text.substr(0, text.find(':')) + " needs a value");
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  finish(program, line.arguments);
  return line;
}

}  // namespace ballpark::command
