"""The records of kernels that run as plain Python."""

import copy
import pickle

import numpy as np
import pytest

from rlrobot_edu.learning.memory import PlainRecord

KINDS = np.dtype([("rate", "f8"), ("count", "i8"), ("on", "b1")])


@pytest.fixture
def record():
    return PlainRecord(np.array((0.5, 3, True), KINDS))


def test_a_record_keeps_the_types_of_its_fields_and_its_numbers_in_its_array(record):
    record.rate, record["count"], record.on = 1, 7.9, 0
    assert (record.rate, record.count, record.on) == (1.0, 7, False)
    assert [type(record[name]) for name in KINDS.names] == [np.float64, np.int64, np.bool]
    assert np.asarray(record).tolist() == (1.0, 7, False)
    np.asarray(record)["rate"] = 2.5
    assert record.rate == 2.5


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda record: pickle.loads(pickle.dumps(record))])
def test_a_copy_has_numbers_of_its_own(record, again):
    other = again(record)
    other.rate = 9.0
    assert (other.rate, np.asarray(other)["rate"], other.count) == (9.0, 9.0, 3)
    assert (record.rate, np.asarray(record)["rate"]) == (0.5, 0.5)


def test_a_field_that_there_is_not_is_named(record):
    with pytest.raises(AttributeError, match="a record of rate, count, on has no temperature"):
        record.temperature  # noqa: B018
    with pytest.raises(KeyError, match="temperature"):
        record.temperature = 1.0
