"""Completion as the shells themselves do it, by the scripts that `completion` prints."""

import os
import pty
import re
import select
import shutil
import subprocess
import sys
import time

import pytest
from tests.e2e.conftest import environment

LONGEST = 30.0
"""How long a shell may take to answer. [s]"""

COMPLETED = (
    ("cranktrain ne", ["new"], "new "),
    ("cranktrain run mine", ["mine.toml"], "mine.toml "),
    ("cranktrain run 3d", ["3d12", "3d12_fit_85_235", "3d12_quoted_rods"], "3d12"),
    ("cranktrain run 3d12 --set cylinder.bo", ["cylinder.bore="], "cylinder.bore="),
    ("cranktrain run 3d12 --quantities rod_angle,swept", ["rod_angle,swept_volume"], "rod_angle,swept_volume "),
    ("cranktrain completion z", ["zsh"], "zsh "),
)
"""Lines, what may stand for their last words, and as far as that is known; a blank where nothing follows at once."""


@pytest.fixture
def home(tmp_path):
    """A folder with the program, by its name, and a machine file."""
    program = tmp_path / "cranktrain"
    program.write_text(f'#!/bin/sh\nexec {sys.executable} -m cranktrain "$@"\n', encoding="utf-8")
    program.chmod(0o755)
    (tmp_path / "mine.toml").touch()
    return tmp_path


@pytest.fixture
def variables(home):
    return environment(PATH=f"{home}:{os.environ['PATH']}", HOME=str(home), TERM="dumb")


@pytest.mark.skipif(shutil.which("fish") is None, reason="no fish")
@pytest.mark.parametrize(("line", "words", "_known"), COMPLETED)
def test_fish(home, variables, line, words, _known):
    """Fish says what it would offer for a line."""
    asked = f"cranktrain completion fish | source; complete -C '{line}'"
    command = ["fish", "--no-config", "-c", asked]
    done = subprocess.run(command, cwd=home, env=variables, capture_output=True, encoding="utf-8", check=True)
    assert (done.stdout.split("\n")[:-1], done.stderr) == (words, "")


class Zsh:
    """An interactive zsh at a terminal of ours, which shows the line as it stands when ctrl-X is typed."""

    READY = (
        "unsetopt zle_bracketed_paste; autoload -U compinit; compinit -u -D; "
        'eval "$(cranktrain completion zsh)"; '
        'shown() { print -r -- "<<$BUFFER>>"; zle .kill-whole-line }; zle -N shown; bindkey "^X" shown; '
        "echo REA''DY\n"
    )

    def __init__(self, folder, variables):
        self.terminal, theirs = pty.openpty()
        streams = {"stdin": theirs, "stdout": theirs, "stderr": theirs}
        self.process = subprocess.Popen(
            ["zsh", "-f", "-i"], cwd=folder, env=variables, start_new_session=True, **streams
        )
        os.close(theirs)
        self.type(self.READY)
        self.answer("READY\r")

    def type(self, keys):
        os.write(self.terminal, keys.encode())

    def answer(self, pattern):
        """Read until a pattern comes."""
        said, end = "", time.monotonic() + LONGEST
        while (found := re.search(pattern, said)) is None:
            ready, _writable, _failed = select.select([self.terminal], [], [], max(0.0, end - time.monotonic()))
            assert ready, said
            said += os.read(self.terminal, 4096).decode(errors="replace")
        return found

    def close(self):
        os.close(self.terminal)
        self.process.kill()
        self.process.wait()


@pytest.mark.skipif(shutil.which("zsh") is None, reason="no zsh")
def test_zsh(home, variables):
    """Zsh completes a line as far as it can when Tab is typed."""
    shell = Zsh(home, variables)
    try:
        for line, _words, known in COMPLETED:
            shell.type(f"{line}\t\x18")
            assert shell.answer(r"<<(.*)>>")[1] == f"{line.rpartition(' ')[0]} {known}"
    finally:
        shell.close()
