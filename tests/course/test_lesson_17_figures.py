"""Lesson 17's cells and figures say what they should."""

import base64
import io
import re
from itertools import pairwise

import numpy as np
import pytest
from PIL import Image

import rlrobot_edu as rl
from rlrobot_course.lesson_17.cells import (
    GOAL,
    SHAPE,
    SHORTEST,
    START,
    WALLS,
    Cells,
    best_way,
    first_episode,
    neighbour,
    number,
    steps_needed,
    thoughts,
)
from rlrobot_course.lesson_17.figures import (
    Walks,
    beliefs_finding,
    order_finding,
    planners_finding,
    plot_real_steps,
    saving_finding,
)
from rlrobot_course.lesson_17.sweeping import SWEEPING

CELLS = [cell for cell in np.ndindex(SHAPE) if cell not in WALLS]


def values(gamma=0.9, sweeps=40):
    """Q of the cells by value iteration, array (35, 4)."""
    q = np.zeros((SHAPE[0] * SHAPE[1], 4))
    for _ in range(sweeps):
        for cell in CELLS:
            for a in range(4 * (cell != GOAL)):
                after = neighbour(cell, a)
                q[number(cell), a] = (
                    1.0 if after == GOAL else gamma * q[number(after)].max()
                )
    return q


def test_the_shortest_way_is_as_long_as_it_is_said_and_leads_from_cell_to_cell():
    q = values()
    way = best_way(q)
    assert way[0] == START and way[-1] == GOAL and len(way) - 1 == SHORTEST
    assert q[number(START)].max() == pytest.approx(0.9 ** (SHORTEST - 1))
    assert all(abs(x - u) + abs(y - v) == 1 for (x, y), (u, v) in pairwise(way))
    assert best_way(np.zeros_like(q)) == [START], "who knows nothing knows no way"


def test_a_wall_stops_the_robot_and_the_goal_pays_and_ends_the_episode():
    env = Cells()
    assert tuple(env.reset()[0]) == START
    assert tuple(env.step(np.int64(1))[0]) == START, "a wall on its right"
    for before, after in pairwise(best_way(values())):
        a = next(a for a in range(4) if neighbour(before, a) == after)
        cell, reward, terminated, truncated, _ = env.step(np.int64(a))
        assert (
            tuple(cell) == after
            and reward == terminated == (after == GOAL)
            and not truncated
        )


@pytest.mark.long
def test_thinking_saves_steps_after_the_first_arrival_and_sweeping_goes_back_from_the_goal():
    plain = steps_needed(7)
    swept = steps_needed(7, planner=SWEEPING, planning_steps=5)
    assert plain[0] == swept[0] == 41, "before the goal there is nothing to think about"
    assert swept[1] - swept[0] < (plain[1] - plain[0]) / 5
    episode = first_episode(7)
    assert len(episode) == 41 and episode[-1].terminated
    order = thoughts(episode, SWEEPING, 12)
    known = [number(cell) for cell in best_way(values())[::-1][1:]]
    found = [order[s] for s in known if order[s] >= 0]
    assert found == sorted(found) and order[known[0]] == 0


def test_the_moving_picture_has_a_frame_a_step_and_counts_arrivals():
    env = Cells()
    walk = rl.learn(
        rl.Agent(env, "Q+EG", seed=7), env, steps=45, progress=False, keep=True
    )
    assert np.flatnonzero(walk.terminated).tolist() == [40]
    film = Walks({"x": walk, "y": walk}, steps=43)
    assert "43 steps. x: 1 arrival; y: 1 arrival" in repr(film)
    page = film._as_html()
    gifs = re.findall(r"data:image/gif;base64,([^\"]+)", page)
    assert len(gifs) == 2
    for gif in gifs:
        assert Image.open(io.BytesIO(base64.b64decode(gif))).n_frames == 43
    assert "No robot arrives more often than all others in 43 steps" in page
    one = Walks({"x": walk}, steps=43)._as_html()
    assert "The robot with “x” arrives most often in 43 steps" in one


def test_the_titles_of_beliefs_count_cells_and_steps():
    q, none = values(), np.zeros((35, 4))
    known = len(CELLS) - 1  # the goal is worth nothing
    said = beliefs_finding({"no thoughts": none, "many": q})
    assert (
        said
        == f"The news of the goal has reached {known} cells with many; 0 with no thoughts"
    )
    assert beliefs_finding({"one": q}).startswith(f"It knows a way of {SHORTEST} steps")
    assert beliefs_finding({"one": none}) == "It knows no way from the start yet"


def test_the_titles_of_planning_follow_the_numbers():
    needed = {"slow": [90, 100, 110], "quick": [5, 6, 7], "other": [100, 100, 100]}
    said = saving_finding(needed)
    assert said.endswith("6 real steps with “quick”, 100 with each of the others")
    assert saving_finding({**needed, "other": [50]}).endswith(
        "“quick”, 100 with “slow”"
    )
    assert plot_real_steps(needed).finding == said
    order = {"dyna: 5": np.array([0, -1, -1]), "sweeping: 5": np.array([0, 2, -1])}
    assert order_finding(order).endswith("2 with sweeping, 1 with dyna")
    rng = np.random.default_rng(0)
    low, high = rng.normal(1, 1, 20), rng.normal(9, 1, 20)
    earned = {
        "a, no planner": low,
        "a, dyna": high,
        "b, no planner": high,
        "b, dyna": low,
    }
    assert (
        planners_finding(earned)
        == "Planning helps clearly in a; in b it is not shown to"
    )
