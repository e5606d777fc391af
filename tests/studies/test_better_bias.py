"""The registered study of the bias: its rivals, its worlds, and that what is run is what is registered."""

import itertools
import json

import better_bias
import better_bias_tests as tests
import better_bias_worlds
import numpy as np
import pytest
from better_bias_methods import LINEAR, RELATIVES, add_alike, pool
from coarse import COARSE, near_or_not
from test_headlines import ROOT

import rlrobot_edu as rl
from rlrobot_edu.learning.memory import new_memory
from rlrobot_edu.learning.parameters import Parameters
from rlrobot_edu.robots import robot_env

SHAPE, ACTIONS = (3, 2, 4), 3


def features(s: int) -> np.ndarray:
    """One for the state, and one for each set of states that differ from it in one input."""
    place, parts = np.unravel_index(s, SHAPE), [np.eye(24)[s]]
    for i in range(len(SHAPE)):
        first = np.ravel_multi_index(
            [0 if k == i else x for k, x in enumerate(place)], SHAPE
        )
        parts.append(np.eye(24)[first])
    return np.concatenate(parts)


def test_linear_is_true_online_sarsa_with_a_table_of_weights():
    agent = rl.Agent(rl_size(), rl.Method(LINEAR, "SR"), traces="full", r_max=10.0)
    rng, weights = np.random.default_rng(1), np.zeros((ACTIONS, 4 * 24))
    trace, q_old = np.zeros_like(weights), 0.0
    alpha, gamma, lam = 0.1 / 4, 0.9, 0.9
    s, a = 0, 0
    for _ in range(300):
        s_next, a_next, r = (
            int(rng.integers(24)),
            int(rng.integers(ACTIONS)),
            float(rng.normal()),
        )
        x, x_next = np.zeros_like(weights), np.zeros_like(weights)
        x[a], x_next[a_next] = features(s), features(s_next)
        q, q_next = (weights * x).sum(), (weights * x_next).sum()
        delta = r + gamma * q_next - q
        trace = gamma * lam * trace + (1 - alpha * gamma * lam * (trace * x).sum()) * x
        weights += alpha * (delta + q - q_old) * trace - alpha * (q - q_old) * x
        q_old = q_next
        assert agent.update(s, a, r, s_next, a_next, False) == pytest.approx(delta)
        s, a = s_next, a_next
    table = np.array(
        [[weights[b] @ features(x) for b in range(ACTIONS)] for x in range(24)]
    )
    np.testing.assert_allclose(agent.q, table, atol=1e-9)


def rl_size():
    """A world of these states and actions."""
    from rlrobot_edu.learning.size import Size

    return Size(SHAPE, ACTIONS)


def test_what_alike_states_share_is_what_their_features_have_in_common():
    for s in range(24):
        q = np.zeros((24, ACTIONS))
        add_alike(q, np.array(SHAPE), s, 1, 1.0)
        assert q[:, 1].tolist() == [features(x) @ features(s) for x in range(24)]
        assert not q[:, [0, 2]].any()


@pytest.mark.parametrize(
    ("by_visits", "with_own"), [*itertools.product((False, True), repeat=2)]
)
def test_a_pool_is_the_weighted_mean_of_those_that_tried(by_visits, with_own):
    rng = np.random.default_rng(3)
    m = new_memory(SHAPE, ACTIONS, Parameters())
    m.q[:], m.visits[:] = rng.normal(size=m.q.shape), rng.integers(0, 3, size=m.q.shape)
    q, visits = m.q.reshape(*SHAPE, ACTIONS), m.visits.reshape(*SHAPE, ACTIONS)
    for s in range(24):
        pool(m, s, by_visits, with_own)
        place, above, below = (
            np.unravel_index(s, SHAPE),
            np.zeros(ACTIONS),
            np.zeros(ACTIONS),
        )
        for i, bins in enumerate(SHAPE):
            for k in range(bins):
                if with_own or k != place[i]:
                    other = tuple(k if j == i else x for j, x in enumerate(place))
                    weight = (visits[other] if by_visits else visits[other] > 0) / bins
                    above, below = above + weight * q[other], below + weight
        np.testing.assert_allclose(
            m.bias, np.divide(above, below, out=np.zeros(ACTIONS), where=below > 0)
        )


def test_all_that_is_registered_is_run_and_every_world_is_asked_for():
    registered, found = better_bias.REGISTERED, better_bias_worlds.worlds()
    asked = {
        name for family in registered["families"].values() for name in family["worlds"]
    } - {"ten mazes"}
    asked |= {
        *registered["relatives"]["worlds"],
        *registered["reproduction"]["rule"],
        *better_bias.MAZES,
    }
    assert asked | {*registered["reproduction"]["wheels"]} == set(found)
    assert registered["relatives"]["names"] == list(RELATIVES)
    for name in found:
        labels = better_bias.first_labels(name)
        for label in labels:
            method, settings, world = better_bias.learner(found[name], label)
            rl.Agent(world.task, method, **settings)
    for family in registered["families"].values():
        for name in (
            family["worlds"]
            if "mazes" not in family["worlds"][-1]
            else family["worlds"][:-1]
        ):
            assert {*family["at T = 1"], "VBIASSR"} <= set(
                better_bias.first_labels(name)
            )
            assert {*family["at best T"]} <= {*better_bias.TUNING["methods"]}


