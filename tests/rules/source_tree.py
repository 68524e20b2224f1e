"""What the rules share: the files of the source tree, and how a rule ends."""

import pathlib
import subprocess
import sys


def files(root):
    """Paths relative to root of what belongs to the project: as git sees it, else all but hidden and built files."""
    git = subprocess.run(["git", "-C", root, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                         capture_output=True, text=True, check=False) if (root / ".git").exists() else None
    if git and git.returncode == 0 and git.stdout:
        names = [pathlib.PurePath(name) for name in git.stdout.split("\0") if name]
    else:
        names = [path.relative_to(root) for path in root.rglob("*")]
        names = [name for name in names if name.parts[0] in (".ci", ".clang-format", ".gitignore") or not
                 (name.parts[0].startswith((".", "build")) or "__pycache__" in name.parts)]
    return sorted(name for name in names if (root / name).is_file())


def root_argument():
    return pathlib.Path(sys.argv[1]).resolve()


def finish(rule, problems, examined):
    """Prints the verdict; a rule that examined nothing is broken itself."""
    if not examined:
        problems = [*problems, "nothing to examine: the rule does not see the tree"]
    for problem in problems:
        print(problem)
    print(f"{rule}: {examined} examined, {len(problems)} in breach")
    sys.exit(1 if problems else 0)
