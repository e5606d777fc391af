"""Exercises of assignment 2: ε that fades, the value of a policy, who has learned, and double Q-learning."""

from __future__ import annotations

from itertools import product

import numpy as np

from rlrobot_edu.course.assignment_2 import mistakes, solutions
from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.grading.replay import Case
from rlrobot_edu.course.grading.tapes import Q_START, TAPE, Chooser, PatientWorld


def other_moment(rng: np.random.Generator, case: Case) -> Case:
    """A case of `epsilon_at` with another beginning and end, and at another moment unless it is the first."""
    start, end = sorted(rng.uniform(0.01, 0.99, 2), reverse=True)
    t = case["t"] and case["t"] + int(rng.integers(1, 9))
    return {"t": t, "start": float(start), "end": float(end), "half_life": case["half_life"] + int(rng.integers(5))}


epsilon_at = Exercise(
    task="return ε at step t: it begins at start, and its distance to end is halved every half_life steps",
    right=solutions.epsilon_at,
    returns="epsilon",
    tape=[
        {"t": 0, "start": 0.9, "end": 0.1, "half_life": 10},
        {"t": 10, "start": 0.9, "end": 0.1, "half_life": 10},
        {"t": 20, "start": 0.5, "end": 0.25, "half_life": 10},
        {"t": 7, "start": 1.0, "end": 0.05, "half_life": 20},
        {"t": 301, "start": 0.75, "end": 0.5, "half_life": 4},
        {"t": 5, "start": 0.625, "end": 0.0, "half_life": 2},
    ],
    mistakes=mistakes.EPSILON_AT,
    another=other_moment,
    hints=(
        "What is halved again and again is the distance to end. How large is it at the start, and how often is it "
        "halved until t?",
        "The distance is start - end, and it is halved t / half_life times: 0.5 ** (t / half_life).",
        "end + (start - end) * …: only the power is missing.",
    ),
    gained="It never gets below end: a robot that must go on learning keeps an open mind.",
)

policy_value = Exercise(
    task="return the mean of the values in q_s, each with the probability that softmax gives its action",
    right=solutions.policy_value,
    returns="value",
    tape=[
        {"q_s": np.array([1.0, 2.5]), "temperature": 0.75},
        {"q_s": np.array([1.0, 2.5, -3.0]), "temperature": 20.0},
        {"q_s": np.array([0.5, -0.5, 0.25, 1.5]), "temperature": 0.125},
        {"q_s": np.array([2.5, 2.5]), "temperature": 1.5},
        {"q_s": np.array([900.5, 899.5, 100.25]), "temperature": 0.5},
        {"q_s": np.array([-7.5, -6.25, -9.5]), "temperature": 2.5},
    ],
    mistakes=mistakes.POLICY_VALUE,
    hints=(
        "Two steps: the probabilities that softmax gives, as in lesson 03, and then the mean in which each value "
        "counts with its probability.",
        "powers = np.exp((q_s - q_s.max()) / temperature): nothing gets too large so, and the probabilities are "
        "powers / sum(powers).",
        "sum(powers * q_s) / …: what is it divided by, so that the probabilities sum to 1?",
    ),
    gained="With T near 0 this is the maximum of Q-learning, with a very large T the plain mean. In between it is the "
    "target of a robot that counts its own curiosity in.",
)

LEARNED = ("it cannot be told", "Q-learning", "SARSA", "expected SARSA")
CLUES = (
    "A went to 2.35: a half of the way to a target of 2.7. So what did s' count as: the best, that of a', or the mean "
    "of the policy?",
    "B stayed at 2.0, so its target was 2. What did s' count as?",
    "C went to 2.5: its target was 3. What did s' count as?",
    "D's step has terminated. Which of the three looks at s' then?",
)
EXAMPLE = [1, 1, 1, 1]

