"""The λ-return."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def lambda_return(rewards, values, gamma, lam):
    n, total, mean = len(rewards), 0.0, 0.0
    for k in range(1, n + 1):
        total += gamma ** (k - 1) * rewards[k - 1]
        g = total + gamma**k * values[k - 1]  # the k-step return
        weight = lam ** (n - 1) if k == n else (1 - lam) * lam ** (k - 1)
        mean += weight * g
    return mean


CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="return the mean of all n-step returns, weighted by powers of λ",
    right=lambda_return,
    returns="G",
    tape=[
        {"rewards": [10.0, -0.02, -2.0], "values": [7.0, 5.0, 4.0], "gamma": 0.9, "lam": 0.8},
        {"rewards": [10.0], "values": [4.0], "gamma": 0.9, "lam": 0.9},
        {"rewards": [10.0, 10.0], "values": [0.0, 5.0], "gamma": 0.95, "lam": 0.9},
        {"rewards": [1.0, -2.0], "values": [6.0, -3.0], "gamma": 0.7, "lam": 0.5},
        {"rewards": [-0.02, -0.02, 10.0, 10.0], "values": [1.0, 2.0, 3.0, 0.0], "gamma": 0.8, "lam": 0.9},
        {"rewards": [1.0, 2.0, 3.0], "values": [4.0, 5.0, 6.0], "gamma": 0.9, "lam": 0.0},
        {"rewards": [-2.0, 3.0, -0.02], "values": [2.0, 5.5, 6.0], "gamma": 0.6, "lam": 1.0},
    ],
    mistakes={
        "no_weight_for_the_last": Mistake(
            "the weights do not sum to 1. The last return, which stands for all the longer ones, has the weight "
            "λⁿ⁻¹, without the factor 1 − λ.",
            {"lam ** (n - 1) if k == n else ": ""},
        ),
        "rest_on_top": Mistake(
            "the weights do not sum to 1: the last return counts twice here. It has the weight λⁿ⁻¹ alone.",
            {
                "lam ** (n - 1) if k == n else (1 - lam) * lam ** (k - 1)": (
                    "(1 - lam) * lam ** (k - 1) + (k == n) * lam ** (n - 1)"
                )
            },
        ),
        "last_value_shared": Mistake(
            "the longest return ends with γⁿ times the last value, in full. If you work back from the end, begin "
            "with the last value, not with 0.",
            {"* values[k - 1]": "* values[k - 1] * (1 - lam if k == n else 1)"},
        ),
        "no_one_minus_lambda": Mistake(
            "the weights of all returns but the last have the factor 1 − λ, so that they sum to 1.",
            {"(1 - lam) * ": ""},
        ),
        "longest_alone": Mistake(
            "this is the longest return alone. The shorter ones count, too, with the weights (1 − λ)λᵏ⁻¹.",
            {"return mean": "return g"},
        ),
        "one_step_alone": Mistake(
            "this is the one-step return alone. The longer ones count, too.",
            {"return mean": "return rewards[0] + gamma * values[0]"},
        ),
        "plain_mean": Mistake(
            "this is the plain mean of the returns. Each has a weight of its own, made of λ.", {"weight * g": "g / n"}
        ),
        "lambda_one_too_high": Mistake(
            "the powers of λ are one too high: the one-step return has the weight (1 − λ)λ⁰.",
            {"lam ** (n - 1)": "lam**n", "lam ** (k - 1)": "lam**k"},
        ),
        "lambda_n_for_the_last": Mistake(
            "the weights do not sum to 1: that of the last return is λⁿ⁻¹, not λⁿ.", {"lam ** (n - 1)": "lam**n"}
        ),
        "gamma_one_too_high": Mistake(
            "the powers of γ of the rewards are one too high: the first reward counts in full.",
            {"gamma ** (k - 1)": "gamma**k"},
        ),
        "value_too_early": Mistake(
            "the value reached after k steps is one step further off than the k-th reward: it is multiplied by γᵏ.",
            {"gamma**k": "gamma ** (k - 1)"},
        ),
        "gamma_once": Mistake(
            "every value is multiplied by γ alone here. The one reached after k steps is multiplied by γᵏ.",
            {"gamma**k": "gamma"},
        ),
        "no_values": Mistake(
            "the values are missing: a k-step return ends with γᵏ times the value reached.",
            {" + gamma**k * values[k - 1]": ""},
        ),
        "no_gamma": Mistake(
            "γ is missing: the reward r_k is multiplied by γᵏ and the value after k steps by γᵏ.",
            {"gamma ** (k - 1)": "1", "gamma**k": "1"},
        ),
        "divided_by_their_sum": Mistake(
            "your weights are divided by their sum. They need not be: the longest return gets all the weight that "
            "is left, λⁿ⁻¹.",
            {"weight * g": "(lam ** (k - 1) / sum(lam ** (j - 1) for j in range(1, n + 1))) * g"},
        ),
        "gamma_and_lambda_swapped": Mistake(
            "γ and λ have changed places: γ is in the returns, λ in their weights.", {"gamma": "lam", "lam": "gamma"}
        ),
        "last_reward_alone": Mistake(
            "the k-step return has all the rewards up to the k-th, not the k-th alone.", {"total +=": "total ="}
        ),
        "values_before": Mistake(
            "each k-step return ends with one value; here the values before it are in it, too. Keep the sum of the "
            "rewards apart from the return.",
            {"g = total +": "g = total = total +"},
        ),
        "last_value_everywhere": Mistake(
            "the k-step return ends with the value that was reached after k steps. Here all of them end with the "
            "last one.",
            {"values[k - 1]": "values[-1]"},
        ),
        "first_value_everywhere": Mistake(
            "the k-step return ends with the value that was reached after k steps. Here all of them end with the "
            "first one.",
            {"values[k - 1]": "values[0]"},
        ),
        "value_one_too_early": Mistake(
            "values[0] is the value after one step already. For k steps it is values[k − 1].",
            {"values[k - 1]": "values[k - 2]"},
        ),
        "sum": Mistake("this is the sum of all returns. They have weights that sum to 1.", {"weight * g": "g"}),
        "not_the_longest": Mistake(
            "the longest return is missing. It has the weight λⁿ⁻¹.", {"lam ** (n - 1) if k == n": "0 if k == n"}
        ),
        "lambda_once": Mistake(
            "in the mean of two or more, the weight of the k-step return is (1 − λ)λᵏ⁻¹, not (1 − λ)λ.",
            {"(1 - lam) * lam ** (k - 1)": "(1 - lam) * lam if k > 1 else (1 - lam)"},
        ),
        "weights_reversed": Mistake(
            "the returns and their weights do not go together: the one-step return has the weight 1 − λ, and the "
            "longest λⁿ⁻¹.",
            {"mean += weight * g": "mean += (lam ** (n - 1) if k == 1 else (1 - lam) * lam ** (n - k)) * g"},
        ),
        "plain_rewards": Mistake("the rewards are not discounted: r_k is multiplied by γᵏ.", {"gamma ** (k - 1)": "1"}),
        "value_in_full": Mistake(
            "the value that is reached is not discounted: after k steps it is multiplied by γᵏ.",
            {"gamma**k * values": "values"},
        ),
        "value_one_too_late": Mistake(
            "values[0] is v₁ already, so the k-step return ends with values[k − 1], not values[k].",
            {"values[k - 1]": "[*values, 0.0][k]"},
        ),
        "longest_without_value": Mistake(
            "the longest return, too, ends with the value reached. (If the episode ended there, that value is 0.)",
            {"gamma**k * values[k - 1]": "gamma**k * values[k - 1] * (k < n)"},
        ),
        "lambda_one_too_high_but_the_last": Mistake(
            "the powers of λ are one too high in all weights but the last: the one-step return has (1 − λ)λ⁰.",
            {"(1 - lam) * lam ** (k - 1)": "(1 - lam) * lam**k"},
        ),
        "one_minus_lambda_for_the_last": Mistake(
            "the longest return gets all the weight that is left, λⁿ⁻¹, not 1 − λ.", {"lam ** (n - 1) if": "1 - lam if"}
        ),
        "backwards": Mistake(
            "the order is turned round: here the latest reward counts most. The first one counts in full.",
            {"total += gamma ** (k - 1) * rewards": "total = gamma * total + rewards"},
        ),
        "return_in_the_loop": Mistake(
            "only the first return has a say. Does the word return stand inside a loop, and end it?",
            {"mean += weight * g": "return weight * g"},
        ),
        "return_of_a_weighted_one": Mistake(
            "only the first return has a say. Does the word return stand inside a loop, and end it?",
            {"mean += weight * g": "return (1 - lam) * g"},
        ),
        "list_of_all": Mistake(
            "these are the returns, all of them. Asked is one number, their weighted mean.",
            {"mean = len(rewards), 0.0, 0.0": "mean = len(rewards), 0.0, []", "mean += weight * g": "mean += [g]"},
        ),
        "v_without_gamma": Mistake(
            "v is reached one step later, like what follows it, so it counts γ times, too: γ is for both.",
            CHANGED["v_without_gamma"],
        ),
        "v_in_full": Mistake(
            "v counts 1 − λ times, and what follows it λ times. Here v counts in full.", CHANGED["v_in_full"]
        ),
        "works_forwards": Mistake(
            "this way works from the last step back to the first. Here it runs forward: turn both lists round.",
            CHANGED["works_forwards"],
        ),
        "lambda_swapped": Mistake(
            "λ and 1 − λ have changed places: the share of the one-step return is 1 − λ.",
            {"lam ** (n - 1)": "(1 - lam) ** (n - 1)", "(1 - lam) * lam ** (k - 1)": "lam * (1 - lam) ** (k - 1)"},
        ),
    },
    hints=(
        "First the n returns, each with its own powers of γ; then their weighted mean. The weights sum to 1.",
        "For k from 1 to n: add γᵏ⁻¹ times the k-th reward to a running total, and the k-step return is this total "
        "plus γᵏ · values[k − 1].",
        "weight = lam ** (n - 1) if k == n else (1 - lam) * lam ** (k - 1), and the answer is the sum of weight · "
        "return over all k.",
    ),
    gained="You can now say what any step of an episode should have taught, given all that came after it. The ideal of "
    "this appendix is nothing but this function, again and again.",
    witnesses=WITNESSES,
)
