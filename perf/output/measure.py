"""Measures what output costs: on the thread that writes, and in time of the run. Runs with and without output take turns.
Exit code 1 with --check-bars if a figure misses its bar."""

import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile

GRAINS = """
[run]
duration = 1.0
step = 0.01
integrator = "rk4"
[[bodies]]
name = "grains"
mass = 1.0
generate = { kind = "random", count = 100000, upper = [1.0, 1.0, 1.0], velocity_spread = [1.0, 1.0, 1.0] }
[[effects]]
kind = "gravity"
"""
STEP = {"ball_rain": 1 / 60, "dust": 0.01}
# Ending, precision of numbers, and the most that positions may cost [ns per body and frame].
FORMATS = [("vtp", "single", 20), ("npz", "single", 20), ("npz", "double", 50), ("vtp", "double", None),
           ("xyz", "single", None), ("csv", "double", None)]
SLOWER = {"ball_rain": 0.05, "dust": None}  # the most by which one frame in ten steps may slow a run


def arguments():
    parser = argparse.ArgumentParser(prog="perf/output/run", description=__doc__)
    parser.add_argument("program", help=argparse.SUPPRESS)
    parser.add_argument("--rounds", type=int, default=5, help="repeats of each run (default: 5)")
    parser.add_argument("--threads", type=int, default=2, help="of runs that output slows (default: 2)")
    parser.add_argument("--seconds", type=float, default=5, help="simulated, of ball_rain (default: 5)")
    parser.add_argument("--folder", help="where the files go for a while (default: that of temporary files)")
    parser.add_argument("--check-bars", action="store_true", help="exit with 1 if a figure misses its bar")
    return parser.parse_args()


def report_of(program, folder, words):
    words = [program, "run", *map(str, words), "--quiet", "--json"]
    done = subprocess.run(words, cwd=folder, stdout=subprocess.PIPE, check=False)
    if done.returncode > 1:  # a missed expectation is no matter here
        raise SystemExit(f"{' '.join(words)}: exit code {done.returncode}")
    for file in pathlib.Path(folder).glob("a*"):
        file.unlink()
    return json.loads(done.stdout)


def judged(value, bar, unit):
    return "" if bar is None else f"  bar {bar:g}{unit}: {'met' if value <= bar else 'MISSED'}"


def writing_costs(options, folder):
    """ns per body and frame of positions, by the writing thread alone: the least of all rounds."""
    print("Positions of 100,000 bodies, by the thread that writes [ns per body and frame]")
    print("  file  numbers   processor    clock")
    met = True
    for ending, precision, bar in FORMATS:
        (pathlib.Path(folder) / "grains.toml").write_text(GRAINS)
        output = ["grains.toml", "--threads", 1, "--every", 0.04, "--out", "a." + ending, "--columns", "position", "--out-precision", precision]
        costs = [report_of(options.program, folder, output) for _ in range(options.rounds)]
        bodies = costs[0]["bodies"] * costs[0]["outputs"][0]["frames"]
        processor, clock = (min(cost["outputs"][0][of] for cost in costs) * 1e9 / bodies
                            for of in ("writing_cpu_seconds", "writing_seconds"))
        print(f"  .{ending}  {precision}  {processor:10.1f} {clock:8.1f}{judged(processor, bar, ' ns')}")
        met &= bar is None or processor <= bar
    return met


def taken(report):
    """Seconds of the run: stepping, and standing still for output."""
    return report["wall_seconds"] + sum(o["copying_seconds"] + o["waiting_seconds"] for o in report["outputs"])


def slow_down(options, folder, scene, output):
    """By how much a run with output takes longer: the median of pairs in turns."""
    words = [scene, "--threads", options.threads]
    words += ["--set", f"run.duration={options.seconds}"] if scene == "ball_rain" else []
    output = output + ["--every", 10 * STEP[scene]]
    ratios = []
    for turn in range(options.rounds):
        pair = [words, words + output] if turn % 2 == 0 else [words + output, words]
        reports = [report_of(options.program, folder, each) for each in pair]
        plain, filmed = reports if turn % 2 == 0 else reversed(reports)
        ratios.append(taken(filmed) / taken(plain) - 1)
    still = (taken(filmed) - filmed["wall_seconds"]) / taken(filmed)
    return statistics.median(ratios), still


def slow_downs(options, folder):
    print(f"\nOne frame in ten steps, {options.threads} threads and one that writes: the run is slower by")
    met = True
    for scene, bar in SLOWER.items():
        for name, output in (("positions, .vtp", ["--out", "a.vtp", "--columns", "position"]),
                             ("all columns, .npz", ["--out", "a.npz"])):
            slower, still = slow_down(options, folder, scene, output)
            print(f"  {scene:9}  {name:17} {100 * slower:6.1f} %, standing still {100 * still:4.1f} %"
                  f"{judged(100 * slower, bar and 100 * bar, ' %')}")
            met &= bar is None or slower <= bar
    return met


def main():
    options = arguments()
    options.program = str(pathlib.Path(options.program).resolve())
    with tempfile.TemporaryDirectory(prefix="ballpark-output-", dir=options.folder) as folder:
        met = writing_costs(options, folder)
        met &= slow_downs(options, folder)
    return 1 if options.check_bars and not met else 0


raise SystemExit(main())
