"""What a shell completes, and that its names are those of the program."""

import json
import os
import shutil
import subprocess
import sys

import pytest

from cranktrain.cli.app import commands
from cranktrain.cli.completing import making, names
from cranktrain.cli.completing.candidates import candidates
from cranktrain.cli.completing.names import example_names
from cranktrain.cli.completing.shells import SCRIPTS
from cranktrain.io import examples


def completed(*typed):
    return candidates(typed, commands())


def test_names_are_those_of_the_program_where_none_were_made(monkeypatch, tmp_path):
    monkeypatch.setattr(names, "LIST", tmp_path / "names.json")
    assert names.names.__wrapped__() == making.made()


@pytest.mark.parametrize("command", ["run", "plot", "compare"])
def test_units_are_completed(monkeypatch, command):
    monkeypatch.setattr(names, "names", making.made)
    assert {"bar", "kPa", "psi", "ft·lbf"} <= set(completed(command, "3d12", "--units", ""))
    assert "psi,kW" in completed(command, "3d12", "--units", "psi,k")


def test_examples_are_those_of_the_program():
    assert tuple(example_names()) == examples.example_names()


@pytest.mark.parametrize(
    ("typed", "among"),
    [
        ([""], {"run", "plot", "new", "completion", "schema"}),
        (["ne"], {"new"}),
        (["new", "s"], {"slider_crank", "scotch_yoke", "slotted_lever", "stephenson"}),
        (["list", ""], {"examples", "kinds", "results"}),
        (["completion", ""], {"bash", "zsh", "fish"}),
        (["run", "3d"], {"3d12", "3d12_fit_85_235", "3d12_quoted_rods"}),
        (["run", "3d12", "--quant"], {"--quantities"}),
        (["run", "3d12", "--quantities", "strok"], {"stroke"}),
        (["run", "--quantities", "rod_angle,strok"], {"rod_angle,stroke"}),
        (["sweep", "3d12", "--wanted", "stroke,largest_piston_s"], {"stroke,largest_piston_speed"}),
        (["sweep", "3d12", "--least", "largest_piston_s"], {"largest_piston_speed"}),
        (["sweep", "3d12", "--most", "largest_piston_s"], {"largest_piston_speed"}),
        (["sweep", "3d12", "--vary", "bank.R.mechanism.rod"], {"bank.R.mechanism.rod_length="}),
        (["sweep", "3d12", "--processes", ""], {"1"}),
        (["sweep", "3d12", "--scheduler", ""], {"tcp://"}),
        (["sweep", "3d12", "-o", "rods.z"], {"rods.zarr"}),
        (["run", "--quantities", "=", "strok"], {"stroke"}),
        (["run", "3d12", "--set", "cylinder.b"], {"cylinder.bore="}),
        (
            ["run", "3d12", "--set", "bank.R.mechanism.k"],
            {"bank.R.mechanism.kind=", "bank.R.mechanism.knuckle_radius="},
        ),
        (["run", "vaz-21213", "--set", "gas.pressure_r"], {"gas.pressure_ratio="}),
        (["run", "3d12", "--set", "evenness.rim.me"], {"evenness.rim.mean_diameter="}),
        (["plot", "3d12", "--set", "shaft.main.sp"], {"shaft.main.speed=", "shaft.main.spacing="}),
        (["run", "3d12", "--decimal", ""], {"point", "comma"}),
        (["plot", "3d12", "--size", ""], {"A4", "A3"}),
        (["run", "3d12", "-o", "curves."], {"curves.csv", "curves.json", "curves.xlsx"}),
        (["compare", "3d12", "vaz"], {"vaz_21213"}),
        (["compare", "3d12", "-o", "both."], {"both.png"}),
        (["textbook", "err"], {"errata"}),
    ],
)
def test_what_is_completed(typed, among):
    found = set(completed(*typed))
    assert among <= found
    assert all(word.startswith(typed[-1]) for word in found)


@pytest.mark.parametrize(
    "typed",
    [
        [],
        ["nothing", ""],
        ["run", "no_such_machine", "--set", "bank."],
        ["run", "3d12", "--set", "shaft.main.speed", "=", "18"],
        ["run", "3d12", "--set", "shaft.main.speed=18"],
        ["run", "3d12", ""],
        ["run", "--step", "1"],
        ["run", "3d12", "--set", "("],
        ["run", "a/b/..", ""],
        ["=", "=", "="],
        ["run", "--set", "=", "=", ""],
        ["new", "[*"],
        ["run", "\x00"],
        ["run", "\x00", "--set", "x"],
    ],
)
def test_nothing_goes_wrong_where_nothing_is_known(typed):
    assert isinstance(completed(*typed), list)


def test_lists_of_designs_are_completed(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("rods.csv", "rods.toml"):
        (tmp_path / name).touch()
    assert completed("sweep", "3d12", "--cases", "") == ["rods.csv"]


def test_paths_of_a_file_that_cannot_be_read(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bad.toml").write_bytes(b"\xff = [")
    assert "cylinder.bore=" in completed("run", "bad.toml", "--set", "cylinder.bor")
    assert completed("run", "ba") == ["bad.toml"]


def asked(place, *words):
    return subprocess.run(
        [sys.executable, "-X", "importtime", "-m", "cranktrain", *words],
        env={**os.environ, "_CRANKTRAIN_COMPLETE": str(place)},
        capture_output=True,
        text=True,
        check=True,
    )


def test_completing_imports_nothing_that_computes():
    answer = asked(4, "run", "3d12", "--set", "cylinder.compression_r")
    assert answer.stdout == "cylinder.compression_ratio=\n"
    imported = {line.rpartition("|")[2].strip().partition(".")[0] for line in answer.stderr.splitlines()}
    assert not imported & {"numpy", "pydantic", "xarray", "rich", "tree_sitter", "matplotlib"}


@pytest.mark.parametrize("place", ["x", "-1", "0", "99", "1e3"])
def test_a_place_that_is_none_gives_nothing(place):
    assert asked(place, "run").stdout == ""


@pytest.mark.parametrize("shell", SCRIPTS)
def test_script(typed, shell):
    assert typed("completion", shell) == (0, SCRIPTS[shell], "")


def test_unknown_shell(typed):
    answer = typed("completion", "zhs")
    assert answer.status == 2
    assert answer.errors == 'SHELL = zhs: must be one of: bash, zsh, fish; write "zsh"\n'


@pytest.mark.skipif(shutil.which("bash") is None, reason="no bash")
def test_bash_completes_by_the_script(tmp_path):
    program = tmp_path / "cranktrain"
    program.write_text(f'#!/bin/sh\nexec {sys.executable} -m cranktrain "$@"\n', encoding="utf-8")
    program.chmod(0o755)
    words = ["cranktrain", "run", "3d12", "--set", "cylinder.bo"]
    listed = " ".join(json.dumps(word) for word in words)
    script = (
        f"{SCRIPTS['bash'].replace('compopt', ': compopt')}\n"
        f'COMP_WORDS=({listed}); COMP_CWORD=4; _cranktrain; printf "%s\\n" "${{COMPREPLY[@]}}"'
    )
    environment = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"}
    answer = subprocess.run(["bash", "-c", script], env=environment, capture_output=True, text=True, check=True)
    assert answer.stdout == "cylinder.bore=\n"
