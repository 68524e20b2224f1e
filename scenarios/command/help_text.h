// What `--help` says beside the options: for each command what it does, an example, and what the words mean.
#pragma once

namespace ballpark::command::help {

inline constexpr const char* program =
    "Ballpark moves many balls and spinning bodies, and measures what it does.\n"
    "First steps:\n"
    "  ballpark list scenarios           what can be run at once\n"
    "  ballpark run projectile           run one of them\n"
    "  ballpark view break               see it: a page for your browser\n"
    "  ballpark describe scene           how to write a scene of your own";

inline constexpr const char* scene_word =
    "SCENE is a scene file (TOML), or the name of a scenario that `ballpark list\n"
    "scenarios` shows. Scenarios come from share/ballpark/scenarios beside the\n"
    "installed program, else from the source tree; set BALLPARK_SCENARIOS to a folder\n"
    "to take them from there.\n"
    "\n";

inline constexpr const char* exit_codes =
    "Exit codes:\n"
    "  0    done\n"
    "  1    an expectation was missed, or a file could not be written\n"
    "  2    bad usage, scene or destination: nothing was run\n"
    "  3    the run left its stability or accuracy contract\n"
    "  130  interrupted (Ctrl-C)";

inline constexpr const char* list =
    "Example:\n"
    "  ballpark list integrators\n"
    "\n"
    "Without a word, all sections.\n"
    "With --json: a list of objects (an object of lists without a word).";

inline constexpr const char* describe =
    "Examples:\n"
    "  ballpark describe rk4             an integrator\n"
    "  ballpark describe quadratic_drag  an effect: formula, parameters, an example\n"
    "  ballpark describe pendulum        a scenario: what it shows, how it is judged\n"
    "  ballpark describe scene           every key of a scene file\n"
    "  ballpark describe scene --json    the same as a JSON Schema, for editors";

inline constexpr const char* run =
    "Examples:\n"
    "  ballpark run projectile\n"
    "  ballpark run my.toml --set run.integrator=euler --set run.step=1e-3\n"
    "  ballpark run pendulum --every 0.01 --out pendulum.npz --state end.csv\n"
    "  ballpark run break --figure break.svg\n"
    "  ballpark run free_kick --ledger --figure work.svg\n"
    "\n"
    "A key of --set is a path in the scene file; a table is addressed by its name,\n"
    "else its kind, else its index: --set bodies.ball.mass=0.2,\n"
    "--set effects.gravity.acceleration=[0,0,-1.62]. The value is TOML; a plain word\n"
    "needs no quotes.\n"
    "\n"
    "Series (--out, [[output]]) hold time, id, position and velocity, and where\n"
    "bodies carry them orientation and angular velocity; their ending says how:\n"
    "  .npz        numpy.load: arrays time [T], id [N], position, velocity [T,N,3],\n"
    "              orientation [T,N,4] (w,x,y,z); stored, not compressed\n"
    "  .csv        a row per time and body\n"
    "  .xyz        extended XYZ for OVITO and ASE, in SI; orientation is x,y,z,w\n"
    "  .pvd, .vtp  ParaView: a file NAME_0000.vtp each frame, NAME.pvd to open\n"
    "contacts [T,N] and contact_force [T,N,3] in N are there if --columns asks for\n"
    "them: of the contacts that press on a body now, or, under impulse, did so in the\n"
    "last substep, without impacts.\n"
    "What OVITO and ParaView draw has radii too; .vtp is in single precision unless\n"
    "--out-precision says otherwise. Another thread writes; the summary says what\n"
    "that took. --state has a row per body, 17 digits. --figure has 301 moments, at\n"
    "most one a step; of an overlap, the deepest so far.\n"
    "\n"
    "--ledger integrates the work of each effect and of contacts for itself, force\n"
    "times velocity at four moments of each step: what the change of the kinetic\n"
    "energy has beyond their sum is the integrator's error. No bit of the motion\n"
    "depends on it.\n"
    "\n"
    "Paths are relative to the current folder. .vtp appear frame by frame, the rest\n"
    "whole at the end. After Ctrl-C or kill series and --figure hold what there was\n"
    "so far, and --state is not written.\n";

inline constexpr const char* explain =
    "Example:\n"
    "  ballpark explain dust\n"
    "\n"
    "Shows what exists for the scene and why: path, groups, columns, passes, bytes\n"
    "and flops per body, what was narrowed and what is off. Nothing is stepped.\n";

inline constexpr const char* check =
    "Example:\n"
    "  ballpark check my.toml && ballpark run my.toml\n"
    "\n"
    "Prints `ok: ...`, or each problem as file:line:column: key: message on standard\n"
    "error (exit code 2). With --json the problems are on standard output as well.\n";

inline constexpr const char* view =
    "Examples:\n"
    "  ballpark view break\n"
    "  ballpark view pendulum --compare integrator=euler,rk4 --out euler.html\n"
    "  ballpark view break --still 0.5 --out break.png\n"
    "  ballpark view recorded.npz --scene break\n"
    "\n"
    "Runs the scene and writes one file that plays it in a browser, offline.\n"
    "Positions are rounded to 1/65535 of the box that holds them all; the page tells\n"
    "to how many metres. Balls that spin are given orientations, which show it, up\n"
    "to 1,000 bodies, or where --columns asks for them. contacts: bodies and walls\n"
    "that a body touches. At most 100,000 bodies are shown, and no more than there is\n"
    "room for in --max-size, and in 1 GB of memory for the frames: of more, every\n"
    "k-th of each group, said so.\n"
    "\n"
    "--with and --compare play runs side by side at the same times; --set applies to\n"
    "all of them. A KEY of --compare without a dot is one of [run].\n"
    "--still: the camera sees all places where bodies were until then.\n"
    "\n"
    "A series that `ballpark run --out` wrote as .npz or .csv is shown as it is, with\n"
    "what it holds; a picture is of its nearest frame. --scene tells which scene was\n"
    "run, whose radii, groups, masses and boundaries are not in the file (radii are\n"
    "if its columns say so).\n"
    "After Ctrl-C the page holds the frames so far.\n";

inline constexpr const char* profile =
    "Example:\n"
    "  ballpark profile dust --threads 4\n"
    "\n"
    "First each pass on all threads: calls, time, share of the time, ns and bytes per\n"
    "body-step, GB/s, and that as a share of the machine's streaming bandwidth\n"
    "(STREAM triad, measured in the same run). Then throughput at 1..N threads, in\n"
    "interleaved repeats that all start from the scene's start.\n";

inline constexpr const char* cost =
    "Examples:\n"
    "  ballpark cost pendulum --html pendulum.html\n"
    "  ballpark cost my.toml --tolerance 1e-6 --write\n"
    "  ballpark cost kepler --integrators rk4,yoshida4,dormand_prince8 --seconds 10\n"
    "  ballpark cost bounce --contacts 12x1,12x4,penalty:1e6\n"
    "\n"
    "Runs the scene by every integrator that it takes, from coarse steps to fine ones\n"
    "(tolerances likewise), six of them in single precision too, and with other\n"
    "rotation updates where bodies turn. Each run's error is held against a closed\n"
    "form if every body has one; else against extrapolation in extended precision at\n"
    "two tolerances; else against the finest of two runs. No error below ten times\n"
    "the reference's own is claimed. Whole runs are timed in turns, from the scene's\n"
    "start, on the code path of `ballpark run`; errors are looked at 20 times,\n"
    "between the steps if need be. Of a scene with [[event]]s, the times of events\n"
    "are compared as well, in a run of its own.\n"
    "\n"
    "Where bodies touch, contacts of the scene's formulation and of the other one are\n"
    "tried: by impulse with more and fewer iterations and substeps, by penalty with\n"
    "softer and stiffer springs than those that stop the fastest impact within 1 % of\n"
    "the smallest radius. The reference has the scene's own contacts: errors of\n"
    "others hold the difference of the models too.\n"
    "\n"
    "--tolerance: with a margin of 2, and proved by a fresh run; exit code 1 if\n"
    "nothing that was tried is accurate enough. --write changes integrator, step or\n"
    "tolerances, precision, rotation and contacts in the scene file, nothing else.\n"
    "Where runs that start almost alike part (chaos), errors of paths are told up to\n"
    "that horizon only. Beyond it, ensembles of 10 runs are compared at the end: of\n"
    "the scene's own setting, and of those on the front, where there is time.\n"
    "--copies asks for more runs, and gives them more of the time (--perturb: how far\n"
    "apart they start, relatively). Their means (energies, speed, centre,\n"
    "spread, deepest overlap) stand with intervals of 95 % beside those of a\n"
    "reference; above 2 standard errors the effect of a method is seen. The output\n"
    "says which it did.\n";

inline constexpr const char* order =
    "Example:\n"
    "  ballpark order bounce\n"
    "\n"
    "Halves the step of every integrator that the scene takes, down to rounding, and\n"
    "shows how the error falls: by 2^p for a method of order p. Where bodies touch it\n"
    "falls slower: the table says by how much.\n";

inline constexpr const char* ablate =
    "Examples:\n"
    "  ballpark ablate break\n"
    "  ballpark ablate my.toml --tolerance 0.01 --json worth.json\n"
    "\n"
    "Runs the scene without each of its effects in turn, with the scene's own\n"
    "integrator and step, and holds each run against that of the full scene: how far\n"
    "the body that moved most is off at the end, the energy there (as the full scene\n"
    "counts it), what the scene expects ([[expect]]), and when and where its events\n"
    "are. Beside that stands the full scene's own numerical error: of paths as `cost`\n"
    "measures it, of other numbers twice the difference to steps half as long. No\n"
    "change below it is claimed.\n"
    "\n"
    "Whole runs are timed in turns, the full one thrice: how far those are apart is\n"
    "the noise, below which no time shows. What an effect alone asked for (spin, a\n"
    "grid) goes with it, and counts as its time.\n"
    "\n"
    "`keep it`: the change is larger than --tolerance, or the scene then misses what\n"
    "it expects, or an event is gone. `it may go`: it is not, though no time shows.\n"
    "Where runs that start almost alike part (chaos), paths are compared before that\n"
    "horizon only, and beyond it means over ensembles decide, if there is time for\n"
    "them (--copies, --perturb: as of `cost`).\n";

inline constexpr const char* prices =
    "Examples:\n"
    "  ballpark prices\n"
    "  ballpark prices curveball --seconds 10\n"
    "\n"
    "What each effect adds to a step of rk4, by itself: free particles (or balls, or\n"
    "bodies with inertia, whichever the effect takes first) beside the same with the\n"
    "effect, many of them, so that memory counts, and few that stay in cache. Times\n"
    "are of one thread unless --threads says more, in ns a body and step, least and\n"
    "median, in both precisions unless --precision names one. Runs with and without\n"
    "are timed in turns, those without thrice: prices in parentheses are within their\n"
    "noise. B and flops are what a body-step moves and computes more, as `explain`\n"
    "counts them; a column that an effect asks for is part of its price.\n"
    "\n"
    "With a SCENE: its own effects alone, and what a step of the scene takes less\n"
    "without each of them.\n";

inline constexpr const char* stress =
    "Examples:\n"
    "  ballpark stress\n"
    "  ballpark stress x02_stiff_spring x13_comet --json limits.json\n"
    "  ballpark stress my_hard_case.toml\n"
    "\n"
    "Each hard case is a scene file: its criterion stands in [[expect]], and [stress]\n"
    "lists the ways to run it: integrator, contacts, precision, or any other key.\n"
    "Owed ways must hold, and set the exit code; shown ones stand beside them,\n"
    "whatever comes of them. Of several numbers the table has the one that decides:\n"
    "the first that is missed, else the one nearest its limit; --json has all. Where\n"
    "the engine must refuse a scene, or report its run, that and nothing else holds.\n"
    "`describe NAME` tells what a case is about.\n"
    "\n"
    "Exit code 1: an owed way does not hold.";

}  // namespace ballpark::command::help
