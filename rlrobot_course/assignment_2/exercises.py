"""Right answers and tapes of assignment 2; the pages of this folder have the tasks, hints and mistakes."""

import numpy as np

from rlrobot_course.exercises.parts import (
    Case,
    Exercise,
    Mistake,
    Question,
    with_pages,
    wrong_choices,
)
from rlrobot_course.worlds.callbacks import Chooser, Weighing
from rlrobot_course.worlds.tapes import (
    FINE_ALPHA,
    FINE_FOR_Q,
    FINE_GAMMA,
    Q_START,
    Q_TAPE,
    PatientWorld,
    rows,
    with_columns,
)


def epsilon_at(t, start, end, half_life):
    return end + (start - end) * 0.5 ** (t / half_life)


def other_moment(rng: np.random.Generator, case: Case) -> Case:
    """A case of `epsilon_at` with another beginning and end, and at another moment unless it is the first."""
    start, end = sorted(rng.uniform(0.01, 0.99, 2), reverse=True)
    t = case["t"] and case["t"] + int(rng.integers(1, 9))
    return {
        "t": t,
        "start": float(start),
        "end": float(end),
        "half_life": case["half_life"] + int(rng.integers(5)),
    }


def policy_value(q_s, temperature):
    powers = np.exp((q_s - q_s.max()) / temperature)
    return sum(powers * q_s) / sum(powers)


LARGEST, COLDEST = 1000.0, 0.1  # as the text promises


def other_row(rng: np.random.Generator, case: Case) -> Case:
    """A case of `policy_value` with other values and warmer; what is at an end of what is promised stays there."""
    q_s, temperature = case["q_s"], case["temperature"]
    shift, heat = rng.uniform(-0.04, 0.04), rng.uniform(1.0, 1.5)
    return {
        "q_s": np.where(np.abs(q_s) < LARGEST, q_s + shift, q_s),
        "temperature": temperature if temperature == COLDEST else temperature * heat,
    }


who = [3, 2, 1, 0]
LEARNED = ("it cannot be told", "Q-learning", "SARSA", "expected SARSA")
CLUES = (
    "A went to 2.35: a half of the way to a target of 2.7. So what did s' count as: the best, that of a', or the mean "
    "of the policy?",
    "B stayed at 2.0, so its target was 2. What did s' count as?",
    "C went to 2.5: its target was 3. What did s' count as?",
    "D's step has terminated. Which of the three looks at s' then?",
)
EXAMPLE = Mistake(
    "that was only to show how it is written. Which target has each of the four gone half of the way to?",
    [1, 1, 1, 1],
)


def double_update(q1, q2, s, a, r, s_next, terminated, heads, alpha, gamma):
    learns, judges = (q1, q2) if heads else (q2, q1)
    best = learns[s_next].argmax()
    target = r if terminated else r + gamma * judges[s_next, best]
    learns[s, a] += alpha * (target - learns[s, a])


OTHER = np.array(
    [[1.0, 0.5, 2.5], [-2.0, 6.5, 3.4567], [4.5, 0.0, -1.0], [8.0, 2.0, 3.0]]
)
HEADS = (True, False, True, False, True, True, False, False, False)
ALPHAS = (0.1, 0.5, 0.25, 0.1, 0.4, 0.3, 0.7, 0.05, 0.2)
GAMMAS = (0.9, 0.5, 0.8, 0.9, 0.9, 0.95, 0.9, 0.6, 0.9)


def double_learn(env, q1, q2, choose, toss, episodes, alpha, gamma):
    for _ in range(episodes):
        s, over = env.reset(), False
        while not over:
            a = choose(q1 + q2, s)
            s_next, r, terminated, truncated = env.step(a)
            double_update(q1, q2, s, a, r, s_next, terminated, toss(), alpha, gamma)
            s, over = s_next, terminated or truncated


class Coin:
    """Falls as given beforehand, again and again."""

    def __init__(self, *falls: bool) -> None:
        self.falls, self.n = falls, 0

    def __call__(self) -> bool:
        """Toss: True for heads."""
        self.n += 1
        return self.falls[(self.n - 1) % len(self.falls)]


check = with_pages(
    globals(),
    epsilon_at=Exercise(
        epsilon_at,
        returns="epsilon",
        tape=rows(
            "t start end half_life",
            (0, 0.9, 0.1, 10),
            (10, 0.9, 0.1, 10),
            (20, 0.5, 0.25, 10),
            (7, 1.0, 0.05, 20),
            (301, 0.75, 0.5, 4),
            (5, 0.625, 0.0, 2),
            (3, 0.91234, 0.12345, 7),
        ),
        another=other_moment,
    ),
    policy_value=Exercise(
        policy_value,
        returns="value",
        tape=rows(
            "q_s[] temperature",
            ([1.0, 2.5], 0.75),
            ([1.0, 2.5, -3.0], 20.0),
            ([0.5, -0.5, 0.25, 1.5], 0.125),
            ([2.5, 2.5], 1.5),
            ([900.5, 899.5, 100.25], 0.5),
            ([-7.5, -6.25, -9.5], 2.5),
            ([1.23456, -0.98765, 0.54321], 0.87654),
            # as large and as cold as is promised
            ([1000.0, 0.0, 0.0], 0.1),
            ([-1000.0, 999.95, 1000.0], 0.1),
            ([-1000.0, -999.95], 0.1),
        ),
        another=other_row,
    ),
    who=Question(who, mistakes=wrong_choices(who, range(len(LEARNED)), CLUES, EXAMPLE)),
    double_update=Exercise(
        double_update,
        memory={"q1": Q_START, "q2": OTHER},
        tape=with_columns(
            (*Q_TAPE, *3 * FINE_FOR_Q),
            heads=(*HEADS, True, False, True),
            alpha=(*ALPHAS, FINE_ALPHA, 0.3, 0.2),
            gamma=(*GAMMAS, FINE_GAMMA, 0.0, 0.99),
        ),
    ),
    double_learn=Exercise(
        double_learn,
        memory={"env": PatientWorld(), "q1": Q_START, "q2": OTHER},
        tape=rows(
            "choose toss episodes alpha gamma",
            (Chooser(0), Coin(True, False), 1, 0.5, 0.9),
            (Chooser(1), Coin(False, True, True), 2, 0.25, 0.8),
            (Chooser(2), Coin(False, False, True), 3, 0.4, 0.7),
            (Weighing(1), Coin(True, False, True, True), 3, FINE_ALPHA, FINE_GAMMA),
            (Weighing(0), Coin(True, False), 1, 0.3, 0.0),
            (Weighing(2), Coin(False, True), 1, 0.2, 0.99),
        ),
    ),
)
