"""A service says what it says in the language that is asked for, to each in their own."""

from concurrent.futures import ThreadPoolExecutor

import pytest
from fastapi.testclient import TestClient
from tests.packed_answers import opened
from tests.pseudo_locale import PSEUDO, marked, write_catalogue
from tests.sentences import NOT_POSITIVE

from cranktrain import language
from cranktrain.web.service import service

MACHINE = {"machine": "textbook_78x78"}
WRONG = {**MACHINE, "settings": ["bank.line.mechanism.stroke=-3 mm"]}


@pytest.fixture
def client(tmp_path, monkeypatch):
    write_catalogue(tmp_path)
    monkeypatch.setattr(language, "_LOCALE", tmp_path)
    language._catalogue.cache_clear()
    with TestClient(service(), base_url="http://127.0.0.1:8765") as one:
        yield one
    language._catalogue.cache_clear()


def test_each_is_answered_in_the_language_that_they_ask(client):
    def asked(of):
        data, _numbers = opened(client.post("/api/case", json={**MACHINE, "language": of}))
        trouble, *_others = client.post("/api/case", json={**WRONG, "language": of}).json()
        return data["language"], data["words"]["undo"], data["machine"]["tabs"][0]["title"], trouble["allowed"]

    expected = {"en": ("en", "Undo", "Motion", f"{NOT_POSITIVE} mm")}
    expected[PSEUDO] = (PSEUDO, marked("Undo"), marked("Motion"), f"{marked(NOT_POSITIVE)} mm")
    of = ["en", PSEUDO] * 4
    with ThreadPoolExecutor(4) as threads:
        assert list(threads.map(asked, of)) == [expected[one] for one in of]


def test_languages_call_themselves_what_they_are_called(client):
    data, _numbers = opened(client.post("/api/case", json=MACHINE))
    assert [(one["code"], one["name"]) for one in data["languages"]] == [("en", "English"), (PSEUDO, marked("English"))]


@pytest.mark.parametrize("of", ["xx", "../locale", "pseudo/..", "\0"])
def test_a_language_that_is_not_there_is_refused(client, of):
    answer = client.post("/api/trust", json={**MACHINE, "language": of})
    assert answer.status_code == 422
    assert answer.json()[0]["path"] == "language"
    assert answer.json()[0]["allowed"].endswith(f"en, {PSEUDO}")
