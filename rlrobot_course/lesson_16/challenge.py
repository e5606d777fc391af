"""Open challenge of lesson 16: what to think of between two steps."""

from typing import Any

from rlrobot_course.challenge import Challenge, Watched
from rlrobot_course.lesson_16.cells import GOAL, SHORTEST, Cells, best_way
from rlrobot_edu import Agent, steps

THOUGHTS, MOST = 5, 3000


def pairs(value: Any) -> list[tuple[int, int]]:
    """Reads a list of pairs. Raises ValueError for anything else, or too many."""
    if not isinstance(value, list | tuple) or len(value) > THOUGHTS:
        raise ValueError(f"a list of at most {THOUGHTS} pairs (s, a) is expected")
    return [(int(s), int(a)) for s, a in value]


def steps_needed(pick: Watched, seed: int) -> float:
    """Real steps of an agent from its first arrival at the goal until its best way is the shortest."""
    env, arrived = Cells(), 0
    agent, seen = Agent(env, "Q+EG", seed=seed), dict[tuple[int, int], tuple[float, int, bool]]()
    for step in steps(agent, env, MOST):
        seen[step.s, step.a] = (step.r, step.s_next, step.terminated)
        arrived = arrived or step.t * step.terminated
        for pair in pick(agent.q.copy(), dict(seen), step.s) if arrived else ():
            if pair not in seen:
                raise ValueError(f"my_pick names {pair}, which was never seen")
            r, s_next, terminated = seen[pair]
            agent.update(*pair, r, s_next, 0, terminated)
        if arrived and len(way := best_way(agent.q)) - 1 == SHORTEST and way[-1] == GOAL:
            break
    return float(step.t + 1 - arrived)


challenge = Challenge(
    "16",
    "Write my_pick(q, seen, s), which returns up to five pairs (s, a) to think of: from the table, from the dict of "
    "what followed each pair, {(s, a): (r, s_next, terminated)}, and the state just left. A robot in the cells learns "
    "by Q-learning. What counts is its real steps from the first arrival at the goal until it knows the shortest way.",
    "steps", lambda pick: Watched(pick, "my_pick(q, seen, s)", pairs), steps_needed,
    seeds=20, least_wins=True,
)  # fmt: skip
