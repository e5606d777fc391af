"""Planners against textbook loops and value iteration; what an agent keeps in mind; and that nothing else changes."""

import copy
import dataclasses
from collections import defaultdict

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from worlds import RandomWorld, recording_of

import rlrobot_edu as rl
from rlrobot_course.lesson_17.heap import pop, put
from rlrobot_course.lesson_17.sweeping import (
    SMALLEST,
    SWEEPING,
    expected_target,
    new_notes,
)
from rlrobot_edu.learning.planning import experience
from rlrobot_edu.widgets.driving.teaching import learn_from

PLANNERS = ("dyna", SWEEPING)


def is_sound(n):
    """Whether the heap is one, as far as sweeping relies on it."""
    size, pairs = int(n.waiting[0]), len(n.heap)
    if not (0 <= size <= pairs and np.isin(n.heap[:size], np.arange(pairs)).all()):
        return False
    place = np.full(pairs, -1)
    place[n.heap[:size]] = np.arange(size)
    is_heap = (
        n.priority[n.heap[:size]] <= n.priority[n.heap[np.arange(-1, size - 1) // 2]]
    )
    return bool(
        (place == n.place).all() and is_heap[1:].all() and (n.priority >= 0).all()
    )


MAZE = """\
.......#G
..#....#.
S.#....#.
..#......
.....#...
........."""  # of Sutton & Barto, figure 8.2


@pytest.fixture(scope="module")
def maze():
    """The maze as a model in which each pair was seen once: deterministic, 1 for the goal and 0 for all else."""
    rows, pairs = MAZE.splitlines(), []
    cells = {
        (y, x): mark
        for y, row in enumerate(rows)
        for x, mark in enumerate(row)
        if mark != "#"
    }
    for (y, x), mark in cells.items():
        for a, (down, right) in enumerate([(-1, 0), (0, 1), (1, 0), (0, -1)]):
            there = (y + down, x + right) if (y + down, x + right) in cells else (y, x)
            is_goal = cells[there] == "G"
            if mark != "G":
                pairs.append(
                    (y * 9 + x, a, float(is_goal), there[0] * 9 + there[1], is_goal)
                )
    recording = recording_of(pairs, shape=(6, 9), n_actions=4, rewards=(0.0, 1.0))
    model = rl.SampleModel.from_recording(recording, unseen="stay")
    return dataclasses.replace(model, starts=np.array([18]))


def is_solved(q, plan):
    """Whether every state's greedy action is one of the best, and every value right to 5 %."""
    chosen = plan.q[np.arange(len(q)), q.argmax(axis=1)]
    return np.allclose(chosen, plan.v, atol=1e-9) and np.allclose(
        q.max(axis=1), plan.v, rtol=0.05
    )


def steps_to_solve(model, plan, planner, seed):
    agent, env = (
        rl.Agent(model, "Q+RANDOM", alpha=0.5, planner=planner, seed=seed),
        rl.make_env(model, seed),
    )
    for steps in range(100, 100_000, 100):
        rl.learn(agent, env, 100, progress=False, resume=steps > 100)
        if is_solved(agent.q, plan):
            return steps
    return steps


@pytest.mark.long
@pytest.mark.parametrize("planner", PLANNERS)
def test_on_a_deterministic_grid_a_planner_reaches_the_values_of_value_iteration(
    maze, planner
):
    agent = rl.Agent(
        maze, "Q+RANDOM", alpha=0.5, planner=planner, planning_steps=30, seed=0
    )
    rl.learn(agent, rl.make_env(maze, 0), 9_000, progress=False)
    q_max = 1 / (1 - 0.9)
    # no pair's error is above the threshold once nothing is urgent: so far from the solution can values be at the most
    tolerance = SMALLEST * q_max / (1 - 0.9) if planner is SWEEPING else 1e-6
    assert planner == "dyna" or agent.experience.notes.waiting[0] == 0
    np.testing.assert_allclose(
        agent.q, rl.value_iteration(maze).q, rtol=0, atol=tolerance
    )


@pytest.mark.long
def test_sweeping_needs_at_most_a_fifth_of_the_real_steps_of_q_learning(maze):
    plan = rl.value_iteration(
        maze
    )  # both act at random, so for each seed they take the same steps until one is done
    without, with_it = (
        np.median([steps_to_solve(maze, plan, planner, seed) for seed in range(5)])
        for planner in (None, SWEEPING)
    )
    assert with_it <= without / 5


class Dyna:
    """Tabular Dyna-Q as the textbook has it, on dictionaries and a dense table."""

    def __init__(self, shape, alpha=0.1, gamma=0.9):
        self.q, self.alpha, self.gamma = np.zeros(shape), alpha, gamma
        self.met = defaultdict(
            dict
        )  # pair -> {outcome: how often}, both in the order in which they came

    def learn(self, s, a, r, s_next, terminated):
        target = r + (0.0 if terminated else self.gamma * self.q[s_next].max())
        self.q[s, a] += self.alpha * (target - self.q[s, a])

    def imagine(self, n, rng):
        for _ in range(n):
            (s, a), outcomes = list(self.met.items())[int(rng.random() * len(self.met))]
            latest_first = list(outcomes.items())[::-1]
            number = int(rng.random() * sum(outcomes.values()))
            k = int(
                np.searchsorted(
                    np.cumsum([times for _, times in latest_first]),
                    number,
                    side="right",
                )
            )
            self.learn(s, a, *latest_first[k][0])


@pytest.mark.parametrize("method", ["Q+SR", "Q+QBIASSR", "SARSA+EG"])
def test_dyna_is_the_textbooks_loop_step_by_step(method):
    world = RandomWorld(seed=3, p_end=0.05)
    agent, oracle = (
        rl.Agent(world, method, planner="dyna", planning_steps=4, seed=5),
        Dyna((12, 3)),
    )
    rng, begins = np.random.default_rng(5), True
    for step in rl.steps(agent, world, 300):
        for _ in range(2 if begins else 1):  # one number for each selection
            rng.random()
        if method.startswith("Q"):
            oracle.learn(*step[1:6])
        else:
            q_next = 0.0 if step.terminated else oracle.q[step.s_next, step.a_next]
            oracle.q[step.s, step.a] += 0.1 * (
                step.r + 0.9 * q_next - oracle.q[step.s, step.a]
            )
        outcomes, outcome = oracle.met[step.s, step.a], step[3:6]
        outcomes[outcome] = outcomes.get(outcome, 0) + 1
        oracle.imagine(4, rng)
        np.testing.assert_allclose(agent.q, oracle.q, rtol=0, atol=1e-12)
        begins = step.terminated
    assert agent.visits.sum() == 300 and agent.rng.random() == rng.random()


@pytest.mark.parametrize("planner", PLANNERS)
def test_what_q_learning_selects_knows_what_was_planned(planner):
    world = RandomWorld(seed=1)
    agent = rl.Agent(world, "Q+SR", temperature=20, planner=planner, seed=0)
    for step in rl.steps(agent, world, 50):
        x = (
            agent.q[step.s_next]
            * agent.parameters.q_scale
            / agent.memory.now.temperature
        )
        np.testing.assert_allclose(
            agent.probabilities, np.exp(x) / np.exp(x).sum(), rtol=1e-9
        )


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("steps", [0, 1, 5])
def test_priority_is_never_less_than_the_error_and_who_has_it_waits(seed, steps):
    world = RandomWorld(seed=seed, p_end=0.1)
    agent = rl.Agent(world, "Q+SR", planner=SWEEPING, planning_steps=steps, seed=seed)
    smallest = SMALLEST * 100 / agent.parameters.q_scale
    for _ in rl.steps(agent, world, 200):
        x, q = agent.experience, agent.q.ravel()
        for pair in x.tried[: x.now.pairs]:
            assert (
                abs(expected_target(agent.memory, x, pair) - q[pair])
                <= x.notes.priority[pair] + 1e-12
            )
        waiting = x.notes.heap[: x.notes.waiting[0]]
        assert set(np.flatnonzero(x.notes.priority > smallest)) <= set(
            waiting.tolist()
        ) and is_sound(x.notes)
        assert (np.flatnonzero(x.notes.place >= 0) == np.sort(waiting)).all()


def test_with_enough_steps_sweeping_solves_the_model_that_was_met():
    world = RandomWorld(seed=4, p_end=0.1)
    agent = rl.Agent(world, "Q+SR", planner=SWEEPING, planning_steps=2000, seed=1)
    rows = [step[1:6] for step in rl.steps(agent, world, 400)]
    recording = recording_of(
        rows, shape=world.shape, n_actions=3, rewards=sorted({row[2] for row in rows})
    )
    q, x = agent.q.copy(), agent.experience
    model = rl.SampleModel.from_recording(recording, unseen="stay")
    for _ in range(
        1000
    ):  # value iteration over what the recording counts; a pair never tried stays at 0
        v, times = q.max(axis=1), np.maximum(model.pair_count.ravel(), 1)
        q = (
            model.sum_by_pair(model.r + 0.9 * ~model.terminated * v[model.s_next])
            / times
        ).reshape(q.shape)
        if np.abs(q.max(axis=1) - v).max() < 1e-10:
            break
    assert x.notes.waiting[0] == 0
    np.testing.assert_allclose(agent.q, q, rtol=0, atol=SMALLEST * 10 / (1 - 0.9))


@settings(deadline=None, max_examples=60)
@given(
    st.lists(
        st.one_of(st.none(), st.tuples(st.integers(0, 11), st.floats(0, 9))),
        max_size=40,
    )
)
def test_the_heap_gives_the_pair_of_highest_priority_first(calls):
    n, waiting = new_notes(4, 3), {}
    for call in calls:
        if call is not None:
            pair, waiting[pair] = call[0], call[1]
            n.priority[pair] = call[1]
            put(n, pair)
        elif waiting:
            assert waiting.pop(int(first := pop(n))) == max(
                [n.priority[first], *waiting.values()]
            )
        assert is_sound(n) and sorted(n.heap[: n.waiting[0]].tolist()) == sorted(
            waiting
        )


@pytest.mark.parametrize("planner", PLANNERS)
def test_true_online_sarsa_sees_only_its_own_last_change(planner):
    world = RandomWorld(seed=2)
    agent = rl.Agent(
        world, "TOSL+SR", temperature=20, planner=planner, planning_steps=200, seed=3
    )
    rl.learn(agent, world, 100, progress=False)
    s, a = agent.pending
    twin = copy.deepcopy(agent)
    twin.change(planning_steps=0)
    for each in (agent, twin):
        each.update(s, a, 1.0, 5, 1, False)
    assert agent.q[5, 1] - agent.memory.now.q_old == pytest.approx(
        twin.q[5, 1] - twin.memory.now.q_old, abs=1e-12
    )
    assert agent.q[5, 1] != twin.q[5, 1] and np.array_equal(agent.e, twin.e)


@pytest.mark.long
@pytest.mark.parametrize("planner", PLANNERS)
@pytest.mark.parametrize("method", ["Q+QBIASSR", "SARSA+EGLE", "TOSL+SR"])
def test_to_imagine_nothing_is_to_have_no_planner(wander_model, method, planner):
    def learned(**planning):
        agent = rl.Agent(wander_model, method, seed=1, **planning)
        history = rl.learn(agent, rl.make_env(wander_model, 2), 400, progress=False)
        return (
            agent.q.tobytes(),
            agent.visits.tobytes(),
            history.rewards.tobytes(),
            agent.rng.random(),
        )

    assert (
        learned()
        == learned(planner=planner, planning_steps=0)
        != learned(planner=planner)
    )


@pytest.mark.parametrize("planner", PLANNERS)
def test_a_saved_planner_keeps_what_it_has_learned_and_observes_anew(
    wander_model, tmp_path, planner
):
    agent, env = (
        rl.Agent(wander_model, "Q+SR", planner=planner, seed=1),
        rl.make_env(wander_model, 2),
    )
    rl.learn(agent, env, 250, progress=False)
    agent.save(tmp_path / "agent.npz")
    loaded = rl.Agent.load(
        tmp_path / "agent.npz", agent.method if planner is SWEEPING else None
    )
    assert (
        np.array_equal(loaded.q, agent.q) and loaded.rng.random() == agent.rng.random()
    )
    assert loaded.method == agent.method and loaded.experience.now.outcomes == 0
    rl.learn(loaded, env, 50, progress=False)
    assert loaded.experience.tries.sum() == 50


def test_a_planner_that_has_observed_all_it_can_keep_is_told_so(
    wander_model, monkeypatch
):
    monkeypatch.setattr(experience, "MOST_OUTCOMES", 100)
    agent, env = (
        rl.Agent(wander_model, planner="dyna", seed=0),
        rl.make_env(wander_model, seed=0),
    )
    with pytest.raises(
        ValueError,
        match="a planner keeps at most 100 outcomes; plan in a smaller world",
    ):
        list(rl.steps(agent, env, 1000))
    assert len(agent.experience.pair) == 100


def test_an_agent_with_a_planner_of_ones_own_comes_back_when_that_planner_is_given(
    tmp_path,
):
    rl.Agent("wander_simple", "Q+SR", planner=SWEEPING).save(tmp_path / "agent.npz")
    with pytest.raises(
        ValueError, match=r"has a method of its own; give it as method=rl\.Method"
    ):
        rl.Agent.load(tmp_path / "agent.npz")


def test_the_experience_is_what_a_sample_model_counts(wander_model):
    recording = rl.read_recording("wander_1k")
    agent = rl.Agent("wander_1k", "SARSA+SR", planner="dyna", planning_steps=1)
    learn_from(agent, recording)
    seen = np.flatnonzero(wander_model.pair_count)
    assert agent.experience.tries.tolist() == wander_model.pair_count.ravel().tolist()
    assert set(agent.experience.tried[: agent.experience.now.pairs].tolist()) == set(
        seen.tolist()
    )
    met = zip(
        *(getattr(agent.experience, name).tolist() for name in experience.OUTCOME[:5]),
        strict=True,
    )
    after = defaultdict(list)
    for pair, *outcome in list(met)[: agent.experience.now.outcomes]:
        after[pair].append(tuple(outcome))
    assert after.keys() == set(seen.tolist()), (
        "nothing follows a pair that was never tried"
    )
    for s, a in np.argwhere(wander_model.pair_count)[::40].tolist():
        assert sorted(after[s * agent.q.shape[1] + a]) == wander_model.outcomes(s, a)


def test_without_a_planner_nothing_is_kept_in_mind():
    agent = rl.Agent("wander_simple")
    assert agent.method.planner is None and agent.experience is None


@pytest.mark.parametrize("wrong", ["dina", "Dyna", "", 1, ["dyna"]])
def test_an_unknown_planner_is_answered_with_the_known_ones(wrong):
    with pytest.raises(
        ValueError, match=r"^the toolkit has no planner .*It has: dyna$"
    ):
        rl.Agent("wander_simple", planner=wrong)


@pytest.mark.parametrize("wrong", [-1, 1.0, True, 10**7, None, "10"])
def test_a_wrong_number_of_planning_steps_is_refused(wrong):
    with pytest.raises(
        ValueError, match=r"^planning_steps must be a whole number from 0"
    ):
        rl.Agent("wander_simple", planner="dyna", planning_steps=wrong)


def test_an_agent_cannot_take_up_planning_later():
    with pytest.raises(ValueError, match="planner cannot be changed later"):
        rl.Agent("wander_simple").change(planner="dyna")


def test_planners_are_compared_like_methods(wander_model, tmp_path):
    methods = {
        "Q+SR": {},
        "planned": {"method": "Q+SR", "planner": "dyna", "planning_steps": np.int64(3)},
    }
    result = rl.compare(
        wander_model, methods, 2, steps=200, progress=False, store=tmp_path / "store"
    )
    assert not np.array_equal(result.final["Q+SR"], result.final["planned"])
    told = (tmp_path / "store" / "experiment.json").read_text()
    assert (
        '"planner of Q+SR": null' in told and '"planning_steps of planned": 3' in told
    )
