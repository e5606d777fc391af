"""What the project imports is what it declares, each where it is needed, and the pins travel with it."""

import re
import subprocess
import sys
import tomllib
from importlib import metadata
from pathlib import Path

import pytest
from imports import imports_of
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

import rlrobot_edu as rl
from rlrobot_edu.installing import to_install

ROOT = Path(__file__).parents[2]
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
PROJECT = PYPROJECT["project"]
EXTRAS = PROJECT["optional-dependencies"]
PAGE = ROOT / "docs/howto/dependencies.md"
PACKAGES = ("rlrobot_edu", "rlrobot_ros", "rlrobot_grading", "rlrobot_course")
OURS = {"rlrobot-edu"}
# Nobody imports these by name: a command starts the one, and joblib finds the other.
STARTED = {"jupyterlab", "distributed"}
FORKS = {"pybullet-arm64": "pybullet"}
# Fetched by `make bench` for itself; PyTorch comes with stable-baselines3, of whose results it is a part.
FETCHED = {"mushroom-rl", "mushroom_rl", "torch"}
NEEDS_NOTEBOOK = (
    "anywidget",
    "ipywidgets",
    "traitlets",
    "IPython",
    "meshcat",
    "umsgpack",
)
PLAIN = """
import sys

for name in sys.argv[2:]:
    sys.modules[name] = None  # importing it fails

import rlrobot_edu as rl
from rlrobot_edu import *
from rlrobot_course.lesson_03.exercises import check

env = rl.make_env("wander_simple", seed=0)
agent = rl.Agent(env, seed=0)
rl.plot_learning(rl.learn(agent, env, steps=20)).png()
rl.film(agent, env, steps=2).gif()
rl.playground(sys.argv[1])
rl.stage()
rl.repeat("worked_example", repetitions=2, steps=30, n_jobs=1)
for call in (lambda: rl.Stepper(agent, env), lambda: rl.watch(agent, env, steps=1), lambda: rl.meshcat(env)):
    try:
        call()
    except ImportError as error:
        print(error)
"""


def names(lines: list[str]) -> set[str]:
    """The distributions that some requirements name, a fork under the name of what it replaces."""
    found = {canonicalize_name(Requirement(line).name) for line in lines}
    return {FORKS.get(name, name) for name in found} - OURS


def declared() -> set[str]:
    lines = list(PROJECT["dependencies"])
    for extra in EXTRAS.values():
        lines += extra
    return names(lines)


def distributions_of(folder: str) -> dict[str, set[str]]:
    """The distributions from which a folder's files import, each with the files."""
    providers = metadata.packages_distributions()
    here = {path.stem for path in ROOT.rglob("*.py")} | {
        *PACKAGES,
        "paper",
        "fuzz",
        "chat_bot",
    }
    found: dict[str, set[str]] = {}
    for module, files in imports_of(folder).items():
        if module in here and module not in providers:
            continue
        provider = canonicalize_name(providers.get(module, [module])[0])
        found[FORKS.get(provider, provider)] = files
    return found


@pytest.mark.parametrize("package", PACKAGES)
def test_all_that_a_package_imports_is_declared(package):
    unknown = {
        name: files
        for name, files in distributions_of(package).items()
        if name not in declared() | OURS
    }
    assert not unknown


@pytest.mark.parametrize(
    "folder", ["studies", "tests", "docs", "datasets", "notebooks"]
)
def test_all_that_developers_import_is_declared(folder):
    groups = dict(PYPROJECT["dependency-groups"])
    assert groups.pop("dev") == [{"include-group": "test"}]
    lines = [line for group in groups.values() for line in group]
    known = declared() | names(lines)
    unknown = {
        name: files
        for name, files in distributions_of(folder).items()
        if name not in known | OURS | FETCHED
    }
    assert not unknown


def test_all_that_is_declared_is_imported():
    imported = set(STARTED)
    for package in PACKAGES:
        imported |= distributions_of(package).keys()
    assert declared() <= imported


def test_a_plain_install_does_without_jupyter_and_says_what_would_bring_a_widget(
    tmp_path,
):
    command = [sys.executable, "-c", PLAIN, tmp_path / "page.html", *NEEDS_NOTEBOOK]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "page.html").exists()
    lines = done.stdout.splitlines()
    assert len(lines) == 3
    for line in lines:
        assert to_install("notebook") in line


def test_jupyters_own_server_is_in_no_extra_for_other_jupyters():
    assert not names(EXTRAS["notebook"]) & {"jupyterlab", "ipykernel", "jupyter-client"}


def test_upper_bounds_stand_only_where_a_page_gives_the_reason():
    bounded = set()
    for line in [*PROJECT["dependencies"], *EXTRAS["notebook"], *EXTRAS["ros"]]:
        requirement = Requirement(line)
        if "<" in str(requirement.specifier) and "x86_64" not in str(
            requirement.marker
        ):
            bounded.add(requirement.name)
    assert bounded == {"cloudpickle", "meshcat", "pymunk"}
    assert "<" not in PROJECT["requires-python"]


def test_the_page_of_dependencies_has_a_row_for_each():
    rows = re.findall(
        r"^\| ([\w.-]+)(?:, ([\w.-]+))* \|", PAGE.read_text("utf-8"), re.M
    )
    said = {canonicalize_name(name) for row in rows for name in row if name}
    assert declared() <= said


def test_the_readmes_line_uses_the_tested_versions():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    lines = re.findall(r"^uvx .*", readme, re.M)
    assert lines
    for line in lines:
        assert "--constraints constraints.txt" in line
        assert f"rlrobot_edu-{rl.__version__}-" in line  # the wheel of this version
