"""What a visitor is told: nothing installs a name that is not ours yet, and each request has a door."""

import os
import re
import tomllib
from email.message import Message
from importlib import metadata
from pathlib import Path

import pytest
import yaml

import rlrobot_edu as rl
from rlrobot_edu import installing

ROOT = Path(__file__).parents[2]
URLS = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["urls"]
BY_NAME = re.compile(
    r"(?:pip3? install|uvx|uv tool|pipx)\b[^\n]*?[\s\"'`]rlrobot-edu(?:\[|==)"
)
# what is done with the first release, and Colab's cell, which is written only for a repository with an address
LATER = {"docs/howto/release.md", "docs/site/launch.py"}


def texts() -> list[Path]:
    """All that a learner or a developer may read."""
    found = [*ROOT.glob("*.md"), ROOT / "pyproject.toml"]
    for folder in ("docs", "notebooks", "tasks", "datasets", "studies"):
        for kind in ("md", "py", "ipynb", "html"):
            found += (ROOT / folder).rglob(f"*.{kind}")
    for package in ("edu", "ros", "grading", "course"):
        for kind in ("md", "py", "toml", "js", "html"):
            found += (ROOT / f"rlrobot_{package}").rglob(f"*.{kind}")
    return [path for path in found if "_build" not in path.parts]


def test_no_text_installs_the_toolkit_by_name_while_it_has_no_address():
    found = set()
    for path in texts():
        if BY_NAME.search(path.read_text("utf-8")):
            found.add(path.relative_to(ROOT).as_posix())
    assert found <= LATER or "Source" in URLS


@pytest.mark.parametrize(
    ("urls", "said"),
    [
        (["Paper, https://x"], "pip install -e '.[lab]' in the toolkit's checkout"),
        (
            ["Paper, https://x", "Source, https://y/z"],
            "pip install 'rlrobot-edu[lab]'",
        ),
    ],
)
def test_the_line_that_installs_an_extra_names_the_toolkit_once_it_has_an_address(
    monkeypatch, urls, said
):
    about = Message()
    for url in urls:
        about["Project-URL"] = url
    monkeypatch.setattr(metadata, "metadata", lambda name: about)
    assert installing.to_install("lab") == said


def test_what_is_not_installed_has_no_address(monkeypatch):
    def missing(name):
        raise metadata.PackageNotFoundError(name)

    monkeypatch.setattr(metadata, "metadata", missing)
    assert installing.source() == ""


@pytest.mark.parametrize("path", sorted(ROOT.glob(".github/ISSUE_TEMPLATE/*_*.yml")))
def test_a_form_has_what_github_asks_of_it(path):
    form = yaml.safe_load(path.read_text("utf-8"))
    assert {"name", "description", "body"} <= form.keys()
    ids = [part["id"] for part in form["body"]]
    assert len(set(ids)) == len(ids)
    for part in form["body"]:
        assert part["type"] in {"input", "textarea"} and part["attributes"]["label"]
        assert part.keys() <= {"type", "id", "attributes", "validations"}


@pytest.mark.parametrize("path", sorted(ROOT.glob(".github/workflows/*.yml")))
def test_a_workflow_runs_what_is_there(path):
    for script in re.findall(r"run: (\.\S+)", path.read_text("utf-8")):
        assert os.access(ROOT / script, os.X_OK)
    makefile = (ROOT / "Makefile").read_text("utf-8")
    for target in re.findall(r"test-\w+(?=[,\]])", path.read_text("utf-8")):
        assert f"{target}:" in makefile or f"{target} " in makefile


@pytest.mark.long
def test_the_ten_lines_of_the_readme_find_what_it_says_of_them():
    readme = " ".join((ROOT / "README.md").read_text("utf-8").split())
    methods = ["TOSL+QBIASSR", "TOSL+SR", "Q+SR"]
    robots = rl.compare("wander_1k", methods, engine="kinematic", progress=False)
    bias, q, _ = robots.tukey().pairs
    assert f"earns {bias.difference:.2f} a step more" in readme
    assert f"and {q.difference:.2f} more" in readme and max(bias.p, q.p) < 0.001


def test_the_paper_cites_what_its_list_has_and_marks_what_only_people_know():
    paper = (ROOT / "paper.md").read_text("utf-8")
    cited = set(re.findall(r"(?<=[\[ @;\n])@(\w+)", paper))
    assert cited == set(
        re.findall(r"^@\w+{(\w+),", (ROOT / "paper.bib").read_text("utf-8"), re.M)
    )
    words = len(paper.split("---\n", 2)[2].split())
    assert 900 < words < 1100
    assert paper.count("To be filled in by people") == 6
