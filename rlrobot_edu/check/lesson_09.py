"""Exercises of lesson 09: all pieces together, TOSL+QBIASSR."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.check.exercise import Exercise, Mistake
from rlrobot_edu.check.tapes import RobotWorld
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop_evasion import HOTTEST
from rlrobot_edu.learning.qbiassr import bias_of
from rlrobot_edu.learning.softmax import probabilities
from rlrobot_edu.learning.world import Size

SHAPE = (2, 2, 3, 2)
Q = np.random.default_rng(9).normal(3.0, 6.0, size=(24, 3)).round(1)
R_MAX, GAMMA, ALPHA, LAM = 4.0, 0.9, 0.1, 0.9


def _preferences(q, shape, s, r_max, gamma):
    return (q[s] + bias_of(q, shape, s)) * 100 * (1 - gamma) / r_max


preferences = Exercise(
    task="return the preferences of QBIASSR in state s, one number an action",
    right=_preferences,
    returns="preferences",
    tape=[{"q": Q, "shape": SHAPE, "s": s, "r_max": R_MAX, "gamma": GAMMA} for s in (0, 5, 13, 23)],
    mistakes=[
        Mistake("the bias is missing: these are the preferences of softmax regression without it.",
                lambda q, shape, s, r_max, gamma: q[s] * 100 * (1 - gamma) / r_max),
        Mistake("this is the bias alone. What the state itself has learned counts, too: Q(s) + bias(s).",
                lambda q, shape, s, r_max, gamma: bias_of(q, shape, s) * 100 * (1 - gamma) / r_max),
        Mistake("Q(s) + bias(s) still has to be normalised: times 100 / Qmax.",
                lambda q, shape, s, r_max, gamma: q[s] + bias_of(q, shape, s)),
        Mistake("only Q(s) was normalised. The bias is made of Q values, too: first add, then normalise.",
                lambda q, shape, s, r_max, gamma: q[s] * 100 * (1 - gamma) / r_max + bias_of(q, shape, s)),
        Mistake("only the bias was normalised: brackets around Q(s) + bias(s) are missing.",
                lambda q, shape, s, r_max, gamma: q[s] + bias_of(q, shape, s) * 100 * (1 - gamma) / r_max),
        Mistake("Qmax is Rmax / (1 − γ), the most that can be earned from here on, not Rmax.",
                lambda q, shape, s, r_max, gamma: (q[s] + bias_of(q, shape, s)) * 100 / r_max),
        Mistake("this is the mean of Q(s) and bias(s). QBIASSR takes their sum.",
                lambda q, shape, s, r_max, gamma: (q[s] + bias_of(q, shape, s)) * 50 * (1 - gamma) / r_max),
    ],
)  # fmt: skip


def _draw(p, u):
    return int(np.searchsorted(np.cumsum(p), u, side="right").clip(max=len(p) - 1))


def _choose(q, shape, s, temperature, r_max, gamma, u):
    return _draw(probabilities(_preferences(q, shape, s, r_max, gamma), temperature), u)


# values so close to one another, and numbers u so spread, that every wrong way to choose shows somewhere
_CHOICES = [
    {"q": Q / 10, "shape": SHAPE, "s": s, "temperature": temperature, "r_max": R_MAX, "gamma": GAMMA, "u": u}
    for temperature in (0.4, 3.0)
    for s, u in zip(range(0, 24, 2), (0.5, 0.05, 0.95, 0.3, 0.7, 0.6, 0.4, 0.8, 0.2, 0.55, 0.35, 0.65), strict=True)
]

choose = Exercise(
    task="return the action that QBIASSR takes in s, drawn with the number u",
    right=_choose,
    returns="action",
    tape=_CHOICES,
    mistakes=[
        Mistake("the best action is not always taken: draw one, with the probabilities of the softmax.",
                lambda q, shape, s, temperature, r_max, gamma, u: int(
                    _preferences(q, shape, s, r_max, gamma).argmax())),
        Mistake("the temperature plays no part in your choice: it goes into the softmax.",
                lambda q, shape, s, temperature, r_max, gamma, u: _choose(q, shape, s, 1.0, r_max, gamma, u)),
        Mistake("your choice does not know the bias.",
                lambda q, shape, s, temperature, r_max, gamma, u: _draw(
                    probabilities(q[s] * 100 * (1 - gamma) / r_max, temperature), u)),
        Mistake("the preferences are not normalised by 100 / Qmax.",
                lambda q, shape, s, temperature, r_max, gamma, u: _draw(
                    probabilities(q[s] + bias_of(q, shape, s), temperature), u)),
        Mistake("all actions are equally probable in your choice. Are the preferences handed to the softmax?",
                lambda q, shape, s, temperature, r_max, gamma, u: int(u * q.shape[1])),
    ],
)  # fmt: skip


def _library(env, shape, n_actions, r_max, steps, rng, loop_evasion):
    """The library's agent in the learner's world: what a right answer equals, number for number."""
    agent = Agent(Size(shape, n_actions, r_max), "TOSL+QBIASSR", traces="full", loop_evasion=loop_evasion)
    agent.rng = rng
    s = env.reset()
    a = agent.begin_episode(s)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        a_next, _ = agent.learn_step(s, a, r, s_next, terminated)
        s, a = s_next, a_next
        if terminated or truncated:
            s = env.reset()
            a = agent.begin_episode(s)
    return agent.q.copy()


def _learn(env, shape, n_actions, r_max, steps, rng):
    return _library(env, shape, n_actions, r_max, steps, rng, loop_evasion=False)


def _learn_and_evade(env, shape, n_actions, r_max, steps, rng):
    return _library(env, shape, n_actions, r_max, steps, rng, loop_evasion=True)


def _variant(changed: str):
    """A program in the learner's own words with one thing changed."""
    evade = changed.startswith("evade")

    def learner(env, shape, n_actions, r_max, steps, rng):
        q, e, q_old = np.zeros((np.prod(shape), n_actions)), np.zeros((np.prod(shape), n_actions)), 0.0
        temperature, states, rewards = 1.0, [], []
        length = 21 if changed == "evade: long queue" else int(max(4, min(21, len(q) // 4)))

        def choice(s):
            x = (q[s] + (0 if changed == "no bias" else bias_of(q, shape, s))) * 100 * (1 - GAMMA) / r_max
            return _draw(probabilities(x, temperature), rng.random())

        s = env.reset()
        a = choice(s)
        for _ in range(steps):
            s_next, r, terminated, truncated = env.step(a)
            if evade:
                states.append(s if changed == "evade: old state" else s_next)
                rewards.append(r)
                del states[:-length], rewards[:-length]
                full = len(states) == length or changed == "evade: not full"
                redundancy = len(states) / len(set(states))
                if full and states.count(s_next) > 1 and sum(rewards) < 0 and redundancy > 2:
                    temperature = min(HOTTEST, temperature + 0.25 * redundancy)
                elif changed != "evade: never cools":
                    temperature = 1.0
            a_next = 0 if changed == "late choice" else choice(s_next)
            if changed == "late choice":
                a_next = int(q[s_next].argmax())
            q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
            delta = r + GAMMA * q_next - q_sa
            e[s, a] = (1 - ALPHA) * e[s, a] + 1
            q += ALPHA * (delta + q_sa - q_old) * e
            q[s, a] -= ALPHA * (q_sa - q_old)
            e *= GAMMA * LAM
            q_old = 0.0 if changed == "lost q_old" else q_next
            s, a = s_next, choice(s_next) if changed in ("late choice", "second choice") else a_next
            if (terminated or truncated) and changed != "no reset":
                if changed not in ("old traces", "old e"):
                    e[:] = 0.0
                if changed != "old traces":
                    q_old = 0.0
                if changed != "evade: old queue":
                    temperature, states, rewards = 1.0, [], []
                s = env.reset()
                a = a if changed == "old action" else choice(s)
        return q

    return learner


def _tape():
    world = RobotWorld("worked_example", seed=0)
    about = {"env": world, "shape": world.shape, "n_actions": world.n_actions, "r_max": world.r_max}
    return [about | {"rng": np.random.default_rng(seed), "steps": n} for n, seed in ((1, 0), (5, 1), (40, 2), (300, 3))]


learn = Exercise(
    task="let TOSL+QBIASSR learn for a number of steps, and return q",
    right=_learn,
    returns="q",
    tape=_tape(),
    mistakes=[
        Mistake("the actions are chosen without the bias.", _variant("no bias")),
        Mistake(
            "the action a' that you learned from must be the one that is taken next. Here another one is drawn for the "
            "step, so two numbers are drawn where there should be one.",
            _variant("second choice"),
        ),
        Mistake("a' must be chosen before the update, which learns from it; here it learns from the best action.",
                _variant("late choice")),
        Mistake("as a new episode starts, the traces and Q_old start afresh: e is 0 and Q_old is 0.",
                _variant("old traces")),
        Mistake("as a new episode starts, the traces start afresh: e is 0.", _variant("old e")),
        Mistake("after a reset the robot stands elsewhere: the action that it still holds was meant for another state. "
                "Choose a new one.", _variant("old action")),
        Mistake("Q_old stays at 0 here. Your true_online_update returns the new one: keep it.",
                _variant("lost q_old")),
        Mistake("where an episode has ended, reset the world, and choose an action for its first state.",
                _variant("no reset")),
    ],
)  # fmt: skip

learn_and_evade = Exercise(
    task="let TOSL+QBIASSR with loop evasion learn for a number of steps, and return q",
    right=_learn_and_evade,
    returns="q",
    tape=_tape(),
    mistakes=[
        Mistake("this is learning without loop evasion. Is the temperature changed before a' is chosen?",
                _variant("none")),
        Mistake("the temperature never falls. When there is no loop, it goes back to its default at once.",
                _variant("evade: never cools")),
        Mistake("as a new episode starts, the queue starts afresh, and so does the temperature.",
                _variant("evade: old queue")),
        Mistake("the queue has as many places as there are traces, 21, but at most a quarter of the states: here 6.",
                _variant("evade: long queue")),
        Mistake("a queue that is not full yet says nothing: keep the temperature at its default until it is.",
                _variant("evade: not full")),
        Mistake("what goes into the queue is the state that the step led to, s', with the reward it brought.",
                _variant("evade: old state")),
    ],
)  # fmt: skip


def _p_value(observed, shuffled):
    return float(np.mean(np.asarray(shuffled) >= observed))


p_value = Exercise(
    task="return the share of the shuffled numbers that are at least as large as the observed one",
    right=_p_value,
    returns="p",
    tape=[
        {"observed": 3.0, "shuffled": np.array([0.2, 1.1, 3.0, 0.7, 5.2, 0.1, 0.4, 2.9, 0.6, 1.5])},
        {"observed": 26.0, "shuffled": np.array([0.5, 1.5, 2.5, 0.1])},
        {"observed": 0.5, "shuffled": np.array([0.5, 1.5, 2.5, 0.1, 0.9])},
    ],
    mistakes=[
        Mistake("this is the share that is smaller. A small p must mean: chance hardly ever gets that far.",
                lambda observed, shuffled: np.mean(shuffled < observed)),
        Mistake("at least as large: those that equal the observed one count, too.",
                lambda observed, shuffled: np.mean(shuffled > observed)),
        Mistake("this is how many they are; divide by how many were shuffled.",
                lambda observed, shuffled: np.sum(shuffled >= observed)),
        Mistake("this is the share that is at most as large as the observed one: the other side.",
                lambda observed, shuffled: np.mean(shuffled <= observed)),
        Mistake("this is in per cent. A share lies between 0 and 1.",
                lambda observed, shuffled: 100 * np.mean(shuffled >= observed)),
        Mistake("this is the mean of the shuffled numbers. Compare each with the observed one first.",
                lambda observed, shuffled: np.mean(shuffled)),
    ],
)  # fmt: skip
