"""How fast the playground is in Chromium: ``python studies/benchmarks/playground.py``. Prints a table in Markdown."""

import shutil
import tempfile
from pathlib import Path

from playwright.sync_api import sync_playwright

import rlrobot_edu as rl

SECONDS = 4.0
RUNS = {
    "wander in a maze, TOSL+QBIASSR": "task=wander_1k&method=TOSL%2BQBIASSR",
    "wander in a maze, TOSL+SR": "task=wander_1k&method=TOSL%2BSR",
    "wander in a square, TOSL+QBIASSR": "task=wander_simple&method=TOSL%2BQBIASSR",
    "drive to the goal, TOSL+QBIASSR": "task=navigation_1k&method=TOSL%2BQBIASSR",
    "the cliff, Q-learning": "task=cliff&method=Q%2BEG",
}
FIRST = "performance.getEntriesByName('learned')[0].startTime"
MARK = (
    "new MutationObserver((_, it) => { performance.mark('learned'); it.disconnect(); })"
)
COUNT = """(seconds) => new Promise((done) => {
  const from = yours.simulation.t, begun = performance.now();
  let frames = 0;
  const next = () => {
    frames += 1;
    const passed = (performance.now() - begun) / 1000;
    if (passed < seconds) requestAnimationFrame(next);
    else done([frames / passed, (yours.simulation.t - from) / passed]);
  };
  requestAnimationFrame(next);
})"""


def main() -> None:
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as p:
        path = Path(folder, "playground.html")
        rl.playground(path)
        browser = p.chromium.launch(executable_path=shutil.which("chromium"))
        print(
            f"{path.stat().st_size / 1000:.0f} kB. Chromium {browser.version}, 1280 × 800, as fast as it can:\n"
        )
        print(
            "| task and method | frames a second | steps a second | first update shown after |"
        )
        print("|---|---|---|---|")
        for name, link in RUNS.items():
            page = browser.new_page(viewport={"width": 1280, "height": 800})
            page.add_init_script(
                f"addEventListener('DOMContentLoaded', () => {MARK}.observe(document.body, "
                "{subtree: true, childList: true}))"
            )
            page.goto(f"{path.as_uri()}#{link}&speed=10000")
            page.wait_for_timeout(1500)  # until its code is compiled
            frames, steps = page.evaluate(COUNT, SECONDS)
            print(
                f"| {name} | {frames:.0f} | {steps:,.0f} | {page.evaluate(FIRST) / 1000:.2f} s |"
            )
            page.close()
        browser.close()


if __name__ == "__main__":
    main()
