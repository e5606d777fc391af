"""The bias explorer: what it shows is what NumPy means along axes say, on the page as in the kernel."""

import re
from dataclasses import replace

import numpy as np
import pytest
from in_node import explored

import rlrobot_edu as rl
from rlrobot_edu.widgets.bias_explorer.words import two_decimals, vector

TASK = rl.load_task("worked_example")
SHAPE = TASK.states.shape
PAPER_STATE = TASK.states.number((1, 1, 1, 1))  # (X, Y, theta, d) = (1, 1, 90, T), the paper's example
Q = np.random.default_rng(7).normal(scale=5, size=(24, 3))


def explorer(state: int = PAPER_STATE, **settings) -> rl.BiasExplorer:
    return rl.BiasExplorer(TASK, {"random": Q, "zeros": np.zeros((24, 3))}, state=state, **settings)


def axis_means(q: np.ndarray, s: int) -> np.ndarray:
    """The mean of Q along each axis at state `s`, array (inputs, A): the oracle."""
    box, bins = q.reshape(*SHAPE, -1), list(TASK.states.bins(s))
    return np.array([box.mean(axis=i)[tuple(bins[:i] + bins[i + 1 :])] for i in range(len(SHAPE))])


def softmax(x: np.ndarray) -> np.ndarray:
    e = np.exp(x - x.max())
    return e / e.sum()


def test_every_number_shown_is_a_mean_along_an_axis_or_a_softmax():
    for s, found in enumerate(explored(explorer())):
        numbers, means, text = explorer(s).numbers, axis_means(Q, s), re.sub(r"</?(b|span)[^>]*>", "", found["html"])
        bias = means.mean(axis=0)
        # Qmax = Rmax / (1 - gamma) = 100 in this task, so the factor is 1
        expected = {"means": means, "bias": bias, "sr": softmax(Q[s]), "qbiassr": softmax(Q[s] + bias)}
        for name, value in expected.items():
            assert np.allclose(getattr(numbers, name), value, atol=1e-12), name
            assert np.allclose(found[name], value, atol=1e-12), name
        for values in (*means, bias, Q[s] + bias):
            assert vector(values) in text
        for p in (*numbers.sr, *numbers.qbiassr):
            assert f"{100 * p:.1f} %" in text


def test_the_formulas_are_those_of_the_papers_example():
    text = re.sub("</?b>", "", explored(explorer())[PAPER_STATE]["html"])
    for members in (
        ["(0,1,90,1)", "(1,1,90,1)"], ["(1,0,90,1)", "(1,1,90,1)"],
        ["(1,1,0,1)", "(1,1,90,1)", "(1,1,−90,1)"], ["(1,1,90,0)", "(1,1,90,1)"],
    ):  # fmt: skip
        assert f"1⁄{len(members)} · [" + " + ".join(f"<i>Q</i>{m}" for m in members) + "]" in text


def edited(shown: rl.BiasExplorer, s: int, a: int, value: float) -> None:
    """What a reader's edit sends to the kernel."""
    q = shown.q
    q[s, a] = value
    at = shown.widget.table
    shown.widget.tables = [q.tolist() if i == at else table for i, table in enumerate(shown.widget.tables)]


def test_an_edit_changes_the_bias_of_its_table_alone_and_not_the_readers_array():
    shown, kept = explorer(), Q.copy()
    before = shown.numbers.bias
    edited(shown, 9, 2, Q[9, 2] + 8)  # state 9 differs in X: half of one mean of four
    assert np.allclose(shown.numbers.bias - before, [0, 0, 1])
    assert np.allclose(explored(shown)[PAPER_STATE]["bias"], shown.numbers.bias)
    shown.widget.table = 1
    assert shown.table == "zeros" and not shown.numbers.bias.any()
    shown.widget.table = 0
    assert np.allclose(shown.numbers.bias - before, [0, 0, 1])  # edits wait for the reader's return
    assert np.array_equal(Q, kept) and np.array_equal(shown.widget.about["originals"][0]["q"], Q)


