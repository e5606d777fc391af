"""A made-up class goes through all of homework, and every table says what was built into it."""

import pytest
from class_of_forty import KINDS, go_through_all


@pytest.mark.long
def test_a_class_that_is_right_half_right_wrong_and_hostile_gets_what_it_deserves(tmp_path):
    assert go_through_all(tmp_path, len(KINDS), jobs=2) == []
