"""What runs where: the page's table is what uv finds."""

import os
import subprocess
import sys

import platforms
import pytest

pytestmark = pytest.mark.nightly


@pytest.fixture(autouse=True)
def registry(monkeypatch):
    """uv, with the settings and the cache of the person who runs the tests."""
    pytest.importorskip("uv")
    monkeypatch.setenv("HOME", os.environ["RLROBOT_TESTS_USERS_HOME"])


def test_the_table_of_platforms_is_what_the_wheels_allow():
    try:
        table = platforms.table()
    except RuntimeError as error:
        if "Failed to fetch" not in str(error):
            raise
        pytest.skip("no registry of packages can be reached")
    assert platforms.table_in(platforms.PAGE.read_text(encoding="utf-8")) == table


def has_wheel(package, platform, python):
    """Whether any version of a package has a wheel there."""
    command = [
        *(sys.executable, "-m", "uv", "pip", "compile", "-", "--quiet", "--no-deps"),
        *("--only-binary=:all:", "--no-python-downloads", "--no-config"),
        *("--python-platform", platforms.PLATFORMS[platform]),
        *("--python-version", python),
    ]
    done = subprocess.run(command, input=package, capture_output=True, text=True)
    if "Failed to fetch" in done.stderr:
        pytest.skip("no registry of packages can be reached")
    return done.returncode == 0


@pytest.mark.parametrize("platform", platforms.PLATFORMS)
@pytest.mark.parametrize("python", platforms.PYTHONS)
def test_pybullets_fork_is_asked_for_only_where_pybullet_has_no_wheel(platform, python):
    chosen = platforms.packages(platform, python)
    assert ("pybullet" in chosen) == has_wheel("pybullet", platform, python)
