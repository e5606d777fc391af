"""A method of the learner's own: it learns wherever the toolkit's do, compiled or not."""

import inspect
import math
import os
import re
import subprocess
import sys
from math import log

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.learning.algorithm import Planner
from rlrobot_edu.learning.methods import made_of
from rlrobot_edu.widgets.stepper.code_view import code_html

WORLDS = ("wander_simple", "model")


def my_update(m, s, a, r, s_next, a_next, terminated):
    """SARSA, written again."""
    target = r if terminated else r + m.parameters.gamma * m.q[s_next, a_next]
    delta = target - m.q[s, a]
    m.q[s, a] += m.parameters.alpha * delta
    return delta


def half_update(m, s, a, r, s_next, a_next, terminated):
    """Learns from the reward alone, and half as fast."""
    delta = r - m.q[s, a]
    m.q[s, a] += 0.5 * m.parameters.alpha * delta
    return delta


def likes_the_last(m, s):
    """The last action nine times of ten, whatever Q says."""
    n_actions = m.probabilities.shape[0]
    for a in range(n_actions):
        m.probabilities[a] = 0.1 / n_actions
    m.probabilities[n_actions - 1] += 0.9


MINE = rl.Algorithm("MINE", my_update)
HALF = rl.Algorithm("HALF", half_update)
LAST = rl.Selection("LAST", likes_the_last)


def world_of(name, wander_model):
    return wander_model if name == "model" else rl.load_task(name)


@pytest.mark.long
@pytest.mark.parametrize("selection", ["SR", "QBIASSR", "EG"])
@pytest.mark.parametrize("world", WORLDS)
def test_sarsa_written_again_learns_what_the_librarys_learns_to_the_last_bit(
    world, selection, wander_model
):
    world = world_of(world, wander_model)
    q = []
    for method in (rl.Method(MINE, selection), f"SARSA+{selection}"):
        agent = rl.Agent(world, method, seed=0)
        rl.learn(agent, rl.make_env(world, seed=1), steps=800, progress=False)
        q.append(agent.q)
    assert np.array_equal(*q) and q[0].any()


@pytest.mark.long
def test_an_algorithm_and_a_selection_of_ones_own_have_their_names_and_are_used(
    wander_model,
):
    agent = rl.Agent(wander_model, rl.Method(HALF, LAST), seed=0)
    assert agent.method.name == "HALF+LAST"
    history = rl.learn(
        agent, rl.make_env(wander_model, seed=1), steps=500, keep=True, progress=False
    )
    assert history.method == "HALF+LAST" and np.mean(history.a == 8) > 0.8
    q = np.zeros_like(agent.q)
    for s, a, r in zip(history.s, history.a, history.rewards, strict=True):
        q[s, a] += 0.05 * (r - q[s, a])
    assert np.array_equal(q, agent.q)


def test_a_comparison_takes_it_into_other_processes_and_its_store_knows_its_code(
    tmp_path,
):
    about = {"repetitions": 2, "steps": 60, "n_jobs": 2, "progress": False}
    mine = rl.compare(
        "wander_simple", [rl.Method(MINE, "SR")], store=tmp_path / "store", **about
    )
    assert list(mine) == ["MINE+SR"]
    same = rl.compare("wander_simple", {"MINE+SR": {"method": "SARSA+SR"}}, **about)
    for ours, theirs in zip(mine["MINE+SR"], same["MINE+SR"], strict=True):
        assert np.array_equal(ours.q, theirs.q)
    other = rl.Method(rl.Algorithm("MINE", half_update), "SR")
    with pytest.raises(ValueError, match="the code of MINE of MINE"):
        rl.compare("wander_simple", [other], store=tmp_path / "store", **about)


def test_a_saved_agent_goes_on_with_its_own_method_and_with_no_other(
    wander_model, tmp_path
):
    method, path = rl.Method(MINE, LAST), tmp_path / "agent.npz"
    agent, env = (
        rl.Agent(wander_model, method, seed=0),
        rl.make_env(wander_model, seed=1),
    )
    rl.learn(agent, env, steps=100, progress=False)
    agent.save(path)
    again = rl.Agent.load(path, method=method)
    assert np.array_equal(again.q, agent.q) and again.method.name == "MINE+LAST"
    with pytest.raises(
        ValueError,
        match=r"agent\.npz: this agent has a method of its own; give it as method=",
    ):
        rl.Agent.load(path)
    for other in (
        rl.Method(HALF, LAST),
        rl.Method(rl.Algorithm("MINE", half_update), LAST),
        rl.Method(MINE, "SR"),
    ):
        with pytest.raises(ValueError, match="is not the one that was given"):
            rl.Agent.load(path, method=other)


