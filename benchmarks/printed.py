"""What the terminal prints, by the command that was typed; as a program, of the commands that come in as JSON."""

import io
import json
import shlex
import sys
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from tempfile import TemporaryDirectory

from cranktrain.cli import main

OF_EVERY_MACHINE = ("check {}", "run {}", "textbook {}")
OF_SOME = """
list
list kinds
list results
schema
textbook errata
run 3d12 --inputs
run vaz_21213 --running-speed
run vaz_21213 --quantities stroke,piston_displacement,largest_torque
run vaz_21213 --set "shaft.main.speed=3000 rpm" --step 5
run everything.toml --running-speed --step 10
run slider_crank.toml --inputs
run crank_rocker.toml --partial --set "mechanism.crank_radius=330 mm"
run crank_rocker.toml --set "mechanism.crank_radius=330 mm"
run vaz_21213 --set "shaft.main.sped=3000 rpm"
run vaz_21213 --set "gas.start_pressure=3 mm"
run vaz_21213 --quantities strok
textbook 3d12 --table
textbook vaz_21213 --forces N
textbook kamaz_740 --forces kgf/cm2 --step 10
textbook vaz_21213 --harmonics
textbook --harmonics --crank-to-rod-ratio 0.25
synthesise slider-crank --stroke "160 mm" --pressure-angle "30 deg"
synthesise crank-rocker --swing "50 deg" --time-ratio 1.2 --rocker-length "400 mm"
synthesise quick-return --stroke "300 mm" --time-ratio 1.2
"""
WRITTEN = """
run everything.toml --step 10 -o {}.csv
run everything.toml --step 10 -o {}.json
run lms_class5 --step 5 -o {}.json
run crank_rocker.toml --step 5 -o {}.csv
"""
"""Commands that write a file."""


def printed(names):
    """Print all there is of the machines of these names.

    Returns
    -------
    dict of str to str
        By command what stands on both streams after it, with the status that it ends with, and what it wrote.
    """
    typed = [command.format(name) for name in names for command in OF_EVERY_MACHINE] + OF_SOME.strip().splitlines()
    texts = {f"$ cranktrain {command}": shown(command) for command in typed}
    with TemporaryDirectory() as folder:
        for command in WRITTEN.strip().splitlines():
            start = Path(folder) / "out"
            shown(command.format(start))
            texts[f"$ cranktrain {command.format('out')}"] = start.with_suffix(Path(command).suffix).read_text("utf-8")
            for path in Path(folder).iterdir():
                path.unlink()
    return texts


def shown(command):
    """Give what a command prints, and its status."""
    out, errors = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(errors):
        status = main(shlex.split(command))
    return f"{out.getvalue()}{errors.getvalue()}status {status}\n"


if __name__ == "__main__":
    json.dump({command: shown(command) for command in json.load(sys.stdin)}, sys.stdout)
