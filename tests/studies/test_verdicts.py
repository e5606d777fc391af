"""Verdicts of the reproduction, what they rest on, and the worlds that show a cause."""

import gymnasium
import numpy as np
import pytest
from holm import holm_corrected
from in_markdown import in_markdown
from paper import paper, tables, tally, verdicts
from paper.experiments import by_key
from paper.outcome import (
    Outcome,
    detectable,
    half_width,
    interval,
    shuttles,
    significant_with,
)
from paper.worlds import PreviousAction, lucky_pairs, without_lucky_loops
from scipy import stats
from worlds import recording_of

import rlrobot_edu as rl
from rlrobot_course.lesson_13.contact import contact_alone
from rlrobot_edu.experiments.statistics import Anova, Tukey, shown_p

QBIASSR, SR, Q = paper.THREE


@pytest.mark.parametrize(
    "gain, p, paper_p, said",
    [
        (1.0, 0.001, 0.002, "agrees"),
        (1.0, 0.03, 0.002, "agrees"),
        (1.0, 0.2, 0.002, "agrees in direction (only the paper's is significant)"),
        (1.0, 0.001, 0.2, "agrees in direction (only ours is significant)"),
        (1.0, 0.2, 0.7, "undecided"),
        (-1.0, 0.2, 0.7, "undecided"),
        (-1.0, 0.2, 0.002, "opposite, not significant"),
        (-1.0, 0.001, 0.002, "significantly the opposite"),
        (
            -1.0,
            0.001,
            0.2,
            "significantly the opposite (the paper's is not significant)",
        ),
        (1.0, 0.001, None, "agrees (the paper gives no test)"),
        (
            1.0,
            0.2,
            None,
            "agrees in direction (ours is not significant; the paper gives no test)",
        ),
        (-1.0, 0.2, None, "opposite, not significant (the paper gives no test)"),
        (-1.0, 0.001, None, "significantly the opposite (the paper gives no test)"),
        (1.0, 0.05, 0.05, "undecided"),
        (0.0, float("nan"), 0.002, "opposite, not significant"),
    ],
)
def test_a_verdict_says_what_agrees_with_the_paper(gain, p, paper_p, said):
    verdict = verdicts.verdict(gain, p, paper_p)
    assert str(verdict) == said


def test_a_verdict_is_the_same_whichever_method_is_named_first():
    for labels in (paper.THREE, paper.THREE[::-1]):
        groups = {label: np.linspace(-1, 1, 9) + 9 * (label == Q) for label in labels}
        (length,) = by_key("robot_wander_1k").lengths
        both, bias, traces = Outcome(
            by_key("robot_wander_1k"), {length: groups}
        ).judged()
        assert (
            bias.gain == traces.gain == -9
            and bias.verdict.name == traces.verdict.name == verdicts.REVERSED
        )
        assert both.gain == 0 and both.pair.name == f"{QBIASSR} over {SR}"


@pytest.mark.parametrize("names, mark", [
    ([verdicts.AGREES] * 2, verdicts.EVERYWHERE), ([verdicts.AGREES, verdicts.REVERSED], verdicts.SOMEWHERE),
    ([verdicts.DIRECTION] * 2, verdicts.TENDENCY), ([verdicts.DIRECTION, verdicts.OPPOSITE], verdicts.NOT),
])  # fmt: skip
def test_a_mark_says_what_all_set_ups_of_a_pair_show(names, mark):
    assert verdicts.mark(map(verdicts.Verdict, names)) == mark


@pytest.mark.parametrize(
    "chosen, said",
    [("c", verdicts.BEST), ("b", verdicts.AS_GOOD), ("a", verdicts.BEATEN)],
)
def test_a_chosen_value_is_only_asked_whether_it_is_the_best(chosen, said):
    noise = np.random.default_rng(0).normal(size=20)
    final = {"a": noise - 9, "b": noise, "c": noise + 0.1}
    verdict = verdicts.of_value(final, Tukey.of(final).pairs, chosen)
    assert verdict.name == said and verdict.best == "c"


