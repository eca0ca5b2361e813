"""Pages look as they did: pictures of some are compared with those in `looks`, a quarter as large.

Where a page is meant to look otherwise, `python -m tests.e2e.test_looks_in_browser` draws all of them anew.
"""

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from tests.browser import Watched, browser

import cranktrain as ct
from cranktrain.web.standalone import standalone_page

LOOKS = Path(__file__).parent / "looks"
SHRUNK = 4
FAR = 40
"""Between values of a colour, of 255, that look like another."""
MOST_FAR = 0.02
"""Of all points of a picture: letters are drawn a little otherwise by another release of a browser."""
LETTERS = (
    "<style>* { font-family: 'DejaVu Sans' !important } .symbol, .symbol * { font-family: 'DejaVu Serif' !important }"
)
PAGES = {
    "v12_motion": ("3d12", "Motion", "light"),
    "v12_forces": ("3d12", "Largest forces", "light"),
    "crusher_dark": ("jaw_crusher", "Loads", "dark"),
    "radial": ("r_1340", "Motion", "light"),
    "deltic": ("deltic", "Motion", "light"),
    "pumping_unit": ("pumping_unit_c57", "Torque", "light"),
    "press": ("high_slip_press", "Torque", "light"),
    "compressor": ("two_throw_compressor", "Gas", "light"),
    "chain": ("shaper", "Motion", "light"),
    "valve_gear": ("lms_class5", "Motion", "light"),
}


def picture(one, folder, example, tab, colours):
    """A picture of a page, shrunk."""
    path = folder / f"{example}.html"
    path.write_text(standalone_page(ct.run(example)).replace("<style>", LETTERS, 1), encoding="utf-8")
    context = one.new_context(
        viewport={"width": 1440, "height": 900}, reduced_motion="reduce", color_scheme=colours, device_scale_factor=1
    )
    page = Watched(context, path.as_uri() + "#phi=70").page
    page.locator(".tabs button", has_text=tab).first.click()
    page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))")
    shot = Image.open(io.BytesIO(page.screenshot(animations="disabled"))).convert("RGB")
    context.close()
    return shot.reduce(SHRUNK)


@pytest.mark.parametrize("name", PAGES)
def test_it_looks_as_it_did(chromium, tmp_path, name):
    found = picture(chromium, tmp_path, *PAGES[name])
    before = Image.open(LOOKS / f"{name}.png").convert("RGB")
    assert found.size == before.size
    apart = np.abs(np.asarray(found, int) - np.asarray(before, int)).max(axis=2)
    if (far := np.mean(apart > FAR)) > MOST_FAR:
        found.save(tmp_path / f"{name}.png")
        pytest.fail(
            f"{far:.1%} of it looks otherwise: see {tmp_path / name}.png, and how to draw {LOOKS.name} anew above"
        )


def draw_anew(folder):
    """Write all pictures."""
    with browser() as one:
        for name, page in PAGES.items():
            picture(one, folder, *page).quantize(64).save(LOOKS / f"{name}.png", optimize=True)


if __name__ == "__main__":
    from tempfile import TemporaryDirectory

    LOOKS.mkdir(exist_ok=True)
    with TemporaryDirectory() as scratch:
        draw_anew(Path(scratch))
