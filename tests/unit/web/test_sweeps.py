"""Sweeps that a service computes while it is asked for others: how far they are, what they give, how they end."""

import asyncio
import time

import numpy as np
import psutil
import pytest
from fastapi.testclient import TestClient
from tests.apart import finished
from tests.odd_questions import Fatal, Hanging
from tests.packed_answers import opened

from cranktrain.web.asked import Case, HowFar, SweepQuestion
from cranktrain.web.service import service
from cranktrain.web.sweeps import Sweeps

TEXT = """
[mechanism]
kind = "slider_crank"
crank_radius = "50 mm"
rod_length = "180 mm"
[shaft.main]
speed = "1500 rpm"
"""
RODS = {"mechanism.rod_length": "130..160 mm:4"}
SOON = 60.0
"""A process begins and ends sooner even on a busy computer. [s]"""


@pytest.fixture
def client():
    before = set(psutil.Process().children())
    with TestClient(service(), base_url="http://127.0.0.1:8765") as one:
        yield one
    assert set(psutil.Process().children()) == before


def begun(client, **sent):
    answer = client.post("/api/sweep", json=sent)
    assert answer.status_code == 202, answer.text
    return f"/api/sweep/{answer.json()['number']}"


def ended(client, place):
    for _wait in range(int(SOON / 0.05)):
        answer = client.get(place)
        if answer.status_code != 202:
            return answer
        assert answer.json().keys() == {"done", "designs"}
        time.sleep(0.05)
    pytest.fail("is not at its end")


def columns(data, numbers):
    """Facts by name, as arrays."""
    found = {}
    for fact in data["facts"]:
        at, shape = fact["values"]["at"], fact["values"]["shape"]
        found[fact["name"]] = (fact["unit"], numbers[at : at + int(np.prod(shape))].reshape(shape))
    return found


def test_facts_over_one_number_are_those_of_each_machine(client):
    wanted = ["largest_piston_speed", "mean_piston_speed"]
    place = begun(client, text=TEXT, settings=["shaft.main.speed=1000 rpm"], vary=RODS, wanted=wanted)
    data, numbers = opened(ended(client, place))
    (varied,) = data["varied"]
    assert (varied["path"], varied["unit"]) == ("mechanism.rod_length", "mm")
    assert varied["texts"] == ["130 mm", "140 mm", "150 mm", "160 mm"]
    found = columns(data, numbers)
    assert found.keys() == set(wanted)
    unit, speeds = found["largest_piston_speed"]
    # r ω √(…): of a crank of 50 mm at 1000 rpm the largest speed of a piston, from its motion in small steps.
    angles = np.linspace(0.0, np.pi, 200_001)
    for length, speed in zip((0.13, 0.14, 0.15, 0.16), speeds, strict=True):
        place_of = 0.05 * np.cos(angles) + np.sqrt(length**2 - (0.05 * np.sin(angles)) ** 2)
        expected = np.max(np.abs(np.gradient(place_of, angles))) * 1000 * np.pi / 30
        assert unit == "m/s"
        assert speed == pytest.approx(expected, rel=1e-6)


def test_facts_over_two_numbers_stand_along_both(client):
    vary = RODS | {"shaft.main.speed": "1000, 2000, 3000 rpm"}
    found = columns(*opened(ended(client, begun(client, text=TEXT, vary=vary, wanted=["mean_piston_speed"]))))
    _unit, speeds = found["mean_piston_speed"]
    assert speeds.shape == (4, 3)
    assert speeds == pytest.approx(np.tile([20 / 6, 40 / 6, 10.0], (4, 1)))  # 2 s n, of a stroke of 100 mm


def test_designs_that_cannot_be_have_no_number_and_are_told(client):
    vary = {"mechanism.rod_length": "40, 130 mm"}
    data, numbers = opened(ended(client, begun(client, text=TEXT, vary=vary, wanted=["stroke"])))
    _unit, strokes = columns(data, numbers)["stroke"]
    assert np.isnan(strokes).tolist() == [True, False]
    assert any("1 of 2 designs cannot be" in words for words in data["minded"])


