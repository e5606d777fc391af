"""The course in the browser: the site that `make lite` builds, and what Python in WebAssembly learns."""

import os
import subprocess
import sys
import threading
import zipfile
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib.metadata import files, version
from pathlib import Path

import make_lite
import nbformat
import pytest
from nbclient import NotebookClient
from serving import served
from waiting import eventually

ROOT = Path(__file__).parents[2]
PYODIDE = Path(os.environ.get("RLROBOT_EDU_PYODIDE", "no folder"))
needs_pyodide = pytest.mark.skipif(
    not PYODIDE.is_dir(), reason="needs Pyodide: tests/unpack_pyodide.sh"
)
PUBLIC = "cdn.jsdelivr.net"
PURE = (
    "gymnasium",
    "farama-notifications",
    "cloudpickle",
    "typing-extensions",
    "lazy-loader",
)
PURE += ("packaging", "tqdm", "joblib")
LEARN = """
import hashlib
import rlrobot_edu as rl

digest = hashlib.sha256()
for name, steps in {"worked_example": 200, "wander_1k": 100}.items():
    model = rl.SampleModel.from_recording(rl.read_recording(name))
    for method in ("Q+EG", "SARSA+SR", "SL+SR", "TOSL+SR", "TOSL+QBIASSR"):
        agent = rl.Agent(model, method, seed=0)
        rl.learn(agent, rl.make_env(model, seed=0), steps=steps, progress=False)
        digest.update(agent.q.tobytes() + agent.e.tobytes())
planner = rl.Agent("worked_example", "Q+EG", planner="dyna", seed=0)
rl.learn(planner, rl.make_env("worked_example", seed=0), steps=20, progress=False)
digest.update(planner.q.tobytes())
"""
PAGE = """<!doctype html><meta charset="utf-8"><title>learning</title><script type="module">
import { loadPyodide } from "./pyodide.mjs";
window.learn = async (code) => {
    const python = await loadPyodide();
    const bring = async (name, format) => {
        const answer = await fetch(name);
        return [await answer.arrayBuffer(), format];
    };
    const site = "/lib/python3.12/site-packages";
    python.unpackArchive(...(await bring("numpy.tar.gz", "gztar")), { extractDir: "/numpy" });
    python.unpackArchive(...(await bring("packages.zip", "zip")), { extractDir: site });
    python.runPython("import sys; sys.path.append('/numpy/lib/python3.12/site-packages')");
    return python.runPython(code + "\\nsys.modules.get('numba'), digest.hexdigest()").toJs();
};
</script>"""


def build(folder, *arguments):
    """The site that `make lite` builds."""
    command = [sys.executable, ROOT / "docs/lite/make_lite.py", folder, *arguments]
    env = os.environ | {"HOME": os.environ["RLROBOT_TESTS_USERS_HOME"]}
    done = subprocess.run(
        command, capture_output=True, text=True, encoding="utf-8", timeout=600, env=env
    )
    if "No matching distribution" in done.stderr or "ConnectionError" in done.stderr:
        pytest.skip("needs a package index, for the wheels that Pyodide lacks")
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    return folder / "site"


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    pytest.importorskip(
        "jupyterlite_pyodide_kernel",
        reason="needs jupyterlite: pip install --group lite",
    )
    return build(tmp_path_factory.mktemp("lite"))


@contextmanager
def opened(browser, folder, path, answers=True):
    """A page of the site, and the addresses beside it that are asked for; all of them are refused, or never answered.

    They are asked through a proxy, which learns of everything: of pages, workers and service workers.
    """
    asked = set()

    class Refusing(BaseHTTPRequestHandler):
        def do_CONNECT(self):
            asked.add(self.path.removesuffix(":443"))
            if answers:
                self.send_error(403)
            else:
                stop.wait()

        do_GET = do_POST = do_CONNECT

        def log_message(self, *_):
            pass

    stop, proxy = threading.Event(), ThreadingHTTPServer(("127.0.0.1", 0), Refusing)
    threading.Thread(target=proxy.serve_forever).start()
    through = {"server": f"http://127.0.0.1:{proxy.server_port}", "bypass": "127.0.0.1"}
    try:
        with served(folder) as address, browser.new_context(proxy=through) as context:
            page = context.new_page()
            page.set_default_timeout(300_000)
            page.goto(f"{address}/{path}", wait_until="commit")
            yield page, asked
    finally:
        stop.set()
        proxy.shutdown()
        proxy.server_close()
        asked.discard(
            "content-autofill.googleapis.com"
        )  # asked by Chromium itself, of any page with a field


def test_the_versions_are_those_that_the_kernel_is_made_for():
    constants = pytest.importorskip("jupyterlite_pyodide_kernel.constants")
    assert (make_lite.PYODIDE, make_lite.PYTHON) == (
        constants.PYODIDE_VERSION,
        constants.PYODIDE_PYTHON_VERSION,
    )
    assert constants.PYODIDE_CDN_URL in make_lite.PUBLIC