def test_a_tiny_p_value_is_never_printed_as_zero():
    groups = {"a": np.arange(9.0), "b": np.arange(9.0) + 1e9, "c": np.arange(9.0) + 2e9}
    for table in (Tukey.of(groups).table(), Anova.of(list(groups.values())).table()):
        for text in (str(table), in_markdown(table), table._repr_html_()):
            assert "1e-15" in text and " 0.0000" not in text
    assert (
        shown_p(0.0) == shown_p(9e-16) == "p < 1e-15"
        and shown_p(1e-15) == 1e-15
        and np.isnan(shown_p(float("nan")))
    )


def test_half_the_width_of_an_interval_is_the_difference_that_is_just_significant():
    groups = {
        name: np.random.default_rng(i).normal(size=12) for i, name in enumerate("abc")
    }
    middle = {
        name: x - x.mean() for name, x in groups.items()
    }  # the variance stays, the means are alike
    just = interval(groups)
    assert just == half_width(Anova.of(list(groups.values())), 12)
    for shift, significant in ((0.999 * just, False), (1.001 * just, True)):
        pair = Tukey.of({**middle, "a": middle["a"] + shift}).pairs[0]
        assert (pair.p < 0.05) == significant


def test_a_detectable_difference_is_found_in_four_of_five_experiments():
    rng = np.random.default_rng(3)
    n, times = 12, 4000
    groups = {name: rng.normal(size=n) for name in "abc"}
    sd = Anova.of(list(groups.values())).ms_within ** 0.5
    shift = detectable(groups) / sd
    a, b, c = rng.normal(size=(3, times, n))
    variances = [x.var(axis=1, ddof=1) for x in (a, b, c)]
    within = np.mean(variances, axis=0)
    critical = stats.studentized_range.ppf(0.95, 3, 3 * n - 3)
    difference = np.abs(a.mean(axis=1) + shift - b.mean(axis=1))
    found = np.sum(difference > critical * np.sqrt(within / n))
    assert found / times == pytest.approx(0.8, abs=0.02)


def test_holm_rejects_what_the_textbooks_steps_do():
    """Oracle: the step-down procedure: the i-th smallest of m against 0.05 / (m - i), until one is not below."""
    rng = np.random.default_rng(4)
    for _ in range(50):
        p = rng.uniform(0, 0.03, size=9) * rng.choice([0.1, 1, 9], size=9)
        rejected = set()
        for i, one in enumerate(np.argsort(p)):
            if p[one] >= 0.05 / (9 - i):
                break
            rejected.add(int(one))
        assert {i for i, q in enumerate(holm_corrected(p)) if q < 0.05} == rejected
    assert holm_corrected([0.01, 0.04, 0.03]) == pytest.approx([0.03, 0.06, 0.06])


def test_a_look_is_marked_as_lost_only_when_many_others_are_taken():
    (length,) = by_key("robot_wander_1k").lengths
    noise = np.linspace(-1, 1, 30)
    groups = {
        label: noise + shift
        for label, shift in zip(paper.THREE, (0.42, 0, -3), strict=True)
    }
    outcome = Outcome(by_key("robot_wander_1k"), {length: groups})
    alone = {"robot_wander_1k": outcome}
    assert outcome.judged()[0].p < 0.05 and not tally.lost_by_holm(alone)
    dull = {label: noise for label in paper.THREE}
    others = {}
    for task in ("wander_4k", "arm_1k", "arm_4k", "navigation_1k"):
        experiment = by_key(f"robot_{task}")
        finals = {length: dull for length in experiment.lengths}
        others[f"robot_{task}"] = Outcome(experiment, finals)
    lost = tally.lost_by_holm({**alone, **others})
    assert lost == {("wander_1k", "3600 steps", f"{QBIASSR} over {SR}")}
    row = tables.pairs_table({**alone, **others}, "wander_1k").rows[0]
    assert row[-1] == "agrees †"


def test_few_repetitions_find_less_and_all_of_them_find_what_the_test_finds():
    rng = np.random.default_rng(1)
    groups = {
        "a": rng.normal(0, 1, 30),
        "b": rng.normal(1, 1, 30),
        "c": rng.normal(9, 1, 30),
    }
    all_of_them, few = (
        significant_with(groups, 30, draws=20),
        significant_with(groups, 6),
    )
    for pair in Tukey.of(groups).pairs:
        assert all_of_them[frozenset(pair[:2])] == (pair.p < 0.05)
    assert few[frozenset("ab")] < 0.8 and few[frozenset("ac")] == 1


