"""What is installed, what is missing, and what that disables: what ``python -m rlrobot_edu doctor`` says.

What is needed comes from the package's own metadata, which pip has written from pyproject.toml; only the words for what
an extra brings are ours.
"""

import importlib.util
import platform
import re
import sys
import tempfile
import textwrap
from collections.abc import Iterator
from importlib import metadata
from pathlib import Path
from typing import NamedTuple

from packaging.requirements import Requirement

import rlrobot_edu
from rlrobot_edu.jit import dispatcher

NAME = "rlrobot-edu"
WIDTH, INDENT = 100, 15  # of a line; of what stands beside a name
PIP = (
    "python -m pip" if importlib.util.find_spec("pip") else "uv pip"
)  # uv makes environments without pip
ANEW = f"Install the toolkit anew, in its folder: {PIP} install -e ."

# What is missing without an extra of pyproject.toml.
WITHOUT = {
    "arm": "arms are geometry alone, which bumps into nothing; engine='pybullet' does not work",
    "lab": "the command lab does not open the course, and there is no 3D: no rl.meshcat, .show3d() or rl.watch",
    "ros": "no bag of ROS can be read, or no robot driven or served over rosbridge",
    "all": "Dask's clusters are missing",
}


class Finding(NamedTuple):
    """One line of the report.

    name: what was looked at; says: what is there
    to_do: a sentence if something should be done about it; is_broken: whether the toolkit cannot work without that
    """

    name: str
    says: str
    to_do: str = ""
    is_broken: bool = False


class Diagnosis(NamedTuple):
    """All findings, by the heading under which they stand; `print` shows them."""

    sections: dict[str, list[Finding]]

    @property
    def is_broken(self) -> bool:
        """Whether something is wrong without which the toolkit cannot work."""
        return any(
            finding.is_broken
            for findings in self.sections.values()
            for finding in findings
        )

    def __str__(self) -> str:
        lines = []
        for heading, findings in self.sections.items():
            lines += [heading, *map(_line, findings), ""]
        to_do = dict.fromkeys(
            one.to_do
            for findings in self.sections.values()
            for one in findings
            if one.to_do
        )
        if not to_do:
            return "\n".join(
                [
                    *lines,
                    "All is well. What is said to be missing is needed only for what is said there.",
                ]
            )
        tasks = (
            textwrap.fill(f"{i}. {text}", WIDTH, subsequent_indent="   ")
            for i, text in enumerate(to_do, 1)
        )
        return "\n".join([*lines, "What to do:", *tasks])


def examine() -> Diagnosis:
    """Look at this Python, at what is installed, and at this folder; nothing is fetched from anywhere."""
    package = _package()
    return Diagnosis(
        {
            "This computer": [_python(), package, _kernels(), _arms(), _folder()],
            "Needed by everything": list(_core()),
            "Extras": [*map(_extra, () if package.is_broken else WITHOUT)],
        }
    )


def _line(finding: Finding) -> str:
    wrapper = textwrap.TextWrapper(
        WIDTH, " " * INDENT, " " * INDENT, break_long_words=False
    )
    says = "\n".join(map(wrapper.fill, finding.says.split("\n")))
    return f"  {finding.name:<{INDENT - 3}} {says[INDENT:]}"


def _python() -> Finding:
    return Finding(
        "Python",
        f"{platform.python_version()} on {sys.platform} {platform.machine()}, {sys.executable}",
    )


def _package() -> Finding:
    """The package's version, and where it lies; what pip knows of it may be older than what runs."""
    says = f"{rlrobot_edu.__version__} in {dispatcher.PACKAGE}"
    try:
        version = metadata.version(NAME)
    except metadata.PackageNotFoundError:
        return Finding(
            NAME,
            f"{says}; not installed by pip",
            f"{ANEW} (pip does not know of it)",
            is_broken=True,
        )
    if version != rlrobot_edu.__version__:
        return Finding(
            NAME, f"{says}; pip knows {version}", f"{ANEW} (pip knows {version})"
        )
    return Finding(NAME, says)


