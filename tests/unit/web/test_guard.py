"""What a service lets in: its own host name, its own pages, requests of a size, and whoever has the token."""

import pytest
from fastapi.testclient import TestClient

from cranktrain.web.guard import Door
from cranktrain.web.service import service

ASKED = {"machine": "textbook_78x78"}
TOKEN = "right-token-Zx"
LAN = "http://192.168.1.5:8765"


@pytest.fixture
def client():
    with TestClient(service(), base_url="http://127.0.0.1:8765") as one:
        yield one


@pytest.fixture
def stranger():
    """Somebody at another computer, who has no token yet."""
    door = Door("192.168.1.5", TOKEN)
    with TestClient(service(door=door), base_url=LAN) as one:
        yield one


def allowed(answer):
    (problem,) = answer.json()
    return problem["allowed"]


def test_it_answers_to_its_own_name_alone(client):
    refused = client.get("/", headers={"Host": "evil.example"})
    assert (refused.status_code, allowed(refused)) == (400, "answers to 127.0.0.1 alone")
    for name in ("localhost:8765", "127.0.0.1", "[::1]:8765", "LOCALHOST"):
        assert client.get("/", headers={"Host": name}).status_code == 200
    for name in ("127.0.0.1.evil.example", "192.168.1.5", "localhost@evil.example", "", "[::1", "127.0.0.2"):
        assert client.get("/", headers={"Host": name}).status_code == 400


def test_no_other_page_asks_it(client):
    for origin in ("http://evil.example", "null", "http://127.0.0.1:8766", "http://localhost:8765"):
        refused = client.post("/api/case", json=ASKED, headers={"Origin": origin})
        assert (refused.status_code, allowed(refused)) == (403, "takes no request from another page")
    own = {"Origin": "http://127.0.0.1:8765"}
    assert client.post("/api/case", json=ASKED, headers=own).status_code == 200


def test_a_browser_is_forbidden_to_ask_others(client):
    for path in ("/", "/app.js", "/app.css", "/nothing.js"):
        policy = client.get(path).headers["Content-Security-Policy"]
        assert "default-src 'none'" in policy
        assert "connect-src 'self'" in policy
    assert "default-src 'none'" in client.get("/", headers={"Host": "evil.example"}).headers["Content-Security-Policy"]


def test_what_is_too_large_is_not_read(client):
    for content in (b" " * 300_000, iter([b"{}"])):
        refused = client.post("/api/case", content=content)
        assert (refused.status_code, allowed(refused)) == (
            413,
            "is too long: what is sent may have 256 kB, and says how many",
        )


@pytest.mark.parametrize(
    "path", ["/", "/app.js", "/openapi.json", "/api/examples", "/?token=", "/?token=right-token-Zy"]
)
def test_a_stranger_learns_nothing(stranger, path):
    refused = stranger.get(path)
    assert refused.status_code == 401
    assert allowed(refused).startswith("needs the token of the address")
    assert TOKEN not in refused.text
    assert "set-cookie" not in refused.headers


@pytest.mark.parametrize("token", ["", "Bearer ", "Bearer x", f"Basic {TOKEN}", f"Bearer {TOKEN}x", "Bearer \xff"])
def test_no_other_token_does(stranger, token):
    headers = {"Authorization": token.encode("latin-1")}
    assert stranger.post("/api/case", json=ASKED, headers=headers).status_code == 401


def test_a_program_sends_the_token_along(stranger):
    assert stranger.post("/api/case", json=ASKED, headers={"Authorization": f"Bearer {TOKEN}"}).status_code == 200


def test_a_browser_has_it_from_the_address_and_keeps_it_where_no_script_and_no_other_page_can(stranger):
    page = stranger.get(f"/?token={TOKEN}")
    assert page.status_code == 200
    cookie = page.headers["set-cookie"]
    assert cookie == f"cranktrain-8765={TOKEN}; HttpOnly; SameSite=Strict; Path=/"
    assert stranger.get("/app.js").status_code == 200  # by what it was given
    assert stranger.post("/api/case", json=ASKED).status_code == 200
    assert stranger.post("/api/case", json=ASKED, headers={"Origin": "http://evil.example"}).status_code == 403


def test_at_all_addresses_numbers_are_its_own_names_and_no_other_name_is():
    door = Door("0.0.0.0", TOKEN)
    for name in ("192.168.1.5", "10.0.0.1", "localhost", "::1", "fe80::1"):
        assert door.has_name(name)
    assert not door.has_name("evil.example")
    assert Door("works.example", TOKEN).has_name("Works.Example")
    assert not Door("works.example", TOKEN).has_name("10.0.0.1")


@pytest.mark.parametrize(
    ("host", "is_open"),
    [("127.0.0.1", False), ("127.0.0.9", False), ("localhost", False), ("::1", False), ("0.0.0.0", True),
     ("::", True), ("192.168.1.5", True), ("works.example", True)],
)  # fmt: skip
def test_which_hosts_others_reach(host, is_open):
    assert Door(host).is_open is is_open
