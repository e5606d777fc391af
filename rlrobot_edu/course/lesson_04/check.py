"""Exercises of lesson 04: SARSA."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.grading.tapes import Q_START, TAPE, TapeWorld
from rlrobot_edu.course.lesson_04 import solutions

by_hand = Question(
    task="the new Q(s, a) after SARSA's update, computed by hand",
    right=solutions.by_hand,
    because="−6 + 0.1 · (−1 + 0.9 · (−40) + 6) = −9.1: the careless action that follows counts.",
    mistakes=[
        Mistake("this is Q-learning's answer: it took the best value in s'. SARSA takes that of a', −40.", -5.77),
        Mistake("this is the target itself. With α = 0.1, Q goes only a tenth of the way towards it.", -37.0),
        Mistake("you forgot γ: the value of a' in s' counts 0.9 times.", -9.5),
        Mistake("you added α times the target. The TD error is the target minus the old Q(s, a).", -9.7),
        Mistake("this is the TD error δ. The new Q(s, a) is the old one plus α · δ.", -31.0),
        Mistake("this is the step α · δ. Add it to the old Q(s, a).", -3.1),
        Mistake("this counts the mean over the actions of s'. SARSA looks at one action only, at a'.", -6.715),
        Mistake("the reward is missing: the target is r + γ · Q(s', a').", -9.0),
        Mistake("watch the signs: taking off a negative number adds it.", -10.3),
    ],
)

sarsa_update = Exercise(
    task="change q[s, a] by α times SARSA's TD error",
    right=solutions.sarsa_update,
    memory={"q": Q_START},
    tape=[row | {"alpha": 0.1, "gamma": 0.9} for row in TAPE],
    mistakes=[
        Mistake("this bootstraps past the end. After a terminal step nothing follows, so the target is the reward "
                "alone.", {"r if terminated else ": ""}),
        Mistake("a terminated step teaches, too: its target is the reward alone.",
                {"alpha * delta": "alpha * delta * (not terminated)"}),
        Mistake("this is Q-learning: it takes the best action of s'. SARSA takes a_next, good or bad.",
                {"q[s_next, a_next]": "q[s_next].max()"}),
        Mistake("in s' the action a_next will be taken, not the old action a once more.", {"a_next": "a"}),
        Mistake("a_next is taken in the next state: its value is q[s_next, a_next], not q[s, a_next].",
                {"s_next": "s"}),
        Mistake("you forgot γ, which makes later rewards count less.", {"gamma * ": ""}),
        Mistake("the TD error is the target minus the old q[s, a]; here the old value is not taken off.",
                {" - q[s, a]": ""}),
        Mistake("q[s, a] should change by α · δ. You replaced it: write += instead of =.",
                {"q[s, a] + alpha": "alpha"}),
        Mistake("q[s, a] jumps to the target. It should go only the share α of the way.", {"alpha * ": ""}),
        Mistake("the pair that learns is (s, a), where the step began, not (s', a').",
                {"q[s, a] = q[s, a] +": "q[s_next, a_next] +="}),
        Mistake("the action that learns is a, which was done; a_next is still to come.", {"q[s, a]": "q[s, a_next]"}),
    ],
)  # fmt: skip


class Chooser:
    """choose(q, s) without chance: asked twice at the same moment it answers differently, so that asking again shows.

    world: the TapeWorld whose clock it reads
    """

    def __init__(self, world: TapeWorld) -> None:
        self.world, self.asked = world, 0
        self.moment: tuple[int, int] | None = None

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


def learn_from(q: np.ndarray, s: int, a: int, r: float, s_next: int, a_next: int, terminated: bool) -> None:
    """The update that the loop calls."""
    q[s, a] += 0.5 * (r + (0.0 if terminated else 0.9 * q[s_next, a_next]) - q[s, a])


WORLD = TapeWorld()

sarsa_learn = Exercise(
    task="choose a' before the update, take that very a' in the next step, choose anew after a reset",
    right=solutions.sarsa_learn,
    # a copy keeps world and chooser together; no value is 0, so that it shows when one is left out of a target
    memory={"env": WORLD, "choose": Chooser(WORLD), "q": Q_START + 0.3},
    # every call stops within an episode, so that it does not matter whether one resets at once or when going on
    tape=[{"update": learn_from, "steps": n} for n in (1, 1, 4, 9)],
    mistakes=[
        Mistake("you choose twice in the same state: once for the update, then again to act. SARSA takes the very a' "
                "that it learned from: a = a_next.", {"s, a = s_next, a_next": "s, a = s_next, choose(q, s_next)"}),
        Mistake("a' was chosen, but the old action is taken once more. After the update: a = a_next.",
                {"s, a = s_next, a_next": "s = s_next"}),
        Mistake("a' is chosen from s. It will be taken in the next state: choose(q, s_next).",
                {"choose(q, s_next)": "choose(q, s)"}),
        Mistake("after a reset the robot is somewhere else: choose a new first action there.",
                {"reset()\n            a = choose(q, s)": "reset()"}),
        Mistake("update is told the action that was just done in place of the next one: hand a_next over.",
                {"a_next, terminated)": "a, terminated)"}),
        Mistake("this learns from the best action of s', as Q-learning does. Learn from the one that choose gave.",
                {"a_next, terminated)": "q[s_next].argmax(), terminated)"}),
        Mistake("truncated only means that time is up: the world goes on, so the target keeps its second part. Hand "
                "terminated alone to update.", {"a_next, terminated)": "a_next, terminated or truncated)"}),
        Mistake("after the end of an episode the world must be reset, which gives a new s.",
                {"if terminated or truncated:": "if False:"}),
        Mistake("an episode also ends when it is truncated. Reset then, too.",
                {"if terminated or truncated:": "if terminated:"}),
        Mistake("the world was reset before the update, so this learns from a state to which the step did not lead. "
                "Update first, then reset.",
                {"env.step(a)": "env.step(a)\n        s_next = env.reset() if terminated or truncated else s_next",
                 "if terminated or truncated:": "if False:"}),
        Mistake("the next step starts where this one ended: you forgot s = s_next.",
                {"s, a = s_next, a_next": "a = a_next"}),
    ],
)  # fmt: skip

fall = Question(
    task="how probable at least one fall is on the way along the edge",
    right=solutions.fall,
    because="1 − 0.975¹¹ = 0.243: nearly every fourth walk along the edge ends in the cliff.",
    mistakes=[
        Mistake("this is the probability of not falling at all. Falling is the rest, up to 1.", 0.975**11),
        Mistake("probabilities of repeated chances do not add up: 50 steps would give more than 1. Compute the "
                "probability that no step falls, and take the rest.", 11 * 0.025),
        Mistake("with ε = 0.1 one step in ten explores, but only one of the four actions leads over the edge.",
                1 - 0.9**11),
        Mistake("nearly: this is rounded. Write the expression and let Python compute it.", 0.24),
        Mistake("a probability lies between 0 and 1: divide the per cent by 100.", 100 * (1 - 0.975**11)),
        Mistake("this is the risk of one step. There are eleven such steps.", 0.025),
        Mistake("this is the probability of falling at every one of the eleven steps. Once is enough.", 0.025**11),
        Mistake("exploring picks any of four actions, the best one included: down has the share 1/4, not 1/3.",
                1 - (1 - 0.1 / 3) ** 11),
    ],
)  # fmt: skip

# How probable each action is in s'. The most probable one is not always the best, as after a change of Q.
POLICIES = ((0.8, 0.1, 0.1), (0.05, 0.05, 0.9), (0.2, 0.5, 0.3), (0.0, 1.0, 0.0), (0.6, 0.3, 0.1))

expected_target = Exercise(
    task="return r + γ · the mean of Q(s', ·), each action weighted with its probability",
    right=solutions.expected_target,
    returns="target",
    tape=[
        {"q": Q_START, "p": np.array(p), "gamma": 0.9} | {name: row[name] for name in ("r", "s_next", "terminated")}
        for p, row in zip(POLICIES, TAPE, strict=False)
    ],
    mistakes=[
        Mistake("this bootstraps past the end. After a terminal step nothing follows, so the target is the reward "
                "alone.", {"if terminated:": "if False:"}),
        Mistake("you forgot γ, which makes later rewards count less.", {"gamma * ": ""}),
        Mistake("this is Q-learning's target: the best action as if it were certain. Weight every action with p.",
                {"sum(p * q[s_next])": "q[s_next].max()"}),
        Mistake("here all actions count alike. Those that are likelier should count more: weight each with p.",
                {"sum(p * q[s_next])": "q[s_next].mean()"}),
        Mistake("this takes the likeliest action as if it were certain. The others happen, too: weight each with p.",
                {"sum(p * q[s_next])": "q[s_next, p.argmax()]"}),
        Mistake("this is one number for each action. Add the weighted values up: the target is a single number.",
                {"sum(p * q[s_next])": "p * q[s_next]"}),
        Mistake("weighted twice: p already sums to 1, so the weighted values are added up, not averaged.",
                {"sum(p * q[s_next])": "(p * q[s_next]).mean()"}),
        Mistake("γ discounts what comes later; the reward of this step counts in full.",
                {"return r\n": "return gamma * r\n",
                 "r + gamma * sum(p * q[s_next])": "gamma * (r + sum(p * q[s_next]))"}),
    ],
)  # fmt: skip