def test_a_lesson_opens_and_asks_only_for_pyodide(site, browser):
    with opened(browser, site, "lab/index.html?path=00_start_here.ipynb") as (
        page,
        asked,
    ):
        page.get_by_role(
            "heading", name="Start here: a robot learns to wander"
        ).first.wait_for()
        page.get_by_text("03_q_learning.ipynb").first.wait_for()
        eventually(
            lambda: asked, lambda: page.wait_for_timeout(500), 300
        )  # the kernel asks for Pyodide
        page.wait_for_timeout(5_000)  # for anything else that may ask
    assert asked == {PUBLIC}


@pytest.mark.parametrize("answers", [True, False])
def test_where_the_network_lets_nothing_through_a_sentence_says_so_within_five_seconds(
    site, browser, answers
):
    """Whether the public address is refused, or never answers."""
    with opened(browser, site, "index.html?path=03_q_learning.ipynb", answers) as (
        page,
        asked,
    ):
        page.get_by_text(f"Python cannot be fetched from {PUBLIC}").wait_for(
            timeout=5_000
        )
        assert asked == {PUBLIC}
        page.get_by_role("link", name="without Python").click()
        page.get_by_role("heading", name="03 Q-learning").first.wait_for()


def test_an_old_browser_is_told_which_ones_are_new_enough(site, browser):
    with opened(browser, site, "robots.txt") as (page, _):
        page.add_init_script("delete WebAssembly.Tag")
        page.goto(page.url.replace("robots.txt", "index.html"))
        page.get_by_text("This browser is too old to run Python").wait_for(
            timeout=5_000
        )


@pytest.mark.nightly
@pytest.mark.parametrize("lesson", make_lite.smaller_numbers())
def test_a_lesson_with_smaller_numbers_runs_from_top_to_bottom(lesson, tmp_path):
    """Here, with numba and SciPy: a browser has to do the same, only slower."""
    notebook = nbformat.from_dict(
        make_lite.in_browser(
            ROOT / f"notebooks/{lesson}.ipynb", make_lite.smaller_numbers()[lesson]
        )
    )
    notebook.cells = [cell for cell in notebook.cells if cell.id != "install"]
    NotebookClient(
        notebook, kernel_name="python3", resources={"metadata": {"path": tmp_path}}
    ).execute()


@pytest.mark.nightly
@needs_pyodide
def test_a_site_with_its_own_pyodide_runs_python_and_asks_nobody_else(
    browser, tmp_path
):
    """With the kernel that the lessons have, which needs no NumPy; packages come from the site's own index.

    Not tried: what the first cell of a lesson installs, since NumPy, SciPy and Matplotlib for this Pyodide are to be
    had from its public address alone.
    """
    pytest.importorskip(
        "jupyterlite_pyodide_kernel",
        reason="needs jupyterlite: pip install --group lite",
    )
    folder = build(tmp_path, "--pyodide", PYODIDE / "course")
    code = "import sys, piplite; await piplite.install('gymnasium', deps=False)\nimport importlib.metadata as m\n"
    code += "print(sys.platform, m.version('gymnasium'))\nawait piplite.install('no-such-package')"
    with opened(browser, folder, "index.html?path=18_real_robot.ipynb") as (
        page,
        asked,
    ):
        page.get_by_role("heading", name="18 A real robot").first.wait_for()
        page.locator(".jp-CodeCell .cm-content").first.click()
        page.keyboard.press("Control+A")
        page.keyboard.insert_text(code)
        page.keyboard.press("Shift+Enter")
        page.get_by_text(f"emscripten {version('gymnasium')}").first.wait_for()
        page.get_by_text("no-such-package").nth(1).wait_for()
    assert not asked


def zip_packages(path):
    """What Python in the browser needs beside NumPy: packages of plain Python, and the toolkit with its data."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in PURE:
            for file in files(name):
                if file.suffix == ".py" or (
                    ".dist-info" in str(file) and ".." not in str(file)
                ):
                    archive.write(file.locate(), str(file))
        for folder, inside in {
            "rlrobot_edu": "",
            "rlrobot_course": "",
            "tasks": "rlrobot_edu",
            "datasets": "rlrobot_edu",
        }.items():
            for file in (ROOT / folder).rglob("*"):
                if file.is_file() and "__pycache__" not in file.parts:
                    archive.write(file, Path(inside, file.relative_to(ROOT)))


@needs_pyodide
def test_python_in_webassembly_learns_the_same_to_the_last_bit(browser, tmp_path):
    for file in (PYODIDE / "numpy").iterdir():
        (tmp_path / file.name).symlink_to(file)
    (tmp_path / "index.html").write_text(PAGE, encoding="utf-8")
    zip_packages(tmp_path / "packages.zip")
    with served(tmp_path) as address, browser.new_context() as context:
        page = context.new_page()
        page.goto(address)
        page.wait_for_function("() => Boolean(window.learn)", timeout=300_000)
        numba, digest = page.evaluate("code => learn(code)", LEARN)
    here = {}
    exec(LEARN, here)
    assert numba is None and digest == here["digest"].hexdigest()
