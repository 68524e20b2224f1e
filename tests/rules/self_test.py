"""Holds that the rules catch what they are for: each breach is planted in a small tree, and its rule must fail and name
the file.  usage: self_test.py COMPILER"""

import pathlib
import subprocess
import sys
import tempfile

RULES = pathlib.Path(__file__).resolve().parent
CLEAN = {
    "engine/core/real.h": "#pragma once\n",
    "engine/core/workers.cpp": '#include <tbb/task_arena.h>\n#include "engine/core/real.h"\n',
    "engine/effects/wind.h": '#include "engine/core/real.h"\n#ifndef BALLPARK_TARGET\n#include <vector>\n'
                             '#include "ballpark/scene.h"\n#endif\n',
    "engine/world/step.kernel.cpp": '#include "engine/effects/wind.h"\n',
    "include/ballpark/scene.h": "#include <Eigen/Core>\n#include <vector>\n",
}
BREACHES = [  # rule, file, its text
    ("includes", "engine/core/high.h", '#include "engine/effects/wind.h"\n'),
    ("includes", "engine/integrators/sibling.h", '#include "engine/effects/wind.h"\n'),
    ("includes", "engine/effects/unrooted.h", '#include "wind.h"\n'),
    ("includes", "engine/world/threads.h", "#include <tbb/parallel_for.h>\n"),
    ("includes", "engine/core/again.h", "#include <tbb/parallel_for.h>\n"),
    ("includes", "engine/world/list.kernel.cpp", "#include <vector>\n"),
    ("includes", "engine/effects/wind.h", "#ifdef BALLPARK_TARGET\n#include <Eigen/Core>\n#endif\n"),
    ("includes", "include/ballpark/inner.h", '#include "engine/core/real.h"\n'),
    ("includes", "include/ballpark/library.h", "#include <fmt/format.h>\n"),
    ("layout", "docs/page.md", "one page too many\n"),
    ("layout", "engine/core/endless.cpp", "//\n" * 401),
    ("layout", "engine/core/path.cpp", "// see /" + "home/somebody/notes\n"),
    ("layout", "tests/unit/split.cpp", "TEST_CASE" + '("one; two") {}\n'),
]


def write(root, name, text):
    path = root / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def verdict(rule, *arguments):
    run = subprocess.run([sys.executable, RULES / f"{rule}.py", *arguments], capture_output=True, text=True, check=False)
    return run.returncode, run.stdout + run.stderr


def expect(what, result, code, word):
    if result[0] != code or word not in result[1]:
        sys.exit(f"{what}: expected exit code {code} and the word {word}, got {result[0]}:\n{result[1]}")


def compile_kernel(compiler, build, text):
    write(build, "kernel.cpp", text)
    out = build / "CMakeFiles/kernels_f64_base.dir/kernel.cpp.o"
    out.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run([compiler, "-O2", "-c", build / "kernel.cpp", "-o", out], check=True)


def main():
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name).resolve() / "tree"
        for path, text in CLEAN.items():
            write(root, path, text)
        for rule in ("includes", "layout"):
            expect(f"{rule} on a clean tree", verdict(rule, root), 0, " 0 in breach")
        for rule, path, text in BREACHES:
            write(root, path, text)
            expect(f"{rule} with {path}", verdict(rule, root), 1, path.removesuffix("/page.md"))
            (root / path).unlink()
            if path in CLEAN:
                write(root, path, CLEAN[path])
        build = pathlib.Path(name) / "objects"
        expect("kernel symbols without objects", verdict("kernel_symbols", root), 1, "nothing")
        compile_kernel(sys.argv[1], build, "static int one() { return 1; }\nint use() { return one(); }\n")
        expect("kernel symbols of a clean object", verdict("kernel_symbols", build), 0, "1 examined")
        compile_kernel(sys.argv[1], build, "template <class T> __attribute__((noinline)) T leak(T x) { return x; }\n"
                                           "int use() { return leak(1); }\n")
        expect("kernel symbols of a leaking object", verdict("kernel_symbols", build), 1, "leak")
    print(f"{len(BREACHES) + 1} planted breaches found")


main()