def _kernels() -> Finding:
    if dispatcher.numba is None or dispatcher.IS_PLAIN:
        why = (
            "without numba" if dispatcher.numba is None else "as NUMBA_DISABLE_JIT says"
        )
        return Finding(
            "kernels", f"plain Python, {why}: the same numbers, some 100 times as slow"
        )
    folder = dispatcher.cache_folder()
    if folder is None:
        to_do = f"Make {dispatcher.PACKAGE / '__pycache__'} or ~/.cache writable, so that compiled kernels can be kept."
        return Finding(
            "kernels",
            "compiled anew by every process: no place to keep them is writable",
            to_do,
        )
    if any(folder.glob("*.nbc")):
        return Finding("kernels", f"compiled, kept in {folder}")
    return Finding(
        "kernels",
        "not compiled yet, which takes some seconds a method, once: the command compile does it",
    )


def _arms() -> Finding:
    try:
        importlib.import_module("rlrobot_edu.robots.engines.bullet.simulation")
    except ImportError as error:
        return Finding("arms", f"geometry alone (engine='kinematic'): {error}")
    return Finding("arms", "simulated by PyBullet")


def _folder() -> Finding:
    try:
        with tempfile.TemporaryFile(dir="."):
            return Finding("folder", f"{Path.cwd()}: files can be written")
    except OSError as error:
        to_do = "Go to a folder of your own: results, recordings and my_course/ are written where you are."
        return Finding(
            "folder", f"nothing can be written here ({error.strerror})", to_do
        )


def _needed(
    distribution: str, extra: str = ""
) -> tuple[list[Requirement], list[Requirement]]:
    """The requirements of a distribution, or of an extra of it: those on this computer, and those only on others."""
    try:
        requirements = [
            Requirement(line) for line in metadata.requires(distribution) or []
        ]
    except metadata.PackageNotFoundError:
        return [], []
    asks = (
        re.compile(f'extra == "{re.escape(extra)}"')
        if extra
        else re.compile("extra ==")
    )
    mine = [r for r in requirements if bool(asks.search(str(r.marker))) == bool(extra)]
    here = [r for r in mine if r.marker is None or r.marker.evaluate({"extra": extra})]
    return here, [r for r in mine if r not in here]


def _core() -> Iterator[Finding]:
    """What the toolkit itself needs: each is imported, because one that is damaged is no better than none."""
    for requirement in _needed(NAME)[0]:
        fault = _fault(requirement)
        try:
            if not fault:
                importlib.import_module(
                    requirement.name.replace("-", "_")
                )  # each is named like its module
        except Exception as error:  # a damaged package may raise anything
            fault = f"cannot be imported: {type(error).__name__}: {error}"
        if fault:
            asked = str(requirement).partition(";")[0]
            to_do = f'Install what is needed: {PIP} install --force-reinstall "{asked}"'
            yield Finding(requirement.name, fault, to_do, is_broken=True)
        else:
            yield Finding(requirement.name, metadata.version(requirement.name))


def _extra(name: str) -> Finding:
    """What an extra needs, and with which versions it is there."""
    here, elsewhere = _needed(NAME, name)
    if not here and not elsewhere:
        return Finding(
            name,
            f"pip knows no such extra, as of an older toolkit.\nWithout it {WITHOUT[name]}.",
            ANEW,
        )
    if not here:
        names = ", ".join(sorted({requirement.name for requirement in elsewhere}))
        computer = f"Python {sys.version_info[0]}.{sys.version_info[1]} on {sys.platform} {platform.machine()}"
        return Finding(
            name, f"no wheel of {names} for {computer}.\nWithout it {WITHOUT[name]}."
        )
    for requirement in list(here):
        for part in requirement.extras:
            here += _needed(requirement.name, part)[0]
    faults = [
        f"{requirement.name} {fault}"
        for requirement in here
        if (fault := _fault(requirement))
    ]
    if faults:
        return Finding(
            name,
            f'{"; ".join(faults)}.\nWithout it {WITHOUT[name]}.\nTo install it: {PIP} install "{NAME}[{name}]"',
        )
    return Finding(
        name,
        ", ".join(
            f"{requirement.name} {metadata.version(requirement.name)}"
            for requirement in here
        ),
    )


def _fault(requirement: Requirement) -> str:
    """What is wrong with an installed distribution; empty if nothing is."""
    try:
        version = metadata.version(requirement.name)
    except metadata.PackageNotFoundError:
        return "is missing"
    fits = requirement.specifier.contains(version, prereleases=True)
    return "" if fits else f"is {version}, not {requirement.specifier}"
