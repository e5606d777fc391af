"""The return of n steps."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def n_step_return(r, v, n, gamma):
    g = gamma**n * v[n]
    for k in range(n):
        g += gamma**k * r[k]
    return g


WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="add n rewards, each discounted, and the value after them, discounted, too",
    right=n_step_return,
    returns="return",
    tape=[
        {"r": np.array(r), "v": np.array(v), "n": n, "gamma": gamma}
        for r, v, n, gamma in (
            ((0.5, -2.0, 0.25, 10.0), (1.0, 2.5, 0.75, 4.0, 0.0), 2, 0.9),
            ((0.5, -2.0, 0.25, 10.0), (1.0, 2.5, 0.75, 4.0, 0.0), 1, 0.8),
            ((0.5, -2.0, 0.25, 10.0), (1.0, 2.5, 0.75, 4.0, 0.0), 4, 0.7),
            ((-1.0, -1.0, -1.0, -1.0, -1.0), (-3.1, -6.2, 1.7, -0.4, -2.9, 0.0), 3, 0.95),
            ((0.0, 0.0, 3.0), (0.6, -0.7, 0.2, 1.9), 2, 0.5),
        )
    ],
    hints=(
        "n real rewards, then believe the table once. How often has each been multiplied by γ?",
        "the reward k steps later is γ**k · r[k], for k = 0 … n − 1. What is believed after them is γ**n · v[n].",
        "sum(gamma**k * r[k] for k in range(n)) + gamma**n * …",
    ),
    gained="You hold the dial between SARSA (n = 1) and the whole return (n to the end). λ will turn it smoothly.",
    mistakes={
        "no_value": Mistake("the value after the n rewards is missing: add γⁿ · v[n].", {"gamma**n * v[n]": "0.0"}),
        "value_in_full": Mistake(
            "the value, too, is discounted: it lies n steps ahead, so it counts γⁿ times.", {"gamma**n * v[n]": "v[n]"}
        ),
        "gamma_once_for_value": Mistake(
            "the value lies n steps ahead, so it counts γⁿ times, not γ once.", {"gamma**n": "gamma"}
        ),
        "one_power_short": Mistake(
            "the value lies n steps ahead: γⁿ. You are one step short.", {"gamma**n": "gamma**(n - 1)"}
        ),
        "one_power_too_many": Mistake(
            "the value lies n steps ahead: γⁿ. This is one step too far.", {"gamma**n": "gamma**(n + 1)"}
        ),
        "value_too_early": Mistake(
            "this takes the value of the pair one step too early. After n rewards one stands at v[n].",
            {"v[n]": "v[n - 1]"},
        ),
        "value_now": Mistake(
            "this is the value of the pair now. What is believed comes after n rewards: v[n].", {"v[n]": "v[0]"}
        ),
        "plain_sum": Mistake(
            "the rewards are not discounted: the one k steps later counts γᵏ times.", {"gamma**k * r": "r"}
        ),
        "first_discounted": Mistake(
            "the first reward counts in full: r[0] is not discounted, r[1] counts γ times.",
            {"gamma**k": "gamma**(k + 1)"},
        ),
        "gamma_each": Mistake(
            "every reward counts γ times here. The one k steps later counts γᵏ times.", {"gamma**k": "gamma"}
        ),
        "one_reward_too_many": Mistake(
            "one reward too many: r[0] to r[n − 1] are n rewards.", {"range(n)": "range(n + 1)"}
        ),
        "one_reward_too_few": Mistake(
            "one reward is missing: r[0] to r[n − 1] are n rewards.", {"range(n)": "range(n - 1)"}
        ),
        "not_the_first": Mistake("the first reward is r[0]: Python counts from 0.", {"range(n)": "range(1, n)"}),
        "all_rewards": Mistake(
            "all rewards are added up, to the end of the episode. Only n of them are taken.",
            {"range(n)": "range(len(r))"},
        ),
        "last_alone": Mistake(
            "only the last of the n rewards is left: inside the loop it is +=.", {"g += gamma": "g = gamma"}
        ),
        "value_for_each": Mistake(
            "the value that is believed stands once at the end, not once for each reward.",
            {"g += gamma**k * r[k]": "g += gamma**k * r[k] + (gamma**n * v[n] if k else 0)"},
        ),
        "value_too_late": Mistake(
            "the value of the pair after the n rewards is v[n], not v[n + 1].", {"v[n]": "v[n + 1]"}
        ),
        "best_value": Mistake("the best value there is would be a guess. One stands at v[n].", {"v[n]": "max(v)"}),
        "one_step_short": Mistake(
            "you have looked one step too short: n rewards, and then v[n].",
            {"gamma**n * v[n]": "gamma**(n - 1) * v[n - 1]", "range(n)": "range(n - 1)"},
        ),
        "gamma_times_k": Mistake(
            "γ is raised to a power: k steps later it has been multiplied k times, not by k.", {"gamma**k": "gamma * k"}
        ),
        "backwards": Mistake(
            "the reward now counts most. Here the order is turned round, and the latest one counts most. "
            "(g = r[k] + gamma * g works back from the end, from k = n − 1.)",
            {"gamma**k * r[k]": "gamma**(n - 1 - k) * r[k]"},
        ),
        "mean": Mistake("it is a sum, not a mean: nothing is divided by n.", {"return g": "return g / n"}),
        "td_error": Mistake(
            "this is a TD error: from the return the old value has been taken off. Here only the return is asked.",
            {"return g": "return g - v[0]"},
        ),
        "return_in_the_loop": Mistake(
            "only the first reward is counted, and there are n of them. (A return inside a loop ends it, too.)",
            {"        g += gamma**k * r[k]": "        return g + r[k]"},
        ),
        "begins_with_r_1": Mistake(
            "the first reward is r[0], for Python counts from 0. Here it begins with r[1].", {"r[k]": "r[k + 1]"}
        ),
        "value_after_each": Mistake(
            "a value is believed once, after the n rewards. Here one is believed after each of them.",
            {"gamma**n * v[n]": "0.0", "r[k]": "(r[k] + gamma * v[k + 1])"},
        ),
        "r_and_v_swapped": Mistake(
            "r and v have changed places: the rewards come first, then one value.", {"r[k]": "v[k]", "v[n]": "r[n]"}
        ),
        "end_of_the_episode": Mistake(
            "after n rewards one stands at v[n], and it counts γⁿ times. Here it is the end of the episode.",
            {"gamma**n * v[n]": "gamma**len(r) * v[len(r)]"},
        ),
        "gamma_everywhere": Mistake(
            "γ is multiplied once more with each step: γᵏ for the rewards, γⁿ for the value. Here it is γ everywhere.",
            {"gamma**n": "gamma", "gamma**k": "(gamma if k else 1)"},
        ),
        "minus_the_value": Mistake(
            "the value after the n rewards is added, not taken off.", {"g = gamma**n": "g = -(gamma**n)"}
        ),
        "last_value": Mistake(
            "the last value of the episode is not the one to believe. After n rewards one stands at v[n].",
            {"v[n]": "v[-1]"},
        ),
        "last_rewards": Mistake(
            "these are the last n rewards. The first n are meant, r[0] to r[n − 1].", {"r[k]": "r[k - n]"}
        ),
    },
    witnesses=WITNESSES,
)
