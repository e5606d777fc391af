"""Verdicts of the reproduction, and the causes it names: said only where the outcomes say so."""

import dataclasses

import gymnasium
import numpy as np
import pytest
from paper import causes, causes_in_models, paper, report, verdicts
from paper.cause import DECIDES, NO_MATTER, NOT_RUN, NOT_SHOWN, NOTHING, PARTLY, SHOWN, cured
from paper.experiments import ARMS, CUT, EVADED, FAULTY, Length, by_key
from paper.outcome import Outcome, half_width, interval, shuttles, significant_with
from paper.worlds import PreviousAction, lucky_pairs, without_lucky_loops
from worlds import recording_of

import rlrobot_edu as rl
from rlrobot_course.lesson_13.contact import contact_alone
from rlrobot_edu.experiments.statistics import Anova, Interval, Pair, Tukey, exact

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
        (-1.0, 0.001, 0.2, "significantly the opposite (the paper's is not significant)"),
        (1.0, 0.001, None, "agrees (the paper gives no test)"),
        (1.0, 0.2, None, "agrees in direction (ours is not significant; the paper gives no test)"),
        (-1.0, 0.2, None, "opposite, not significant (the paper gives no test)"),
        (-1.0, 0.001, None, "significantly the opposite (the paper gives no test)"),
        (1.0, 0.05, 0.05, "undecided"),
        (0.0, float("nan"), 0.002, "opposite, not significant"),
    ],
)
def test_a_verdict_says_what_agrees_with_the_paper(gain, p, paper_p, said):
    verdict = verdicts.verdict(gain, p, paper_p)
    assert str(verdict) == said and verdict.name in verdicts.CLASSES


def test_a_verdict_is_the_same_whichever_method_is_named_first():
    nothing = Interval(0.0, 0.0, 0.0)
    its = paper.PaperPair("a", "b", 1.0, 0.001)
    for pair in (Pair("a", "b", -2.0, 5.0, 0.001, nothing), Pair("b", "a", 2.0, 5.0, 0.001, nothing)):
        assert verdicts.gain(pair, its) == -2 and verdicts.of_pair(pair, its).name == verdicts.REVERSED
        assert verdicts.papers(pair, (its,)) is its


@pytest.mark.parametrize("chosen, said", [("c", verdicts.BEST), ("b", verdicts.AS_GOOD), ("a", verdicts.BEATEN)])
def test_a_chosen_value_is_only_asked_whether_it_is_the_best(chosen, said):
    noise = np.random.default_rng(0).normal(size=20)
    final = {"a": noise - 9, "b": noise, "c": noise + 0.1}
    verdict = verdicts.of_value(final, Tukey.of(final).pairs, chosen)
    assert verdict.name == said and verdict.best == "c"


def test_a_tiny_p_value_is_never_printed_as_zero():
    groups = {"a": np.arange(9.0), "b": np.arange(9.0) + 1e9, "c": np.arange(9.0) + 2e9}
    for table in (Tukey.of(groups).table(), Anova.of(list(groups.values())).table()):
        for text in (str(table), table.markdown, table._repr_html_()):
            assert "1e-15" in text and " 0.0000" not in text
    assert exact(0.0) == exact(9e-16) == "p < 1e-15" and exact(1e-15) == 1e-15 and np.isnan(exact(float("nan")))


def test_half_the_width_of_an_interval_is_the_difference_that_is_just_significant():
    groups = {name: np.random.default_rng(i).normal(size=12) for i, name in enumerate("abc")}
    middle = {name: x - x.mean() for name, x in groups.items()}  # the variance stays, the means are alike
    just = interval(groups)
    assert just == half_width(Anova.of(list(groups.values())), 12)
    for shift, significant in ((0.999 * just, False), (1.001 * just, True)):
        pair = Tukey.of({**middle, "a": middle["a"] + shift}).pairs[0]
        assert (pair.p < 0.05) == significant


def test_few_repetitions_find_less_and_all_of_them_find_what_the_test_finds():
    rng = np.random.default_rng(1)
    groups = {"a": rng.normal(0, 1, 30), "b": rng.normal(1, 1, 30), "c": rng.normal(9, 1, 30)}
    all_of_them, few = significant_with(groups, 30, draws=20), significant_with(groups, 6)
    for pair in Tukey.of(groups).pairs:
        assert all_of_them[frozenset(pair[:2])] == (pair.p < 0.05)
    assert few[frozenset("ab")] < 0.8 and few[frozenset("ac")] == 1


CHAIN = [(0, 0, -1.0, 1, 0), (1, 0, -1.0, 0, 0), (0, 1, 5.0, 0, 0), (0, 0, -1.0, 1, 0), (1, 1, 0.0, 1, 0)]


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
        assert r == paid[state, action, there] if (state, action, there) in paid else r in (-1.0, 0.0, 5.0)
        state, last = there, action
    env.reset()
    assert env.step(1)[1] == paid[env.unwrapped.state, 1, env.unwrapped.state]  # nothing is left of the episode before


