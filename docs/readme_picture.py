"""Draws the picture of the README anew, light enough to be kept: `python docs/readme_picture.py`."""

import io
from pathlib import Path

from PIL import Image

import cranktrain as ct
from cranktrain.viz import save, sheet

EXAMPLE = "3d12"
PICTURE = Path(__file__).parent / "static" / f"{EXAMPLE}.png"
WIDTH, COLOURS = 1200, 64


def drawn() -> Image.Image:
    """Give the sheet of the example, in few colours."""
    file = PICTURE.with_suffix(".large.png")
    save(sheet(ct.run(ct.load(EXAMPLE))), file)
    with Image.open(io.BytesIO(file.read_bytes())) as large:
        file.unlink()
        size = (WIDTH, round(WIDTH * large.height / large.width))
        return large.convert("RGB").resize(size, Image.Resampling.LANCZOS).quantize(COLOURS)


if __name__ == "__main__":
    drawn().save(PICTURE, optimize=True)
