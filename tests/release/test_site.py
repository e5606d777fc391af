"""The documentation site: it builds without a warning, every link leads somewhere, and it asks nobody for anything."""

import json
import os
import re
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import make_site
import pytest
from launch import add_buttons, in_colab
from live_pages import enliven
from serving import served
from waiting import until

import rlrobot_edu as rl
from rlrobot_course.authoring.lists import facts, lessons
from rlrobot_edu.task.task_file import available_tasks

ROOT = Path(__file__).parents[2]
MAIN_PAGES = (
    "docs/index", "notebooks/03_q_learning", "docs/howto/your_own_task", "docs/api/learning",
)  # fmt: skip
OTHERS = ("tasks/README", "docs/lessons", "docs/real_robot", "docs/stepper")
LIVE = {
    "steppers": "<Stepper at step",
    "explorers": "<BiasExplorer of",
    "replays": "Replay of",
}
SERIOUS = {"serious", "critical"}
NONE_OF = {"landmark-unique"}  # less serious, and not to come back
AT_HOME = """import sys, launch
launch.SOURCE = "https://github.com/owner/name"
import make_site
sys.exit(make_site.main())"""
LOOKS = {
    "light": {},
    "dark": {"runOnly": ["color-contrast"]},
}  # in the dark nothing else is another


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """The folder of its pages, built once; a warning of Sphinx fails every test."""
    for package in ("sphinx", "myst_nb", "furo", "meshcat", "pybullet"):
        pytest.importorskip(
            package, reason=f"needs {package}: pip install 'rlrobot-edu[lab,arm,docs]'"
        )
    build = tmp_path_factory.mktemp("site")
    env = os.environ | {"PYTHONPATH": str(ROOT / "docs/site")}
    command = [sys.executable, "-c", AT_HOME, build]
    done = subprocess.run(
        command,
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=600,
        cwd=build,
        env=env,
    )
    assert done.returncode == 0 and "WARNING" not in done.stderr, (
        done.stdout + done.stderr
    )
    return build / "html"