def test_lucky_loops_are_taken_out_of_a_model_and_nothing_else():
    model = rl.SampleModel.from_recording(rl.read_recording("wander_1k"))
    lucky, less = lucky_pairs(model), without_lucky_loops(model)
    assert len(lucky) and not less.pair_count.ravel()[lucky].any()
    for pair in range(0, 9216, 7):
        if pair not in lucky:
            assert less.outcomes(*divmod(pair, 9)) == model.outcomes(*divmod(pair, 9))
    assert not less.diagnose().loops


def test_the_first_lines_count_every_pair_of_the_paper_once():
    always, some = [verdicts.AGREES] * 2, [verdicts.AGREES, verdicts.REVERSED]
    only, opposite = [verdicts.DIRECTION] * 2, [verdicts.DIRECTION, verdicts.OPPOSITE]
    said = {
        ("room", "a over b"): always,
        ("room", "a over c"): some,
        ("arm", "a over b"): only,
        ("arm", "b over c"): opposite,
    }
    first, second, third = report._reproduced(said)
    assert "in every set-up in 1 (room: a over b), and in some set-ups in 1 (room: a over c)" in first
    assert "1 (arm: a over b)" in second
    assert "at least one set-up: 1 (arm: b over c)" in third and "opposite in at least one set-up: 1 (room: a" in third


def test_the_reward_for_contact_alone_pays_nothing_for_the_way():
    task = contact_alone(rl.load_task("arm_1k"))
    thing = {"object_x": 0.0, "object_y": 0.0, "object_z": 0.0, "gripper_y": 0.0, "gripper_z": 0.0}
    far, near, touching = ({**thing, "gripper_x": x} for x in (0.2, 0.1, 0.04))
    assert task.reward_for(far, near) == task.reward_for(near, far) == task.reward_for(touching, far) == -0.02
    assert task.reward_for(near, touching) == task.reward_for(touching, touching) == 10


def outcome(key, means_by_length, n=30, spread=0.1, labels=paper.THREE):
    """An outcome with these means, by length, around which the repetitions lie regularly."""
    experiment = by_key(key)
    noise = spread * np.linspace(-1, 1, n)
    final = {length: {label: mean + noise for label, mean in zip(labels, means, strict=True)}
             for length, means in means_by_length.items()}  # fmt: skip
    pairs = {length: Tukey.of(groups).pairs for length, groups in final.items()}
    return Outcome(experiment._replace(lengths=tuple(final)), final, pairs, seconds=1.0)


SHORT, LONG = by_key("robot_wander_simple").lengths


@pytest.mark.parametrize(
    "short, long, status",
    [
        ((0, 1, 2), (2, 2.01, 0), SHOWN),  # Q+SR ahead, and then last as in the paper
        ((0, 1, 2), (0, 1, 2), NOT_SHOWN),
        ((2, 2.01, 0), (0, 1, 2), NOTHING),
    ],
)
def test_the_length_is_the_cause_only_where_the_longer_process_agrees(short, long, status):
    one = outcome("robot_wander_simple", {SHORT: short, LONG: long})
    said = {cause.title: cause for cause in causes.causes({"robot_wander_simple": one}, {})}
    cause = said["Wander-simple: the length"]
    assert cause.status == status and (SHORT in {length for _, length, _ in cause.explains}) == (status == SHOWN)
    assert all(cause.status == NOT_RUN for title, cause in said.items() if title != "Wander-simple: the length")


@pytest.mark.parametrize(
    "one, five, status",
    [((1, 2, 3), (3, 2, 1), SHOWN), ((1, 2, 3), (3, 1, 2), NOT_SHOWN), ((3, 2, 1), (3, 2, 1), NOTHING)],
)
def test_the_number_of_episodes_is_the_cause_only_where_more_of_them_bring_the_papers_order(one, five, status):
    first, three, scored, ten = by_key("robot_navigation_1k").lengths
    found = outcome("robot_navigation_1k", {first: one, three: one, scored: five, ten: five})
    made = causes._navigation({"robot_navigation_1k": found}, {}, "robot_navigation_1k")
    assert made[0] == status and "+1.08" in made[1]  # the paper's: 1.95·√(0.918 / 3)


@pytest.mark.parametrize(
    "means, status",
    [((3, 5, 1), SHOWN), ((3, 5, 4), NOT_SHOWN), ((3, 5, 2.99), NOT_SHOWN), ((5, 3, 1), NOTHING)],
)
def test_the_fault_is_the_cause_only_where_it_brings_the_papers_order_back(means, status):
    one = outcome("cause_fault", {Length(3600): means}, labels=(SR, Q, FAULTY))
    found = causes_in_models.fault({"cause_fault": one}, {}, "cause_fault")
    assert found[0] == status


