"""The client of pages: its types are those of the records, what is built is of its sources, and its own tests pass."""

from importlib.util import module_from_spec, spec_from_file_location

import pytest
from tests.client import CLIENT, installed, run

BUILT = CLIENT.parent / "src/cranktrain/web/built"


@pytest.fixture(scope="module")
def client(tmp_path_factory):
    """The sources in a folder of their own."""
    return installed(tmp_path_factory.mktemp("built"))


def test_types_are_those_of_the_records():
    spec = spec_from_file_location("write_types", CLIENT / "write_types.py")
    written = module_from_spec(spec)
    spec.loader.exec_module(written)
    assert (CLIENT / "src/data.ts").read_text(encoding="utf-8") == written.types_text(), "python client/write_types.py"


def test_what_is_built_is_of_these_sources(client):
    run("npm", "run", "build", folder=client)
    found = client.parent / "src/cranktrain/web/built"
    assert sorted(path.name for path in found.iterdir()) == sorted(path.name for path in BUILT.iterdir())
    for path in found.iterdir():
        assert path.read_bytes() == (BUILT / path.name).read_bytes(), f"{path.name}: npm run build in client/"


def test_types_hold(client):
    run("npm", "run", "check", folder=client)


def test_its_own_tests_pass(client):
    run("npm", "test", folder=client)


def test_the_lock_file_names_no_host():
    text = (CLIENT / "package-lock.json").read_text(encoding="utf-8")
    assert "resolved" not in text
    assert text.count('"integrity"') > 20
