"""What is said of the package: its version, its licence, what it needs, and that every version is pinned."""

import os
import re
import shutil
import tomllib
from importlib import metadata
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest
import yaml
from packaging.requirements import Requirement
from packaging.specifiers import SpecifierSet
from packaging.utils import canonicalize_name
from try_wheel import disagreements

import rlrobot_edu as rl
from rlrobot_edu.jit import dispatcher

ROOT = Path(__file__).parents[2]
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
PROJECT, GROUPS = PYPROJECT["project"], PYPROJECT["dependency-groups"]
CONSTRAINTS = [
    Requirement(line)
    for line in (ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines()
]
PINNED = {
    canonicalize_name(pin.name): pin.specifier
    for pin in CONSTRAINTS
    if not pin.marker or pin.marker.evaluate()
}


def test_the_version_is_written_once_and_the_metadata_agree():
    assert "version" in PROJECT["dynamic"]
    assert rl.__version__ == metadata.version("rlrobot-edu")


def test_the_citation_names_this_version_and_the_paper():
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert {
        "cff-version",
        "message",
        "title",
        "authors",
    } <= citation.keys()  # what the format asks for
    assert (citation["cff-version"], citation["type"]) == ("1.2.0", "software")
    assert (
        citation["version"] == rl.__version__
        and citation["license"] == PROJECT["license"].split(" AND ")[0]  # of the code
    )
    assert [author["name"] for author in citation["authors"]] == [
        author["name"] for author in PROJECT["authors"]
    ]
    (paper,) = citation["references"]
    assert paper["url"] == PROJECT["urls"]["Paper"] and len(paper["authors"]) == 4


def test_each_licence_has_its_text_and_says_what_it_covers():
    kinds = {
        "MIT": ("LICENSE", "MIT License", "Permission is hereby granted"),
        "CC-BY-4.0": ("LICENSE-CONTENT", "notebooks/", "Section 8 – Interpretation"),
        "CC0-1.0": ("LICENSE-DATA", "datasets/", "4. Limitations and Disclaimers"),
        "OFL-1.1": ("rlrobot_edu/show/fonts/OFL.txt", "Source", "SIL OPEN FONT"),
    }
    assert PROJECT["license"].split(" AND ") == list(kinds)
    assert PROJECT["license-files"] == [name for name, *_ in kinds.values()]
    for name, *parts in kinds.values():
        text = (ROOT / name).read_text(encoding="utf-8")
        assert all(part in text for part in parts), name


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("CITATION.cff", f"version: {rl.__version__}", "version: 9.0"),
        ("CITATION.cff", "license:", "date-released: 2020-01-01\nlicense:"),
        ("CHANGELOG.md", f"## [{rl.__version__}] - ", "## [9.0] - "),
        ("rlrobot_edu/version.py", rl.__version__, "9.0"),
    ],
)
def test_a_release_wants_one_version_and_one_date(name, old, new, tmp_path):
    (tmp_path / "rlrobot_edu").mkdir()
    for file in ("CITATION.cff", "CHANGELOG.md", "rlrobot_edu/version.py"):
        text = (ROOT / file).read_text(encoding="utf-8")
        assert file != name or old in text
        (tmp_path / file).write_text(
            text.replace(old, new, 1) if file == name else text, encoding="utf-8"
        )
    assert disagreements(ROOT) == [] and len(disagreements(tmp_path)) == 1


@pytest.mark.parametrize(
    ("source", "shown"),
    [
        (None, "See how and a robot."),
        (
            "https://x/y",
            "See [how](https://x/y/blob/v1.0/docs/a.md#b) and ![a robot](https://x/y/raw/v1.0/a.gif).",
        ),
    ],
)
def test_links_of_the_readme_on_pypi_lead_to_the_repository_or_are_words(source, shown):
    spec = spec_from_file_location("hatch_build", ROOT / "hatch_build.py")
    hatch_build = module_from_spec(spec)
    spec.loader.exec_module(hatch_build)
    assert (
        hatch_build.from_elsewhere(
            "See [how](docs/a.md#b) and ![a robot](a.gif).", source, "1.0"
        )
        == shown
    )
    web = "[a paper](https://x) and [below](#below)"
    assert hatch_build.from_elsewhere(web, source, "1.0") == web


