"""What runs where: ``make platforms`` writes the table of docs/howto/install.md.

For each platform and Python uv chooses what ``.[lab,arm,ros]`` would install, in the versions of constraints.txt
and from wheels only. Nothing is installed, so all platforms can be asked on one computer.
"""

import os
import re
import subprocess
import sys
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs/howto/install.md"
PYTHONS = ["3.11", "3.12", "3.13", "3.14", "3.15"]
# The oldest macOS, and below the oldest glibc, for which all of these packages have wheels
MACOS = "14.0"
PLATFORMS = {
    "Linux, x86-64": "x86_64-manylinux_2_28",
    "Linux, ARM": "aarch64-manylinux_2_28",
    "Windows, x86-64": "x86_64-pc-windows-msvc",
    "macOS, Apple silicon": "aarch64-apple-darwin",
    "macOS, Intel": "x86_64-apple-darwin",
}
CAN_BE_MISSING = {
    "numba": {"numba"},
    "PyBullet": {"pybullet", "pybullet-arm64"},
    "bags of ROS": {"rosbags"},
}
CHOOSE = [
    *(
        "-m",
        "uv",
        "pip",
        "compile",
        "pyproject.toml",
        "--extra=lab",
        "--extra=arm",
        "--extra=ros",
    ),
    *("--constraints=constraints.txt", "--only-binary=:all:", "--no-python-downloads"),
    *("--quiet", "--no-header", "--no-annotate"),
]


@cache
def packages(platform: str, python: str) -> frozenset[str] | None:
    """Names of what would be installed there; None where a package has no wheel."""
    there = ["--python-platform", PLATFORMS[platform], "--python-version", python]
    done = subprocess.run(
        [sys.executable, *CHOOSE, *there],
        cwd=ROOT,
        env=os.environ | {"MACOSX_DEPLOYMENT_TARGET": MACOS},
        capture_output=True,
        text=True,
    )
    if done.returncode and "no usable wheels" not in done.stderr:
        raise RuntimeError(done.stderr)
    return (
        None
        if done.returncode
        else frozenset(re.findall(r"^[\w-]+", done.stdout, re.MULTILINE))
    )


def cell(platform: str, python: str) -> str:
    """What a learner there does without."""
    names = packages(platform, python)
    if names is None:
        return "cannot be installed"
    missing = [part for part, wheels in CAN_BE_MISSING.items() if not names & wheels]
    return f"without {', '.join(missing)}" if missing else "everything"


def table() -> str:
    """All platforms and Pythons, as Markdown."""
    rows = [
        [f"**{platform}**", *(cell(platform, python) for python in PYTHONS)]
        for platform in PLATFORMS
    ]
    head = [
        ["", *(f"Python {python}" for python in PYTHONS)],
        ["---"] * (len(PYTHONS) + 1),
    ]
    return "".join(f"| {' | '.join(row)} |\n" for row in head + rows)


def table_in(page: str) -> str:
    """The first table of a page."""
    return re.search(r"(^\|.*\n)+", page, re.MULTILINE).group()


if __name__ == "__main__":
    page = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(page.replace(table_in(page), table()), encoding="utf-8")