def test_an_agent_of_the_toolkits_method_loads_with_its_name_alone(tmp_path):
    rl.Agent("wander_simple", rl.Method("TOSL", "SR")).save(tmp_path / "agent.npz")
    assert rl.Agent.load(tmp_path / "agent.npz").method.name == "TOSL+SR"
    with pytest.raises(
        ValueError, match=r"the method is TOSL\+SR in the file, Q\+SR in this call"
    ):
        rl.Agent.load(tmp_path / "agent.npz", method=rl.Method("Q", "SR"))
    assert made_of(rl.Method("TOSL", "SR")) == {"planner": None}


def test_the_stepper_shows_it_and_where_its_code_is():
    from in_node import (
        view,
    )  # here: this file is imported by processes that know no other

    env = rl.make_env("worked_example", seed=0)
    stepper = rl.Stepper(
        rl.Agent("worked_example", rl.Method(MINE, "SR"), seed=0), env, at=5
    )
    assert "δ" in view(stepper) and stepper.picture().png()
    where, code = code_html(stepper._tape.agent)
    assert "test_own_method.py" in where and "target" in code


def test_unknown_parts_are_named_and_the_nearest_suggested():
    with pytest.raises(
        ValueError, match="no selection 'QBIASR'; did you mean 'QBIASSR'"
    ):
        rl.Method(MINE, "QBIASR")
    with pytest.raises(ValueError, match="no algorithm 'TOSLL'; did you mean 'TOSL'"):
        rl.Method("TOSLL", "SR")
    with pytest.raises(ValueError, match="'sarsa lambda'; did you mean 'SL'"):
        rl.Method("sarsa lambda", "SR")
    with pytest.raises(ValueError, match="no selection 'Softmax'; did you mean 'SR'"):
        rl.Method("Q", "Softmax")


PLAIN = """
import sys, hashlib
sys.path.insert(0, sys.argv[1])
from test_own_method import MINE, rl
agent = rl.Agent("worked_example", rl.Method(MINE, "QBIASSR"), seed=0)
rl.learn(agent, rl.make_env("worked_example", seed=1), steps=300, progress=False)
print(hashlib.sha256(agent.q.tobytes()).hexdigest())
"""


@pytest.mark.long
def test_compiled_or_not_the_numbers_are_the_same_to_the_last_bit(tmp_path):
    folder = os.path.dirname(__file__)
    said = [
        subprocess.check_output(
            [sys.executable, "-c", PLAIN, folder],
            env={**os.environ, "NUMBA_DISABLE_JIT": plain},
        )
        for plain in "01"
    ]
    assert said[0] == said[1]


def row_after(m, s, a, r, s_next, a_next, terminated):
    m.q[s, a] += 1.0
    return m.q[s_next + 1].max()  # LINE


def column_after(m, s, a, r, s_next, a_next, terminated):
    m.e[s, a] = 1.0
    return m.e[s, m.e.shape[1]]  # LINE


def no_divisor(m, s, a, r, s_next, a_next, terminated):
    m.q[s, a] += r
    return r / (m.parameters.alpha - m.parameters.alpha)  # LINE


def raises(m, s, a, r, s_next, a_next, terminated):
    m.q[s, a] += r
    if m.q[s, a] > 2.5:
        raise ValueError("three are enough")  # LINE
    return 0.0


def misspelt(m, s, a, r, s_next, a_next, terminated):
    return r - m.quality[s, a]  # LINE


def counts_in_a_dictionary(m, s, a, r, s_next, a_next, terminated):
    seen = {"s": [s], "a": []}  # LINE
    return float(len(seen))


def returns_nothing(m, s, a, r, s_next, a_next, terminated):  # LINE
    m.q[s, a] += 0.1


def not_a_number(m, s, a, r, s_next, a_next, terminated):  # LINE
    return r * math.inf


def root_below_0(m, s, a, r, s_next, a_next, terminated):
    if math.sqrt(m.q[s, a] - 1.0) > 3.0:  # LINE
        m.q[s, a] = 9.0
    return 0.0


def logarithm_of_0(m, s, a, r, s_next, a_next, terminated):
    return min(0.0, log(m.q[s, a]) + 9.0) * 0.0  # LINE


def far_away(q, s):
    return q[s + 10_000, 0]  # LINE


def calls_a_helper(m, s, a, r, s_next, a_next, terminated):
    return far_away(m.q, s)


def line_of(function):
    """The line of this file that its comment marks."""
    lines, first = inspect.getsourcelines(function)
    return first + next(i for i, line in enumerate(lines) if "# LINE" in line)


