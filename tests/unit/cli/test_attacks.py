"""Files and options made to break the program: each is answered soon, shortly, and in words."""

import os
import re
import threading

import numpy as np
import pytest
from tests.sentences import HOLDS_NOTHING, NOT_A_KEY, TOO_DEEP

import cranktrain as ct
from cranktrain.mechanisms import KINDS

HEAD = '[mechanism]\nkind = "slider_crank"\nstroke = "80 mm"\nrod_length = "136 mm"\n'
BANK = '[bank.A.mechanism]\nkind = "slider_crank"\nstroke = "80 mm"\nrod_length = "136 mm"\n'
THROWS = '"0 deg",' * 20_000
DEEP = ".".join(["a"] * 40_000)

COMMANDS = {
    "check": ("check",),
    "run": ("run",),
    "run -o": ("run", "-o", "out.csv"),
    "plot": ("plot", "-o", "out.png"),
    "textbook": ("textbook",),
    "textbook --forces": ("textbook", "--forces", "N"),
    "textbook --harmonics": ("textbook", "--harmonics"),
}


@pytest.mark.parametrize("kind", [kind.name for kind in KINDS])
def test_inputs_of_every_file_to_start_from(typed, kind):
    assert typed("new", kind, "-o", "new.toml").status == 0
    answer = typed("run", "new.toml", "--inputs", "--step", "30")
    assert (answer.status, answer.errors) == (0, "")
    assert "What this rests on" in answer.output


@pytest.mark.parametrize("command", COMMANDS.values(), ids=list(COMMANDS))
def test_fifty_problems_are_told_and_the_rest_counted(typed, written, command):
    path = written(HEAD + "".join(f"k{i} = {i}\n" for i in range(2000)))
    answer = typed(*command, str(path))
    assert (answer.status, answer.output) == (2, "")
    lines = answer.errors.splitlines()
    assert len(lines) == 51
    assert lines[0].startswith(f"{path}:5:6  mechanism.k0 = 0: {NOT_A_KEY}")
    assert lines[49].startswith(f"{path}:54:7  mechanism.k49 = 49: ")
    assert lines[50] == "and 1950 more"


def test_settings_are_at_most_a_hundred(typed):
    many = [part for i in range(101) for part in ("--set", f"mechanism.k{i}=1")]
    answer = typed("run", "3d12", *many)
    assert (answer.status, answer.errors) == (2, "--set  is given 101 times, and may be 100 times; write a file\n")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            f"{HEAD}{DEEP} = 1\n",
            f":5:1  {DEEP[:59]}…: {TOO_DEEP}",
        ),
        (f"{HEAD}[{DEEP}]\n", ":5:2  a.a.a.a"),
        (f'{HEAD}x = {{ "a" . {DEEP} = 1 }}\n', ':5:7  "a" . a.a.a.a'),
        (HEAD + "".join(f"[t{i}]\n" for i in range(30_000)), "  has 30004 keys, and no machine needs more than 20000"),
        (
            f"{BANK}[shaft.main]\nthrows = [{THROWS}]\n",
            ":6:10  shaft.main.throws = a list of 20000, from 0 deg to 0 deg",
        ),
        (f"{HEAD}[balance]\n", f":5:1  balance: {HOLDS_NOTHING}"),
        (f'"" = 1\n{HEAD}', f':1:6  "" = 1: {NOT_A_KEY}'),
        (f'"a\\nb\\u001b[31m" = 1\n{HEAD}', f':1:20  "a\\nb\\u001b[31m" = 1: {NOT_A_KEY}'),
        (f'{HEAD}offset = "\\u001b[31m{"x" * 999}"\n', r":5:10  mechanism.offset = \x1b[31mxxxxxxxx"),
        (
            f"{HEAD}[cylinder]\ncompression_ratio = 1e29\n",
            ":6:21  cylinder.compression_ratio = 1e+29: must be at most",
        ),
    ],
)
def test_attacks_are_refused(typed, written, text, said):
    path = written(text)
    answer = typed("run", str(path))
    assert (answer.status, answer.output) == (2, "")
    assert answer.errors.startswith(f"{path}{said}")
    assert answer.errors[:-1].replace("\n", "").isprintable()
    assert all(len(line) < 600 for line in answer.errors.splitlines())