def test_on_new_ground_a_circle_pays_no_more_once_it_was_driven():
    world = better_bias_worlds.worlds()["wander_4k, new ground"]
    circle = next(
        a for a in range(25) if world.task.command_for(a) == {"left_wheel": 0.5, "right_wheel": 1.0}
    )  # fmt: skip
    with (
        world.plain_env(np.random.SeedSequence(0)) as env,
        rl.make_env(world.task, engine="kinematic") as old,
    ):
        env.reset()
        old.reset()
        rewards = np.array([env.step(circle)[1] for _ in range(200)])
        assert np.mean([old.step(circle)[1] for _ in range(200)]) == 10
    assert rewards[:20].max() == 10 and rewards[60:].max() < 0


def test_a_random_maze_is_the_same_in_every_process_and_leaves_the_start_free():
    for number in range(10):
        maze = better_bias_worlds.random_maze(number)
        assert maze == better_bias_worlds.random_maze(number)
        world = better_bias_worlds.worlds()[f"maze {number}"]
        with world.plain_env(np.random.SeedSequence(0)) as env:
            _, info = env.reset()
            assert (
                info["readings"]["x"] == pytest.approx(0)
                and env.unwrapped.robot.arena == maze
            )
            assert (
                min(r for name, r in info["readings"].items() if "laser" in name) > 0.2
            )


def test_a_robot_s_result_depends_on_its_world_label_and_number_alone():
    first = better_bias.one("arm_1k", "VBIASSR, T = 0.3", 2)
    better_bias.one("arm_1k", "SR", 0)
    assert (
        better_bias.one("arm_1k", "VBIASSR, T = 0.3", 2)
        == first
        != better_bias.one("arm_1k", "VBIASSR, T = 0.3", 3)
    )


@pytest.mark.long
@pytest.mark.parametrize(
    "name",
    [
        "wander_1k",
        "wander_4k, new ground",
        "maze 3",
        "wander_12k, their wheels",
        "navigation_1k",
    ],
)
def test_the_compiled_loop_gives_the_rewards_of_the_loop_in_python(name, monkeypatch):
    world = better_bias_worlds.worlds()[name]
    method, settings, world = better_bias.learner(world, "VBIASSR, T = 0.3")
    assert world.is_fast
    both, steps = [], []
    step = robot_env.RobotEnv.step
    monkeypatch.setattr(
        robot_env.RobotEnv, "step", lambda self, a: steps.append(a) or step(self, a)
    )
    for env in (
        world.env(np.random.SeedSequence(0)),
        world.plain_env(np.random.SeedSequence(0)),
    ):
        with env:
            agent = rl.Agent(world.task, method, seed=5, **settings)
            both.append(
                rl.learn(
                    agent, env, 5000, episodes=world.episodes, progress=False, keep=True
                )
            )
        assert len(steps) == (0 if len(both) == 1 else len(both[1]))
        monkeypatch.setattr(robot_env, "WORTH_COMPILING", 10**9)
    assert (
        both[0].s.tolist() == both[1].s.tolist()
        and both[0].rewards.tolist() == both[1].rewards.tolist()
    )
    np.testing.assert_array_equal(both[0].q, both[1].q)
    assert both[0].final_average_reward == both[1].final_average_reward


@pytest.fixture(scope="module")
def found():
    return json.loads(better_bias.NUMBERS.read_text(encoding="utf-8"))


def signs(rows, names):
    """Who earns more by the corrected tests, by world and comparison."""
    return {
        (row.world, name): row.sign
        for row, name in zip(rows, itertools.cycle(names), strict=False)
    }


def test_holms_correction_is_that_of_statsmodels_in_small():
    rows = [tests.Difference("", "", "", 1.0, 0.0, 2.0, p) for p in (0.04, 0.01, 0.03)]
    assert [row.corrected for row in tests.holm(rows)] == pytest.approx(
        [0.06, 0.03, 0.06]
    )


def test_a_difference_over_mazes_has_one_number_a_maze():
    runs = {
        f"maze {i}": {"VBIASSR": [i + 1.0, i + 2.0], "SR": [float(i)] * 3}
        for i in range(10)
    }
    runs["maze 3"]["SR"] = [2.0]
    its = tests.difference(runs, "ten mazes", "VBIASSR", "SR")
    assert its.mean == pytest.approx(1.6) and its.low < 1.6 < its.high


