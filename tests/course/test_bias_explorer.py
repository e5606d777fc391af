"""The bias explorer: what it shows is what NumPy means along axes say, on the page as in the kernel."""

import re
from dataclasses import replace

import numpy as np
import pytest
from in_node import explored, run

import rlrobot_edu as rl
from rlrobot_edu.widgets.bias_explorer.explorer import BiasExplorer
from rlrobot_edu.widgets.bias_explorer.widget import script
from rlrobot_edu.widgets.bias_explorer.words import amount, finding, percents, vector

TASK = rl.load_task("worked_example")
SHAPE = TASK.states.shape
PAPER_STATE = TASK.states.number(
    (1, 1, 1, 1)
)  # (X, Y, theta, d) = (1, 1, 90, T), the paper's example
Q = np.random.default_rng(7).normal(scale=5, size=(24, 3))


def explorer(state: int = PAPER_STATE, **settings) -> BiasExplorer:
    return BiasExplorer(
        TASK, {"random": Q, "zeros": np.zeros((24, 3))}, state=state, **settings
    )


def axis_means(q: np.ndarray, s: int) -> np.ndarray:
    """The mean of Q along each axis at state `s`, array (inputs, A): the oracle."""
    box, bins = q.reshape(*SHAPE, -1), list(TASK.states.bins(s))
    return np.array(
        [box.mean(axis=i)[tuple(bins[:i] + bins[i + 1 :])] for i in range(len(SHAPE))]
    )


def softmax(x: np.ndarray) -> np.ndarray:
    e = np.exp(x - x.max())
    return e / e.sum()


def plain(html: str) -> str:
    return re.sub(r"<[^>]*>", "", html).replace("&nbsp;", " ")


def test_every_number_shown_is_a_mean_along_an_axis_or_a_softmax():
    for s, found in enumerate(explored(explorer())):
        numbers, means, said = explorer(s).numbers, axis_means(Q, s), found["said"]
        bias = means.mean(axis=0)
        # Qmax = Rmax / (1 - gamma) = 100 in this task, so the factor is 1
        expected = {
            "means": means,
            "bias": bias,
            "sr": softmax(Q[s]),
            "qbiassr": softmax(Q[s] + bias),
        }
        for name, value in expected.items():
            assert np.allclose(getattr(numbers, name), value, atol=1e-12), name
            assert np.allclose(found[name], value, atol=1e-12), name
        for a, (own, _, means_said, bias_said, choice) in enumerate(
            map(plain, stages) for stages in said
        ):
            assert f"says {amount(Q[s, a])} for {TASK.actions.label(a)}" in own
            assert re.findall(r" = ([−\d.e]+)[;.]", means_said) == [
                amount(mean) for mean in means[:, a]
            ]
            assert bias_said.endswith(f") / 4 = {amount(bias[a])}.")
            assert vector(bias) in choice and vector(Q[s] + bias) in choice
            shares = ", ".join(
                percents(p, sr, 1)[0]
                for p, sr in zip(numbers.qbiassr, numbers.sr, strict=True)
            )
            assert choice.endswith(f"P = {shares}.")


def test_the_title_blames_similar_states_only_where_their_values_made_the_change():
    """Their part of the bias is what is left of it when the state's own value is 0."""
    told = set()
    for s, found in enumerate(explored(explorer())):
        title = plain(found["finding"])
        assert title.startswith(finding(TASK.actions.labels, Q, explorer(s).numbers))
        change = softmax(Q[s] + axis_means(Q, s).mean(axis=0)) - softmax(Q[s])
        a = int(np.abs(change).argmax())
        without = Q.copy()
        without[s] = 0
        theirs = axis_means(without, s).mean(axis=0)[a]
        own = axis_means(Q, s).mean(axis=0)[a] - theirs
        cause = "With its bias, the chance of"
        if abs(theirs) >= abs(own) and theirs * change[a] > 0:
            cause = f"Similar states speak {'for' if theirs > 0 else 'against'}"
        assert title.startswith(f"{cause} “{TASK.actions.label(a)}”")
        told.add(cause)
    assert len(told) == 3


def test_the_sums_are_those_of_the_papers_example():
    q = (
        np.arange(72.0).reshape(24, 3) - 40
    )  # of an action, the value of a state tells which state it is
    said = explored(BiasExplorer(TASK, {"q": q}))[PAPER_STATE]["said"][1]
    sets, sums = plain(said[1]), plain(said[2])
    for name, members in (
        ("X", {9: "(0,1,90,1)", 21: "(1,1,90,1)"}), ("Y", {15: "(1,0,90,1)", 21: "(1,1,90,1)"}),
        ("θ", {19: "(1,1,0,1)", 21: "(1,1,90,1)", 23: "(1,1,−90,1)"}), ("d", {20: "(1,1,90,0)", 21: "(1,1,90,1)"}),
    ):  # fmt: skip
        assert (
            f"{name}: {', '.join(f'{k} {text}' for k, text in members.items())}" in sets
        )
        terms = [amount(q[k, 1]) for k in members]
        brackets = [
            terms[0],
            *(f"({term})" if term.startswith("−") else term for term in terms[1:]),
        ]
        assert f"{name}: ({' + '.join(brackets)}) / {len(members)} = " in sums