class Page(HTMLParser):
    """What a page names: its own anchors, where its links lead, what it loads, and the words of its pictures."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.anchors, self.links, self.loads, self.alts = set(), [], [], []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors.update(given[name] for name in ("id", "name") if given.get(name))
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        if tag in ("script", "img", "iframe") and "src" in given:
            self.loads.append(given["src"])
        if tag == "link" and given.get("rel") in ("stylesheet", "icon", "preload"):
            self.loads.append(given["href"])
        if tag == "img":
            self.alts.append(given.get("alt") or "")


@pytest.fixture(scope="module")
def pages(site):
    return {
        path: Page(path)
        for path in site.rglob("*.html")
        if not {"_static", "lite"} & set(path.parts)
    }


def test_every_lesson_task_and_dataset_has_its_place(site, pages):
    assert len(pages) > 60
    for notebook in [*lessons(ROOT).values(), *ROOT.glob("notebooks/homework/*.ipynb")]:
        assert site / notebook.relative_to(ROOT).with_suffix(".html") in pages
    tasks = pages[site / "tasks/README.html"].links
    for task in available_tasks():
        assert any(link.endswith(f"/{task}.py") for link in tasks)
    datasets = pages[site / "datasets/README.html"].links
    for dataset in (ROOT / "datasets").glob("*/README.md"):
        assert f"{dataset.parent.name}/README.html" in datasets


def test_each_page_has_a_description_and_a_card_for_who_shares_a_link(site, pages):
    made_by_sphinx = [site / "docs" / f"{name}.html" for name in ("index", "method")]
    alone = [
        site / "index.html",
        site / "docs/a_robot_learns.html",
        site / "docs/who_does_it_ask.html",
    ]
    lessons_made = [site / "notebooks/05_qbiassr.html"]
    steppers = sorted((site / "docs/steppers").glob("*.html"))
    for path in [*made_by_sphinx, *alone, *lessons_made, *steppers]:
        text = path.read_text(encoding="utf-8")
        for name in (
            'name="description"',
            'property="og:title"',
            'property="og:description"',
        ):
            assert re.search(rf'<meta {name} content="[^"]{{10,}}"', text), (path, name)


def test_a_shared_link_to_any_page_shows_a_picture_that_is_in_the_site(site, pages):
    without = []
    for path in pages:
        text = path.read_text(encoding="utf-8")
        found = re.findall(r'<meta property="og:image" content="([^"]+)"', text)
        has_card = "og:title" in text
        if has_card and [(path.parent / name).is_file() for name in found] != [True]:
            without.append((path.relative_to(site), found))
    assert without == []


def test_each_lesson_has_a_card_with_its_picture_minutes_and_what_one_writes(site):
    text = (site / "docs/lessons.html").read_text(encoding="utf-8")
    cards = re.findall(r'<a class="card" href="\.\./([^"]+)">(.*?)</a>', text, re.S)
    for (page, card), lesson in zip(cards, facts(ROOT).values(), strict=True):
        assert page == lesson.path.relative_to(ROOT).with_suffix(".html").as_posix()
        assert f"{lesson.minutes} minutes. You write: " in card
        (picture,) = re.findall(r'src="(cards/\d\d\.png)"', card)
        assert (site / "docs" / picture).stat().st_size < 30_000


def test_a_page_says_the_whole_address_of_its_picture_once_the_site_has_one(
    tmp_path, monkeypatch
):
    monkeypatch.setattr(make_site, "ADDRESS", "https://example.org/course/")
    page = tmp_path / "page.html"
    page.write_text('<meta property="og:title" content="A page">', encoding="utf-8")
    make_site.show_when_shared(page, Path("docs/steppers/page.html"))
    assert 'content="https://example.org/course/docs/card.png"' in page.read_text(
        encoding="utf-8"
    )


def test_steppers_explorers_and_replays_of_the_lessons_are_alive(site, pages):
    lives = {folder: 0 for folder in LIVE}
    for notebook in lessons(ROOT).values():
        cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
        text_of = json.dumps(
            [c for c in cells if "still" not in c["metadata"].get("tags", [])],
            ensure_ascii=False,
        )
        loads = pages[site / notebook.relative_to(ROOT).with_suffix(".html")].loads
        for folder, text in LIVE.items():
            shows_one = f'"{text}' in text_of
            assert (
                any(load.startswith(f"{folder}/{notebook.stem}_") for load in loads)
                is shows_one
            )
            lives[folder] += shows_one
    assert min(lives.values()) >= 1, lives


def test_what_differs_from_its_notebook_does_not_get_into_the_site(tmp_path):
    """And of the cells before it those alone are run that it needs."""
    cells = [
        "from types import SimpleNamespace as Name",
        "1 / 0",
        "x = 3",
        "x += 1",
        "Name(x=x)",
    ]
    kept = {
        "output_type": "display_data",
        "data": {"text/plain": "Replay of steps", "text/html": ""},
    }
    content = [
        {"cell_type": "code", "metadata": {}, "source": cell, "outputs": []}
        for cell in cells
    ]
    content[-1]["outputs"] = [kept]
    (tmp_path / "lesson.ipynb").write_text(
        json.dumps({"cells": content}), encoding="utf-8"
    )
    with pytest.raises(
        ValueError,
        match=r"lesson: its replay in 3D is kept as Replay of steps, but is .*\(x=4\)",
    ):
        enliven(tmp_path / "lesson.ipynb", tmp_path)


def test_every_lesson_leads_to_its_copy_for_colab(site, pages):
    for notebook in lessons(ROOT).values():
        name = notebook.relative_to(ROOT)
        assert (
            in_colab(name.as_posix(), "https://github.com/owner/name")
            in pages[site / name.with_suffix(".html")].links
        )
        assert (site / "colab" / name).is_file()


def test_a_lesson_has_a_button_for_each_place_that_runs_it(tmp_path):
    name = "notebooks/03_q_learning.ipynb"
    lesson, files = Path(shutil.copy(ROOT / name, tmp_path)), tmp_path / "lite/files"
    before = lesson.read_text(encoding="utf-8")
    add_buttons(
        lesson, tmp_path / "lite", in_colab(name, "https://codeberg.org/owner/name")
    )
    assert lesson.read_text(encoding="utf-8") == before, (
        "Colab opens what is on GitHub only"
    )
    files.mkdir(parents=True)
    (files / lesson.name).touch()
    add_buttons(
        lesson, tmp_path / "lite", in_colab(name, "https://github.com/owner/name")
    )
    addresses = re.findall(
        'href="([^"]+)"',
        json.loads(lesson.read_text(encoding="utf-8"))["cells"][1]["source"],
    )
    assert addresses == [
        f"../lite/index.html?path={lesson.name}",
        f"https://colab.research.google.com/github/owner/name/blob/gh-pages/colab/{name}",
    ]


def test_every_public_name_is_described(site, pages):
    anchors = {
        anchor
        for path, page in pages.items()
        if path.parent == site / "docs/api"
        for anchor in page.anchors
    }
    public = {name for name in dir(rl) if not name.startswith("_")}
    assert {f"rlrobot_edu.{name}" for name in public} <= anchors


def test_every_picture_is_said_in_words(site, pages):
    """Sphinx writes the name of the file where words are missing."""
    wordless = [
        f"{path.relative_to(site)}: {alt!r}"
        for path, page in pages.items()
        for alt in page.alts
        if " " not in alt or alt.endswith((".png", ".gif"))
    ]
    assert wordless == []
    assert sum(len(page.alts) for page in pages.values()) > 150


def test_every_link_within_the_site_leads_somewhere(site, pages):
    lost = []
    for path, page in pages.items():
        for link in page.links + page.loads:
            target = urlsplit(link)
            if target.scheme or target.netloc:
                continue
            to = (path.parent / unquote(target.path)).resolve() if target.path else path
            anchor = unquote(target.fragment)
            if not to.is_file() or (
                anchor and to in pages and anchor not in pages[to].anchors
            ):
                lost.append(f"{path.relative_to(site)}: {link}")
    assert lost == []


def test_no_page_loads_anything_from_elsewhere(pages):
    elsewhere = [
        load
        for page in pages.values()
        for load in page.loads
        if urlsplit(load).scheme not in ("", "data")
    ]
    assert elsewhere == []


@pytest.fixture(scope="module")
def address(site):
    with served(site) as address:
        yield address


@pytest.mark.parametrize(
    "name",
    [*MAIN_PAGES, *(pytest.param(page, marks=pytest.mark.nightly) for page in OTHERS)],
)
def test_a_page_is_quiet_and_open_to_all(address, browser, name):
    """No request leaves the machine, the console is silent, axe-core finds nothing serious, a phone need not scroll."""
    axe = pytest.importorskip(
        "axe_playwright_python.sync_playwright", reason="needs axe-playwright-python"
    ).Axe()
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    said, asked = [], set()
    page.on("console", lambda message: said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    page.on("request", lambda request: asked.add(request.url))
    try:
        page.goto(f"{address}/{name}.html", wait_until="load")
        found = []
        for look, rules in LOOKS.items():
            page.emulate_media(color_scheme=look)
            violations = axe.run(page, options=rules).response["violations"]
            found += [
                (v["id"], [n["html"][:100] for n in v["nodes"]])
                for v in violations
                if v["impact"] in SERIOUS or v["id"] in NONE_OF
            ]
        page.set_viewport_size({"width": 400, "height": 800})
        assert page.evaluate("document.documentElement.scrollWidth") <= 400
    finally:
        page.close()
    assert said == [] and found == []
    assert {
        url for url in asked if not url.startswith((address, "data:", "blob:"))
    } == set()


@pytest.mark.parametrize(
    ("lesson", "folder"), [("03_q_learning", "steppers"), ("05_qbiassr", "explorers")]
)
def test_frames_follow_the_switch_between_light_and_dark(
    address, browser, lesson, folder
):
    page = browser.new_page(
        color_scheme="null"
    )  # no scheme pretended: pretence is for all frames alike
    dark = "matchMedia('(prefers-color-scheme: dark)').matches"
    try:
        page.goto(f"{address}/notebooks/{lesson}.html")
        page.locator(f"iframe.{folder}").scroll_into_view_if_needed()
        page.frame_locator(f"iframe.{folder}").locator(".said").first.wait_for()
        # a frame that is still to be loaded would be asked for ever
        page.evaluate(
            "document.querySelectorAll('iframe').forEach((frame) => (frame.loading = 'eager'))"
        )
        frames = [frame for frame in page.frames if frame.parent_frame]
        for frame in frames:
            frame.wait_for_load_state()
        page.locator(
            "button.theme-toggle >> visible=true"
        ).click()  # from what the browser has to its opposite
        before = page.evaluate("document.body.dataset.theme")
        for theme in (before, {"dark": "light", "light": "dark"}[before]):
            page.wait_for_function(f"document.body.dataset.theme === '{theme}'")
            for frame in frames:
                until(frame, f"{dark} === {str(theme == 'dark').lower()}")
            page.locator("button.theme-toggle >> visible=true").click()
        assert frames
    finally:
        page.close()


def test_the_sidebar_shows_at_most_twenty_pages_before_a_click(address, browser):
    page = browser.new_page(viewport={"width": 1280, "height": 2000})
    try:
        page.goto(f"{address}/docs/index.html")
        assert page.locator(".sidebar-tree a:visible").count() <= 20
    finally:
        page.close()


def test_on_the_front_page_a_robot_asks_and_the_playground_is_one_click_away(
    address, browser
):
    page = browser.new_page(reduced_motion="reduce")
    try:
        page.goto(f"{address}/docs/index.html")
        until(
            page, "frames.length === 1 && frames[0].document.readyState === 'complete'"
        )
        until(page.frames[1], "phase === 'ask' && !isMoving")
        page.get_by_role("link", name="the playground", exact=True).first.click()
        page.wait_for_url(f"{address}/docs/a_robot_learns.html*")
        until(page, "yours.simulation.t > 100")
    finally:
        page.close()


def test_a_replay_plays_and_an_explorer_answers_within_their_lessons(address, browser):
    page = browser.new_page()
    try:
        page.goto(f"{address}/notebooks/14_sample_models.html")
        page.locator("iframe.replays").scroll_into_view_if_needed()
        replay = page.frame_locator("iframe.replays")
        replay.get_by_role("button", name="Last").click()
        replay.get_by_text("step 50 of 50: reward").first.wait_for()
        page.goto(f"{address}/notebooks/05_qbiassr.html")
        page.locator("iframe.explorers").scroll_into_view_if_needed()
        explorer = page.frame_locator("iframe.explorers")
        explorer.get_by_role("button", name=re.compile(r"^13\b")).click()
        explorer.get_by_text("State 13 (").first.wait_for()
    finally:
        page.close()


def test_a_formula_is_set_and_a_stepper_steps(address, browser):
    page = browser.new_page()
    try:
        page.goto(f"{address}/notebooks/03_q_learning.html")
        page.wait_for_selector("math")
        page.locator("iframe.steppers").first.scroll_into_view_if_needed()
        page.frame_locator("iframe.steppers").first.get_by_text(
            "Step 31 (episode"
        ).first.wait_for()
        page.goto(f"{address}/")  # leads to docs/index.html
        page.wait_for_url(f"{address}/docs/index.html")
        page.goto(f"{address}/docs/stepper.html")
        page.locator("iframe").first.scroll_into_view_if_needed()
        stepper = page.frame_locator("iframe").first
        stepper.locator("button[name=step]").click()
        stepper.get_by_text("Step 2 (episode 1").first.wait_for()
    finally:
        page.close()
