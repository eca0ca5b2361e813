"""Whatever a file says and whatever is asked of it, the answer is a result or a sentence: never status 70, a wait, NaN.

Every command on the smallest files, each table alone, and every example without one of its parts; of these products a
fixed sample, in which every file and every command is. `benchmarks/fuzz.py --smallest` takes them whole.
"""

import re
from pathlib import Path

import pytest
from tests.answers import GOOD, REFUSED, answered
from tests.machine_text import toml
from tests.smallest_files import commands, examples_taken_apart, smallest_files

FILES, COMMANDS, EXAMPLES = smallest_files(), commands(), dict(examples_taken_apart())
FOUND = sorted(Path(__file__).with_name("answered").glob("*.toml"))
EVERY = 5
"""Each n-th example without a part."""


def names_of(commands):
    return [re.sub(r"[^\w.-]+", " ", one) for one in commands]


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def answer(text, command):
    Path("machine.toml").write_text(text, encoding="utf-8")
    found = answered(["machine.toml" if part == "FILE" else part for part in command])
    assert not found.fault, f"{' '.join(command)}\n{text}\n{found.errors}"
    return found


@pytest.mark.parametrize("command", range(len(COMMANDS)), ids=names_of(COMMANDS))
def test_every_command_on_smallest_files(command):
    """Each command takes files a prime apart, and begins one further than the command before."""
    asked = [*COMMANDS.values()][command]
    step = 61 if asked[0] == "plot" else 31
    texts = [*FILES.values()]
    for place in range(command % step, len(texts), step):
        answer(texts[place], asked)


@pytest.mark.parametrize("name", [*EXAMPLES][::EVERY])
def test_examples_without_a_part_as_json(name):
    answer(toml(EXAMPLES[name]), ("run", "FILE", "--step", "30", "-o", "out.json"))


@pytest.mark.parametrize("path", FOUND, ids=lambda path: path.stem)
def test_what_once_was_no_answer(path):
    """The first line is the command; the second, if it is refused, what is said, and where it stands."""
    text = path.read_text(encoding="utf-8")
    first, second = (line.removeprefix("# ") for line in text.splitlines()[:2])
    command = [{"machine.toml": "FILE"}.get(part, part) for part in first.split()[1:]]
    found = answer(text, command)
    if second.startswith("refused: "):
        assert found.status == REFUSED
        assert second.removeprefix("refused: ") in found.errors
    else:
        assert found.status == GOOD, found.errors


def test_smallest_files_are_mostly_machines(tmp_path):
    """A table that is refused by itself shows little."""
    good = 0
    for number, text in enumerate(FILES.values()):
        path = tmp_path / f"{number}.toml"
        path.write_text(text, encoding="utf-8")
        good += answered(["check", str(path)]).status == GOOD if number % 9 == 0 else 0
    assert good > 0.5 * len(FILES) / 9