def edited(shown: BiasExplorer, s: int, a: int, value: float) -> None:
    """What a reader's edit sends to the kernel."""
    q = shown.q
    q[s, a] = value
    at = shown.widget.table
    shown.widget.tables = [
        q.tolist() if i == at else table for i, table in enumerate(shown.widget.tables)
    ]


def test_an_edit_changes_the_bias_of_its_table_alone_and_not_the_readers_array():
    shown, kept = explorer(), Q.copy()
    before = shown.numbers.bias
    edited(shown, 9, 2, Q[9, 2] + 8)  # state 9 differs in X: half of one mean of four
    assert np.allclose(shown.numbers.bias - before, [0, 0, 1])
    assert np.allclose(explored(shown)[PAPER_STATE]["bias"], shown.numbers.bias)
    shown.widget.table = 1
    assert shown.table == "zeros" and not shown.numbers.bias.any()
    shown.widget.table = 0
    assert np.allclose(
        shown.numbers.bias - before, [0, 0, 1]
    )  # edits wait for the reader's return
    assert np.array_equal(Q, kept) and np.array_equal(
        shown.widget.about["originals"][0]["q"], Q
    )


def test_the_state_itself_counts_in_each_of_its_sets():
    shown = BiasExplorer(TASK, {"zeros": np.zeros((24, 3))}, state=PAPER_STATE)
    shown.widget.tables = [
        [[12 * (s == PAPER_STATE), 0, 0] for s in range(24)]
    ]  # whole numbers, as a browser has them
    assert np.allclose(shown.numbers.means[:, 0], [6, 6, 4, 6]) and np.isclose(
        shown.numbers.bias[0], 5.5
    )
    assert shown.q.dtype == float


def test_an_agent_is_shown_as_it_would_choose():
    agent = rl.Agent(TASK, gamma=0.5, loop_evasion=False, seed=0)
    rl.learn(agent, rl.make_env(TASK, seed=0), 200, progress=False)
    agent.begin_episode(PAPER_STATE)
    numbers = BiasExplorer(TASK, {"mine": agent}, state=PAPER_STATE).numbers
    assert np.allclose(numbers.qbiassr, agent.probabilities) and np.allclose(
        numbers.bias, agent.bias
    )


def test_numbers_of_numpys_are_taken_and_the_page_can_be_saved(tmp_path):
    shown = explorer(np.int64(21))
    shown.save(tmp_path / "bias.html")
    assert shown.state == 21 and np.allclose(shown.numbers.sr, softmax(Q[21]))
    assert np.allclose(explored(shown)[21]["sr"], shown.numbers.sr)


def test_any_small_task_can_be_shown():
    shown = BiasExplorer("wander_simple", {"zeros": np.zeros((4, 4))})
    assert (
        explored(shown)[3]["html"].count("<button value") == 4 and shown.picture().png()
    )


def test_a_task_of_one_input_can_be_shown():
    task = replace(TASK, inputs=TASK.inputs[2:3], goal=None)
    shown = BiasExplorer(task, {"q": Q[:3]}, state=1)
    found = explored(shown)
    assert found[1]["members"] == [[1, None], [0, 0], [2, 0]] and np.allclose(
        found[1]["bias"], Q[:3].mean(axis=0)
    )
    assert found[1]["html"].count("<button value") == 3 and shown.picture().png()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"task": "wander_1k"}, "wander_1k has 1024 states .* at most 64"),
        ({"tables": {}}, "at least one Q-table"),
        (
            {"tables": {"short": np.zeros((4, 3))}},
            "'short' must hold .* 24 states .* shape .4, 3.",
        ),
        (
            {"tables": {"bad": np.full((24, 3), np.nan)}},
            "'bad' must hold finite numbers",
        ),
        ({"state": 24}, "there is no state 24"),
    ],
)
def test_what_does_not_fit_is_refused_in_words(arguments, message):
    with pytest.raises(ValueError, match=message):
        BiasExplorer(
            **{"task": TASK, "tables": {"zeros": np.zeros((24, 3))}, **arguments}
        )


