"""What is made when the package is built, and stands in no repository."""

import json
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest
from babel.messages.extract import extract_from_dir
from babel.messages.pofile import read_po

from cranktrain.analysis import unasked
from cranktrain.cli.completing import making
from cranktrain.cli.other_messages import other_messages

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "src/cranktrain"


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """The archive of the sources and the package."""
    folder = tmp_path_factory.mktemp("built")
    build = [sys.executable, "-m", "hatchling", "build", "-d", folder, "-t", "sdist", "-t", "wheel"]
    subprocess.run(build, cwd=ROOT, check=True, capture_output=True)
    (sources,), (package,) = folder.glob("*.tar.gz"), folder.glob("*.whl")
    return sources, package


def test_names_to_complete_are_those_of_the_program(built):
    with zipfile.ZipFile(built[1]) as package:
        assert json.loads(package.read("cranktrain/cli/completing/names.json")) == making.made()


def test_questions_that_a_file_does_not_ask_are_those_of_the_program(built):
    with zipfile.ZipFile(built[1]) as package:
        listed = json.loads(package.read("cranktrain/analysis/unasked.json"))
    assert listed == json.loads(json.dumps(unasked.made()))


def test_translators_find_every_message_in_the_sources_and_users_none(built):
    found = extract_from_dir(str(PACKAGE), [("**.py", "python")], keywords={"_": None, "N_": None})
    said = {message for _file, _line, message, _comments, _context in found}
    with tarfile.open(built[0]) as sources:
        name = next(name for name in sources.getnames() if name.endswith("src/cranktrain/locale/cranktrain.pot"))
        template = {message.id for message in read_po(sources.extractfile(name)) if message.id}
    assert template == said | set(other_messages())
    with zipfile.ZipFile(built[1]) as package:
        assert not [name for name in package.namelist() if name.endswith(".pot")]
