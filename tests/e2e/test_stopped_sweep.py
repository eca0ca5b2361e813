"""A sweep that is stopped by Ctrl-C at a terminal keeps what was computed so far."""

import csv

import pytest
from tests.e2e.conftest import stopped

ASKED = ("sweep", "vaz_21213", "--vary", "rod_length=110..170 mm:90000", "--wanted", "largest_torque", "--yes")


@pytest.mark.parametrize("processes", ["1", "2"])
def test_ctrl_c_keeps_what_was_computed(tmp_path, processes):
    output = tmp_path / "rods.csv"
    status, said = stopped((*ASKED, "--processes", processes, "-o", str(output)), times=3)
    assert status == 0
    assert b"written: " in said
    assert b"Traceback" not in said
    assert (
        b"of 90000 designs were computed; a store keeps them: with -o NAME.zarr the same command with --resume" in said
    )
    lines = output.read_text(encoding="utf-8").splitlines()
    assert any("of 90000 designs: not computed" in line for line in lines if line.startswith("#"))
    torques = [row["largest_torque [N*m]"] for row in csv.DictReader(line for line in lines if line[0] != "#")]
    assert len(torques) == 90000
    n_known = sum(torque not in ("", "nan") for torque in torques)
    assert 4 <= n_known < 90000
    assert all(torque not in ("", "nan") for torque in torques[:n_known])
