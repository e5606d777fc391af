"""Lesson 04's largest exercise: the loop of SARSA, in which a' is chosen before the update and then really taken."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise, Mistake
from rlrobot_edu.course.grading.tapes import Q_START, TapeWorld


class Chooser:
    """choose(q, s) without chance: asked twice at the same moment it answers differently, so that asking again shows.

    world: the TapeWorld whose clock it reads
    """

    def __init__(self, world: TapeWorld) -> None:
        self.world, self.moment, self.asked = world, None, 0

    def __repr__(self) -> str:
        return "choose"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Chooser)  # how often it was asked is judged by what follows from it

    def __call__(self, q: np.ndarray, s: int) -> int:
        """The best, second or third best action in `s`, as the time and the number of times asked will have it."""
        moment = (self.world.episode, self.world.t)
        self.asked = self.asked + 1 if moment == self.moment else 0
        self.moment = moment
        return int(np.argsort(-q[s])[(sum(moment) + self.asked) % 3])


def _loop(slip: str = ""):
    """The loop with one slip in it; without one it is right."""

    def learn(env, q, choose, update, steps):
        s = env.reset()
        a = choose(q, s)
        for _ in range(steps):
            s_next, r, terminated, truncated = env.step(a)
            over = terminated or truncated
            ends = {"never resets": False, "misses truncated": terminated}.get(slip, over)
            if ends and slip == "resets too soon":
                s_next = env.reset()
            a_next = choose(q, s if slip == "chooses from s" else s_next)
            learned = {"hands over a": a, "learns from the best": int(q[s_next].argmax())}.get(slip, a_next)
            update(q, s, a, r, s_next, learned, over if slip == "takes truncated for terminated" else terminated)
            s = s if slip == "stays" else s_next
            a = choose(q, s) if slip == "chooses again" else a if slip == "keeps the old action" else a_next
            if ends and slip != "resets too soon":
                s = env.reset()
                a = a if slip == "keeps a' after a reset" else choose(q, s)

    return learn


def _update(q, s, a, r, s_next, a_next, terminated):
    q[s, a] += 0.5 * (r + (0.0 if terminated else 0.9 * q[s_next, a_next]) - q[s, a])


_WORLD = TapeWorld()

sarsa_learn = Exercise(
    task="choose a' before the update, take that very a' in the next step, choose anew after a reset",
    right=_loop(),
    # a copy keeps world and chooser together; no value is 0, so that it shows when one is left out of a target
    memory={"env": _WORLD, "choose": Chooser(_WORLD), "q": Q_START + 0.3},
    # every call stops within an episode, so that it does not matter whether one resets at once or when going on
    tape=[{"update": _update, "steps": n} for n in (1, 1, 4, 9)],
    mistakes=[
        Mistake("you choose twice in the same state: once for the update, then again to act. SARSA takes the very a' "
                "that it learned from: a = a_next.", _loop("chooses again")),
        Mistake("a' was chosen, but the old action is taken once more. After the update: a = a_next.",
                _loop("keeps the old action")),
        Mistake("a' is chosen from s. It will be taken in the next state: choose(q, s_next).", _loop("chooses from s")),
        Mistake("after a reset the robot is somewhere else: choose a new first action there.",
                _loop("keeps a' after a reset")),
        Mistake("update is told the action that was just done in place of the next one: hand a_next over.",
                _loop("hands over a")),
        Mistake("this learns from the best action of s', as Q-learning does. Learn from the one that choose gave.",
                _loop("learns from the best")),
        Mistake("truncated only means that time is up: the world goes on, so the target keeps its second part. "
                "Hand terminated alone to update.", _loop("takes truncated for terminated")),
        Mistake("after the end of an episode the world must be reset, which gives a new s.", _loop("never resets")),
        Mistake("an episode also ends when it is truncated. Reset then, too.", _loop("misses truncated")),
        Mistake("the world was reset before the update, so this learns from a state to which the step did not lead. "
                "Update first, then reset.", _loop("resets too soon")),
        Mistake("the next step starts where this one ended: you forgot s = s_next.", _loop("stays")),
    ],
)  # fmt: skip
