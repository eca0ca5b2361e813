"""The service of pages: what it gives, what it refuses, and that it reads no file but its own."""

import json
import os

import numpy as np
import pytest
from fastapi.testclient import TestClient
from tests.packed_answers import opened

import cranktrain as ct
from cranktrain.web.service import service

CANARY = "canary-7f3a"


@pytest.fixture
def client():
    with TestClient(service(), base_url="http://127.0.0.1:8765") as one:
        yield one


def asked(machine="textbook_78x78", *settings):
    return {"machine": machine, "settings": settings}


def test_a_number_set_anew_is_in_all_that_is_shown(client):
    data, _numbers = opened(client.post("/api/case", json=asked("3d12", "shaft.main.speed=1800 rpm")))
    assert "1800 rpm" in data["machine"]["made_of"]
    row = next(
        row for row in data["machine"]["tabs"][0]["content"]["answer"]["rows"] if row["name"] == "mean piston speed"
    )
    expected = ct.run("3d12", set={"shaft.main.speed": "1800 rpm"}).mean_piston_speed
    assert float(row["cells"][0]) == pytest.approx(expected[0], rel=1e-3)


def test_inputs_are_those_of_the_file(client):
    data, _numbers = opened(client.post("/api/case", json=asked("3d12")))
    inputs = {one["path"]: one for table in data["tables"] for one in table["inputs"]}
    assert inputs["bank.L.mechanism.stroke"]["text"] == "180 mm"
    assert inputs["bank.L.mechanism.stroke"]["status"] == "published"
    assert inputs["shaft.main.throws[1]"]["name"] == "throws 2"


def test_only_the_open_tab_has_its_content_and_others_come_when_they_are_asked_for(client):
    data, _numbers = opened(client.post("/api/case", json={"machine": "3d12", "tab": "Largest forces"}))
    tabs = data["machine"]["tabs"]
    assert [tab["title"] for tab in tabs if tab["content"]] == ["Largest forces"]
    assert data["machine"]["trust"] is None
    whole, _numbers = opened(client.post("/api/tab", json={"machine": "3d12", "tab": "Main bearings"}))
    assert whole["answer"]["title"] == "Main bearings"
    going_on, _numbers = opened(client.post("/api/trust", json={"machine": "3d12"}))
    trust = going_on["trust"]
    assert len(trust["checks"]) == len(ct.run("3d12").checks)
    assert any("[masses.crank]" in sentence for sentence in trust["to_mind"])
    first, _numbers = opened(client.post("/api/case", json={"machine": "3d12", "tab": "Nothing"}))
    assert first["machine"]["tabs"][0]["content"]["answer"]["title"] == tabs[0]["title"]


@pytest.mark.parametrize(("machine", "tab"), [("3d12", "Main bearings"), ("r_1340", "Largest forces")])
def test_what_a_browser_opens_comes_compressed(client, machine, tab):
    answer = client.post("/api/case", json={"machine": machine, "tab": tab})
    assert answer.headers["Content-Encoding"] == "gzip"
    assert answer.num_bytes_downloaded < 100_000 < len(answer.content)
    plain = client.post("/api/case", json={"machine": machine, "tab": tab}, headers={"Accept-Encoding": "identity"})
    assert plain.content == answer.content


def test_a_served_file_that_was_written_anew_is_read_anew(tmp_path):
    path = tmp_path / "mine.toml"
    text = '[mechanism]\nkind = "slider_crank"\ncrank_radius = "50 mm"\nrod_length = "{} mm"\n'
    with TestClient(service(str(path)), base_url="http://localhost:8765") as client:
        for time, rod in enumerate(("130", "140")):
            path.write_text(text.format(rod))
            os.utime(path, (time, time))
            data, _numbers = opened(client.post("/api/case", json=asked("")))
            assert f"{rod} mm" in {one["text"] for table in data["tables"] for one in table["inputs"]}


def test_pins_that_may_be_moved_say_which_numbers_that_changes(client):
    data, _numbers = opened(client.post("/api/handles", json=asked("3d12", "bank.L.mechanism.rod_length=330 mm")))
    numbers = {handle["pin"]: handle["numbers"][0] for handle in data["handles"] if handle["mechanism"] == "1L"}
    assert (numbers["B"]["paths"], numbers["B"]["number"]) == (["bank.L.mechanism.rod_length"], 330.0)
    assert data["open"] == []
    short, _numbers = opened(client.post("/api/handles", json=asked("3d12", "bank.L.mechanism.rod_length=80 mm")))
    assert "close" in short["open"][0]


def clicked(name="pair", mechanism="1", angle=60.0, clicks=(("knee", 0, 0), ("", 0.3, 0.3), ("C", 0, 0))):
    places = [{"name": pin, "right": right, "up": up} for pin, right, up in clicks]
    return asked("toggle_press") | {
        "addition": {"mechanism": mechanism, "name": name, "angle": angle, "clicks": places},
    }


