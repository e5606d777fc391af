"""The return of n steps, which may reach the end of the episode."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def n_step_return(rewards, values, t, n, gamma):
    last = min(t + n, len(rewards))
    g = sum(gamma ** (k - t) * rewards[k] for k in range(t, last))
    if t + n < len(rewards):
        g += gamma**n * values[t + n]
    return g


REWARDS = [1.0, -2.5, 0.5, 3.0, 1.5]

VALUES = [4.0, 2.5, -1.0, 0.5, 6.0, 50.0]  # the last is of where nothing follows, and tempts those who look there

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return n rewards from step t on, discounted, and then what the state promises that follows",
    right=n_step_return,
    returns="G",
    tape=[
        {"rewards": REWARDS, "values": VALUES, "t": t, "n": n, "gamma": gamma}
        for t, n, gamma in (
            (0, 1, 0.5),
            (0, 3, 0.9),
            (1, 2, 0.8),
            (2, 3, 0.9),
            (3, 4, 0.7),
            (4, 1, 0.6),
            (1, 3, 0.95),
            (3, 1, 0.4),
        )
    ],
    mistakes={
        "past_the_end": Mistake(
            "the episode has an end: beyond it there are no rewards, and no value is counted. Stop there.",
            {"if t + n < len(rewards):": "if True:", "values[t + n]": "values[min(t + n, len(rewards))]"},
        ),
        "no_value": Mistake(
            "the value at step t + n is missing: what comes after the n rewards counts as the table says.",
            {"if t + n < len(rewards):": "if False:"},
        ),
        "value_at_the_end": Mistake(
            "where the n steps reach the end exactly, nothing follows any more: no value there.",
            {"if t + n < len(rewards):": "if t + n <= len(rewards):"},
        ),
        "gamma_once": Mistake(
            "the value lies n steps ahead: it counts γ to the power of n times.", {"gamma**n": "gamma"}
        ),
        "value_in_full": Mistake(
            "the value lies n steps ahead: it counts γ to the power of n times, where yours counts in full.",
            {"gamma**n * ": ""},
        ),
        "plain_sum": Mistake(
            "the rewards are not discounted: the k-th after t counts γ to the power of k times.",
            {"gamma ** (k - t) * ": ""},
        ),
        "from_the_start": Mistake(
            "the first reward counts in full: count the power from t on, not from the start of the episode.",
            {"(k - t)": "k"},
        ),
        "first_discounted": Mistake(
            "the first reward counts in full: its power of γ is 0.", {"(k - t)": "(k - t + 1)"}
        ),
        "value_too_early": Mistake(
            "the value is that of the state after n steps, values[t + n].", {"values[t + n]": "values[t + n - 1]"}
        ),
        "value_of_s": Mistake(
            "the value is that of the state after n steps, values[t + n]. Yours is where it began.",
            {"values[t + n]": "values[t]"},
        ),
        "one_reward_too_many": Mistake(
            "n rewards count, and yours are one more.", {"range(t, last)": "range(t, min(last + 1, len(rewards)))"}
        ),
        "rewards_before": Mistake(
            "rewards of before t do not count any more.", {"range(t, last)": "range(last)", "(k - t)": "abs(k - t)"}
        ),
    },
    hints=(
        "Two parts: the rewards of at most n steps, and a value, where the episode goes on after them.",
        "The rewards are those of the steps t to min(t + n, len(rewards)) − 1; the one of step k counts gamma ** (k - "
        "t) times.",
        "Below the sum: if t + n < len(rewards): g += gamma**n * values[t + n].",
    ),
    gained="From n = 1, which is TD, to the whole episode, which is the return itself: one function.",
    witnesses=WITNESSES,
)