@pytest.mark.parametrize(
    ("sent", "path"),
    [
        ({"text": TEXT, "vary": {"mechanism.rod_length": "1..2 mm:3"}}, ""),
        ({"text": TEXT, "vary": {"shaft.main.speed": "1..20000 rpm:20000"}}, "vary"),
        ({"text": TEXT, "vary": RODS, "wanted": ["nothing"]}, "wanted"),
        ({"text": "a = [", "vary": RODS}, ""),
    ],
)
def test_what_is_wrong_is_said_when_it_is_asked_for(client, sent, path):
    answer = ended(client, begun(client, **sent))
    assert answer.status_code == 422
    assert [problem["path"] for problem in answer.json()] == [path]


@pytest.mark.parametrize(
    ("sent", "path"),
    [
        ({"text": TEXT}, "vary"),
        ({"text": TEXT, "vary": {}}, "vary"),
        ({"text": TEXT, "vary": {"a": "1", "b": "1", "c": "1"}}, "vary"),
        ({"text": TEXT, "vary": RODS, "wanted": ["a"] * 5}, "wanted"),
        ({"machine": "/etc/passwd", "vary": RODS}, "machine"),
        ({"machine": "mill_engine", "vary": {"gas.file": "/etc/passwd, b"}}, "gas.file"),
        ({"machine": "mill_engine", "vary": {"gas": '[{file = "/etc/passwd"}]'}}, "gas"),
    ],
)
def test_what_may_not_be_asked_is_refused_at_once(client, sent, path):
    answer = client.post("/api/sweep", json=sent)
    assert answer.status_code == 422
    assert [problem["path"] for problem in answer.json()] == [path]


def test_a_sweep_is_stopped_and_forgotten(client):
    place = begun(client, machine="3d12", vary={"shaft.main.speed": "1000..2000 rpm:9999"}, wanted=["stroke"])
    assert client.delete(place).status_code == 204
    for way in (client.get, client.delete):
        answer = way(place)
        assert answer.status_code == 404
        assert answer.json()[0]["allowed"]


def with_sweeps(do, **limits):
    """Do something with sweeps, and look that no process is left."""

    async def all_of_it():
        sweeps = Sweeps(**limits)
        try:
            return await do(sweeps)
        finally:
            await sweeps.stop()

    before = set(psutil.Process().children())
    found = finished(all_of_it())
    assert set(psutil.Process().children()) == before
    return found


async def end_of(sweeps, number):
    for _wait in range(int(SOON / 0.05)):
        found = sweeps.reply(number)
        if not isinstance(found, HowFar):
            return found
        await asyncio.sleep(0.05)
    pytest.fail("is not at its end")


@pytest.mark.parametrize(
    ("question", "longest", "sentence"),
    [(Hanging(), 1.0, b"takes longer than 1 s"), (Fatal(), SOON, b"its process ended")],
)
def test_one_that_takes_too_long_or_dies_is_said_so(question, longest, sentence):
    reply = with_sweeps(lambda sweeps: end_of(sweeps, sweeps.begin(question)), longest=longest)
    assert reply.status == 503
    assert sentence in reply.content


def test_no_more_are_taken_than_can_be_kept_and_each_has_a_number_of_its_own():
    async def many(sweeps):
        return [sweeps.begin(Hanging()) for _each in range(22)]

    numbers = with_sweeps(many)
    assert numbers[20:] == [None, None]
    assert len(set(numbers[:20])) == 20


def test_what_nobody_asks_for_is_forgotten():
    async def late(sweeps):
        number = sweeps.begin(Hanging())
        asked = [sweeps.reply(number)]
        await asyncio.sleep(0.5)
        return [*asked, sweeps.reply(number)]

    assert with_sweeps(late, kept=0.2) == [HowFar(), None]


def test_how_far_it_is_grows():
    question = SweepQuestion(Case("3d12"), (("shaft.main.speed", "1000..2000 rpm:400"),), ("largest_piston_force",))

    async def followed(sweeps):
        number = sweeps.begin(question)
        seen = []
        while isinstance(found := sweeps.reply(number), HowFar):
            seen.append(found)
            await asyncio.sleep(0.02)
        return seen, found

    seen, reply = with_sweeps(followed)
    assert reply.status == 200, reply.content[:300]
    assert seen == sorted(seen)
    assert seen[0] == HowFar(0, 0)
