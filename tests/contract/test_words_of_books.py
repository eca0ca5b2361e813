"""What books and other programs call otherwise leads to the key that says it here, whatever table it stands in."""

import re
import tomllib

import pytest

import cranktrain as ct
from cranktrain import fluids, mechanisms, motors
from cranktrain.layout.bodies import BodySpec
from cranktrain.layout.specs import ShaftSpec
from cranktrain.questions.balance.spec import BalanceSpec
from cranktrain.questions.cylinders.spec import CylindersSpec
from cranktrain.questions.evenness.spec import EvennessSpec
from cranktrain.spec import Spec


def specs(found=Spec):
    """All specs that are loaded, those of all kinds too."""
    for kind in (*mechanisms.KINDS, *fluids.KINDS):
        assert issubclass(kind.spec, Spec)
    for one in found.__subclasses__():
        yield one
        yield from specs(one)


SPECS = sorted(set(specs()), key=lambda one: one.__name__)
TOLD = [(spec, word, what) for spec in SPECS for word, what in spec.elsewhere.items()]
KINDS = [(spec, word, what) for spec in SPECS for word, what in spec.kinds_elsewhere.items()]
KEYS = {
    "mechanism": {key for kind in mechanisms.KINDS for key in kind.spec.model_fields},
    "gas": {key for kind in fluids.KINDS for key in kind.spec.model_fields},
    "shaft.main": ShaftSpec.model_fields,
    "cylinder": CylindersSpec.model_fields,
    "evenness": EvennessSpec.model_fields,
    "balance": BalanceSpec.model_fields,
    "drive.motor": {key for kind in motors.KINDS for key in kind.spec.model_fields},
    **{f"masses.{part}": BodySpec.model_fields for part in ("piston", "rod", "crank")},
}
"""Keys of the tables in which another table's words are written."""


@pytest.mark.parametrize(("spec", "word", "what"), TOLD, ids=lambda value: getattr(value, "__name__", value))
def test_it_is_no_key_of_its_table_and_leads_to_one(spec, word, what):
    assert word not in spec.model_fields
    assert word == word.lower(), "words are looked up as they are written, and in small letters"
    table, key = re.fullmatch(r"(?:\[([\w.]+)\] )?(\w+).*", what).groups()
    assert key in (KEYS[table] if table else spec.model_fields)


@pytest.mark.parametrize(("spec", "word", "what"), KINDS, ids=lambda value: getattr(value, "__name__", value))
def test_a_kind_of_another_name_leads_to_one_that_there_is(spec, word, what):
    kinds = fluids.KINDS if issubclass(spec, fluids.FluidSpec) else mechanisms.KINDS
    assert re.fullmatch(r'kind = "(\w+)"', what)[1] in kinds.names
    assert word not in kinds.names


FIRST_TRY = """
flywheel = "2 kg m2"
rpm = 500
[shaft.main]
n = 3
[mechanism]
kind = "slider_crank"
R = "75 mm"
lambda = 0.2
double_acting = true
[cylinder]
bore = "300 mm"
epsilon = 9
[gas]
kind = "otto"
n1 = 1.3
k = 1.4
[masses]
piston = "2 kg"
"""


def test_a_first_try_with_the_letters_of_a_book():
    with pytest.raises(ct.InputError) as caught:
        ct.Machine(**tomllib.loads(FIRST_TRY))
    told = {problem.path: str(problem.repair) for problem in caught.value.problems if problem.repair}
    assert told == {
        "flywheel": "write [evenness] flywheel",
        "rpm": "write [shaft.main] speed",
        "shaft.main.n": "write speed",
        "mechanism.R": "write crank_radius",
        "mechanism.lambda": "write crank_to_rod_ratio",
        "mechanism.double_acting": 'write [cylinder] chambers = ["head", "crank"]',
        "cylinder.epsilon": "write compression_ratio",
        "gas.n1": "write compression_exponent",
        "gas.k": "write compression_exponent",
        "masses.piston": 'write piston = { mass = "2 kg" }',
    }


STEAM = """
[shaft.main]
throws = ["0 deg", "90 deg"]
spacing = "2200 mm"
speed = "161 rpm"
[bank.cyl]
angle = "90 deg"
mechanism = { kind = "slider_crank", stroke = "700 mm", rod_length = "3100 mm" }
[bank.valve]
angle = "90 deg"
[bank.valve.mechanism]
kind = "walschaerts"
crosshead = "cyl"
notch = 0.6
lap = "38 mm"
lead = "6 mm"
[gas]
kind = "steam"
boiler_pressure = "12 ати"
"""


def test_a_restorers_lap_lead_and_steam_lead_somewhere():
    """Lap and lead of Walschaerts's gear are R · v/(v + w): crank radius, and both parts of the combination lever."""
    with pytest.raises(ct.InputError) as caught:
        ct.Machine(**tomllib.loads(STEAM))
    told = {problem.path: str(problem.repair) for problem in caught.value.problems if problem.repair}
    gear = "bank.valve.mechanism."
    assert "valve_pin_distance" in told[f"{gear}lap"]
    assert "valve_pin_distance" in told[f"{gear}lead"]
    assert told["gas.kind"] == 'write kind = "indicator"'