def test_the_state_itself_counts_in_each_of_its_sets():
    shown = rl.BiasExplorer(TASK, {"zeros": np.zeros((24, 3))}, state=PAPER_STATE)
    shown.widget.tables = [[[12 * (s == PAPER_STATE), 0, 0] for s in range(24)]]  # whole numbers, as a browser has them
    assert np.allclose(shown.numbers.means[:, 0], [6, 6, 4, 6]) and np.isclose(shown.numbers.bias[0], 5.5)
    assert shown.q.dtype == float


def test_an_agent_is_shown_as_it_would_choose():
    agent = rl.Agent(TASK, gamma=0.5, loop_evasion=False, seed=0)
    rl.learn(agent, rl.make_env(TASK, seed=0), 200, progress=False)
    agent.begin_episode(PAPER_STATE)
    numbers = rl.BiasExplorer(TASK, {"mine": agent}, state=PAPER_STATE).numbers
    assert np.allclose(numbers.qbiassr, agent.probabilities) and np.allclose(numbers.bias, agent.bias)


def test_numbers_of_numpys_are_taken_and_the_page_can_be_saved(tmp_path):
    shown = explorer(np.int64(21), temperature=np.float32(0.5))
    shown.save(tmp_path / "bias.html")
    assert shown.state == 21 and np.allclose(shown.numbers.sr, softmax(Q[21] / 0.5))
    assert np.allclose(explored(shown)[21]["sr"], shown.numbers.sr)


def test_any_small_task_can_be_shown():
    shown = rl.BiasExplorer("wander_simple", {"zeros": np.zeros((4, 4))})
    assert explored(shown)[3]["html"].count("<button value") == 4 and shown.picture().png()


def test_a_task_of_one_input_can_be_shown():
    task = replace(TASK, inputs=TASK.inputs[2:3], goal=None)
    shown = rl.BiasExplorer(task, {"q": Q[:3]}, state=1)
    found = explored(shown)
    assert found[1]["members"] == [[1, None], [0, 0], [2, 0]] and np.allclose(found[1]["bias"], Q[:3].mean(axis=0))
    assert found[1]["html"].count("<button value") == 3 and shown.picture().png()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"task": "wander_1k"}, "wander_1k has 1024 states .* at most 64"),
        ({"tables": {}}, "at least one Q-table"),
        ({"tables": {"short": np.zeros((4, 3))}}, "'short' must hold .* 24 states .* shape .4, 3."),
        ({"tables": {"bad": np.full((24, 3), np.nan)}}, "'bad' must hold finite numbers"),
        ({"state": 24}, "state 24 does not exist"),
        ({"temperature": 0.0}, "temperature must be"),
    ],
)
def test_what_does_not_fit_is_refused_in_words(arguments, message):
    with pytest.raises(ValueError, match=message):
        rl.BiasExplorer(**{"task": TASK, "tables": {"zeros": np.zeros((24, 3))}, **arguments})


def test_the_saved_output_is_a_picture_with_a_description_and_a_text_that_stays():
    data = explorer()._repr_mimebundle_()
    assert "data:image/png;base64," in data["text/html"] and "application/vnd.jupyter.widget-view+json" in data
    assert data["text/plain"] == repr(explorer()) and "0x" not in data["text/plain"]
    assert "state 21 (X 1, Y 1, theta 90 deg, d 1)" in data["text/plain"]
    alt = data["text/html"]
    assert "X: 9, 21; Y: 15, 21; theta: 19, 21, 23; d: 20, 21" in alt and vector(explorer().numbers.bias) in alt


def test_numbers_have_a_true_minus_and_no_negative_zero():
    assert (two_decimals(-1.5), two_decimals(-0.001), two_decimals(0.125001)) == ("−1.50", "0.00", "0.13")
