"""The service as a process of its own, as `cranktrain web` starts it."""

import re
import subprocess
import sys
from contextlib import contextmanager

from tests.e2e.conftest import environment


@contextmanager
def started(folder, *asked):
    """Start the service in a folder; give its process."""
    command = [sys.executable, "-m", "cranktrain", "web", *asked, "--no-browser"]
    process = subprocess.Popen(
        command, cwd=folder, env=environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8"
    )
    try:
        yield process
    finally:
        process.terminate()
        process.communicate(timeout=20)


def address_of(process):
    """Where a service says that its page is."""
    return re.search(r"http://[^\s;]+", process.stdout.readline())[0]


@contextmanager
def served(folder, *asked):
    """Start the service in a folder; give where it is."""
    with started(folder, *asked) as process:
        yield address_of(process)
