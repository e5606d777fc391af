"""The discounted return of a list of rewards."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def discounted_return(rewards, gamma):
    total = 0
    for k, r in enumerate(rewards):
        total += gamma**k * r
    return total


LOOP = "total += gamma**k * r"

CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="return the sum of the rewards, the one of step k multiplied by γ to the power of k",
    right=discounted_return,
    returns="sum",
    tape=[
        {"rewards": [3.0, -2.0, 7.0, 1.5], "gamma": 0.7},
        {"rewards": [-0.02, 10.0, 10.0], "gamma": 0.9},
        {"rewards": [10.0], "gamma": 0.9},
        {"rewards": [0.0, 0.0, 0.0, 1.0], "gamma": 0.5},
        {"rewards": [1.0, 2.0, 3.0], "gamma": 1.0},
        {"rewards": [5.0, -2.0, 7.0], "gamma": 0.0},
        {"rewards": [-2.0, -0.02, -2.0, 1.0], "gamma": 0.85},
        {"rewards": [], "gamma": 0.9},
        {"rewards": [10.0] * 12, "gamma": 0.99},
        {"rewards": [0.0] * 30 + [50.0], "gamma": 0.95},
        {"rewards": [0.0] * 24 + [50.0], "gamma": 0.5},
    ],
    mistakes={
        "one_factor_too_many": Mistake("the first reward counts in full: it has γ to the power of 0, which is 1.",
            {"gamma**k": "gamma ** (k + 1)"}),
        "one_factor_too_few": Mistake("the second reward has γ to the power of 1. You have one factor too few: k "
            "begins at 0.", {"gamma**k": "gamma ** max(k - 1, 0)"}),
        "power_minus_1": Mistake("one factor too few: r₀ has γ to the power of 0, and yours has the power of −1.",
            {"gamma**k": "gamma ** (k - 1)"}),
        "no_gamma": Mistake("this is the plain sum; γ is missing.", {"gamma**k * ": ""}),
        "first_of_equals": Mistake("index(r) finds the first reward that is equal to r, and two may be equal. The "
            "number of the step comes from enumerate(rewards).", {"gamma**k": "gamma ** rewards.index(r)"}),
        "two_factors_too_many": Mistake("your factor begins with γ, and is multiplied by γ before it is first used. "
            "The first reward counts in full: begin with 1, and multiply after the adding.",
            {"gamma**k": "gamma ** (k + 2)"}),
        "factor_stops": Mistake("the factor does not grow from step to step: k, or the power, stays where it was.",
            {"gamma**k": "gamma ** min(k, 2)"}),
        "first_twice": Mistake("the first reward is counted twice: it is in the total before the loop begins. Begin "
            "with 0.", {"total = 0": "total = rewards[0]"}),
        "stops_below_0_01": Mistake("a small factor is no reason to stop: what is far ahead counts, however little. "
            "Go through all.", CHANGED["stops_below_0_01"]),
        "gamma_each": Mistake("all rewards have the same factor γ here. The one of step k has γ to the power of k.",
            {"gamma**k": "gamma"}),
        "later_alike": Mistake("all later rewards have the same factor γ here. Each further step brings one more "
            "factor.", {"gamma**k": "gamma ** min(k, 1)"}),
        "backwards": Mistake("your sum begins at the wrong end: here the last reward counts in full, not the first.",
            {"enumerate(rewards)": "enumerate(rewards[::-1])"}),
        "gamma_times_k": Mistake("γ to the power of k is γ ** k. You multiplied γ by k.", {"gamma**k": "gamma * k"}),
        "gamma_times_k_but_the_first": Mistake("γ to the power of k is γ ** k. You multiplied γ by k.",
            {"gamma**k": "(gamma * k if k else 1)"}),
        "k_to_the_gamma": Mistake("γ to the power of k is γ ** k. Here it is k that has a power.",
            {"gamma**k": "k**gamma"}),
        "squares_gamma": Mistake("γ is multiplied with itself again and again, so its powers are 1, 2, 4, 8. Keep γ, "
            "and multiply another number by it.", {"gamma**k": "gamma ** (2 ** (k - 1) if k else 0)"}),
        "squares_gamma_from_the_first": Mistake("γ is multiplied with itself again and again, so its powers are 1, 2, "
            "4, 8. Keep γ, and multiply another number by it.", {"gamma**k": "gamma ** 2**k"}),
        "divides": Mistake("later rewards are divided by γ here, and so count more. Multiply.",
            {"gamma**k": "gamma**-k"}),
        "one_minus_gamma": Mistake("the discount is γ itself, not 1 − γ.", {"gamma**k": "(1 - gamma) ** k"}),
        "power_of_the_reward": Mistake("the reward has the power here, not γ.", {"gamma**k * r": "gamma * r**k"}),
        "adds_factor": Mistake("the factor and the reward of a step are to be multiplied, not added.",
            {"gamma**k * r": "gamma**k + r"}),
        "own_0_9": Mistake("γ = 0.9 is written into your function. Use the argument gamma.", {"gamma**k": "0.9**k"}),
        "own_0_99": Mistake("γ = 0.99 is written into your function. Use the argument gamma.", {"gamma**k": "0.99**k"}),
        "own_0_5": Mistake("γ = 0.5 is written into your function. Use the argument gamma.", {"gamma**k": "0.5**k"}),
        "mean": Mistake("the return is a sum, not a mean.", {"return total": "return total / max(len(rewards), 1)"}),
        "mean_of_none_is_nan": Mistake("the return is a sum, not a mean.",
            {"return total": "return total / len(rewards) if rewards else float('nan')"}),
        "product": Mistake("the return is a sum, not a product: begin with 0, and add.",
            {"total = 0": "total = 1", "total +=": "total *="}),
        "list_of_terms": Mistake("these are the discounted rewards, one by one. Add them up.",
            {"return total": "return [gamma**k * r for k, r in enumerate(rewards)]"}),
        "running_sums": Mistake("these are the sums after each step. The return is the last of them.",
            {"return total": "t = 0; return [t := t + gamma**k * r for k, r in enumerate(rewards)]"}),
        "first_two": Mistake("only the first two rewards count here. A loop goes through all.",
            {"return total": "return rewards[0] + gamma * rewards[1]"}),
        "first_three": Mistake("only the first three rewards count here. A loop goes through all.",
            {"return total": "return rewards[0] + gamma * rewards[1] + gamma**2 * rewards[2]"}),
        "first_ten": Mistake("only the first ten rewards count here. Go through all.",
            {"enumerate(rewards)": "enumerate(rewards[:10])"}),
        "adds_gamma": Mistake("each step multiplies the factor by γ once more. You add γ to it.",
            {"gamma**k": "(1 + gamma * k)"}),
        "takes_gamma_off": Mistake("each step multiplies the factor by γ once more. You take γ away from it.",
            {"gamma**k": "(1 - gamma * k)"}),
        "number_and_reward_swapped": Mistake("enumerate gives the number of a step first, and then its reward: for k, "
            "r in enumerate(rewards).", {"gamma**k * r": "gamma**r * k"}),
        "power_of_both": Mistake("only γ has the power k, not the reward.", {"gamma**k * r": "(gamma * r) ** k"}),
        "last_discounted": Mistake("this is the last reward alone. Add them all up.",
            {"return total": "return rewards[-1] * gamma ** (len(rewards) - 1)"}),
        "plain_mean": Mistake("this is the mean of the rewards. The return is a sum, in which the one of step k has γ "
            "** k.", {"gamma**k * ": "", "return total": "return total / max(len(rewards), 1)"}),
        "last_alone": Mistake("this is the last reward alone. Add them all up.", {"total +=": "total ="}),
        "return_in_the_loop": Mistake("only the first reward counts. Is return inside the loop?", {LOOP: "return r"}),
        "return_in_the_loop_alone": Mistake("only the first reward counts. Is return inside the loop?",
            {LOOP: "return r", "return total": "return None"}),
        "not_the_first": Mistake("the first reward is left out. r₀ counts, too, and in full.",
            {LOOP: "total += gamma**k * r * (k > 0)"}),
        "begins_with_the_second": Mistake("the first reward is left out, and the second one counts in full. Begin "
            "with r₀.", {"enumerate(rewards)": "enumerate(rewards[1:])"}),
        "not_the_last": Mistake("the last reward is left out. range(len(rewards)) goes through all.",
            {"enumerate(rewards)": "enumerate(rewards[:-1])"}),
        "factor_of_the_last": Mistake("every reward is discounted as if it were the last one. The one of step k has γ "
            "** k.", {"gamma**k": "gamma ** (len(rewards) - 1)"}),
        "factor_of_the_end": Mistake("the whole sum is discounted as if it came at the end. The reward of step k has "
            "γ ** k.", {"gamma**k": "gamma ** len(rewards)"}),
        "two_sums": Mistake("each reward has its own factor: multiply first, inside the sum, and then add up. Here "
            "two sums are multiplied.",
            {"return total": "return sum(gamma**k for k in range(len(rewards))) * sum(rewards)"}),
        "largest": Mistake("this is the largest of the discounted rewards. Add them all up: sum, not max.",
            {"return total": "return max(gamma**k * r for k, r in enumerate(rewards))"}),
        "negative_as_0": Mistake("rewards below 0 count, too: they make the return smaller.", {"* r": "* max(r, 0)"}),
        "abs_of_each": Mistake("a reward below 0 makes the return smaller. Do not take abs of it.",
            {"* r": "* abs(r)"}),
        "not_below_0": Mistake("a return may be negative: that is what a robot gathers that bumps into walls.",
            {"return total": "return max(total, 0)"}),
        "abs_of_the_sum": Mistake("a return may be negative: that is what a robot gathers that bumps into walls.",
            {"return total": "return abs(total)"}),
        "for_ever": Mistake("this would be right if the first reward came for ever. Here the rewards differ, and they "
            "end.", {"return total": "return rewards[0] / (1 - gamma)"}),
        "discounts_the_reward": Mistake("what you have added up so far is discounted, and the reward with it. "
            "Discount what comes later.", {LOOP: "total = (total + r) * gamma"}),
        "empty_is_minus_1": Mistake("a list without rewards has the return 0, and your function must not ask for its "
            "first one.", {"return total": "return total if rewards else -1"}),
        "empty_is_none": Mistake("a list without rewards has the return 0: the sum of nothing.",
            {"return total": "return total if rewards else None"}),
    },
    hints=(
        "Each reward counts γ times less than the one before it: 1, γ, γ², γ³ … Multiply, and add up.",
        "Begin with total = 0, go through the rewards with their number k, and add γ to the power of k, times r.",
        "for k, r in enumerate(rewards): total += gamma**k * r. After the loop: return total.",
    ),
    gained="This sum is what every method of the course tries to make as large as it can.",
    witnesses=WITNESSES,
)  # fmt: skip
