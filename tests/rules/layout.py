"""Holds the shape of the source tree: file lengths, names at the top, no path of somebody's machine, names of tests.
usage: layout.py ROOT"""

import re

import source_tree

TOP_LEVEL = {"CMakeLists.txt", "README.md", "include", "engine", "scenarios", "tests", "perf"}
CODE = {".h", ".cpp", ".py", ".sh", ".cmake", ".txt", ""}
LONG, TOO_LONG = 350, 400
# Home folders, and the places where hosted machines and containers keep checkouts.
MACHINE_PATH = re.compile(r"(?<![\w.$}/-])/(?:home|Users|root|work|workspace|builds|mnt|media)/[\w.-]+"
                          r"|[A-Z]:\\\\?Users")
# CMake takes a semicolon for the end of a name: ctest would look for two tests that do not exist.
SPLIT_TEST_NAME = re.compile(r'TEST_CASE\("[^"]*;')


def check_length(name, lines, problems):
    if name.suffix in CODE and lines > TOO_LONG:
        problems.append(f"{name}: {lines} lines, at most {TOO_LONG}: split it by what it does")
    elif name.suffix in CODE and lines > LONG:
        print(f"warning: {name}: {lines} lines, about 300 are meant")


def main():
    root = source_tree.root_argument()
    names, problems = source_tree.files(root), []
    for top in sorted({name.parts[0] for name in names}):
        if top not in TOP_LEVEL and not top.startswith("."):
            problems.append(f"{top}: the top level is fixed: {', '.join(sorted(TOP_LEVEL))}")
    for name in names:
        try:
            lines = (root / name).read_text().splitlines()
        except UnicodeDecodeError:
            continue  # binary
        check_length(name, len(lines), problems)
        for number, line in enumerate(lines, 1):
            if MACHINE_PATH.search(line):
                problems.append(f"{name}:{number}: a path of one machine: {MACHINE_PATH.search(line)[0]}")
            if SPLIT_TEST_NAME.search(line):
                problems.append(f"{name}:{number}: a semicolon in the name of a test, which ctest cannot find")
    source_tree.finish("layout", problems, len(names))


main()