def test_a_text_of_many_dots_is_no_key(typed, written):
    dots = ".".join(["a"] * 50)
    point = f'points."{dots}" = {{ link = "rod", along = "9 mm", across = "0 mm" }}'
    path = written(f'name = """\n{dots} = 1"""\n# {dots}\n{HEAD}{point}\n')
    assert typed("check", str(path)).status == 0


class TestPipes:
    def test_one_into_which_nobody_writes_is_refused_at_once(self, typed, tmp_path):
        os.mkfifo(tmp_path / "pipe")
        assert typed("run", "pipe").errors == "pipe  is a pipe into which nobody writes\n"

    def test_one_into_which_somebody_writes_is_read(self, typed, tmp_path):
        os.mkfifo(tmp_path / "pipe")
        reading = os.open(tmp_path / "pipe", os.O_RDONLY | os.O_NONBLOCK)  # so that the writer need not wait
        writer = (tmp_path / "pipe").open("w", encoding="utf-8")

        def write():
            writer.write(HEAD)
            writer.close()

        late = threading.Timer(0.3, write)
        late.start()
        try:
            assert typed("check", "pipe").status == 0
        finally:
            late.join()
            os.close(reading)


@pytest.mark.parametrize("device", ["/dev/zero", "/dev/null", "/dev"])
def test_devices_are_refused(typed, device):
    answer = typed("run", device)
    assert (answer.status, len(answer.errors.splitlines())) == (2, 1)


def test_names_and_notes_of_a_file_reach_no_terminal_raw(typed, written):
    rod = '{ value = "136 mm", status = "assumed", note = "a\\u001b[31m\\nb" }'
    text = HEAD.replace('"136 mm"', rod)
    text += 'points."p\\u001b[31m\\nq" = { link = "rod", along = "9 mm", across = "0 mm" }\n'
    path = written('name = "n\\u001b]0;title\\u0007"\n' + text)
    for options in ((), ("--full",), ("--inputs",), ("--quantities", "point_x,stroke")):
        answer = typed("run", str(path), *options)
        assert answer.status == 0
        assert answer.output.replace("\n", "").isprintable()


def test_what_is_typed_comes_back_without_controls(typed):
    for arguments in (("\x1b[31m",), ("run", "\x1b[31m"), ("list", "\x1b"), ("run", "3d12", "--\x1b"), ("new", "\x1b")):
        answer = typed(*arguments)
        assert answer.status == 2
        assert answer.errors.replace("\n", "").isprintable()


def test_sizes_that_cannot_be_are_refused_without_a_warning(typed):
    typed("new", "walschaerts", "-o", "gear.toml")
    answer = typed("run", "gear.toml", "--set", "bank.valve.mechanism.full_gear_die=1e20 mm")
    assert answer.status == 2
    assert "must" in answer.errors or "cannot" in answer.errors


def test_errors_of_curves_that_are_zero_are_not_infinite(typed):
    answer = typed(
        "run", "traction_engine", "--set", "bank.cylinder.mechanism.stroke=1e-20 in", "--step", "10", "--full"
    )
    assert (answer.status, answer.errors) == (0, "")
    assert not re.search(r"\binf\b", answer.output)


def test_a_rod_beside_its_line_is_no_two_masses(typed, written):
    rod = '[masses.rod]\nmass = "0.7 kg"\nalong = "36 mm"\nacross = "5 mm"\ninertia = "0.002 kg·m²"\n'
    path = written(f'{HEAD}{rod}[shaft.main]\nspeed = "1500 rpm"\n')
    answer = typed("run", str(path), "--step", "10", "--full")
    assert (answer.status, answer.errors) == (0, "")
    result = ct.run(path, step_degrees=10)
    errors = dict(zip(result.labels["rod_method"], result.side_force_error[:, 0].tolist(), strict=True))
    assert {name for name, error in errors.items() if np.isfinite(error)} == {"exact"}
