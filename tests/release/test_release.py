"""What `make release` builds works on its own: by uvx, by pip and in Colab, in empty folders and with an empty home."""

import contextlib
import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time
import urllib.request
import zipfile
from functools import partial
from pathlib import Path

import pytest
from launch import write_colab
from try_wheel import run_alone

import rlrobot_edu as rl
from rlrobot_course.authoring.lists import lessons

ROOT = Path(__file__).parents[2]
PYTHON = f"{sys.version_info.major}.{sys.version_info.minor}"
FOLDERS = [
    "rlrobot_edu",
    "rlrobot_ros",
    "rlrobot_grading",
    "rlrobot_course",
    "tasks",
    "datasets",
    "studies",
    "tests",
    "notebooks",
    "docs",
]
PATH = f"{sys.prefix}/bin:{os.environ['PATH']}"
PATIENCE = 400  # a busy machine is not a fault [s]
WIDGET = "application/vnd.jupyter.widget-view+json"
JUPYTER = "etc/jupyter/jupyter_server_config.d/rlrobot_edu.json"
NOTEBOOK = r"notebooks/(more/|homework/)?\d[^/]*\.ipynb"


def run(*command, **kwargs) -> str:
    """Standard output of `command`; if it fails, the test fails with all that it said."""
    done = subprocess.run(
        [str(part) for part in command],
        capture_output=True,
        text=True,
        encoding="utf-8",
        **kwargs,
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def copy_what_is_there(source, target):
    """Copy a file, unless it is gone: Python renames its caches while other tests run."""
    with contextlib.suppress(FileNotFoundError):
        shutil.copy2(source, target)


def copied(copy):
    """A copy of the checkout, with its caches."""
    copy.mkdir()
    for path in ROOT.iterdir():
        if path.is_file() and path.name != ".git":
            shutil.copy2(path, copy)
    for name in FOLDERS:
        shutil.copytree(ROOT / name, copy / name, copy_function=copy_what_is_there)
    return copy


@pytest.fixture(scope="module")
def released(tmp_path_factory):
    """A copy of the checkout after `make release` with this Python, and what that said.

    The environment in which the wheel was tried is build/pythonX.Y.
    """
    copy = copied(tmp_path_factory.mktemp("released") / "checkout")
    tools = ["--assume-old", f"{sys.prefix}/tools.done", f"TOOLS={sys.prefix}"]
    settings = os.environ | {
        "HOME": os.environ["RLROBOT_TESTS_USERS_HOME"]
    }  # pip's: where packages come from
    return copy, run(
        "make", "release", *tools, f"VERSIONS={PYTHON}", cwd=copy, env=settings
    )


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """The wheel of this checkout, not tried yet."""
    folder = tmp_path_factory.mktemp("built")
    copy = copied(folder / "checkout")
    run(sys.executable, "-m", "build", "--wheel", "--no-isolation", cwd=copy)
    (path,) = (copy / "dist").glob("*.whl")
    return path


@pytest.fixture(scope="module")
def wheel(released):
    (path,) = (released[0] / "dist").glob("*.whl")
    return path


@pytest.fixture
def alone(released):
    """Run a command in the environment in which the wheel was tried."""
    return partial(run_alone, released[0] / f"build/python{PYTHON}")


def files_in(folder: str) -> set[str]:
    """The files of a folder of the checkout, without caches."""
    return {
        path.relative_to(ROOT).as_posix()
        for path in (ROOT / folder).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }


def test_the_wheel_holds_the_package_with_its_notebooks_tasks_and_datasets_and_nothing_else(
    built,
):
    names = set(zipfile.ZipFile(built).namelist())
    about = {
        name
        for name in names
        if name.startswith(f"rlrobot_edu-{rl.__version__}.dist-info/")
    }
    data = (files_in("tasks") | files_in("datasets")) - {
        "tasks/README.md",
        "datasets/README.md",
        "datasets/make_datasets.py",
    }

    data |= {name for name in files_in("notebooks") if re.fullmatch(NOTEBOOK, name)}
    packages = set()
    for package in ("edu", "ros", "grading", "course"):
        packages |= files_in(f"rlrobot_{package}")
    assert names - about == packages | {f"rlrobot_edu/{name}" for name in data} | {
        "rlrobot_course/averages.csv",
        "rlrobot_edu/constraints.txt",
        f"rlrobot_edu-{rl.__version__}.data/data/{JUPYTER}",
    }
    for licence in ("LICENSE", "LICENSE-CONTENT", "LICENSE-DATA"):
        assert f"rlrobot_edu-{rl.__version__}.dist-info/licenses/{licence}" in about
    for name in [
        "py.typed",
        "tasks/wander_1k.py",
        *(f"datasets/wander_1k/{n}" for n in ("transitions.csv", "datapackage.json")),
    ]:
        assert f"rlrobot_edu/{name}" in names


def test_the_wheel_carries_the_tested_versions(built):
    carried = zipfile.ZipFile(built).read("rlrobot_edu/constraints.txt")
    assert carried == (ROOT / "constraints.txt").read_bytes()


@pytest.mark.nightly
def test_doctor_compares_the_versions_with_those_that_are_tested(alone):
    assert "those with which the toolkit is tested" in alone("rlrobot-edu", "doctor")


@pytest.mark.nightly
def test_a_release_is_tried_and_what_is_left_to_do_is_said(released):
    _, said = released
    assert said.count("PASSED") == 2 and f"Python {PYTHON}: the wheel installs" in said
    assert re.search(
        "left to do.*date-released.*git tag.*twine upload.*sha256sum", said, re.S
    )


@pytest.mark.nightly
def test_the_wheel_brings_the_course_to_an_empty_folder(alone):
    tasks = alone("python", "-m", "rlrobot_edu", "tasks")
    assert "wander_1k " in tasks and alone("rlrobot-edu", "tasks") == tasks
    assert "worked_example" in alone(
        "rlrobot-edu", "check-task", "worked_example", "--steps", "300"
    )
    assert "my_course/02_returns_and_values.ipynb is fresh" in alone(
        "rlrobot-edu", "fresh", "02"
    )
    home = alone.args[0]
    lesson = json.loads(
        (home / "my_course/02_returns_and_values.ipynb").read_text(encoding="utf-8")
    )
    assert [
        cell["outputs"]
        for cell in lesson["cells"]
        if cell["cell_type"] == "code" and cell["outputs"]
    ] == []
    assert "](../" not in json.dumps([cell["source"] for cell in lesson["cells"]])


IN_COLAB = {  # stand-ins for its modules
    "__init__": "",
    "drive": "def mount(place): print('mounted', place)",
    "output": """
import types
_widgets = types.SimpleNamespace(_installed_url="https://colab/manager")
def enable_custom_widget_manager(): print("custom widget manager")
""",
}
ANSWER = """
from rlrobot_course.lesson_01.exercises import check
def bin_of(x, cuts):
    return sum(x > cut for cut in cuts)
check.bin_of(bin_of)
"""


@pytest.fixture(scope="module")
def colab(released):
    """The folder of a lesson's copy for Colab, run where `google.colab` is a stand-in; pip finds the released wheel."""
    copy, home = released[0], released[0] / f"build/python{PYTHON}"
    (site,) = home.glob("venv/lib/python*/site-packages")
    (site / "google/colab").mkdir(parents=True)
    for name, text in IN_COLAB.items():
        (site / f"google/colab/{name}.py").write_text(text, encoding="utf-8")
    write_colab("notebooks/00_start_here.ipynb", home, "https://github.com/owner/name")
    lesson = home / "notebooks/00_start_here.ipynb"
    content = json.loads(
        lesson.read_text(encoding="utf-8").replace("/content/", f"{home}/content/")
    )
    content["cells"].append({**content["cells"][0], "id": "answer", "source": ANSWER})
    lesson.write_text(json.dumps(content), encoding="utf-8")
    (home / "first.ipy").write_text(content["cells"][0]["source"], encoding="utf-8")
    theirs = Path(os.environ["RLROBOT_TESTS_USERS_HOME"], ".config/pip/pip.conf")
    settings = {
        name: value for name, value in os.environ.items() if name.startswith("PIP_")
    }
    settings |= {"PIP_CONFIG_FILE": str(theirs)} if theirs.exists() else {}
    settings["PIP_FIND_LINKS"] = f"{copy / 'dist'} {settings.get('PIP_FIND_LINKS', '')}"
    settings |= {"PIP_CONSTRAINT": str(ROOT / "constraints.txt"), "PIP_NO_COMPILE": "1"}
    pip = ("python", "-m", "pip", "install", "--quiet")
    run_alone(home, *pip, "ipykernel", "nbconvert", **settings)  # Colab has its own
    run_alone(home, "ipython", "first.ipy", **settings)
    assert "jupyterlab " not in run_alone(home, "python", "-m", "pip", "list")
    run_alone(
        home,
        "jupyter",
        "nbconvert",
        "--to",
        "notebook",
        "--execute",
        "--inplace",
        str(lesson),
        **settings,
    )
    return home


@pytest.mark.nightly
def test_a_lesson_runs_in_colab_and_its_widgets_come_from_their_own_manager(colab):
    cells = json.loads(
        (colab / "notebooks/00_start_here.ipynb").read_text(encoding="utf-8")
    )["cells"]
    said = json.dumps([output.get("text") for output in cells[0]["outputs"]])
    assert "mounted" in said and "custom widget manager" in said
    outputs = [
        output
        for cell in cells
        for output in cell.get("outputs", [])
        if WIDGET in output.get("metadata", {})
    ]
    managers = {
        output["metadata"][WIDGET]["colab"]["custom_widget_manager"]["url"]
        for output in outputs
    }
    assert managers == {"https://colab/manager"}, "ipywidgets' own need none"


@pytest.mark.nightly
def test_what_a_learner_writes_in_colab_is_kept_in_the_drive(colab):
    (kept,) = (colab / "content").rglob("my_functions.py")
    assert (
        kept.parent == colab / "content/drive/MyDrive/my_course"
        and "def bin_of" in kept.read_text(encoding="utf-8")
    )


def test_links_of_a_copy_for_colab_lead_to_colab_or_to_the_repository(tmp_path):
    for notebook in lessons(ROOT).values():
        name = notebook.relative_to(ROOT).as_posix()
        write_colab(name, tmp_path, "https://github.com/owner/name")
        cells = json.loads((tmp_path / name).read_text(encoding="utf-8"))["cells"]
        text = "".join(
            "".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"
        )
        for link in re.findall(r"\]\(([^)]+)\)", text):
            if match := re.match(
                r"https://\S+/owner/name/blob/(?:gh-pages/colab|v[\d.]+)/([^#]+)", link
            ):
                assert (ROOT / match[1]).exists(), link
            else:
                assert link.startswith(("https://", "#", "attachment:")), (
                    f"{name}: {link}"
                )


@pytest.fixture(params=["uvx", "make lab"])
def lab(request, released, wheel, tmp_path):
    """What a line of the README starts, from an empty home: where it answers. The wheel's path stands for its name."""
    line = re.search(
        f"^{request.param}[^#\n]*",
        (ROOT / "README.md").read_text(encoding="utf-8"),
        re.M,
    )[0]
    options = [
        "--no-browser",
        "--port=0",
        "--IdentityProvider.token=",
        *["--allow-root"] * (os.geteuid() == 0),
    ]
    if request.param == "uvx":
        if not shutil.which("uvx", path=PATH):
            pytest.skip("needs uv")
        shutil.copy(ROOT / "constraints.txt", tmp_path)
        command, folder = (
            [*shlex.split(line.replace(f"dist/{wheel.name}", str(wheel))), *options],
            tmp_path,
        )
    else:
        command = [
            *line.split(),
            f"PYTHON={sys.executable}",
            f"LAB_FLAGS={' '.join(options)}",
        ]
        folder = released[0]
    env = {
        name: os.environ[name] for name in os.environ if re.match("SSL_|UV_|PIP_", name)
    }
    env |= {
        "HOME": str(tmp_path),
        "PATH": PATH,
        "JUPYTER_RUNTIME_DIR": str(tmp_path / "running"),
    }
    with open(tmp_path / "log", "w") as log:
        server = subprocess.Popen(
            command, cwd=folder, env=env, stdout=log, stderr=log, start_new_session=True
        )
    try:
        yield soon(lambda: address_in(tmp_path / "running", server, tmp_path / "log"))
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(server.pid, signal.SIGTERM)
        server.wait(timeout=60)


def address_in(folder, server, log):
    """Where JupyterLab answers, once it has written that down."""
    if server.poll() is not None:
        said = log.read_text(encoding="utf-8")
        pytest.skip("no registry answers") if re.search(
            "Failed to fetch|from versions: none", said
        ) else pytest.fail(said)
    for told in folder.glob("jpserver-*.json"):
        with contextlib.suppress(OSError, ValueError):
            address = f"http://127.0.0.1:{json.loads(told.read_text())['port']}"
            urllib.request.urlopen(f"{address}/api", timeout=5).close()
            return address


def soon(look):
    """What `look` finds, once it finds anything."""
    end = time.monotonic() + PATIENCE
    while not (found := look()):
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.2)
    return found


@pytest.mark.nightly
def test_a_line_of_the_readme_opens_lesson_00_with_its_widgets(lab, browser):
    page = browser.new_page()
    page.set_default_timeout(1000 * PATIENCE)
    try:
        page.goto(lab)
        page.wait_for_url("**/my_course/00_start_here.ipynb")
        page.locator(
            ".jp-Toolbar-kernelName", has_text="Python 3"
        ).wait_for()  # before that there is nothing to run it
        page.locator(".jp-Notebook-ExecutionIndicator[data-status=idle]").wait_for()
        page.click("text=Run >> nth=0")
        page.click("text=Run All Cells")
        page.frame_locator(".jp-OutputArea iframe").first.get_by_text(
            "bumps"
        ).first.wait_for()  # the playground
        page.locator(
            ".jp-OutputArea .jupyter-widgets", has_text="about fifty"
        ).first.wait_for()  # a prediction
    finally:
        page.close()
