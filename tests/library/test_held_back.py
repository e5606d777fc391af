"""A model asked about rows that it has not seen: where states lump together what differs, it is found out."""

from collections import Counter, defaultdict

import gymnasium
import numpy as np
import pytest
from worlds import RandomWorld, recording_of

import rlrobot_edu as rl

LUMPED = "The step before tells what comes next better than the state alone"


class Rooms(gymnasium.ObservationWrapper):
    """Shows in which room of `size` neighbouring states the robot is, and not where in it."""

    def __init__(self, env, size):
        super().__init__(env)
        self.size = size
        n = env.observation_space.n // size
        self.observation_space = gymnasium.spaces.Discrete(n)

    def observation(self, observation):
        return int(observation) // self.size


class Corridor(gymnasium.Env):
    """A walk of 24 cells to the right and back to the left, paid at its right end; it goes on for ever."""

    observation_space = gymnasium.spaces.Discrete(24)
    action_space = gymnasium.spaces.Discrete(2)
    r_max = 5.0

    def reset(self, *, seed=None, options=None):
        self.state = 0
        return 0, {}

    def step(self, action):
        step = 1 if action else -1
        self.state = min(max(self.state + step, 0), 23)
        return self.state, 5.0 * (self.state == 23), False, False, {}


def turning(env, n):
    """A recording of a robot that goes one way and turns now and then, whatever it sees."""
    rng = np.random.default_rng(0)
    observation, _ = env.reset()
    rows = []
    action = 1
    for _ in range(n):
        if rng.random() < 0.05:
            action = 1 - action
        after, r, *_ = env.step(action)
        rows.append((observation, action, r, after, False))
        observation = after
    return recording_of(rows, shape=(env.observation_space.n,), n_actions=2)


def test_states_that_lump_places_together_are_found_out():
    lumped = rl.SampleModel.hold_back(turning(Rooms(Corridor(), 6), 3000))
    assert lumped.verdict.startswith(LUMPED)
    gained = lumped.guessed_from_two - lumped.guessed
    assert gained > 3 * abs(lumped.gained_by_chance)
    whole = rl.SampleModel.hold_back(turning(Corridor(), 3000))
    assert whole.verdict.startswith("Nothing odd in these rows. That is no proof")
    assert whole.guessed == whole.guessed_from_two == 1.0


def sound_worlds():
    for seed in range(20):
        world = RandomWorld(seed=seed, p_end=0.05)
        yield world, rl.Agent(world, "Q+EG", seed=seed)
    model = rl.SampleModel.from_recording(
        rl.read_recording("wander_simple"), unseen="stay"
    )
    for seed in range(20):
        env = rl.make_env(model, seed=seed)
        yield env, rl.Agent(env, "TOSL+QBIASSR", seed=seed)


def test_where_states_tell_all_hardly_any_recording_is_suspected():
    verdicts = [
        rl.SampleModel.hold_back(rl.record(agent, env, 1500)).verdict
        for env, agent in sound_worlds()
    ]
    n_suspected = sum(verdict.startswith(LUMPED) for verdict in verdicts)
    assert n_suspected <= 3  # of 40; by chance one


def test_a_model_of_a_robot_whose_lasers_lump_places_together_is_found_out():
    assert rl.SampleModel.hold_back(rl.read_recording("wander_1k")).verdict.startswith(
        LUMPED
    )


@pytest.mark.parametrize("name", ["wander_simple", "navigation_1k", "worked_example"])
def test_the_guesses_are_those_of_a_table_of_counts(name):
    recording = rl.read_recording(name)
    n_first = len(recording) * 4 // 5
    counts = {"pair": defaultdict(Counter), "two": defaultdict(Counter)}
    rewards = defaultdict(list)
    guesses, foretold = [], []
    before = None
    columns = (getattr(recording, x) for x in ("s", "a", "r", "s_next", "terminated"))
    rows = zip(*(column.tolist() for column in columns), strict=True)
    for i, (s, a, r, *rest) in enumerate(rows):
        if recording.step[i] == 0:
            before = None
        after = (r, *rest)
        keys = {"pair": (s, a), "two": (before, s, a)}
        seen = {kind: counts[kind][key] for kind, key in keys.items()}
        if i < n_first:
            for counter in seen.values():
                counter[after] += 1
            rewards[s, a].append(r)
        else:
            if seen["two"]:
                shares = [c[after] / c.total() for c in seen.values()]
                guesses.append(shares)
            if seen["pair"]:
                foretold.append(np.mean(rewards[s, a]))
        before = (s, a)
    report = rl.SampleModel.hold_back(recording)
    assert report.rows == len(recording) - n_first
    assert report.new_rows == report.rows - len(foretold)
    assert report.reward_foretold == pytest.approx(np.mean(foretold))
    due = np.mean(guesses, axis=0)
    assert [report.guessed, report.guessed_from_two] == pytest.approx(due.tolist())


def test_too_few_rows_are_said_to_be_too_few():
    rows = [(0, 0, 0.0, 1, False), (1, 0, 0.0, 2, False), (2, 0, 0.0, 3, False)]
    report = rl.SampleModel.hold_back(recording_of(rows))
    assert report.new_rows == 1 and report.verdict.startswith("Too few pairs")
    assert "nan" in repr(report)
    with pytest.raises(ValueError, match="no fifth to hold back"):
        rl.SampleModel.hold_back(recording_of(rows[:1]))


def test_a_diagnosis_says_what_it_does_not_look_for():
    report = rl.SampleModel.from_recording(recording_of([(0, 0, 5.0, 0, 0)])).diagnose()
    assert "lump together what differs, see SampleModel.hold_back" in repr(report)
