"""How soon a page is drawn anew after an edit, and how evenly it plays, in Chromium on this computer.

    python benchmarks/page.py [MACHINE:PATH:TAB ...]

Each edit sets a number by its field, as somebody types it, and waits for the picture after the first one in which the
answer has changed. Of it are shown: waiting for the service (request to last byte), drawing (script on the page from
there on), and the rest, which is the browser's layout, painting and its waiting for the next frame.
"""

import re
import subprocess
import sys
from itertools import pairwise
from pathlib import Path
from statistics import median, quantiles

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.browser import browser

EDITS = 40
CASES = ("3d12:shaft.main.speed:Largest forces", "burning_cylinder:shaft.main.speed:", "jaw_crusher:shaft.main.speed:")

WATCHED = """
() => {
  const times = { asked: 0, answered: 0, filled: 0 };
  window.times = times;
  const fetch = window.fetch;
  window.fetch = async (...asked) => {
    if (!String(asked[0]).endsWith("api/case")) return fetch(...asked);
    times.asked = performance.now();
    const answer = await fetch(...asked);
    const whole = answer.arrayBuffer.bind(answer);
    answer.arrayBuffer = async () => { const found = await whole(); times.answered = performance.now(); return found; };
    return answer;
  };
}
"""
EDIT = """
([label, value]) => new Promise((done) => {
  const field = [...document.querySelectorAll(".numbers label")].find((one) => one.title === label).control;
  const start = performance.now();
  const watcher = new MutationObserver(() => {
    watcher.disconnect();
    const filled = performance.now();
    requestAnimationFrame(() => {
      const channel = new MessageChannel();
      channel.port1.onmessage = () => {
        const { asked, answered } = window.times;
        done([performance.now() - start, answered - asked, filled - answered]);
      };
      channel.port2.postMessage(0);
    });
  });
  watcher.observe(document.querySelector("#page"), { subtree: true, childList: true, characterData: true });
  field.value = value;
  field.dispatchEvent(new Event("change", { bubbles: true }));
})
"""
FRAMES = """
() => new Promise((done) => {
  const times = [];
  const next = (time) => { times.push(time); if (times.length < 180) requestAnimationFrame(next); else done(times); };
  requestAnimationFrame(next);
})
"""


def main() -> None:
    """Measure each case and show it."""
    command = [sys.executable, "-m", "cranktrain", "web", "--no-browser"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, encoding="utf-8")
    try:
        address = re.search(r"http://\S+/", process.stdout.readline())[0]
        with browser() as chromium:
            for case in sys.argv[1:] or CASES:
                show(chromium, address, *case.split(":"))
    finally:
        process.terminate()


def show(chromium, address, machine, path, tab) -> None:
    """Measure one machine on one tab."""
    context = chromium.new_context(viewport={"width": 1440, "height": 900}, reduced_motion="reduce")
    page = context.new_page()
    page.goto(f"{address}#machine={machine}&tab={tab}&phi=70")
    page.wait_for_selector(".numbers")
    page.evaluate(WATCHED)
    text = page.locator(f'.numbers label[title="{path}"] + input').input_value()
    number, _space, unit = text.partition(" ")
    found = []
    for edit in range(EDITS + 5):
        found.append(page.evaluate(EDIT, [path, f"{float(number) * (1 + 0.001 * (edit + 1)):.5g} {unit}"]))
        page.wait_for_timeout(120)
    whole, waiting, drawing = (sorted(one) for one in zip(*found[5:], strict=True))
    page.locator("button.play").click()
    frames = page.evaluate(FRAMES)
    between = [later - sooner for sooner, later in pairwise(frames)]
    print(
        f"{machine:18} edit to picture {median(whole):5.1f} ms, 95 % {quantiles(whole, n=20)[-1]:5.1f}; "
        f"of it the service {median(waiting):5.1f}, drawing {median(drawing):5.1f}; "
        f"a frame {median(between):5.1f}, the longest {max(between):5.1f}",
        flush=True,
    )
    context.close()


if __name__ == "__main__":
    main()
