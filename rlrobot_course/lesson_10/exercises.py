"""Right answers and tapes of lesson 10; the pages of this folder have the tasks, hints and mistakes."""

from functools import partial

import numpy as np

from rlrobot_course.exercises.parts import Case, Exercise, with_pages
from rlrobot_course.lesson_04.exercises import draw, softmax
from rlrobot_course.lesson_05.exercises import bias
from rlrobot_course.lesson_08.exercises import true_online_update
from rlrobot_course.lesson_09.exercises import new_temperature
from rlrobot_course.lesson_10.fixtures import (
    ENDS,
    FINE,
    FINELY,
    OTHER,
    OTHERS,
    SHAPE,
    USUAL,
    P,
    Q,
    drives,
    library,
    ring,
    sharp,
)
from rlrobot_course.worlds.tapes import HAIR, SMALL, rows


def preferences(q, shape, s, r_max, gamma):
    q_max = r_max / (1 - gamma)
    return (q[s] + bias(q, shape, s)) * 100 / q_max


def choose(q, shape, s, temperature, r_max, gamma, u):
    return draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)


def at_the_border(
    q: np.ndarray,
    shape: tuple[int, ...],
    temperature: float,
    r_max: float,
    gamma: float,
    hair: float = 0.02,
) -> list[Case]:
    """Cases in which u lies just below, or just above, the border between two actions, by so much.

    So whoever computes other probabilities takes another action in one of the two.
    """
    cases: list[Case] = []
    for s in range(0, len(q), len(q) // 6):
        p = softmax(preferences(q, shape, s, r_max, gamma), temperature)
        border = min(np.cumsum(p)[:-1], key=lambda reached: abs(reached - 0.5))
        about = {
            "q": q,
            "shape": shape,
            "s": s,
            "temperature": temperature,
            "r_max": r_max,
            "gamma": gamma,
        }
        if 0.05 < border < 0.95:
            cases += [about | {"u": float(border) + beside} for beside in (-hair, hair)]
    return cases


CHOICES = [
    case
    for q, shape, temperature, r_max, gamma in (
        (SMALL, (2, 3), 12.0, 10.0, 0.8),
        (Q, SHAPE, 10.0, 4.0, 0.9),
        (P, OTHER, 12.0, 6.0, 0.8),
        (Q, SHAPE, 3.0, 20.0, 0.95),
        (P, OTHER, 20.0, 10.0, 0.5),
        (Q / 10, SHAPE, 0.5, 4.0, 0.9),
    )
    for case in at_the_border(q, shape, temperature, r_max, gamma)
]
CHOICES += at_the_border(Q, SHAPE, 30.0, 4.0, 0.0)
CHOICES += at_the_border(Q, SHAPE, 1.0, 4.0, 0.99)
CHOICES += at_the_border(FINE, SHAPE, 11.73519, 3.45678, 0.87654, HAIR)
CHOICES += [{**CHOICES[-1], "u": u} for u in (0.0, 0.99999)]


def learn(env, shape, n_actions, r_max, steps, rng, alpha, gamma, lam, temperature):
    q = np.zeros((np.prod(shape), n_actions))
    e, q_old = np.zeros_like(q), 0.0

    def act(s):
        return choose(q, shape, s, temperature, r_max, gamma, rng.random())

    s = env.reset()
    a = act(s)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        a_next = act(s_next)
        q_old = true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)  # fmt: skip
        s, a = s_next, a_next
        if terminated or truncated:
            e[:], q_old = 0.0, 0.0
            s = env.reset()
            a = act(s)
    return q


def learn_and_evade(
    env, shape, n_actions, r_max, steps, rng, alpha, gamma, lam, default
):
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
        q_old = true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)  # fmt: skip
        s, a = s_next, a_next
        if terminated or truncated:
            e[:], q_old = 0.0, 0.0
            states, rewards, temperature = [], [], default
            s = env.reset()
            a = act(s)
    return q


# γ and λ at the ends of what the lessons say of them
AT_ENDS = (
    {"alpha": 0.2, "gamma": 0.0, "lam": 0.9},
    {"alpha": 0.2, "gamma": 0.99, "lam": 1.0},
    {"alpha": 0.2, "gamma": 0.9, "lam": 0.0},
)
# Rings of 22 and 18 states, which are no multiples of four; and rewards whose mean says something else than their
# signs, or than rewards that are rounded.
UNEVEN = (
    ((2, 11), (6.0, -0.3, -0.4, -0.2, -0.3, -0.45)),
    ((3, 6), (-6.2, 0.3, 0.4, 0.2, 0.45)),
    ((2, 11), (1.5051, -0.3044, -0.3044, -0.6044, -0.3044)),
)

check = with_pages(
    globals(),
    preferences=Exercise(
        preferences,
        returns="preferences",
        tape=rows(
            "q shape s r_max gamma",
            (SMALL, (2, 3), 4, 4.0, 0.8),
            (Q, SHAPE, 13, 4.0, 0.8),
            (Q, SHAPE, 0, 4.0, 0.9),
            (P, OTHER, 5, 10.0, 0.5),
            (P, OTHER, 11, 7.0, 0.95),
            (Q, SHAPE, 23, 0.5, 0.9),
            (Q, SHAPE, 5, 10.0, 0.0),
            (FINE, SHAPE, 17, 3.45678, 0.87654),
            (Q, SHAPE, 9, 4.0, 0.99),
            # of state 7 nothing is known but one action
            (
                np.where(np.arange(12)[:, None] == 7, [[0.0, 2.5, 0.0, 0.0]], P),
                OTHER,
                7,
                4.0,
                0.8,
            ),
        ),
    ),
    choose=Exercise(choose, returns="action", tape=CHOICES),
    learn=Exercise(
        learn,
        library=partial(library, learn),
        returns="q",
        tape=drives(
            [
                ring((3, 4), ENDS, 10, **USUAL, temperature=1.0),
                ring((4, 5), ENDS[::-1], 80, **OTHERS, temperature=4.0),
                sharp(
                    learn,
                    preferences,
                    ring((3, 6), ENDS, 40, **FINELY, temperature=2.34567),
                ),
                *(ring((3, 4), ENDS, 10, **ends, temperature=1.0) for ends in AT_ENDS),
            ],
            "temperature",
        ),
    ),
    learn_and_evade=Exercise(
        learn_and_evade,
        library=partial(library, learn_and_evade, loop_evasion=True),
        returns="q",
        tape=drives(
            [
                ring((3, 4), ENDS, 10, **USUAL, default=1.0),
                ring((4, 5), ((11, False), (9, True)), 34, 6, **OTHERS, default=0.02),
                ring((10, 12), ((50, False),), 66, 12, **USUAL, default=0.02),
                ring((3, 4), ((50, False),), 40, 6, **USUAL, default=0.02),
                ring((10, 12), ((56, False),), 66, 3, **USUAL, default=0.02, r_max=2.0),
                *(
                    sharp(
                        learn_and_evade,
                        preferences,
                        ring(
                            shape,
                            ((23, False),),
                            60,
                            7,
                            pays,
                            **FINELY,
                            default=0.54321,
                        ),
                    )
                    for shape, pays in UNEVEN
                ),
                *(ring((3, 4), ENDS, 10, **ends, default=1.0) for ends in AT_ENDS),
            ],
            "default",
        ),
    ),
)
