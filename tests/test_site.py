"""The documentation site: it builds without a warning, every link leads somewhere, and it asks nobody for anything."""

import functools
import subprocess
import sys
import threading
from html.parser import HTMLParser
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

import rlrobot_edu as rl

ROOT = Path(__file__).parents[1]
MAIN_PAGES = ("docs/index", "notebooks/02_q_learning", "docs/api/learning", "docs/tasks", "docs/real_robot")
SERIOUS = {"serious", "critical"}


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """The folder of its pages, built once; a warning of Sphinx fails every test."""
    for package in ("sphinx", "myst_nb", "furo"):
        pytest.importorskip(package, reason=f"needs {package}: pip install 'rlrobot-edu[docs]'")
    build = tmp_path_factory.mktemp("site")
    command = [sys.executable, ROOT / "docs/make_site.py", build]
    done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", timeout=600, cwd=build)
    assert done.returncode == 0 and "WARNING" not in done.stderr, done.stdout + done.stderr
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
    return {path: Page(path) for path in site.rglob("*.html") if not {"_static", "lite"} & set(path.parts)}


def test_every_lesson_task_and_dataset_has_its_place(site, pages):
    assert len(pages) > 60
    for notebook in (ROOT / "notebooks").glob("*.ipynb"):
        assert site / "notebooks" / f"{notebook.stem}.html" in pages
    assert set(rl.available_tasks()) <= {anchor.replace("-", "_") for anchor in pages[site / "docs/tasks.html"].anchors}
    for dataset in (ROOT / "datasets").glob("*/README.md"):
        assert f"../datasets/{dataset.parent.name}/README.html" in pages[site / "docs/datasets.html"].links


def test_the_steppers_of_the_lessons_are_alive(site, pages):
    for notebook in (ROOT / "notebooks").glob("*.ipynb"):
        shows_one = "<Stepper at step" in notebook.read_text(encoding="utf-8")
        page = f"steppers/{notebook.stem}.html"
        assert (page in pages[site / "notebooks" / f"{notebook.stem}.html"].loads) is shows_one


def test_every_public_name_is_described(site, pages):
    anchors = {anchor for path, page in pages.items() if path.parent == site / "docs/api" for anchor in page.anchors}
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
    assert sum(len(page.alts) for page in pages.values()) > 200


def test_every_link_within_the_site_leads_somewhere(site, pages):
    lost = []
    for path, page in pages.items():
        for link in page.links + page.loads:
            target = urlsplit(link)
            if target.scheme or target.netloc:
                continue
            to = (path.parent / unquote(target.path)).resolve() if target.path else path
            anchor = unquote(target.fragment)
            if not to.is_file() or (anchor and to in pages and anchor not in pages[to].anchors):
                lost.append(f"{path.relative_to(site)}: {link}")
    assert lost == []


def test_no_page_loads_anything_from_elsewhere(pages):
    elsewhere = [load for page in pages.values() for load in page.loads if urlsplit(load).scheme not in ("", "data")]
    assert elsewhere == []


class Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


@pytest.fixture(scope="module")
def address(site):
    with ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=site)) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()
        thread.join()


@pytest.mark.parametrize(
    ("name", "look"),
    [*((name, "light") for name in (*MAIN_PAGES, "docs/stepper")), *((name, "dark") for name in MAIN_PAGES[:2])],
)
def test_a_page_is_quiet_and_open_to_all(address, browser, name, look):
    """No request leaves the machine, the console is silent, axe-core finds nothing serious, a phone need not scroll."""
    axe = pytest.importorskip("axe_playwright_python.sync_playwright", reason="needs axe-playwright-python").Axe()
    page = browser.new_page(color_scheme=look, viewport={"width": 1280, "height": 900})
    said, asked = [], set()
    page.on("console", lambda message: said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    page.on("request", lambda request: asked.add(request.url))
    try:
        page.goto(f"{address}/{name}.html", wait_until="load")
        page.wait_for_function("!window.MathJax?.startup || !document.querySelector('.math') "
                               "|| document.querySelector('mjx-container')")  # fmt: skip
        found = [
            (v["id"], [node["html"][:100] for node in v["nodes"]])
            for v in axe.run(page).response["violations"]
            if v["impact"] in SERIOUS
        ]
        page.set_viewport_size({"width": 400, "height": 800})
        assert page.evaluate("document.documentElement.scrollWidth") <= 400
    finally:
        page.close()
    assert said == [] and found == []
    assert {url for url in asked if not url.startswith((address, "data:", "blob:"))} == set()


def test_a_formula_is_set_and_a_stepper_steps(address, browser):
    page = browser.new_page()
    try:
        page.goto(f"{address}/notebooks/02_q_learning.html")
        page.wait_for_selector("mjx-container")
        page.locator("iframe").first.scroll_into_view_if_needed()
        page.frame_locator("iframe").first.get_by_text("step 31 of 51").first.wait_for()
        page.goto(f"{address}/")  # leads to docs/index.html
        page.wait_for_url(f"{address}/docs/index.html")
        page.goto(f"{address}/docs/stepper.html")
        page.locator("iframe").first.scroll_into_view_if_needed()
        stepper = page.frame_locator("iframe").first
        stepper.locator("button[name=step]").click()
        stepper.get_by_text("step 2 of 40").first.wait_for()
    finally:
        page.close()