def test_constraints_hold_names_versions_and_platforms_only():
    for pin in CONSTRAINTS:
        assert (
            re.fullmatch(r"==[0-9][A-Za-z0-9.+]*", str(pin.specifier))
            and not pin.url
            and not pin.extras
        ), pin


def test_pyproject_names_no_place_to_download_from():
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    text = re.sub(r"^\[project.urls\].*?^$", "", text, flags=re.M | re.S).replace(
        "https://github.com/owner/name", ""
    )
    assert not re.search(r"://|file:|\s@\s|[\"']/", text)


def test_every_dependency_is_pinned():
    direct = [
        *PROJECT["dependencies"],
        *(
            line
            for extra in PROJECT["optional-dependencies"].values()
            for line in extra
        ),
        *(line for name in GROUPS for line in GROUPS[name] if name != "dev"),
    ]
    waiting, seen = (
        [Requirement(line) for line in direct if not line.startswith("rlrobot-edu[")],
        set(),
    )
    while waiting:
        requirement = waiting.pop()
        name = canonicalize_name(requirement.name)
        assert name in {canonicalize_name(pin.name) for pin in CONSTRAINTS}, (
            f"{name} is not in constraints.txt"
        )
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
def test_the_arm_is_simulated_by_the_one_wheel_that_there_is(
    system, machine, version, wheel
):
    here = {
        "sys_platform": system,
        "platform_machine": machine,
        "python_version": version,
    }
    requirements = map(Requirement, PROJECT["optional-dependencies"]["arm"])
    assert [r.name for r in requirements if r.marker.evaluate(here)] == (
        [wheel] if wheel else []
    )


def test_every_pin_takes_the_first_python_3_11():
    # Debian 12 has 3.11.2. Where an environment of 3.11.5 would be pinned as it is, the installation fails there.
    for package in metadata.distributions():
        if package.version in PINNED.get(canonicalize_name(package.name), "!=0"):
            needs = package.metadata.get("Requires-Python", "")
            assert "3.11.0" in SpecifierSet(needs), (
                f"{package.name} {package.version} needs Python {needs}"
            )


def needed_by(name: str, extra: str) -> list[Requirement]:
    """What an installed package needs in turn; nothing for a package of an extra that is not installed."""
    try:
        lines = metadata.requires(name) or []
    except metadata.PackageNotFoundError:
        return []
    requirements = map(Requirement, lines)
    return [
        r
        for r in requirements
        if r.marker is None or r.marker.evaluate({"extra": extra})
    ]


@pytest.fixture
def small_package(tmp_path, monkeypatch):
    """An empty package and an empty home, for the cache of compiled kernels."""
    (tmp_path / "package").mkdir()
    monkeypatch.setattr(dispatcher, "PACKAGE", tmp_path / "package")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    return tmp_path / "package"


def test_kernels_of_a_read_only_package_are_kept_at_home_and_without_a_home_nowhere(
    small_package,
):
    (
        small_package / "__pycache__"
    ).touch()  # a file: nobody, not even root, can make a folder of it
    assert (
        dispatcher.cache_folder().parent
        == small_package.parent / "home/.cache/rlrobot_edu"
    )

    shutil.rmtree(small_package.parent / "home")
    (small_package.parent / "home").touch()
    assert dispatcher.cache_folder() is None


def test_no_test_sees_the_home_of_the_person_who_runs_it():
    theirs = Path(os.environ["RLROBOT_TESTS_USERS_HOME"])
    for place in ("~", "~/.cache/rlrobot_edu"):
        assert not Path(place).expanduser().is_relative_to(theirs) or theirs == Path(
            theirs.anchor
        )
    assert dispatcher.cache_folder().is_relative_to(
        dispatcher.PACKAGE
    ) or dispatcher.cache_folder().is_relative_to(Path.home())
