"""Holds that no kernel object offers a weak symbol: the linker could pick a copy built for a newer processor and use it
everywhere.  usage: kernel_symbols.py BUILD_DIRECTORY [NM]"""

import re
import subprocess
import sys

import source_tree

WEAK = re.compile(r"^[0-9a-f ]{16} ([WwVvu]) (.*)")


def weak_symbols(nm, path):
    symbols = subprocess.run([nm, "--demangle", path], capture_output=True, text=True, check=True).stdout
    return [found.groups() for found in map(WEAK.match, symbols.splitlines()) if found]


def main():
    build = source_tree.root_argument()
    nm = sys.argv[2] if len(sys.argv) > 2 else "nm"
    objects = sorted(path for path in build.rglob("*.o") if any(
        part.startswith("kernels_") and part.endswith(".dir") for part in path.parts))
    problems = [f"{path.relative_to(build)}: weak symbol ({kind}) {name}"
                for path in objects for kind, name in weak_symbols(nm, path)]
    source_tree.finish("kernel symbols", problems, len(objects))


main()
