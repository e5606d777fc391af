"""The whole learner with loop evasion."""

from __future__ import annotations

from functools import partial

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.lesson_03.solutions import (
    draw,  # noqa: F401  (a mistake calls it)
    softmax,  # noqa: F401  (a mistake calls it)
)
from rlrobot_course.lesson_06.solutions import true_online_update
from rlrobot_course.lesson_07.solutions import bias  # noqa: F401  (a mistake calls it)
from rlrobot_course.lesson_08.solutions import new_temperature
from rlrobot_course.lesson_09.exercises.choose import choose
from rlrobot_course.lesson_09.exercises.preferences import preferences  # noqa: F401  (a mistake calls it)
from rlrobot_course.lesson_09.given import ABOVE, ENDS, LENDERS, OTHERS, USUAL, drives, library, ring
from rlrobot_course.lesson_09.learners import COMMON


def learn_and_evade(env, shape, n_actions, r_max, steps, rng, alpha, gamma, lam, default):
    q = np.zeros((np.prod(shape), n_actions))
    e, q_old = np.zeros_like(q), 0.0
    length = max(4, min(21, len(q) // 4))
    states, rewards, temperature = [], [], default

    def act(s):
        return choose(q, shape, s, temperature, r_max, gamma, rng.random())

    s = env.reset()
    a = act(s)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        states, rewards = [*states, s_next][-length:], [*rewards, r][-length:]
        if len(states) == length:
            temperature = new_temperature(temperature, states, rewards, s_next, default)
        a_next = act(s_next)
        q_old = true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)
        s, a = s_next, a_next
        if terminated or truncated:
            e[:], q_old = 0.0, 0.0
            states, rewards, temperature = [], [], default
            s = env.reset()
            a = act(s)
    return q


CHANGED, WITNESSES = read_answers(
    __file__, {"choose": choose, "new_temperature": new_temperature, "true_online_update": true_online_update}
)

exercise = Exercise(
    task="let TOSL+QBIASSR with loop evasion learn for a number of steps, and return q",
    right=learn_and_evade,
    library=partial(library, learn_and_evade, loop_evasion=True),
    returns="q",
    lenders=LENDERS | ABOVE | {"push": "not needed here: [*states, s_next][-length:] does it"},
    tape=drives(
        [
            ring((3, 4), ENDS, 10, **USUAL, default=1.0),
            ring((4, 5), ((11, False), (9, True)), 34, 6, **OTHERS, default=0.02),
            ring((10, 12), ((50, False),), 66, 12, **USUAL, default=0.02),
            ring((3, 4), ((50, False),), 40, 6, **USUAL, default=0.02),
            ring((10, 12), ((56, False),), 66, 3, **USUAL, default=0.02, r_max=2.0),
        ],
        "default",
    ),
    mistakes={
        "no_evasion": Mistake(
            "this is learning without loop evasion. Is the temperature changed before a' is chosen?",
            {"if len(states) == length": "if False"},
        ),
        "stays_hot": Mistake(
            "the temperature never falls. When there is no loop, it goes back to its default at once.",
            {"s_next, default)": "s_next, temperature)"},
        ),
        "keeps_queue_and_temperature": Mistake(
            "as a new episode starts, the queue starts afresh, and so does the temperature.",
            CHANGED["keeps_queue_and_temperature"],
        ),
        "keeps_temperature": Mistake(
            "as a new episode starts, the temperature is back at its default, too.", CHANGED["keeps_temperature"]
        ),
        "keeps_queue": Mistake("as a new episode starts, the queues are empty again, too.", CHANGED["keeps_queue"]),
        "no_quarter_of_the_states": Mistake(
            "the queue has as many places as there are traces, 21, but at most a quarter of the states.",
            {"max(4, min(21, len(q) // 4))": "21"},
        ),
        "no_21": Mistake(
            "the queue has a quarter of the number of states as places, but never more than 21.",
            {"max(4, min(21, len(q) // 4))": "max(4, len(q) // 4)"},
        ),
        "acts_before_full": Mistake(
            "a queue that is not full yet says nothing: keep the temperature at its default until it is.",
            {"if len(states) == length": "if True"},
        ),
        "pushes_s": Mistake(
            "what goes into the queue is the state that the step led to, s', with the reward it brought.",
            {"[*states, s_next]": "[*states, s]"},
        ),
        "asks_about_s": Mistake(
            "new_temperature asks about s', which has just been pushed, not about s.",
            {"rewards, s_next, default": "rewards, s, default"},
        ),
        "queue_grows": Mistake("the queues grow without end. Keep the latest: [-length:].", {"[-length:]": ""}),
        "keeps_the_oldest": Mistake(
            "the queues keep their oldest entries for ever. The latest are at the end: [-length:].",
            {"[-length:]": "[:length]"},
        ),
        "chooses_too_early": Mistake(
            "a' is chosen before the temperature changes, so the heat comes a step too late. Ask "
            "new_temperature first.",
            {
                "        if len(states) == length": "        a_next = act(s_next)\n        if len(states) == length",
                "        a_next = act(s_next)\n": "",
            },
        ),
        "from_the_default": Mistake(
            "the temperature rises from where it is, not from the default: keep what new_temperature returns.",
            {"new_temperature(temperature": "new_temperature(default"},
        ),
        **COMMON,
    },
    hints=(
        "Three lines come on top of your learn: before the loop, after env.step, and where an episode ends.",
        "After env.step: both queues take what has come, and if they are full, temperature = new_temperature(…).",
        "if len(states) == length: temperature = new_temperature(temperature, states, rewards, s_next, default)",
    ),
    gained="Nothing is missing now: what you have written is what rl.Agent does when you say nothing else.",
    witnesses=WITNESSES,
)