@pytest.mark.parametrize(
    "on_robot, spread, status",
    [((1, 1, 1, 1), 0.1, SHOWN), ((1, 1, 1, 1), 20, NOT_SHOWN), ((1, 1, 1, 3), 0.1, NOT_SHOWN)],
)
def test_a_model_alone_is_to_blame_only_where_the_robot_is_known_to_lose_less(on_robot, spread, status):
    labels = tuple(by_key("preliminary_alpha").methods)
    outcomes = {
        "preliminary_alpha": outcome("preliminary_alpha", {Length(3600): (0, 1, 2, 3)}, labels=labels),
        "preliminary_alpha_robot": outcome(
            "preliminary_alpha_robot", {Length(3600): on_robot}, spread=spread, labels=labels
        ),
    }
    assert causes_in_models.model_only(outcomes, {}, *outcomes)[0] == status


def test_few_repetitions_are_the_cause_only_where_as_few_of_ours_would_miss_it():
    for difference, status in ((0.08, SHOWN), (5, NOT_SHOWN)):  # in the paper, TOSL+SR less Q+SR is not significant
        one = outcome("robot_wander_4k", {Length(3600): (9, difference, 0)})
        found = causes._few({"robot_wander_4k": one}, {})
        assert found[0] == status


@pytest.mark.parametrize(("means", "status"), [((8, 7.9, 4), SHOWN), ((8, 3, 4), PARTLY), ((2, 3, 4), NOT_SHOWN)])
@pytest.mark.parametrize(("kind", "cause"), [("contact", causes._to_and_fro), ("traces", causes._long_traces)])
def test_what_is_changed_about_the_arm_is_the_cause_of_the_pairs_that_it_turns_round(kind, cause, means, status):
    needs = causes._by_kind(ARMS, "robot", f"cause_{kind}")
    lengths = by_key(needs[0]).lengths[-2:]
    agrees, opposite = (9, 5, 2), (2, 2, 9)
    found = {key: outcome(key, dict.fromkeys(lengths, agrees)) for key in needs}
    assert cause(found, {}, *needs)[0] == NOTHING
    found[needs[0]] = outcome(needs[0], dict(zip(lengths, (agrees, opposite), strict=True)))
    found[needs[1]] = outcome(needs[1], dict(zip(lengths, (agrees, means), strict=True)))
    made = cause(found, {}, *needs)
    assert made[0] == status and len(made[3]) == {SHOWN: 2, PARTLY: 1, NOT_SHOWN: 0}[status]
    assert str(lengths[1]) in made[1] and str(lengths[0]) not in made[1]


def test_a_pair_that_changes_its_sign_by_chance_is_not_explained():
    (length,) = by_key("robot_wander_1k").lengths
    before = outcome("robot_wander_1k", {length: (5, 3, 4)})
    by_chance, surely = (outcome("cause_walls_wander_1k", {length: (5, 4.01, 4)}, spread=x) for x in (1, 0.01))
    assert cured(("it", before, by_chance)) == (NOT_SHOWN, frozenset())
    assert cured(("it", before, surely)) == (SHOWN, frozenset([("it", length, "TOSL+SR over Q+SR")]))


@pytest.mark.parametrize(
    ("left", "status"),
    [((0, 0, 0), SHOWN), ((0, -0.5, -1), NOT_SHOWN), ((0, 0, -1), NOT_SHOWN), ((1, 0.5, 0), SHOWN)],
)
def test_lucky_rows_decide_the_order_only_where_it_goes_with_them_whatever_unknown_pairs_do(left, status):
    model = rl.SampleModel.from_recording(rl.read_recording("wander_1k"))
    full = outcome("preliminary_algorithms", {Length(3600): (5, 6)}, labels=(SR, Q))
    shares = {label: np.array([0.2, 0.1]) for label in (SR, Q)}
    found = {"full": dataclasses.replace(full, diagnosis=model.diagnose(), lucky=shares)}
    for unseen, difference in zip(CUT, left, strict=True):
        found[unseen] = outcome(f"cause_loops_{unseen}", {Length(3600): (0.4 + difference, 0.4)}, labels=(SR, Q))
    assert causes_in_models.lucky_rows(found, {}, *found)[0] == status


@pytest.mark.parametrize(("means", "status"), [((5, 3, 4), NO_MATTER), ((5, 6, 4), DECIDES)])
def test_a_verdict_that_hangs_on_loop_evasion_is_named(means, status):
    needs = causes._by_kind(EVADED[-1:], "robot", "cause_evasion")
    (length,) = by_key(needs[0]).lengths
    found = dict(
        zip(needs, (outcome(key, {length: x}) for key, x in zip(needs, ((5, 3, 4), means), strict=True)), strict=True)
    )
    said = causes._evasion(found, {}, *needs)
    assert said[0] == status


def test_a_difference_that_may_be_none_is_not_called_opposite():
    (length,) = by_key("robot_wander_1k").lengths
    for spread, place in ((0.01, 0), (9, 1)):
        one = outcome("robot_wander_1k", {length: (5, 3.9, 4)}, spread=spread)
        said = report._unexplained({"robot_wander_1k": one}, [])
        assert "TOSL+SR" in said[place] and said[1 - place] == "none"


def test_a_final_average_is_of_a_shuttle_when_it_is_near_what_one_pays():
    assert shuttles(np.array([2.2, 4.3, 9.0, 3.0])) == 0.5
