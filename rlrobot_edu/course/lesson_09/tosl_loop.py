"""Lesson 09's largest exercises: the whole learner, TOSL+QBIASSR, without and with loop evasion."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise, Mistake
from rlrobot_edu.course.grading.tapes import RobotWorld, draw
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn as run
from rlrobot_edu.learning.loop_evasion import HOTTEST
from rlrobot_edu.learning.qbiassr import bias_of
from rlrobot_edu.learning.size import Size
from rlrobot_edu.learning.softmax import probabilities

ALPHA, GAMMA, LAM = 0.1, 0.9, 0.9


def _library(env, shape, n_actions, r_max, steps, rng, loop_evasion):
    """The library's agent in the learner's world: what a right answer equals, number for number."""
    agent = Agent(Size(shape, n_actions, r_max), "TOSL+QBIASSR", traces="full", loop_evasion=loop_evasion)
    agent.rng = rng
    run(agent, env.env, steps, progress=False)
    return agent.q


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
            return draw(probabilities(x, temperature), rng.random())

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
            a_next = int(q[s_next].argmax()) if changed == "late choice" else choice(s_next)
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