def test_the_saved_output_is_a_picture_with_a_description_and_a_text_that_stays():
    data = explorer()._repr_mimebundle_()
    assert (
        "data:image/png;base64," in data["text/html"]
        and "application/vnd.jupyter.widget-view+json" in data
    )
    assert data["text/plain"] == repr(explorer()) and "0x" not in data["text/plain"]
    assert "state 21 (X 1, Y 1, θ 90°, d 1)" in data["text/plain"]
    alt = data["text/html"]
    assert (
        "X: 9, 21; Y: 15, 21; θ: 19, 21, 23; d: 20, 21" in alt
        and vector(explorer().numbers.bias) in alt
    )


def drawn(figure) -> list[str]:
    return [text.get_text().strip() for text in figure.axes[0].texts]


def test_the_picture_is_built_up_column_by_column_and_at_last_for_all_actions():
    shown = explorer()
    numbers, best = shown.numbers, shown.numbers.most_changed
    means, bias = (
        [amount(mean) for mean in numbers.means[:, best]],
        amount(numbers.bias[best]),
    )
    for stage in (1, 2, 3):
        texts = drawn(shown.picture(stage))
        assert [name for name in texts if name in TASK.actions.outputs[0].words] == [
            TASK.actions.label(best)
        ]
        own = [text for text in texts if text.startswith(f"{PAPER_STATE} ")]
        assert own == [f"{PAPER_STATE} {amount(Q[PAPER_STATE, best]):>15}"], (
            "a row of its own, once"
        )
        assert [text for text in texts if text in "●▲■◆"] == list("●▲■◆"), (
            "the state itself has the mark of each set"
        )
        boxes = [
            text[1:].strip() for text in texts if re.fullmatch(r"[●▲■◆] +\S+", text)
        ]
        assert boxes == (means if stage > 1 else [])
        assert (bias in texts) == (stage == 3)
        assert (vector(numbers.bias) in shown.picture(stage).alt) == (stage == 3)
        assert not any(text.endswith("%") for text in texts)
    picture = shown.picture()
    texts = drawn(picture)
    assert picture.finding == finding(TASK.actions.labels, Q, numbers)
    order = [best, *(a for a in range(3) if a != best)]  # the others, a row each
    assert [text for text in texts if re.fullmatch(r"[\d.]+ %", text)] == [
        text for a in order for text in percents(numbers.sr[a], numbers.qbiassr[a], 0)
    ]
    assert all(amount(x) in texts for x in numbers.bias)
    rows = [text for text in texts if re.match(rf"{PAPER_STATE} ", text)]
    assert len(rows) == 1, "one action is opened"


def test_in_the_picture_a_line_leads_from_each_state_to_each_of_its_sets_and_from_these_to_the_bias():
    ax = explorer().picture(3).axes[0]
    starts = [line.get_ydata()[0] for line in ax.lines if line.get_xdata()[0] < 20]
    heights = sorted(set(starts))
    assert len(heights) == 6 and [starts.count(y) for y in heights] == [
        4,
        1,
        1,
        1,
        1,
        1,
    ]
    to_bias = [line for line in ax.lines if line.get_xdata()[0] > 20]
    assert len(to_bias) == 4 and len({line.get_ydata()[1] for line in to_bias}) == 1


@pytest.mark.parametrize("stage", [0, 5, "2"])
def test_a_stage_that_does_not_exist_is_refused(stage):
    with pytest.raises(ValueError, match="stage must be 1, 2, 3 or 4"):
        explorer().picture(stage)


def test_a_number_shows_its_sign_and_what_differs_from_0_never_reads_0():
    written = {-1.5: "−1.50", 0.125001: "0.13", -0.0075: "−0.0075", 4e-5: "4e−5"}
    written |= {-0.0: "0.00", 5e-18: "0.00", 476.97: "477.0"}
    written |= {12345.6: "1.2e4", -0.01: "−0.01", 0.03149: "0.031"}
    assert [amount(x) for x in written] == list(written.values())
    told = run(f"{script()}\nconsole.log(JSON.stringify({list(written)}.map(amount)))")
    assert told == list(written.values())


def test_two_probabilities_have_the_decimals_that_tell_them_apart():
    pairs = [(1 / 3, 0.6142), (0.333, 0.3321), (0.99999, 1.0), (1.0, 1.0)]
    said = [percents(p, other, 0) for p, other in pairs]
    assert said == [
        ("33 %", "61 %"),
        ("33.3 %", "33.2 %"),
        ("99.999 %", "100.000 %"),
        ("100 %", "100 %"),
    ]
    told = run(
        f"{script()}\nconsole.log(JSON.stringify({[list(pair) for pair in pairs]}"
        ".map(([p, other]) => percents(p, other, 0))))"
    )
    assert told == [list(texts) for texts in said]


def test_where_the_bias_changes_nothing_the_title_says_so():
    shown = BiasExplorer(TASK, {"zeros": np.zeros((24, 3))})
    title = "Similar states change nothing here: “advance” keeps 33 %"
    assert shown.picture().finding == title
    assert plain(explored(shown)[PAPER_STATE]["finding"]).startswith(title)
