"""The type checker runs beside the tests: begun when they begin, asked for its end by the test that it is for."""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parents[1]
TYPE_CHECKER = [sys.executable, "-m", "basedpyright", "--warnings", "--pythonpath", sys.executable]
LONGEST = 900
"""How long it is waited for. [s]"""

_RUN = """\
import subprocess, sys
done = subprocess.run(sys.argv[2:], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", check=False)
with open(sys.argv[1] + ".part", "w", encoding="utf-8") as file:
    file.write(f"{done.returncode}\\n{done.stdout}")
import os
os.replace(sys.argv[1] + ".part", sys.argv[1])
"""
"""Whichever process of the tests asks finds status and words in a file, which is there when they are."""

_BESIDE: list[subprocess.Popen[bytes]] = []
"""It is kept here, for nobody in this process waits for it."""


def said() -> Path:
    """Where the type checker of these tests, whose processes may be several, leaves its status and words."""
    run = os.environ.get("PYTEST_XDIST_TESTRUNUID", str(os.getpid()))
    return Path(tempfile.gettempdir()) / f"cranktrain-types-{run}"


def start_type_checker() -> None:
    """Start it, in the first process of the tests, and do not wait."""
    if os.environ.get("PYTEST_XDIST_WORKER", "gw0") == "gw0":
        quiet = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        _BESIDE.append(subprocess.Popen([sys.executable, "-c", _RUN, str(said()), *TYPE_CHECKER], cwd=ROOT, **quiet))


def type_checker_outcome() -> tuple[int, str]:
    """Wait for its end: its status, and what it said."""
    deadline = time.monotonic() + LONGEST
    while not said().exists():
        if time.monotonic() > deadline:
            raise TimeoutError
        time.sleep(0.1)
    status, _, words = said().read_text(encoding="utf-8").partition("\n")
    said().unlink()
    return int(status), words
