"""What runs where: the page's table is what uv finds."""

import os

import platforms
import pytest


@pytest.fixture
def registry(monkeypatch):
    """Where packages come from; what uv has seen of it is kept in the user's own folder."""
    pytest.importorskip("uv")
    monkeypatch.setenv("HOME", os.environ["RLROBOT_TESTS_USERS_HOME"])
    try:
        platforms.packages("Linux, x86-64", "3.11")
    except RuntimeError as error:
        if "Failed to fetch" not in str(error):
            raise
        pytest.skip("no registry of packages can be reached")


@pytest.mark.long
def test_the_table_of_platforms_is_what_the_wheels_allow(registry):
    assert platforms.table_in(platforms.PAGE.read_text(encoding="utf-8")) == platforms.table()
