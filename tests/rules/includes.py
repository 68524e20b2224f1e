"""Holds who may include whom against every #include line.  usage: includes.py ROOT"""

import re

import source_tree

# Folder: the other folders that it may include. Siblings (integrators, effects, collide) never include each other.
MAY_INCLUDE = {
    "engine/core": [],
    "engine/kernels": ["engine/core"],
    "engine/store": ["engine/core"],
    "engine/integrators": ["engine/store", "engine/kernels", "engine/core"],
    "engine/effects": ["engine/store", "engine/kernels", "engine/core"],
    "engine/collide": ["engine/store", "engine/kernels", "engine/core"],
    "engine/contact": ["engine/collide", "engine/store", "engine/kernels", "engine/core"],
    "engine/world": ["engine/contact", "engine/collide", "engine/effects", "engine/integrators", "engine/store",
                     "engine/kernels", "engine/core"],
    "engine/api": ["engine/world", "engine/contact", "engine/collide", "engine/effects", "engine/integrators",
                   "engine/store", "engine/kernels", "engine/core", "ballpark"],
    "include/ballpark": ["ballpark"],
    "scenarios/files": ["ballpark"],
    "perf": ["scenarios/files", "engine/collide", "ballpark"],  # the grid is measured apart, beside a peer
    "scenarios/view": ["perf", "scenarios/files", "ballpark"],  # perf draws
    "scenarios/command": ["scenarios/view", "perf", "scenarios/files", "ballpark"],
}
# The public face's plain values (they compute nothing) are the vocabulary of what is checked and explained.
PLAIN_VALUES = ["ballpark/scene.h", "ballpark/catalogue.h", "ballpark/options.h", "ballpark/report.h",
                "ballpark/state.h", "ballpark/user_effect.h"]
SEE_PLAIN_VALUES = ["engine/integrators", "engine/effects", "engine/collide", "engine/contact", "engine/world"]
# The public face builds on this alone, beside the standard library.
FACE_LIBRARIES = ["Eigen/"]

# A library that one file alone includes, and the folders where there may be such a file. The tests are not asked.
ONE_FILE = {r"<(oneapi/)?tbb/": ["engine/core"], r"<CLI/": ["scenarios/command", "perf"],
            r"<toml\+\+/": ["scenarios/files"], r"<zlib\.h>": ["scenarios/view", "scenarios/command"]}

# Kernel files, with all that they include, keep to plain loops and simd: no template of these may be built in them.
NOT_IN_KERNELS = re.compile(r"<(Eigen/|(algorithm|any|array|bit|deque|format|functional|iostream|list|map|memory|"
                            r"numeric|optional|ranges|set|span|sstream|string|string_view|tuple|unordered_map|utility|"
                            r"variant|vector|cmath|math\.h)>)")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"][^>"]+[>"])')
CONDITION = re.compile(r"^\s*#\s*(ifdef|ifndef|if|elif|else|endif)\b\s*(.*?)\s*(//.*)?$")


def folder_of(name):
    """The row of the table that a path belongs to, or None."""
    for folder in MAY_INCLUDE:
        if name.startswith(folder + "/"):
            return folder
    return None


def includes(text):
    """(line, what, seen by kernel compilations) of each #include."""
    branches = []  # of each open #if: is this branch left out of kernel compilations?
    for number, line in enumerate(text.splitlines(), 1):
        condition = CONDITION.match(line)
        if condition:
            word, about_target = condition[1], condition[2] == "BALLPARK_TARGET"
            if word.startswith("if"):
                branches.append({"hidden": about_target and word == "ifndef", "about_target": about_target})
            elif word == "endif":
                branches.pop()
            else:
                branches[-1]["hidden"] = branches[-1]["about_target"] and not branches[-1]["hidden"]
        found = INCLUDE.match(line)
        if found:
            yield number, found[1], not any(branch["hidden"] for branch in branches)


def allowed(folder, target):
    """May a file of this folder include this path, given from the root or as "ballpark/..."?"""
    if target in PLAIN_VALUES and folder in SEE_PLAIN_VALUES:
        return True
    if target == "ballpark/scenes.h" and folder.startswith(("engine", "include")):
        return False
    return any(target.startswith(other + "/") for other in [folder, *MAY_INCLUDE[folder]])


def check_file(root, name, lines, one_file, problems):
    folder = folder_of(name)
    for number, what, _ in lines:
        place, target = f"{name}:{number}", what[1:-1]
        for library, homes in ONE_FILE.items():
            if re.match(library, what):
                one_file.setdefault((library, folder), set()).add(name)
                if folder not in homes:
                    problems.append(f"{place}: {what} belongs to one file of {' or '.join(homes)}")
        if what[0] == "<":
            if folder == "include/ballpark" and "/" in target and not target.startswith(tuple(FACE_LIBRARIES)):
                problems.append(f"{place}: the public face shows no library but {', '.join(FACE_LIBRARIES)}: {what}")
        elif not any((root / base / target).is_file() for base in ("", "include")):
            problems.append(f'{place}: {what}: no such file from the root (or "ballpark/...")')
        elif not allowed(folder, target):
            problems.append(f"{place}: {folder} may not include {target}; it may: "
                            f"{', '.join(MAY_INCLUDE[folder]) or 'nothing else'}")


def check_kernel(sources, kernel, problems):
    """Follows a kernel file through what it includes."""
    seen, open_names = {kernel}, [kernel]
    while open_names:
        name = open_names.pop()
        for number, what, in_kernels in sources.get(name, []):
            target = what[1:-1]
            if in_kernels and NOT_IN_KERNELS.match(what):
                problems.append(f"{name}:{number}: {what} reaches the kernel file {kernel}; guard it with "
                                "#ifndef BALLPARK_TARGET or move what needs it")
            if in_kernels and what[0] == '"' and target not in seen:
                seen.add(target)
                open_names.append("include/" + target if target.startswith("ballpark/") else target)


def main():
    root = source_tree.root_argument()
    names = [name.as_posix() for name in source_tree.files(root) if name.suffix in (".h", ".cpp")]
    names = [name for name in names if folder_of(name)]
    sources = {name: list(includes((root / name).read_text())) for name in names}
    problems, one_file = [], {}
    for name, lines in sources.items():
        check_file(root, name, lines, one_file, problems)
        if name.endswith(".kernel.cpp"):
            check_kernel(sources, name, problems)
    for (library, folder), users in one_file.items():
        if len(users) > 1:
            problems.append(f"{folder}: {library} is included by more than one file: {', '.join(sorted(users))}")
    source_tree.finish("includes", sorted(set(problems)), len(names))


main()
