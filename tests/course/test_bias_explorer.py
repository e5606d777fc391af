"""The bias explorer: what it shows is what NumPy means along axes say, and every control does what its label says."""

import time

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.widgets.bias_explorer.panes import two_decimals, vector

TASK = rl.load_task("worked_example")
SHAPE = TASK.states.shape
PAPER_STATE = TASK.states.number((1, 1, 1, 1))  # (X, Y, theta, d) = (1, 1, 90, T), the paper's example
Q = np.random.default_rng(7).normal(scale=5, size=(24, 3))


def explorer(state: int = PAPER_STATE, **settings) -> rl.BiasExplorer:
    return rl.BiasExplorer(TASK, {"random": Q, "zeros": np.zeros((24, 3))}, state=state, **settings)


def page(shown: rl.BiasExplorer) -> str:
    parts = [*shown.widget.children, *shown.widget.children[0].children]
    return "".join(part.value for part in parts if hasattr(part, "value"))


def axis_means(q: np.ndarray, s: int) -> np.ndarray:
    """The mean of Q along each axis at state `s`, array (inputs, A): the oracle."""
    box, bins = q.reshape(*SHAPE, -1), list(TASK.states.bins(s))
    return np.array([box.mean(axis=i)[tuple(bins[:i] + bins[i + 1 :])] for i in range(len(SHAPE))])


def softmax(x: np.ndarray) -> np.ndarray:
    e = np.exp(x - x.max())
    return e / e.sum()


@pytest.mark.parametrize("s", range(24))
def test_every_number_shown_is_a_mean_along_an_axis_or_a_softmax(s):
    shown, means = explorer(s), axis_means(Q, s)
    numbers, text = shown.numbers, page(shown)
    assert np.allclose(numbers.means, means) and np.allclose(numbers.bias, means.mean(axis=0))
    assert np.allclose(numbers.biased, Q[s] + means.mean(axis=0))
    # Qmax = Rmax / (1 - gamma) = 100 in this task, so the factor is 1
    assert np.allclose(numbers.sr, softmax(Q[s])) and np.allclose(numbers.qbiassr, softmax(numbers.biased))
    for values in (*numbers.means, numbers.bias, numbers.biased):
        assert vector(values) in text
    for p in (*numbers.sr, *numbers.qbiassr):
        assert f"{100 * p:.1f} %" in text


def test_the_formulas_are_those_of_the_papers_example():
    text = page(explorer()).replace("<b>", "").replace("</b>", "")
    for members in (
        ["(0,1,90,1)", "(1,1,90,1)"], ["(1,0,90,1)", "(1,1,90,1)"],
        ["(1,1,0,1)", "(1,1,90,1)", "(1,1,−90,1)"], ["(1,1,90,0)", "(1,1,90,1)"],
    ):  # fmt: skip
        assert f"1⁄{len(members)} · [" + " + ".join(f"<i>Q</i>{m}" for m in members) + "]" in text


def test_a_click_shows_another_state_and_marks_its_sets():
    shown = explorer()
    shown.states.buttons[13].click()
    assert shown.state == 13 and [dropdown.value for dropdown in shown.inputs] == [1, 0, 0, 1]
    labels = [button.description for button in shown.states.buttons]
    marked = {13: "▸13◂", 1: "1 ●", 19: "19 ▲", 15: "15 ■", 17: "17 ■", 12: "12 ◆"}
    assert labels == [marked.get(s, str(s)) for s in range(24)]
    colours = [shown.states.buttons[s].style.button_color for s in marked]
    assert len(set(colours)) == 5 and None not in colours  # the two of theta are alike
    assert shown.states.buttons[0].style.button_color is None


def test_choosing_the_inputs_shows_the_same_state_as_a_click():
    shown = explorer(0)
    for dropdown, value in zip(shown.inputs, (1, 1, 1, 1), strict=True):
        dropdown.value = value
    assert shown.state == PAPER_STATE and page(shown) == page(explorer())


def test_an_edit_changes_the_bias_and_reset_undoes_it_without_touching_the_readers_array():
    shown, kept = explorer(), Q.copy()
    before, text = shown.numbers.bias.copy(), page(shown)
    row = [s for s, _ in shown.numbers.members].index(9)  # differs in X: half of one mean of four
    shown.members.fields[row][2].value = Q[9, 2] + 8
    assert np.allclose(shown.numbers.bias - before, [0, 0, 1]) and page(shown) != text
    shown.table.value = "zeros"
    assert not shown.numbers.bias.any()
    shown.table.value = "random"
    assert np.allclose(shown.numbers.bias - before, [0, 0, 1])  # edits wait for the reader's return
    shown.reset.click()
    assert np.array_equal(shown.q, Q) and page(shown) == text and np.array_equal(Q, kept)


def test_the_state_itself_counts_in_each_of_its_sets():
    shown = rl.BiasExplorer(TASK, {"zeros": np.zeros((24, 3))}, state=PAPER_STATE)
    shown.members.fields[0][0].value = 12.0
    assert np.allclose(shown.numbers.means[:, 0], [6, 6, 4, 6]) and np.isclose(shown.numbers.bias[0], 5.5)


def test_what_is_no_number_is_not_taken_over():
    shown = explorer()
    shown.members.fields[1][0].value = float("nan")
    assert np.array_equal(shown.q, Q) and np.isclose(shown.members.fields[1][0].value, Q[9, 0], atol=1e-3)


def test_an_agent_is_shown_as_it_would_choose():
    agent = rl.Agent(TASK, gamma=0.5, loop_evasion=False, seed=0)
    rl.learn(agent, rl.make_env(TASK, seed=0), 200, progress=False)
    agent.begin_episode(PAPER_STATE)
    numbers = rl.BiasExplorer(TASK, {"mine": agent}, state=PAPER_STATE).numbers
    assert np.allclose(numbers.qbiassr, agent.probabilities) and np.allclose(numbers.bias, agent.bias)


def test_any_small_task_can_be_shown():
    shown = rl.BiasExplorer("wander_simple", {"zeros": np.zeros((4, 4))})
    assert len(shown.states.buttons) == 4 and shown.picture().png()


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


def test_the_kernel_answers_a_click_at_once():
    shown, start = explorer(), time.process_time()
    for button in shown.states.buttons:
        button.click()
    assert (time.process_time() - start) / 24 < 0.02


def test_numbers_have_a_true_minus_and_no_negative_zero():
    assert (two_decimals(-1.5), two_decimals(-0.001), two_decimals(0.125001)) == ("−1.50", "0.00", "0.13")
