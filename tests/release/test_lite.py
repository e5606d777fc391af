"""The course in the browser: the lessons that `make lite` writes, its site, and what Python in WebAssembly learns."""

import ast
import json
import os
import re
import subprocess
import sys
import zipfile
from importlib.metadata import files
from pathlib import Path

import pytest
from serving import served

from rlrobot_course.my_course import blank

ROOT = Path(__file__).parents[2]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
PYODIDE = Path(os.environ.get("RLROBOT_EDU_PYODIDE", "")) / "package"
PURE = ("gymnasium", "farama-notifications", "cloudpickle", "typing-extensions", "lazy-loader")
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


@pytest.fixture(scope="module")
def site(make_lite, tmp_path_factory):
    build = tmp_path_factory.mktemp("lite_site")
    command = [sys.executable, ROOT / "lite/make_lite.py", build]
    env = os.environ | {"HOME": os.environ["RLROBOT_TESTS_USERS_HOME"]}
    done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", timeout=600, env=env)
    if "No matching distribution" in done.stderr or "ConnectionError" in done.stderr:
        pytest.skip("needs a package index, for the wheels that Pyodide lacks")
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    return build / "site"


def test_the_site_opens_its_first_lesson_and_asks_only_for_pyodide(site, browser):
    """Pyodide's address is the one that pages ask beside their own; here it is not answered."""
    asked = set()

    def refuse(route):
        asked.add(route.request.url.partition("/pyodide/")[0])
        route.abort()

    with served(site) as address, browser.new_context(service_workers="block") as context:
        context.route(lambda url: not url.startswith((address, "blob:", "data:")), refuse)
        page = context.new_page()
        page.goto(address)
        page.get_by_role("heading", name="Start here: a robot learns to wander").first.wait_for(timeout=300_000)
        page.get_by_text("03_q_learning.ipynb").first.wait_for(timeout=300_000)
        for _ in range(300):
            if not asked:
                page.wait_for_timeout(1_000)  # for the kernel, which asks for Pyodide
        page.wait_for_timeout(5_000)  # for anything else that may ask
    assert asked == {"https://cdn.jsdelivr.net"}


def zip_packages(path):
    """What Python in the browser needs beside NumPy: packages of plain Python, and the toolkit with its data."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in PURE:
            for file in files(name):
                if file.suffix == ".py" or (".dist-info" in str(file) and ".." not in str(file)):
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


@pytest.mark.skipif(not PYODIDE.is_dir(), reason="needs Pyodide: tests/unpack_pyodide.sh, RLROBOT_EDU_PYODIDE")
def test_python_in_webassembly_learns_the_same_to_the_last_bit(browser, tmp_path):
    for file in PYODIDE.iterdir():
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