CHAIN = [
    (0, 0, -1.0, 1, 0),
    (1, 0, -1.0, 0, 0),
    (0, 1, 5.0, 0, 0),
    (0, 0, -1.0, 1, 0),
    (1, 1, 0.0, 1, 0),
]


def test_with_the_papers_fault_the_action_before_moves_and_the_present_one_is_paid():
    # two states; action 0 changes the state (-1), action 1 stays: in state 0 for 5, in state 1 for nothing
    model = rl.SampleModel.from_recording(recording_of(CHAIN, shape=(2,), n_actions=2))
    env = PreviousAction(rl.make_env(model, seed=0))
    assert isinstance(env, gymnasium.Wrapper)
    state, last, moves = int(env.reset()[0][0]), None, {0: (1, 0), 1: (0, 1)}
    paid = {(0, 0, 1): -1.0, (1, 0, 0): -1.0, (0, 1, 0): 5.0, (1, 1, 1): 0.0}
    for action in (1, 1, 0, 0, 1, 0, 1, 1, 0):
        observation, r, *_ = env.step(action)
        there = moves[action if last is None else last][state]
        assert observation[0] == there
        assert (
            r == paid[state, action, there]
            if (state, action, there) in paid
            else r in (-1.0, 0.0, 5.0)
        )
        state, last = there, action
    env.reset()
    assert (
        env.step(1)[1] == paid[env.unwrapped.state, 1, env.unwrapped.state]
    )  # nothing is left of the episode before


def test_lucky_loops_are_taken_out_of_a_model_and_nothing_else():
    model = rl.SampleModel.from_recording(rl.read_recording("wander_1k"))
    lucky, less = lucky_pairs(model), without_lucky_loops(model)
    assert len(lucky) and not less.pair_count.ravel()[lucky].any()
    for pair in range(0, 9216, 7):
        if pair not in lucky:
            assert less.outcomes(*divmod(pair, 9)) == model.outcomes(*divmod(pair, 9))
    assert not less.diagnose().loops


def test_the_reward_for_contact_alone_pays_nothing_for_the_way():
    task = contact_alone(rl.load_task("arm_1k"))
    thing = {
        "object_x": 0.0,
        "object_y": 0.0,
        "object_z": 0.0,
        "gripper_y": 0.0,
        "gripper_z": 0.0,
    }
    far, near, touching = ({**thing, "gripper_x": x} for x in (0.2, 0.1, 0.04))
    assert (
        task.reward_for(far, near)
        == task.reward_for(near, far)
        == task.reward_for(touching, far)
        == -0.02
    )
    assert task.reward_for(near, touching) == task.reward_for(touching, touching) == 10


def test_a_table_of_changes_has_the_pairs_that_are_opposite_or_become_others():
    def outcome(key, *means):
        (length,), noise = by_key(key).lengths, 0.1 * np.linspace(-1, 1, 30)
        return Outcome(
            by_key(key),
            {
                length: {
                    x: mean + noise for x, mean in zip(paper.THREE, means, strict=True)
                }
            },
        )

    ideal, held = (
        outcome("robot_wander_1k", 5, 3, 4),
        outcome("cause_walls_wander_1k", 3, 4, 5),
    )
    assert tables.changes_table({"robot_wander_1k": ideal}, "wander_1k").rows == []
    rows = tables.changes_table(
        {"robot_wander_1k": ideal, "cause_walls_wander_1k": held}, "wander_1k"
    ).rows
    assert [(row[2], row[3], row[4], row[6:]) for row in rows] == [
        (
            f"{QBIASSR} less {SR}",
            pytest.approx(2),
            pytest.approx(-1),
            [verdicts.AGREES, verdicts.REVERSED],
        ),
        (
            f"{QBIASSR} less {Q}",
            pytest.approx(1),
            pytest.approx(-2),
            [verdicts.AGREES, verdicts.REVERSED],
        ),
        (
            f"{SR} less {Q}",
            pytest.approx(-1),
            pytest.approx(-1),
            [verdicts.REVERSED] * 2,
        ),
    ]


def test_a_final_average_is_of_a_shuttle_when_it_is_near_what_one_pays():
    assert shuttles(np.array([2.2, 4.3, 9.0, 3.0])) == 0.5
