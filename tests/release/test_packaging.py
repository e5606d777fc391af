"""The toolkit travels: what the wheel holds, that it works on its own, and that its versions are pinned."""

import contextlib
import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from importlib import metadata
from pathlib import Path

import pytest
import yaml
from packaging.requirements import Requirement
from packaging.specifiers import SpecifierSet
from packaging.utils import canonicalize_name

import rlrobot_edu as rl
from rlrobot_edu.learning import jit

ROOT = Path(__file__).parents[2]
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
PROJECT, GROUPS = PYPROJECT["project"], PYPROJECT["dependency-groups"]
CONSTRAINTS = [Requirement(line) for line in (ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines()]
PINNED = {canonicalize_name(pin.name): pin.specifier for pin in CONSTRAINTS if not pin.marker or pin.marker.evaluate()}

LESSON = """
import sys
from pathlib import Path

import gymnasium

import rlrobot_edu as rl

assert Path(rl.__file__).is_relative_to(sys.prefix), rl.__file__
assert "wander_1k" in rl.available_tasks()
task = rl.load_task("wander_1k")
assert Path(task.path).is_relative_to(sys.prefix), task.path

history = rl.learn(rl.Agent(task, "TOSL+QBIASSR", seed=0), rl.make_env(task, seed=0), steps=200, progress=False)
assert history.average_reward.shape == (200,)

model = rl.SampleModel.from_recording(rl.read_recording("wander_1k"))
history = rl.learn(rl.Agent(model, seed=0), rl.make_env(model, seed=0), steps=1000, progress=False)
assert history.average_reward.shape == (1000,)

env = gymnasium.make("rlrobot_edu:rlrobot/wander_simple-v0")
env.reset(seed=0)
env.step(0)
print("learned")
"""


NOTEBOOK = r"(notebooks|notebooks/more|homework)/\d[^/]*\.ipynb"


def run(*command, **kwargs) -> str:
    """Standard output of `command`; if it fails, the test fails with all that it said."""
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, **kwargs)
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def copy_what_is_there(source, target):
    """Copy a file, unless it is gone: Python renames its caches while other tests run."""
    with contextlib.suppress(FileNotFoundError):
        shutil.copy2(source, target)


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The wheel, built from a copy of the checkout, with the caches that lie about in it."""
    folder = tmp_path_factory.mktemp("wheel")
    copy = folder / "checkout"
    copy.mkdir()
    for name in ["pyproject.toml", "README.md", "LICENSE", ".gitignore", "hatch_build.py"]:
        shutil.copy(ROOT / name, copy)
    for name in ["rlrobot_edu", "rlrobot_course", "tasks", "datasets", "tests", "notebooks", "homework", "docs"]:
        shutil.copytree(ROOT / name, copy / name, copy_function=copy_what_is_there)
    run(sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", folder, copy)
    (path,) = folder.glob("*.whl")
    return path


def files_in(folder: str) -> set[str]:
    """The files of a folder of the checkout, without caches."""
    return {
        path.relative_to(ROOT).as_posix()
        for path in (ROOT / folder).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }


def test_the_wheel_holds_the_package_with_its_notebooks_tasks_and_datasets_and_nothing_else(wheel):
    names = set(zipfile.ZipFile(wheel).namelist())
    about = {name for name in names if name.startswith(f"rlrobot_edu-{rl.__version__}.dist-info/")}
    data = (files_in("tasks") | files_in("datasets")) - {"tasks/README.md", "datasets/make_datasets.py"}

    data |= {name for name in files_in("notebooks") | files_in("homework") if re.fullmatch(NOTEBOOK, name)}
    packages = files_in("rlrobot_edu") | files_in("rlrobot_course")
    assert names - about == packages | {f"rlrobot_edu/{name}" for name in data} | {"rlrobot_course/averages.csv"}
    assert f"rlrobot_edu-{rl.__version__}.dist-info/licenses/LICENSE" in about
    for name in [
        "py.typed",
        "tasks/wander_1k.py",
        *(f"datasets/wander_1k/{n}" for n in ("transitions.csv", "datapackage.json")),
    ]:
        assert f"rlrobot_edu/{name}" in names


def test_the_installed_wheel_learns_in_an_empty_environment(wheel, tmp_path):
    run(sys.executable, "-m", "venv", tmp_path / "venv")
    python = tmp_path / "venv" / "bin" / "python"
    settings = os.environ | {"HOME": os.environ["RLROBOT_TESTS_USERS_HOME"]}  # pip's: where packages come from
    run(python, "-m", "pip", "install", "--quiet", "-c", ROOT / "constraints.txt", wheel, env=settings)
    (tmp_path / "lesson.py").write_text(LESSON, encoding="utf-8")
    alone = {"cwd": tmp_path, "env": {"HOME": str(tmp_path), "PATH": "/usr/bin:/bin", "PYTHONPATH": ""}}

    assert run(python, "lesson.py", **alone) == "learned\n"
    assert "wander_1k " in run(python, "-m", "rlrobot_edu", "tasks", **alone)
    command = tmp_path / "venv" / "bin" / "rlrobot-edu"
    assert run(command, "tasks", **alone) == run(python, "-m", "rlrobot_edu", "tasks", **alone)
    assert "All is well." in run(command, "doctor", **alone)
    assert "my_course/02_returns_and_values.ipynb is fresh" in run(command, "fresh", "02", **alone)
    lesson = json.loads((tmp_path / "my_course/02_returns_and_values.ipynb").read_text(encoding="utf-8"))
    assert [cell["outputs"] for cell in lesson["cells"] if cell["cell_type"] == "code" and cell["outputs"]] == []
    assert "](../" not in json.dumps([cell["source"] for cell in lesson["cells"]])


def test_the_version_is_written_once_and_the_metadata_agree():
    assert "version" in PROJECT["dynamic"]
    assert rl.__version__ == metadata.version("rlrobot-edu")


def test_the_citation_names_this_version_and_the_paper():
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert {"cff-version", "message", "title", "authors"} <= citation.keys()  # what the format asks for
    assert (citation["cff-version"], citation["type"]) == ("1.2.0", "software")
    assert citation["version"] == rl.__version__ and citation["license"] == PROJECT["license"]
    assert [author["name"] for author in citation["authors"]] == [author["name"] for author in PROJECT["authors"]]
    (paper,) = citation["references"]
    assert paper["url"] == PROJECT["urls"]["Paper"] and len(paper["authors"]) == 4


def test_the_changelog_tells_of_this_version():
    assert re.search(rf"^## \[.*{re.escape(rl.__version__)}", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.M)


def test_constraints_hold_names_versions_and_platforms_only():
    for pin in CONSTRAINTS:
        assert re.fullmatch(r"==[0-9][A-Za-z0-9.+]*", str(pin.specifier)) and not pin.url and not pin.extras, pin


def test_pyproject_names_no_place_to_download_from():
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    text = text.replace("https://arxiv.org/abs/1702.06329", "")  # the paper
    assert not re.search(r"://|file:|\s@\s|[\"']/", text)


def test_every_dependency_is_pinned():
    direct = [
        *PROJECT["dependencies"],
        *(line for extra in PROJECT["optional-dependencies"].values() for line in extra),
        *(line for group in GROUPS.values() for line in group),
    ]
    waiting, seen = [Requirement(line) for line in direct if not line.startswith("rlrobot-edu[")], set()
    while waiting:
        requirement = waiting.pop()
        name = canonicalize_name(requirement.name)
        assert name in {canonicalize_name(pin.name) for pin in CONSTRAINTS}, f"{name} is not in constraints.txt"
        for extra in {"", *requirement.extras}:
            if (name, extra) not in seen:
                seen.add((name, extra))
                waiting += needed_by(name, extra)


@pytest.mark.parametrize(
    ("system", "machine", "version", "wheel"),
    [
        ("linux", "x86_64", "3.11", "pybullet"), ("linux", "x86_64", "3.12", "pybullet-arm64"),
        ("linux", "x86_64", "3.13", "pybullet-arm64"), ("win32", "AMD64", "3.11", "pybullet-arm64"),
        ("win32", "AMD64", "3.13", "pybullet-arm64"), ("darwin", "arm64", "3.13", "pybullet-arm64"),
        ("darwin", "x86_64", "3.12", "pybullet-arm64"), ("darwin", "x86_64", "3.13", None),
        ("linux", "aarch64", "3.12", None), ("linux", "x86_64", "3.14", None), ("emscripten", "wasm32", "3.13", None),
    ],
)  # fmt: skip
def test_the_arm_is_simulated_by_the_one_wheel_that_there_is(system, machine, version, wheel):
    here = {"sys_platform": system, "platform_machine": machine, "python_version": version}
    requirements = map(Requirement, PROJECT["optional-dependencies"]["arm"])
    assert [r.name for r in requirements if r.marker.evaluate(here)] == ([wheel] if wheel else [])


def test_every_pin_takes_the_first_python_3_11():
    # Debian 12 has 3.11.2. Where an environment of 3.11.5 would be pinned as it is, the installation fails there.
    for package in metadata.distributions():
        if package.version in PINNED.get(canonicalize_name(package.name), "!=0"):
            needs = package.metadata.get("Requires-Python", "")
            assert "3.11.0" in SpecifierSet(needs), f"{package.name} {package.version} needs Python {needs}"


def needed_by(name: str, extra: str) -> list[Requirement]:
    """What an installed package needs in turn; nothing for a package of an extra that is not installed."""
    try:
        lines = metadata.requires(name) or []
    except metadata.PackageNotFoundError:
        return []
    requirements = map(Requirement, lines)
    return [r for r in requirements if r.marker is None or r.marker.evaluate({"extra": extra})]


@pytest.fixture
def small_package(tmp_path, monkeypatch):
    """An empty package and an empty home, for the cache of compiled kernels."""
    (tmp_path / "package").mkdir()
    monkeypatch.setattr(jit, "PACKAGE", tmp_path / "package")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    return tmp_path / "package"


def test_kernels_of_a_read_only_package_are_kept_at_home_and_without_a_home_nowhere(small_package):
    (small_package / "__pycache__").touch()  # a file: nobody, not even root, can make a folder of it
    assert jit.cache_folder().parent == small_package.parent / "home/.cache/rlrobot_edu"

    shutil.rmtree(small_package.parent / "home")
    (small_package.parent / "home").touch()
    assert jit.cache_folder() is None


def test_no_test_sees_the_home_of_the_person_who_runs_it():
    theirs = Path(os.environ["RLROBOT_TESTS_USERS_HOME"])
    for place in ("~", "~/.cache/rlrobot_edu"):
        assert not Path(place).expanduser().is_relative_to(theirs) or theirs == Path(theirs.anchor)
    assert jit.cache_folder().is_relative_to(jit.PACKAGE) or jit.cache_folder().is_relative_to(Path.home())
