"""Right answers and tapes of lesson 17; the pages of this folder have the tasks, hints and mistakes."""

import inspect
from typing import Any

from rlrobot_course.exercises.parts import Exercise, Formula, Question, with_pages
from rlrobot_course.worlds.callbacks import QLearner, Wavering, taken
from rlrobot_course.worlds.tapes import Q_START, TapeWorld, rows, with_action


def dyna(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        seen[s, a] = (r, s_next, terminated)
        for pair in pick(seen):
            update(q, *pair, *seen[pair])
        s = s_next
        if terminated or truncated:
            s = env.reset()


class Lenient(TapeWorld):
    """A world in which a bump costs nothing: a step that pays 0 must be remembered, too."""

    @with_action
    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Do action `a`: returns next state, reward, terminated, truncated."""
        s_next, reward, terminated, truncated = super().step(a)
        return s_next, max(0.0, reward), terminated, truncated


class Picker:
    """What the loop calls for the pairs to imagine: n of those that were seen, without chance."""

    def __init__(self, n: int) -> None:
        self.n = n

    @property
    def __signature__(self) -> inspect.Signature:
        """The names of its arguments, as Python tells them."""
        return inspect.signature(self._pairs)

    def __call__(self, *arguments: Any, **by_name: Any) -> list[tuple[int, int]]:
        """Pairs (s, a), the last by number first. Raises TypeError for anything but a dict with pairs for its keys."""
        return self._pairs(*taken("pick", self._pairs, arguments, by_name))

    def _pairs(self, seen: Any) -> list[tuple[int, int]]:
        if not isinstance(seen, dict):
            raise TypeError("pick takes (seen), the dict alone")
        pairs = sorted(seen, reverse=True)
        if not all(isinstance(pair, tuple) and len(pair) == 2 for pair in pairs):
            raise TypeError("the keys of seen are pairs (s, a)")
        return [pairs[i % len(pairs)] for i in range(self.n)] if pairs else []


check = with_pages(
    globals(),
    planned_by_hand=Question(
        Formula("α * γ * Q_B", α=0.5, γ=0.9, Q_C=0.5, Q_B="α * γ * Q_C")
    ),
    dyna=Exercise(
        dyna,
        memory={
            "env": TapeWorld(),
            "q": Q_START,
            "seen": {},
            "update": QLearner(0.5, 0.9),
        },
        tape=rows(
            "choose update pick steps",
            (Wavering(1), QLearner(0.5, 0.9), Picker(1), 1),
            (Wavering(1), QLearner(0.5, 0.9), Picker(1), 4),
            (Wavering(2), QLearner(0.3, 0.7), Picker(3), 3),
            (Wavering(0), QLearner(0.2, 0.8), Picker(2), 9),
            (Wavering(1), QLearner(0.25, 0.9), Picker(0), 1),
            (Wavering(2), QLearner(0.4, 0.9), Picker(4), 7),
        )
        + [
            {
                "env": Lenient(),
                "choose": Wavering(1),
                "update": QLearner(0.3, 0.9),
                "pick": Picker(2),
                "steps": 7,  # in the middle of an episode: a loop may reset at its head
            }
        ],
    ),
)
