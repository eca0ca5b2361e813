"""Pictures of pages for the documents are made of the service as it is: each with something in it, one that moves."""

import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image
from tests.e2e.conftest import environment

ROOT = Path(__file__).parents[2]


@pytest.mark.usefixtures("chromium")  # says so where there is none
def test_pictures_and_the_recording_are_made(tmp_path):
    script = ROOT / "client" / "record_pages.py"
    subprocess.run([sys.executable, str(script), str(tmp_path)], check=True, env=environment(), timeout=300)
    shipped = {path.name for path in (ROOT / "docs" / "static").glob("*.*") if path.suffix in (".png", ".gif")}
    made = {path.name for path in tmp_path.iterdir()}
    assert made <= shipped
    assert len(made) == 5
    for name in made:
        with Image.open(tmp_path / name) as picture:
            assert len(picture.convert("RGB").getcolors(1 << 20)) > 20
    with Image.open(tmp_path / "web.gif") as recording:
        frames = []
        for place in range(recording.n_frames):
            recording.seek(place)
            frames.append(recording.convert("RGB").tobytes())
    assert len(set(frames)) == len(frames) > 12