def test_what_the_page_says_in_short_is_what_the_corrected_tests_show(found):
    """1 is more, -1 less, 0 not shown; of VBIASSR beside the other."""
    said = {}
    for key, its in better_bias.REGISTERED["families"].items():
        said |= signs(
            tests.family(found, key),
            [*its["at T = 1"], *(f"{name}, best" for name in its["at best T"])],
        )
    four = better_bias.REGISTERED["families"]["no circle pays"]["worlds"]
    assert {
        said[world, other]
        for world in four
        for other in ("QBIASSR", "blind", "SR, best")
    } == {1}
    assert [said[world, "COUNT, best"] for world in four] == [1, 1, 0, 1]
    assert [said[world, "QBIASSR, best"] for world in four] == [1, 0, 0, 1]
    assert {said[world, "LINEAR, best"] for world in four} == {0}
    assert [said[world, "coarse, best"] for world in four] == [0, 0, -1, -1]
    changed = better_bias.REGISTERED["families"]["changed in one thing"]["worlds"]
    assert [said[world, "QBIASSR"] for world in changed] == [1] * 9 + [0, 0]
    assert [said[world, "SR"] for world in changed] == [1] * 9 + [0, 0]
    others = ("SR", "QBIASSR", "SR, best", "QBIASSR, best")
    assert {said["giraff_wander_1k", other] for other in others} == {1}
    assert said["navigation_1k", "SR"] == said["navigation_1k", "QBIASSR"] == 1
    assert said["navigation_1k", "QBIASSR, best"] == 0
    assert {
        said[arm, other] for arm in ("arm_1k", "arm_4k") for other in ("SR", "QBIASSR")
    } == {-1}


def test_what_the_page_says_of_the_relatives_and_of_the_rule_is_what_their_tests_show(
    found,
):
    names, worlds = (
        better_bias.REGISTERED["relatives"][part] for part in ("names", "worlds")
    )
    its = signs(tests.relatives(found), names)
    said = {name: {world: its[world, name] for world in worlds} for name in names}
    assert [len(tests.never_hurts(found, name)) > 0 for name in names] == [True] * 6
    assert [
        fault.split(" beside")[0] for fault in tests.never_hurts(found, "VFBIASSR")
    ] == ["arm_4k"]
    better = {world for world, sign in said["NZBIASSR"].items() if sign == 1}
    assert better == {"wander_4k, nine actions", "wander_simple", "arm_1k", "arm_4k"}
    assert -1 not in said["NZBIASSR"].values() and -1 not in said["VFBIASSR"].values()
    assert (
        list(said["VOBIASSR"].values()).count(-1) == 5
        and list(said["VFBIASSR"].values()).count(1) == 4
    )
    worse = {world for world, sign in said["VHBIASSR"].items() if sign}
    assert worse == {"giraff_wander_1k", "navigation_1k"}
    assert sum(pair.decides for pair in tests.rules(found)) == 3
    ends = {its.world: its.low for its in tests.wheels(found) if its.second == "blind"}
    assert ends["wander_4k, their wheels"] > 0 > ends["wander_4k"]


def test_who_sees_little_tells_the_lowest_bin_of_each_input_from_the_rest():
    task = rl.load_task("wander_1k")
    agent = rl.Agent(task, COARSE, seed=0, loop_evasion=False)
    for s in range(0, task.states.n, 7):
        bins = np.minimum(np.unravel_index(s, task.states.shape), 1)
        assert near_or_not(agent.memory, s) == np.ravel_multi_index(
            bins, task.states.shape
        )
    rl.learn(agent, rl.make_env(task, seed=0), 300, progress=False)
    used = np.array(
        np.unravel_index(np.flatnonzero(agent.q.any(axis=1)), task.states.shape)
    )
    assert used.shape[1] > 2 and used.max() == 1


def test_the_verdicts_of_the_page_speak_of_the_worlds_that_count():
    """Which these are, and who is ahead there and elsewhere, after correction."""
    found = json.loads((ROOT / "studies/better_bias.json").read_text(encoding="utf-8"))
    first, _, changed = tests.REGISTERED["families"]
    rows = [*tests.family(found, first), *tests.family(found, changed)]
    counts = {
        row.world for row in rows if tests.pays_no_circle(found, row.world).high < 0
    }
    assert {"wander_1k", "wander_4k, new ground"} == counts & {
        *tests.REGISTERED["families"][first]["worlds"]
    }
    ahead = {row.world: row.sign for row in rows if row.second == "QBIASSR"}
    elsewhere = [sign for world, sign in ahead.items() if world not in counts]
    assert (sum(elsewhere), len(elsewhere)) == (6, 7)
    assert {world for world in counts if not ahead[world]} == {"wander_1k, new ground"}