who = Question(
    task="for each of the robots A, B, C and D a number from 0 to 3, such as [1, 1, 1, 1]",
    right=solutions.who,
    because="3.4, the mean of the policy, makes the target 2.7; Q(s', a') = 2 makes it 2; the best, 4, makes it 3; and "
    "D's target is r alone, whoever it is.",
    mistakes=[
        Mistake("that was only to show how it is written. Which target has each of the four gone half of the way to?",
                EXAMPLE),
        *(
            Mistake(CLUES[next(i for i in range(4) if tried[i] != solutions.who[i])], list(tried))
            for tried in product(range(len(LEARNED)), repeat=4)
            if list(tried) not in (EXAMPLE, solutions.who)
        ),
    ],
    hints=(
        "Turn the update round: with α = 0.5 the target is as far beyond the new value as that is beyond the old one.",
        "The target is 1 + 0.5 · (what s' counts as): 4 for Q-learning, 2 for SARSA, and the mean of the policy, "
        "0.7 · 4 + 0.3 · (4 + 0 + 2) / 3, for expected SARSA.",
        "The targets were 2.7, 2, 3 and 1, and expected SARSA is number 3.",
    ),
    gained="From a number before and after one can often tell what a program does, whatever its comments say.",
)  # fmt: skip

OTHER = np.array([[1.0, 0.5, 2.5], [-2.0, 6.5, 3.5], [4.5, 0.0, -1.0], [8.0, 2.0, 3.0]])
HEADS = (True, False, True, False, True, True, False, False, False)
ALPHAS = (0.1, 0.5, 0.25, 0.1, 0.4, 0.3, 0.7, 0.05, 0.2)
GAMMAS = (0.9, 0.5, 0.8, 0.9, 0.9, 0.95, 0.9, 0.6, 0.9)

double_update = Exercise(
    task="change the table that the coin has picked: its best action of s' counts as the other table says",
    right=solutions.double_update,
    memory={"q1": Q_START, "q2": OTHER},
    tape=[
        {name: row[name] for name in ("s", "a", "r", "s_next", "terminated")}
        | {"heads": heads, "alpha": alpha, "gamma": gamma}
        for row, heads, alpha, gamma in zip(TAPE, HEADS, ALPHAS, GAMMAS, strict=True)
    ],
    mistakes=mistakes.DOUBLE_UPDATE,
    hints=(
        "Write it for heads first: q1 learns. Its own argmax picks the action of s', and q2 tells what that is worth.",
        "To write it once only: learns, judges = (q1, q2) if heads else (q2, q1).",
        "best = learns[s_next].argmax(); the target is r, or r + gamma * judges[s_next, best]; then learns[s, a] += …",
    ),
    gained="Two tables, and each is judged by one that had other luck.",
)


class Coin:
    """Falls as it was told beforehand, again and again."""

    def __init__(self, *falls: bool) -> None:
        self.falls, self.n = falls, 0

    def __call__(self) -> bool:
        """Toss: True for heads."""
        self.n += 1
        return self.falls[(self.n - 1) % len(self.falls)]


double_learn = Exercise(
    task="learn for so many episodes with two tables, choosing by their sum, with a toss for each step",
    right=solutions.double_learn,
    memory={"env": PatientWorld(), "q1": Q_START, "q2": OTHER},
    lenders={"double_update": "your function of exercise 4"},
    tape=[
        {"choose": Chooser(rank), "toss": Coin(*falls), "episodes": n, "alpha": alpha, "gamma": gamma}
        for rank, falls, n, alpha, gamma in (
            (0, (True, False), 1, 0.5, 0.9),
            (1, (False, True, True), 2, 0.25, 0.8),
            (2, (False, False, True), 3, 0.4, 0.7),
        )
    ],
    mistakes=mistakes.DOUBLE_LEARN,
    hints=(
        "The loop of lesson 02, by episodes, with two tables: what chooses, and what learns, in each step?",
        "Inside: a = choose(q1 + q2, s), then the step, then double_update(…, toss(), alpha, gamma), then go on.",
        "s, over = env.reset(), False; while not over: …; and the last line is s, over = s_next, terminated or "
        "truncated.",
    ),
    gained="That is double Q-learning (van Hasselt, 2010). Below, a hundred robots try it.",
)  # fmt: skip
