"""Exercises of lesson 09: all pieces together, TOSL+QBIASSR."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.tapes import RobotWorld
from rlrobot_edu.course.lesson_09 import solutions
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn as run
from rlrobot_edu.learning.size import Size

SHAPE = (2, 2, 3, 2)
Q = np.random.default_rng(9).normal(3.0, 6.0, size=(24, 3)).round(1)
R_MAX, GAMMA = 4.0, 0.9

preferences = Exercise(
    task="return the preferences of QBIASSR in state s, one number an action",
    right=solutions.preferences,
    returns="preferences",
    tape=[{"q": Q, "shape": SHAPE, "s": s, "r_max": R_MAX, "gamma": GAMMA} for s in (0, 5, 13, 23)],
    mistakes=[
        Mistake("the bias is missing: these are the preferences of softmax regression without it.",
                {" + bias(q, shape, s)": ""}),
        Mistake("this is the bias alone. What the state itself has learned counts, too: Q(s) + bias(s).",
                {"q[s] + ": ""}),
        Mistake("Q(s) + bias(s) still has to be normalised: times 100 / Qmax.", {" * 100 / q_max": ""}),
        Mistake("only Q(s) was normalised. The bias is made of Q values, too: first add, then normalise.",
                {"(q[s] + bias(q, shape, s)) * 100 / q_max": "q[s] * 100 / q_max + bias(q, shape, s)"}),
        Mistake("only the bias was normalised: brackets around Q(s) + bias(s) are missing.",
                {"(q[s] + bias(q, shape, s))": "q[s] + bias(q, shape, s)"}),
        Mistake("Qmax is Rmax / (1 − γ), the most that can be earned from here on, not Rmax.", {" / (1 - gamma)": ""}),
        Mistake("this is the mean of Q(s) and bias(s). QBIASSR takes their sum.", {"100": "50"}),
    ],
)  # fmt: skip

# values so close to one another, and numbers u so spread, that every wrong way to choose shows somewhere
CHOICES = [
    {"q": Q / 10, "shape": SHAPE, "s": s, "temperature": temperature, "r_max": R_MAX, "gamma": GAMMA, "u": u}
    for temperature in (0.4, 3.0)
    for s, u in zip(range(0, 24, 2), (0.5, 0.05, 0.95, 0.3, 0.7, 0.6, 0.4, 0.8, 0.2, 0.55, 0.35, 0.65), strict=True)
]

choose = Exercise(
    task="return the action that QBIASSR takes in s, drawn with the number u",
    right=solutions.choose,
    returns="action",
    tape=CHOICES,
    mistakes=[
        Mistake("the best action is not always taken: draw one, with the probabilities of the softmax.",
                {"draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)":
                 "int(preferences(q, shape, s, r_max, gamma).argmax())"}),
        Mistake("the temperature plays no part in your choice: it goes into the softmax.", {"temperature": "1.0"}),
        Mistake("your choice does not know the bias.",
                {"preferences(q, shape, s, r_max, gamma)": "q[s] * 100 * (1 - gamma) / r_max"}),
        Mistake("the preferences are not normalised by 100 / Qmax.",
                {"preferences(q, shape, s, r_max, gamma)": "q[s] + bias(q, shape, s)"}),
        Mistake("all actions are equally probable in your choice. Are the preferences handed to the softmax?",
                {"draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)": "int(u * q.shape[1])"}),
    ],
)  # fmt: skip


def library(
    env: RobotWorld,
    shape: tuple[int, ...],
    n_actions: int,
    r_max: float,
    steps: int,
    rng: np.random.Generator,
    loop_evasion: bool = False,
) -> np.ndarray:
    """The library's agent in the learner's world: what a right answer equals, number for number."""
    agent = Agent(Size(shape, n_actions, r_max), "TOSL+QBIASSR", traces="full", loop_evasion=loop_evasion)
    agent.rng = rng
    run(agent, env.env, steps, progress=False)
    return agent.q


def drives() -> list[dict[str, Any]]:
    """The learner's robot with random numbers, for a step, for some steps and for many."""
    world = RobotWorld("worked_example", seed=0)
    about = {"env": world, "shape": world.shape, "n_actions": world.n_actions, "r_max": world.r_max}
    return [about | {"rng": np.random.default_rng(seed), "steps": n} for n, seed in ((1, 0), (5, 1), (40, 2), (300, 3))]