def test_a_part_that_is_clicked_stands_in_the_file_and_is_a_machine(client):
    data, _numbers = opened(client.post("/api/handles", json=asked("toggle_press")))
    assert [(one["mechanism"], one["name"]) for one in data["additions"]] == [
        ("1", "point"), ("1", "pin"), ("1", "slider_pin"), ("1", "eccentric"), ("1", "pair"), ("1", "swivel"),
        ("1", "slider"), ("1", "yoke"), ("1", "trammel"), ("1", "triad"),
    ]  # fmt: skip
    sent = clicked()
    sent["settings"] = ["mechanism.crank.main.radius=49 mm"]
    text = client.post("/api/file", json=sent).text
    before = client.post("/api/file", json=asked("toggle_press", *sent["settings"])).text
    # The knee is 320 mm from the crank pin and 250 mm from C, to the right of the line from one to the other.
    pin, pivot = 0.049 * np.exp(1j * np.pi / 3), 0.4 + 0.25j
    apart = abs(pivot - pin)
    corner = np.arccos((0.32**2 + apart**2 - 0.25**2) / (2 * 0.32 * apart))
    knee = pin + 0.32 * np.exp(1j * (np.angle(pivot - pin) - corner))
    assert [line for line in text.splitlines() if line not in before.splitlines()] == [
        f'rod = {{ name = "rod", from = "knee", length = "{1e3 * abs(0.3 + 0.3j - knee):.0f} mm" }}',
        'rocker = { name = "rocker", from = "C", length = "112 mm" }',
        'joint = "B"',
        'side = "left"',
    ]
    data, _numbers = opened(client.post("/api/handles", json={"text": text}))
    assert "B" in [one["pin"] for one in data["handles"]]
    assert data["open"] == []


NAN = float("nan")


@pytest.mark.parametrize(
    "sent",
    [
        {"clicks": [("knee", 0, 0), ("", NAN, 0.3), ("C", 0, 0)]},
        {"clicks": [("knee", 0, 0), ("", 0.3, float("inf")), ("C", 0, 0)]},
        {"clicks": [("knee", 0, 0), ("", 0.3, 1e9), ("C", 0, 0)]},
        {"clicks": [("knee", 0, 0), ("", "here", 0.3), ("C", 0, 0)]},
        {"clicks": [("no_pin", 0, 0), ("", 0.3, 0.3), ("C", 0, 0)]},
        {"clicks": [("knee", 0, 0)] * 11},
        {"clicks": []},
        {"name": "wheel"},
        {"name": "x" * 600},
        {"mechanism": "7"},
        {"mechanism": None},
        {"angle": NAN},
        {"angle": 1e12},
    ],
    ids=str,
)
def test_a_part_that_cannot_be_is_refused(client, sent):
    answer = client.post("/api/file", content=json.dumps(clicked(**sent)), headers={"Content-Type": "application/json"})
    assert answer.status_code == 422
    assert answer.json()[0]["allowed"]
    assert answer.json()[0]["path"].startswith("addition") or "mechanism" in sent


@pytest.mark.parametrize("malformed", [[], "pair", {"name": "pair"}, {"mechanism": "1", "name": "pair", "clicks": {}}])
def test_a_malformed_part_is_refused(client, malformed):
    answer = client.post("/api/file", json=asked("toggle_press") | {"addition": malformed})
    assert answer.status_code == 422
    assert all(one["path"].startswith("addition") for one in answer.json())


def test_the_file_keeps_its_comments(client):
    text = client.post("/api/file", json=asked("3d12", "cylinder.bore=151 mm")).text
    assert 'bore = "151 mm"' in text
    assert text.count("#") > 3
    assert ct.Machine(**__import__("tomllib").loads(text)).cylinder.bore.text == "151 mm"


def test_all_that_is_wrong_is_said_with_its_path(client):
    answer = client.post("/api/case", json=asked("3d12", "cylinder.bore=-3 mm", "gas.pressure_ratio=0.2"))
    assert answer.status_code == 422
    assert {one["path"] for one in answer.json()} == {"cylinder.bore", "gas.pressure_ratio"}
    assert answer.json()[0]["given"] == "-3 mm"


@pytest.mark.parametrize("machine", ["/etc/passwd", "../../secret.toml", "secret.toml", "", "x" * 499])
def test_no_name_becomes_a_file(client, machine, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "secret.toml").write_text(CANARY)
    answer = client.post("/api/case", json=asked(machine))
    assert answer.status_code == 422
    assert CANARY not in answer.text
    assert answer.json()[0]["path"] == "machine"


