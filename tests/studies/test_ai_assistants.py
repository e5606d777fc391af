"""The page on AI assistants says what the checks say of a chat bot's answers."""

import ai_assistants as study
import pytest


@pytest.mark.long
def test_the_table_is_what_the_checks_say():
    page = study.PAGE.read_text(encoding="utf-8")
    found = study.verdicts()
    assert study.written(page, found) == page
    assert list(found.values()).count("right") > 0.8 * len(found)  # "nearly all"
