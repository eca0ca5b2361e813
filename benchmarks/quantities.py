"""All that the program computes and prints, as a file; and two such files compared, so that no number moves unnoticed.

    python benchmarks/quantities.py dump after.npz
    python benchmarks/quantities.py dump before.npz --from main
    python benchmarks/quantities.py compare before.npz after.npz

A dump has whole curves of every example and of the machines in `weighed/`, and what the terminal prints of them. With
`--from` it is that of another commit, whose code is checked out into a temporary folder; the machines in `weighed/`
stay those that are here. `compare` ends with status 1 where a number moved by more than its limit, or a quantity is
lost; a text that differs is shown.
"""

import argparse
import os
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

HERE = Path(__file__).parent
ONE_LANGUAGE = {"LANGUAGE": "en", "OPENBLAS_NUM_THREADS": "1"}


@contextmanager
def checked_out(commit):
    """Give a folder with that commit's files."""
    with TemporaryDirectory() as folder:
        tree = Path(folder) / "tree"
        git("worktree", "add", "--detach", str(tree), commit)
        try:
            yield tree
        finally:
            git("worktree", "remove", "--force", str(tree))


def git(*arguments):
    subprocess.run(["git", "-C", str(HERE), *arguments], check=True, capture_output=True)


def dump_of(commit, path):
    """Dump that commit's quantities, by its own code in a process of its own."""
    with checked_out(commit) as tree:
        environment = {**os.environ, "PYTHONPATH": str(tree / "src")}
        subprocess.run([sys.executable, __file__, "dump", str(path)], check=True, env=environment)


def dump(path):
    """Dump the quantities of the code that Python finds first."""
    os.environ.update(ONE_LANGUAGE)  # before the program is imported, which looks once
    from dumping import written

    print(written(path))


def compare(before, after):
    """Print how two dumps differ; 1 where a number moved."""
    from agreement import read, report

    lines, moved = report(read(before), read(after))
    print("\n".join(lines))
    return int(moved)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    dumping = commands.add_parser("dump", help="write a dump")
    dumping.add_argument("path", type=Path)
    dumping.add_argument("--from", dest="commit", help="commit whose code is run, instead of the one that is here")
    comparing = commands.add_parser("compare", help="say how two dumps differ")
    comparing.add_argument("before", type=Path)
    comparing.add_argument("after", type=Path)
    given = parser.parse_args()
    if given.command == "compare":
        return compare(given.before, given.after)
    if given.commit is None:
        dump(given.path.absolute())
    else:
        dump_of(given.commit, given.path.absolute())
    return 0


if __name__ == "__main__":
    sys.exit(main())
