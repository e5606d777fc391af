"""What runs where: the page's table is what uv finds."""

import os

import platforms
import pytest


@pytest.mark.long
def test_the_table_of_platforms_is_what_the_wheels_allow(monkeypatch):
    pytest.importorskip("uv")
    monkeypatch.setenv(
        "HOME", os.environ["RLROBOT_TESTS_USERS_HOME"]
    )  # uv's settings and cache are there
    try:
        table = platforms.table()
    except RuntimeError as error:
        if "Failed to fetch" not in str(error):
            raise
        pytest.skip("no registry of packages can be reached")
    assert platforms.table_in(platforms.PAGE.read_text(encoding="utf-8")) == table
