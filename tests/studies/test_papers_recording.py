"""The format of the paper's authors: its numbers of states and actions become the task's."""

import numpy as np
import pytest
from papers_recording import read_papers_recording

import rlrobot_edu as rl


def fortran(recording, order):
    """The rows (s, a, s', r) of a recording in the paper's numbering, with the inputs in another order."""
    states = recording.source.states
    shape = [states.shape[i] for i in order]

    def renumber(numbers):
        bins = np.unravel_index(numbers, states.shape)
        return np.ravel_multi_index([bins[i] for i in order], shape, order="F")

    actions = np.unravel_index(recording.a, recording.source.actions.shape)
    a = np.ravel_multi_index(actions, recording.source.actions.shape, order="F")
    return np.column_stack(
        [renumber(recording.s), a, renumber(recording.s_next), recording.r]
    ).astype(float)


@pytest.mark.parametrize("order", [[0, 1, 2, 3], [2, 0, 3, 1]])
def test_the_papers_numbers_become_the_tasks(tmp_path, order):
    task = rl.load_task("worked_example")
    agent = rl.Agent(task, "Q+RANDOM", seed=0)
    recording = rl.record(agent, rl.make_env(task, seed=0), steps=200)
    np.save(tmp_path / "old.npy", fortran(recording, order))
    inputs = [task.inputs[i].name for i in order]
    back = read_papers_recording(tmp_path / "old.npy", task, inputs)
    assert all(
        np.array_equal(getattr(back, name), getattr(recording, name))
        for name in ("s", "a", "r", "s_next")
    )
    joins = back.s[1:] == back.s_next[:-1]
    assert np.array_equal(np.diff(back.episode), ~joins) and not back.terminated.any()