FAULTS = {
    row_after: "IndexError: index 1024 is out of bounds",
    column_after: "IndexError",
    no_divisor: "FloatingPointError: divide by zero",
    raises: "ValueError: three are enough",
    misspelt: "AttributeError",
    counts_in_a_dictionary: "numba cannot compile the update of MINE",
    returns_nothing: "TypeError",
    not_a_number: "must return the TD error, a finite number",
    root_below_0: "ValueError: math domain error",
    logarithm_of_0: "ValueError: math domain error",
    calls_a_helper: "IndexError",
}


@pytest.mark.parametrize("update", FAULTS, ids=lambda update: update.__name__)
def test_an_update_that_fails_is_one_sentence_with_its_line_and_nothing_is_half_done(
    update, wander_model
):
    agent = rl.Agent(wander_model, rl.Method(rl.Algorithm("MINE", update), "SR"))
    last, done = agent.q.shape[0] - 1, 0
    with pytest.raises(ValueError) as error:
        for done in range(5):  # noqa: B007 - how many came before the fault
            agent.update(last, 0, 1.0, last, 0, False)
    said = str(error.value)
    assert re.search(FAULTS[update], said), said
    line = line_of(far_away if update is calls_a_helper else update)
    assert f"test_own_method.py, line {line}: " in said and "\n" not in said, said
    assert agent.q.sum() == done == (2 if update is raises else 0)
    assert not agent.e.any() and not agent.visits.any()


def all_alike(m, s):
    m.probabilities[:] = 1.0


def some_below_0(m, s):
    m.probabilities[:] = 0.0
    m.probabilities[0], m.probabilities[1] = 2.0, -1.0


def none_is_finite(m, s):
    m.probabilities[:] = math.nan


def one_too_many(m, s):
    n = m.probabilities.shape[0]
    m.probabilities[:] = 1.0 / n
    m.probabilities[n] = 0.0


SELECTIONS = {
    all_alike: "it must leave probabilities: their sum must be 1",
    some_below_0: "it must leave probabilities: none below 0, all finite",
    none_is_finite: "it must leave probabilities: none below 0, all finite",
    one_too_many: "IndexError",
}


@pytest.mark.parametrize("selection", SELECTIONS, ids=lambda select: select.__name__)
def test_a_selection_must_leave_probabilities(selection, wander_model):
    method = rl.Method("SARSA", rl.Selection("MINE", selection))
    agent = rl.Agent(wander_model, method, seed=0)
    rng = agent.rng.bit_generator.state
    with pytest.raises(ValueError, match="the selection MINE failed") as error:
        agent.begin_episode(0)
    assert SELECTIONS[selection] in str(error.value)
    assert agent.rng.bit_generator.state == rng
    assert np.ptp(agent.probabilities) == 0.0


def test_a_planner_that_leaves_its_experience_is_one_sentence(wander_model):
    def plan(m, x, s, a, n, rng):
        x.tries[m.q.shape[0] * m.q.shape[1]] += 1

    agent = rl.Agent(wander_model, "Q+SR", planner=Planner("AHEAD", plan))
    with pytest.raises(ValueError, match="the planner AHEAD failed: IndexError"):
        agent.update(0, 0, 1.0, 1, 0, False)
    assert not agent.q.any() and not agent.experience.tries.any()


def four_times(m, s, a, r, s_next, a_next, terminated):
    m.q[s, a] += 1.0
    if m.visits[s, a] > 3:
        raise ValueError("three are enough")
    return 0.0


def test_a_run_ends_before_the_step_that_fails_also_in_the_middle_of_a_slice(
    wander_model,
):
    method = rl.Method(rl.Algorithm("MINE", four_times), "SR")
    agent, twin = (rl.Agent(wander_model, method, seed=0) for _ in range(2))
    with pytest.raises(ValueError, match="three are enough"):
        rl.learn(agent, rl.make_env(wander_model, seed=1), 5000, progress=False)
    done = int(agent.visits.sum())
    assert agent.visits.max() == 3 and done > 10
    rl.learn(twin, rl.make_env(wander_model, seed=1), done, progress=False)
    assert np.array_equal(agent.q, twin.q)
    assert np.array_equal(agent.visits, twin.visits)
    assert agent.rng.bit_generator.state == twin.rng.bit_generator.state
    assert agent.pending == twin.pending


class Callable:
    def __call__(self, m, s, a, r, s_next, a_next, terminated):
        return 0.0


@pytest.mark.parametrize("update", [Callable(), Callable().__call__, None, 3])
def test_a_part_that_is_no_function_is_refused(update):
    with pytest.raises(ValueError, match="the update of MINE must be a function that"):
        rl.Method(rl.Algorithm("MINE", update), "SR")