learn = Exercise(
    task="let TOSL+QBIASSR learn for a number of steps, and return q",
    right=solutions.learn,
    library=library,
    returns="q",
    tape=drives(),
    mistakes=[
        Mistake("the actions are chosen without the bias.",
                {"choose(q, shape, s, temperature, r_max, gamma, ":
                 "draw(softmax(q[s] * 100 * (1 - gamma) / r_max, temperature), "}),
        Mistake("the action a' that you learned from must be the one that is taken next. Here another one is drawn "
                "for the step, so two numbers are drawn where there should be one.",
                {"s, a = s_next, a_next": "s, a = s_next, act(s_next)"}),
        Mistake("a' must be chosen before the update, which learns from it; here it learns from the best action.",
                {"a_next = act(s_next)": "a_next = q[s_next].argmax()",
                 "s, a = s_next, a_next": "s, a = s_next, act(s_next)"}),
        Mistake("as a new episode starts, the traces and Q_old start afresh: e is 0 and Q_old is 0.",
                {"e[:], q_old = 0.0, 0.0": "pass"}),
        Mistake("as a new episode starts, the traces start afresh: e is 0.", {"e[:], q_old = 0.0, 0.0": "q_old = 0.0"}),
        Mistake("after a reset the robot stands elsewhere: the action that it still holds was meant for another "
                "state. Choose a new one.", {"reset()\n            a = act(s)": "reset()"}),
        Mistake("Q_old stays at 0 here. Your true_online_update returns the new one: keep it.",
                {"q_old = true_online_update": "true_online_update"}),
        Mistake("where an episode has ended, reset the world, and choose an action for its first state.",
                {"if terminated or truncated": "if False"}),
    ],
)  # fmt: skip

learn_and_evade = Exercise(
    task="let TOSL+QBIASSR with loop evasion learn for a number of steps, and return q",
    right=solutions.learn_and_evade,
    library=partial(library, loop_evasion=True),
    returns="q",
    tape=drives(),
    mistakes=[
        Mistake("this is learning without loop evasion. Is the temperature changed before a' is chosen?",
                {"if len(states) == length": "if False"}),
        Mistake("the temperature never falls. When there is no loop, it goes back to its default at once.",
                {"s_next, default)": "s_next, temperature)"}),
        Mistake("as a new episode starts, the queue starts afresh, and so does the temperature.",
                {"q_old = 0.0, 0.0\n            states, rewards, temperature = [], [], default": "q_old = 0.0, 0.0"}),
        Mistake("the queue has as many places as there are traces, 21, but at most a quarter of the states: here 6.",
                {"max(4, min(21, len(q) // 4))": "21"}),
        Mistake("a queue that is not full yet says nothing: keep the temperature at its default until it is.",
                {"if len(states) == length": "if True"}),
        Mistake("what goes into the queue is the state that the step led to, s', with the reward it brought.",
                {"[*states, s_next]": "[*states, s]"}),
    ],
)  # fmt: skip

p_value = Exercise(
    task="return the share of the shuffled numbers that are at least as large as the observed one",
    right=solutions.p_value,
    returns="p",
    tape=[
        {"observed": 3.0, "shuffled": np.array([0.2, 1.1, 3.0, 0.7, 5.2, 0.1, 0.4, 2.9, 0.6, 1.5])},
        {"observed": 26.0, "shuffled": np.array([0.5, 1.5, 2.5, 0.1])},
        {"observed": 0.5, "shuffled": np.array([0.5, 1.5, 2.5, 0.1, 0.9])},
    ],
    mistakes=[
        Mistake("this is the share that is smaller. A small p must mean: chance hardly ever gets that far.",
                {">=": "<"}),
        Mistake("at least as large: those that equal the observed one count, too.", {">=": ">"}),
        Mistake("this is how many they are; divide by how many were shuffled.", {" / len(shuffled)": ""}),
        Mistake("this is the share that is at most as large as the observed one: the other side.", {">=": "<="}),
        Mistake("this is in per cent. A share lies between 0 and 1.", {"sum(": "100 * sum("}),
        Mistake("this is the mean of the shuffled numbers. Compare each with the observed one first.",
                {"1 for f in shuffled if f >= observed": "shuffled"}),
    ],
)  # fmt: skip
