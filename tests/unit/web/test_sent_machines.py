"""Machines that are sent as text: what they name is found among what was sent with them, and never on the disk."""

import sys
from pathlib import Path

import numpy as np
import pytest
from fastapi.testclient import TestClient
from tests.packed_answers import opened
from tests.sentences import NOT_SENT

import cranktrain as ct
from cranktrain.io.examples import example_text
from cranktrain.web.service import service

CANARY = "canary-7f3a"
CYLINDER = """
[mechanism]
kind = "slider_crank"
crank_radius = "50 mm"
rod_length = "180 mm"
[cylinder]
bore = "90 mm"
compression_ratio = 10
cycle = "two-stroke"
[shaft.main]
speed = "1500 rpm"
"""
CARD = CYLINDER + '[gas]\nkind = "indicator"\nfile = {file}\n'
TABLES = {
    "gas": CARD,
    "shaft.main.speed_curve": CYLINDER + "speed_curve = {{ file = {file} }}\n",
    "load.x": CYLINDER + '[load.x]\non = "main"\nfile = {file}\n',
    "crankshaft.pull.x": CYLINDER + "[crankshaft.pull.x]\nfile = {file}\n",
}
PARTS = ("case", "tab", "trust", "members", "handles", "file")

_watches: list[list[str]] = []


def _watch(event: str, arguments: tuple[object, ...]) -> None:
    if event in ("open", "os.listdir", "os.scandir"):
        for names in _watches:
            names.append(str(arguments[0]))


sys.addaudithook(_watch)  # which stays as long as the process


@pytest.fixture
def touched():
    """Names of all files and folders that are opened meanwhile."""
    _watches.append([])
    yield _watches[-1]
    _watches.clear()


@pytest.fixture
def client():
    with TestClient(service(), base_url="http://127.0.0.1:8765") as one:
        yield one


@pytest.fixture
def secret(tmp_path, monkeypatch):
    """A folder in which one works, with a file that nobody may have; it would be a card, and a speed curve."""
    home = tmp_path / f"home-{CANARY}"
    (home / "work").mkdir(parents=True)
    monkeypatch.chdir(home / "work")
    for path in (home / "secret.csv", home / "work" / "secret.csv"):
        path.write_text(f"{CANARY} deg;{CANARY} bar\n" + "\n".join(f"{i};{2 + i % 3}" for i in range(-180, 180)))
    (home / "work" / "linked.csv").symlink_to(home / "secret.csv")
    return home / "secret.csv"


def card(peak):
    """A smooth card over the crank angle. [bar]"""
    angles = np.arange(-180, 180)
    pressures = 1.0 + (peak - 1.0) * (1.0 + np.cos(np.deg2rad(angles))) / 2.0
    rows = (f"{angle};{pressure:.9f}" for angle, pressure in zip(angles, pressures, strict=True))
    return "angle, deg;p, bar\n" + "\n".join(rows)


def rows_of(data):
    contents = (tab["content"] for tab in data["machine"]["tabs"])
    return {row["name"]: row["cells"] for content in contents if content for row in content["answer"]["rows"]}


def test_a_text_gives_what_its_file_gives(client):
    of_text, numbers = opened(client.post("/api/case", json={"text": example_text("3d12"), "tab": "Largest forces"}))
    of_name, expected = opened(client.post("/api/case", json={"machine": "3d12", "tab": "Largest forces"}))
    assert of_text == of_name
    assert numbers.tobytes() == expected.tobytes()


def test_settings_change_a_text_and_its_comments_stay(client):
    sent = {"text": "# mine\n" + CYLINDER, "settings": ["cylinder.bore=91 mm"]}
    assert client.post("/api/file", json=sent).text == "# mine\n" + CYLINDER.replace("90 mm", "91 mm")


