"""Critical speeds next to the machine's: of major orders in the answer, of minor ones in the table of all."""

import numpy as np
import pytest

import cranktrain as ct

SIX = """
[shaft.main]
throws = ["0 deg", "240 deg", "120 deg", "120 deg", "240 deg", "0 deg"]
spacing = "130 mm"
speed = "1500 rpm"
[bank.A.mechanism]
kind = "slider_crank"
stroke = "135 mm"
rod_length = "220 mm"
[cylinder]
bore = "115 mm"
cycle = "four-stroke"
firing_order = "1-5-3-6-2-4"
[masses]
piston = { mass = "2.9 kg" }
rod = { mass = "3.1 kg", along = "72 mm", inertia = "0.031 kg·m²" }
crank = { mass = "11 kg", along = "22 mm", inertia = "0.05 kg·m²" }
[crankshaft]
journal_diameter = "95 mm"
pin_diameter = "80 mm"
pin_length = "40 mm"
web_thickness = "24 mm"
web_width = "130 mm"
bearing_width = "34 mm"
[torsion.disc.flywheel]
inertia = "1.9 kg·m²"
beside = 6
stiffness = "2 MN·m/rad"
[torsion.disc.damper]
inertia = "0.12 kg·m²"
beside = 1
stiffness = "0.8 MN·m/rad"
"""
"""A truck's six: orders 6 and 9 excite its first mode most, 8 between them hardly."""


def test_a_six_between_its_major_orders(typed, written):
    path = str(written(SIX))
    said = typed("run", path).output
    row = next(line for line in said.splitlines() if "next critical speeds" in line)
    assert row.split(None, 3)[3] == "1285 rpm (order 9), 1927 rpm (order 6)"
    result = ct.run(path)
    of_first = (values[0].tolist() for values in (result.critical_speed, result.mode_vector_sum))
    found = dict(zip(result.labels["order"], zip(*of_first, strict=True), strict=True))
    for order, speed, vector_sum in (("9", 1284.9, 3.504), ("8", 1445.6, 0.1314), ("6", 1927.4, 3.504)):
        assert found[order][0] * 30 / np.pi == pytest.approx(speed, abs=0.05)
        assert found[order][1] == pytest.approx(vector_sum, rel=5e-4)
    table = [
        line.split()
        for line in typed("run", path, "--quantities", "critical_speed,mode_vector_sum").output.splitlines()
    ]
    assert ["1", "8", "1446", "0.1314"] in table
