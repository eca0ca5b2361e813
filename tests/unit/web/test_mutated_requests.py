"""A thousand requests that are almost right: each is answered or refused in a sentence, and none is a fault of ours."""

import json
import random

import pytest
from fastapi.testclient import TestClient

from cranktrain.web.service import service

N_REQUESTS = 1000
TEXT = """# a small one
[mechanism]
kind = "slider_crank"
crank_radius = "50 mm"
rod_length = "180 mm"
[cylinder]
bore = "80 mm"
[shaft.main]
speed = "1500 rpm"
"""
RIGHT = (
    {
        "machine": "textbook_78x78",
        "settings": ["mechanism.rod_length=140 mm"],
        "tab": "Motion",
        "beside": {"machine": "3d12"},
    },
    {"text": TEXT, "files": {"a.csv": "0;1\n90;2"}, "settings": ["cylinder.bore=81 mm"], "tab": "Motion"},
    {"text": TEXT + '[load.x]\non = "main"\nfile = "a.csv"\n', "files": {"a.csv": "deg;N m\n0;1\n90;2\n"}},
    {
        "machine": "toggle_press",
        "addition": {
            "mechanism": "1",
            "name": "pin",
            "angle": 60.0,
            "clicks": [{"name": "upper", "right": 0.4, "up": 0.1}],
        },
    },
    {"text": TEXT, "vary": {"mechanism.rod_length": "130..160 mm:4"}, "wanted": ["stroke"]},
)
ODD = (
    None, True, -1, 10**30, 1e308, float("nan"), "", "=", "a=b", "\x00", "\ud800", "é" * 300, "../x", "{}", [], {},
    [[[[[[]]]]]], {"a": {"a": {}}}, ["a"] * 1000, "shaft.main.throws=[" + "0," * 200, "x.y=1 mm", "tab", 1e-320,
    "mechanism.rod_length=1e400 mm", "mechanism.kind=chain", "cylinder.bore=[1,2]", "shaft.main.speed=inf rpm",
    "bank.A.mechanism.stroke=1 mm", "mechanism.rod_length=nan mm", "units.length=furlong", "[" * 50_000,
)  # fmt: skip
ASKED = ("/api/case", "/api/tab", "/api/others", "/api/trust", "/api/members", "/api/handles", "/api/file")
OTHERS = ("/api/none", "/api/sweep", "/api/gallery", "/api/examples", "/", "/app.css")
WAYS = ("POST",) * 12 + ("GET", "PUT", "DELETE", "OPTIONS", "HEAD")
HEADERS = (
    {"Content-Type": "text/plain"}, {"Content-Type": "application/x-www-form-urlencoded"}, {"Origin": "http://x"},
    {"Host": "x"}, {"Content-Type": "application/json; charset=utf-16"}, {"Content-Length": "-3"}, {"Accept": "x"},
    {"Content-Encoding": "gzip"}, {"Authorization": "x"}, {"Cookie": "a=\xff"}, {"Content-Length": "99999999999"},
)  # fmt: skip


def mutated(drawn, value, depth=0):
    """Put something odd in one place of what JSON holds."""
    if depth == 3 or drawn.random() < 0.25 or not value:
        return drawn.choice(ODD)
    if isinstance(value, dict):
        key = drawn.choice(list(value))
        changed = dict(value)
        if drawn.random() < 0.1:
            changed[str(drawn.choice(ODD))[:600]] = changed.pop(key)
        else:
            changed[key] = mutated(drawn, value[key], depth + 1)
        return changed
    if isinstance(value, list):
        return [*value[:-1], mutated(drawn, value[-1], depth + 1)]
    return typed_wrong(drawn, value) if isinstance(value, str) else drawn.choice(ODD)


def typed_wrong(drawn, text):
    """Take out, double, or replace some letters of a text."""
    for _time in range(drawn.randint(1, 3)):
        place = drawn.randrange(len(text) + 1)
        length = drawn.choice((1, 1, 2, 5, 20))
        instead = drawn.choice(("", "", text[place : place + length] * 2, drawn.choice('"[]{}=.\n#-9\\é\t\x01')))
        text = text[:place] + instead + text[place + length :]
    return text


def requests():
    drawn = random.Random(49)
    for _number in range(N_REQUESTS):
        body = json.dumps(mutated(drawn, drawn.choice(RIGHT)))
        if drawn.random() < 0.2:
            body = typed_wrong(drawn, body)
        content = body.encode(errors="surrogatepass")
        if drawn.random() < 0.05:
            content = drawn.randbytes(drawn.randint(1, 40)) + content
        headers = {"Content-Type": "application/json"} | (drawn.choice(HEADERS) if drawn.random() < 0.1 else {})
        path = drawn.choice(ASKED if drawn.random() < 0.95 else OTHERS)
        yield drawn.choice(WAYS), path, content, headers


@pytest.fixture
def client():
    with TestClient(service(), base_url="http://127.0.0.1:8765") as one:
        yield one


def test_none_is_a_fault(client, capfd):
    n_by_status = {}
    for number, (way, path, content, headers) in enumerate(requests()):
        coded = {name: value.encode("latin-1") for name, value in headers.items()}
        answer = client.request(way, path, content=content, headers=coded)
        n_by_status[answer.status_code] = n_by_status.get(answer.status_code, 0) + 1
        place = f"request {number}: {way} {path} {content[:300]!r} {headers}"
        assert answer.status_code < 500, place
        if answer.status_code >= 400:
            assert "Traceback" not in answer.text, place
            assert way == "HEAD" or all(problem["allowed"] for problem in answer.json()), place
    assert "Traceback" not in capfd.readouterr().err
    # What is drawn is neither all right nor all refused at the first look.
    assert n_by_status[200] > 50
    assert n_by_status[422] > 300
    assert n_by_status.keys() >= {400, 404, 405, 413}