def test_what_it_names_is_found_among_what_was_sent(client, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "card.csv").write_text(card(90.0))
    (tmp_path / "mine.toml").write_text(CARD.format(file='"other.csv"'))
    (tmp_path / "other.csv").write_text(card(20.0))
    expected = ct.run("mine.toml", quantities="peak_pressure").peak_pressure[0] / 1e5
    sent = {"text": CARD.format(file='"card.csv"'), "files": {"card.csv": card(20.0), "x": ""}}
    rows = {}
    for tab in opened(client.post("/api/case", json=sent))[0]["machine"]["tabs"]:
        rows |= rows_of(opened(client.post("/api/case", json=sent | {"tab": tab["name"]}))[0])
    assert float(rows["peak pressure"][0]) == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("table", TABLES)
@pytest.mark.parametrize(
    "name",
    ["{path}", "secret.csv", "./secret.csv", "../secret.csv", "../work/linked.csv", "linked.csv", "file://{path}",
     "//{path}", "SECRET.CSV", "secret.csv\\u0000", "secret", "", "..", "/", "~/secret.csv", "%2e%2e/secret.csv"],
)  # fmt: skip
def test_nothing_comes_from_the_disk(client, secret, touched, table, name):
    text = TABLES[table].format(file=f'"{name.format(path=secret)}"')
    for part in PARTS:
        answer = client.post(f"/api/{part}", json={"text": text, "files": {"card.csv": card(20.0)}})
        assert answer.status_code == 422
        said = answer.text.replace(str(secret), "")  # which was sent
        assert CANARY not in said
        assert NOT_SENT in [one["allowed"] for one in answer.json() if one["path"] == f"{table}.file"]
    assert [path for path in touched if CANARY in path or "secret" in path or "linked" in path] == []


@pytest.mark.parametrize("name", ["3d12", "/etc/passwd", "secret.csv", "../secret.csv", "", "\n", "a = 1"])
def test_a_text_is_no_name(client, secret, touched, name):
    for part in PARTS:
        answer = client.post(f"/api/{part}", json={"text": name})
        assert answer.status_code == 422
        assert CANARY not in answer.text
        assert "root:" not in answer.text
    assert [path for path in touched if CANARY in path or "passwd" in path or "secret" in path] == []


def test_nothing_that_stands_beside_comes_from_the_disk(client, secret, touched):
    text = CARD.format(file=f'"{secret}"')
    for beside in ({"text": text}, {"machine": str(secret)}, {"machine": "3d12", "settings": [f"gas.file={secret}"]}):
        for part in ("case", "tab"):
            answer = client.post(f"/api/{part}", json={"machine": "textbook_78x78", "beside": beside})
            assert answer.status_code == 422
            assert CANARY not in answer.text.replace(str(secret), "")
    assert [path for path in touched if CANARY in path or "secret" in path] == []


def test_what_is_wrong_stands_with_its_line(client):
    (problem,) = client.post("/api/case", json={"text": CYLINDER.replace("90 mm", "-90 mm")}).json()
    assert (problem["path"], problem["given"], problem["line"]) == ("cylinder.bore", "-90 mm", 7)
    (problem,) = client.post("/api/case", json={"text": "a = \n[["}).json()
    assert problem["line"] == 1


@pytest.mark.parametrize(
    ("sent", "path"),
    [
        ({"machine": "3d12", "text": CYLINDER}, "machine"),
        ({"machine": "3d12", "files": {"a": "b"}}, "files"),
        ({"text": "#" * 64_001}, "text"),
        ({"text": CYLINDER, "files": {str(n): "" for n in range(21)}}, "files"),
        ({"text": CYLINDER, "files": {"a": 3}}, "files.a"),
        ({"text": CYLINDER, "files": {"a" * 501: ""}}, f"files.{'a' * 501}.[key]"),
        ({"text": CYLINDER, "settings": ["gas.file=card.csv"]}, "gas.file"),
    ],
)
def test_what_does_not_go_together_or_is_too_much_is_refused(client, sent, path):
    answer = client.post("/api/case", json=sent)
    assert answer.status_code == 422
    assert [one["path"] for one in answer.json()] == [path]


def test_an_example_reads_its_own_files_alone(client, secret):
    example = Path(ct.__file__).parent / "examples"
    assert not [path for path in example.iterdir() if path.suffix == ".csv"]
    assert CANARY not in client.post("/api/case", json={"machine": "mill_engine"}).text