@pytest.mark.parametrize(
    "setting",
    [
        "shaft.main.speed_curve.file={file}",
        'shaft.main.speed_curve={{file="{file}"}}',
        "gas.file={file}",
        'load={{a={{file="{file}"}}}}',
        'shaft.main."speed_curve".file={file}',
        'shaft.main.speed_curve."file"={file}',
    ],
)
def test_no_setting_reads_a_file(client, setting, tmp_path):
    path = tmp_path / "secret.csv"
    path.write_text(f"{CANARY}\n{CANARY},1\n")
    answer = client.post("/api/case", json=asked("3d12", setting.format(file=path)))
    assert answer.status_code == 422
    assert CANARY not in answer.text


@pytest.mark.parametrize(
    "body",
    [
        b"",
        b"{",
        b"[" * 20_000,
        b'{"machine": 3}',
        b'{"settings": "a=1"}',
        b'{"settings": [' + b'"a=1",' * 101 + b'"a=1"]}',
        b'{"machine": "' + b"x" * 501 + b'"}',
        b'{"machine": "\xff"}',
        json.dumps(asked("3d12", "=")).encode(),
        json.dumps(asked("3d12", "a" * 499)).encode(),
        json.dumps(asked("3d12", "a." * 240 + "b=1")).encode(),
        json.dumps(asked("3d12", "cylinder.bore=1e999 mm")).encode(),
    ],
)
def test_what_is_malformed_is_refused(client, body):
    answer = client.post("/api/case", content=body, headers={"Content-Type": "application/json"})
    assert 400 <= answer.status_code < 500


def test_what_is_too_long_is_told_in_a_sentence_at_its_place(client):
    for body, path, words in (
        (asked("3d12", "cylinder.bore=" + "9" * 500), "cylinder.bore", "is too long: it may have 500 characters"),
        (asked("3d12", *["a=1"] * 101), "settings", "is too much at once: 100 may be sent"),
        ({"text": "#" * 64_001}, "text", "is too long: it may have 64000 characters"),
    ):
        (problem,) = client.post("/api/case", json=body).json()
        assert (problem["path"], problem["allowed"]) == (path, words)


def test_script_in_a_name_stays_text(client):
    data, _numbers = opened(client.post("/api/case", json=asked("3d12", "name=<b>x</b>")))
    assert data["machine"]["name"] == "<b>x</b>"


def test_its_interface_is_described(client):
    schema = client.get("/openapi.json").json()
    assert set(schema["paths"]) == {
        *(
            "/api/case",
            "/api/tab",
            "/api/trust",
            "/api/members",
            "/api/others",
            "/api/handles",
            "/api/file",
            "/api/examples",
            "/api/gallery",
            *("/api/export", "/api/whence"),
        ),
        *("/api/sweep", "/api/sweep/{number}"),
    }
    for table in ("PageAsked", "SweepAsked"):
        sent = schema["components"]["schemas"][table]["properties"]
        assert {name for name, one in sent.items() if not one.get("description")} == set()
    replies = schema["paths"]["/api/case"]["post"]["responses"]
    assert list(replies["200"]["content"]) == ["application/octet-stream"]
    assert {"422", "503"} <= replies.keys()


@pytest.mark.parametrize(
    ("way", "path", "status"), [("get", "/api/case", 405), ("get", "/api/none", 404), ("get", "/none.js", 404)]
)
def test_what_is_not_there_is_said_so(client, way, path, status):
    answer = getattr(client, way)(path)
    assert answer.status_code == status
    assert answer.json()[0]["allowed"]


def test_machines_that_take_too_much_are_refused(client):
    kind = 'kind="slider_crank",crank_radius="50 mm",rod_length="130 mm"'
    bank = f"[bank.A]\nmechanism={{{kind}}}\n"
    for n_throws, allowed in ((201, "has 201 mechanisms; a page shows at most 200"), (1001, "must have at most 1000")):
        answer = client.post("/api/case", json={"text": f"{bank}[shaft.main]\nthrows={['0 deg'] * n_throws}"})
        assert answer.status_code == 422
        assert allowed in answer.json()[0]["allowed"]


def test_a_served_file_stands_beside_the_examples(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text('[mechanism]\nkind = "slider_crank"\ncrank_radius = "50 mm"\nrod_length = "130 mm"\n')
    with TestClient(service(str(path)), base_url="http://localhost:8765") as client:
        data, _numbers = opened(client.post("/api/case", json=asked("", "mechanism.rod_length=140 mm")))
        assert {one["text"] for table in data["tables"] for one in table["inputs"]} == {"50 mm", "140 mm"}


def test_a_number_says_where_it_is_from(client):
    found, _numbers = opened(client.post("/api/whence", json={"machine": "3d12", "quantity": "largest_side_force"}))
    assert any("eq. (13.10)" in sentence for sentence in found["sentences"])
    assert {"bank.R.mechanism.rod_length", "gas.cut_off_ratio"} <= set(found["inputs"])
    assert "largest_forces" in found["stages"]
    answer = client.post("/api/whence", json={"machine": "3d12", "quantity": "no_such_thing"})
    assert answer.status_code == 422
