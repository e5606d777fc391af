"""Exercises of appendix 06a: the λ-return, and how large α may be."""

from __future__ import annotations

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_06a import solutions

lambda_return = Exercise(
    task="return the mean of all n-step returns, weighted by powers of λ",
    right=solutions.lambda_return,
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
    mistakes=[
        Mistake("the weights do not sum to 1. The last return, which stands for all the longer ones, has the weight "
                "λⁿ⁻¹, without the factor 1 − λ.", {"lam ** (n - 1) if k == n else ": ""}),
        Mistake("the longest return ends with γⁿ times the last value, in full. If you work back from the end, begin "
                "with the last value, not with 0.",
                {"* values[k - 1]": "* values[k - 1] * (1 - lam if k == n else 1)"}),
        Mistake("the weights of all returns but the last have the factor 1 − λ, so that they sum to 1.",
                {"(1 - lam) * ": ""}),
        Mistake("this is the longest return alone. The shorter ones count, too, with the weights (1 − λ)λᵏ⁻¹.",
                {"return mean": "return g"}),
        Mistake("this is the one-step return alone. The longer ones count, too.",
                {"return mean": "return rewards[0] + gamma * values[0]"}),
        Mistake("this is the plain mean of the returns. Each has a weight of its own, made of λ.",
                {"weight * g": "g / n"}),
        Mistake("the powers of λ are one too high: the one-step return has the weight (1 − λ)λ⁰.",
                {"lam ** (n - 1)": "lam**n", "lam ** (k - 1)": "lam**k"}),
        Mistake("the weights do not sum to 1: that of the last return is λⁿ⁻¹, not λⁿ.", {"lam ** (n - 1)": "lam**n"}),
        Mistake("the powers of γ of the rewards are one too high: the first reward counts in full.",
                {"gamma ** (k - 1)": "gamma**k"}),
        Mistake("the value reached after k steps is one step further off than the k-th reward: it is multiplied by γᵏ.",
                {"gamma**k": "gamma ** (k - 1)"}),
        Mistake("every value is multiplied by γ alone here. The one reached after k steps is multiplied by γᵏ.",
                {"gamma**k": "gamma"}),
        Mistake("the values are missing: a k-step return ends with γᵏ times the value reached.",
                {" + gamma**k * values[k - 1]": ""}),
        Mistake("γ is missing: the reward r_k is multiplied by γᵏ and the value after k steps by γᵏ.",
                {"gamma ** (k - 1)": "1", "gamma**k": "1"}),
        Mistake("your weights are divided by their sum. They need not be: the longest return gets all the weight that "
                "is left, λⁿ⁻¹.",
                {"weight * g": "(lam ** (k - 1) / sum(lam ** (j - 1) for j in range(1, n + 1))) * g"}),
        Mistake("γ and λ have changed places: γ is in the returns, λ in their weights.",
                {"gamma": "lam", "lam": "gamma"}),
        Mistake("the k-step return has all the rewards up to the k-th, not the k-th alone.", {"total +=": "total ="}),
        Mistake("each k-step return ends with one value; here the values before it are in it, too. Keep the sum of the "
                "rewards apart from the return.", {"g = total +": "g = total = total +"}),
        Mistake("the k-step return ends with the value that was reached after k steps. Here all of them end with the "
                "last one.", {"values[k - 1]": "values[-1]"}),
        Mistake("the k-step return ends with the value that was reached after k steps. Here all of them end with the "
                "first one.", {"values[k - 1]": "values[0]"}),
        Mistake("values[0] is the value after one step already. For k steps it is values[k − 1].",
                {"values[k - 1]": "values[k - 2]"}),
        Mistake("this is the sum of all returns. They have weights that sum to 1.", {"weight * g": "g"}),
        Mistake("the longest return is missing. It has the weight λⁿ⁻¹.",
                {"lam ** (n - 1) if k == n": "0 if k == n"}),
        Mistake("in the mean of two or more, the weight of the k-step return is (1 − λ)λᵏ⁻¹, not (1 − λ)λ.",
                {"(1 - lam) * lam ** (k - 1)": "(1 - lam) * lam if k > 1 else (1 - lam)"}),
        Mistake("the returns and their weights do not go together: the one-step return has the weight 1 − λ, and the "
                "longest λⁿ⁻¹.",
                {"mean += weight * g": "mean += (lam ** (n - 1) if k == 1 else (1 - lam) * lam ** (n - k)) * g"}),
        Mistake("the rewards are not discounted: r_k is multiplied by γᵏ.", {"gamma ** (k - 1)": "1"}),
        Mistake("the value that is reached is not discounted: after k steps it is multiplied by γᵏ.",
                {"gamma**k * values": "values"}),
        Mistake("values[0] is v₁ already, so the k-step return ends with values[k − 1], not values[k].",
                {"values[k - 1]": "[*values, 0.0][k]"}),
        Mistake("the longest return, too, ends with the value reached. (If the episode ended there, that value is 0.)",
                {"gamma**k * values[k - 1]": "gamma**k * values[k - 1] * (k < n)"}),
        Mistake("the powers of λ are one too high in all weights but the last: the one-step return has (1 − λ)λ⁰.",
                {"(1 - lam) * lam ** (k - 1)": "(1 - lam) * lam**k"}),
        Mistake("the longest return gets all the weight that is left, λⁿ⁻¹, not 1 − λ.",
                {"lam ** (n - 1) if": "1 - lam if"}),
        Mistake("the order is turned round: here the latest reward counts most. The first one counts in full.",
                {"total += gamma ** (k - 1) * rewards": "total = gamma * total + rewards"}),
        Mistake("return stands inside the loop: it ends the function with the first return.",
                {"mean += weight * g": "return weight * g"}),
        Mistake("return stands inside the loop: it ends the function with the first return.",
                {"mean += weight * g": "return (1 - lam) * g"}),
        Mistake("these are the returns, all of them. Asked is one number, their weighted mean.",
                {"mean = len(rewards), 0.0, 0.0": "mean = len(rewards), 0.0, []", "mean += weight * g": "mean += [g]"}),
        Mistake("v is reached one step later, like what follows it, so it counts γ times, too: γ is for both.",
                {"return mean": "g = values[-1]\n    for r, v in zip(rewards[::-1], values[::-1]):\n"
                 "        g = r + gamma * lam * g + (1 - lam) * v\n    return g"}),
        Mistake("v counts 1 − λ times, and what follows it λ times. Here v counts in full.",
                {"return mean": "g = values[-1]\n    for r, v in zip(rewards[::-1], values[::-1]):\n"
                 "        g = r + gamma * (v + lam * g)\n    return g"}),
        Mistake("this way works from the last step back to the first. Here it runs forward: turn both lists round.",
                {"return mean": "g = values[-1]\n    for r, v in zip(rewards, values):\n"
                 "        g = r + gamma * ((1 - lam) * v + lam * g)\n    return g"}),
        Mistake("λ and 1 − λ have changed places: the share of the one-step return is 1 − λ.",
                {"lam ** (n - 1)": "(1 - lam) ** (n - 1)", "(1 - lam) * lam ** (k - 1)":
                 "lam * (1 - lam) ** (k - 1)"}),
    ],
    hints=(
        "First the n returns, each with its own powers of γ; then their weighted mean. The weights sum to 1.",
        "For k from 1 to n: add γᵏ⁻¹ times the k-th reward to a running total, and the k-step return is this total "
        "plus γᵏ · values[k − 1].",
        "weight = lam ** (n - 1) if k == n else (1 - lam) * lam ** (k - 1), and the answer is the sum of weight · "
        "return over all k.",
    ),
    gained="You can now say what any step of an episode should have taught, given all that came after it. The ideal of "
    "this appendix is nothing but this function, again and again.",
)  # fmt: skip

largest_alpha = Question(
    task="the largest α at which accumulating traces cannot overshoot",
    right=solutions.largest_alpha,
    because="The trace climbs towards 1/(1 − 0.81) = 5.26, and 1/5.26 = 0.19. "
    "A dutch trace climbs to 1/(1 − (1 − α) · 0.81), and α times that never exceeds 1.",
    mistakes=[
        Mistake("this is γλ, the share of a trace that one step leaves. How high does a trace climb that gains 1 at "
                "every step and keeps this share?", 0.81),
        Mistake("this is how high the trace climbs. Which α times this gives 1?", 1 / (1 - 0.81)),
        Mistake("this is 1 − 0.9. But a trace fades by γλ, not by γ or λ alone.", 1 - 0.9),
        Mistake("a trace of 1 would allow this. But an accumulating trace climbs above 1.", 1),
        Mistake("this is where the update overshoots by as much as it was off before. It should not overshoot at all: "
                "α · e ≤ 1.", 2 * (1 - 0.81)),
        Mistake("this allows for two visits in a row, where the trace is 1.81. With more visits it climbs further.",
                1 / 1.81),
        Mistake("4.47 is the trace after nine steps. On a longer drive it climbs further: how high?", 1 / 4.47),
        Mistake("this is for the trace after it has faded. It overshoots where it is highest: right after a visit.",
                (1 - 0.81) / 0.81),
        Mistake("nearly: 5.26 is rounded. How high the trace climbs is exactly 1/(1 − 0.81).", 1 / 5.26),
        Mistake("nearly, but with 0.2 it does overshoot after a while. Give a digit more.", 0.2),
        Mistake("nearly: 5.3 is rounded. How high the trace climbs is exactly 1/(1 − 0.81).", 1 / 5.3),
        Mistake("this is γ, or λ. How high does a trace climb that gains 1 at every step and keeps the share γλ?", 0.9),
        Mistake("this is 1/(γλ). How high does a trace climb that gains 1 at every step and keeps this share?",
                1 / 0.81),
        Mistake("this is the trace before the next visit adds its 1. And asked is α: which α times the highest trace "
                "is 1?", 0.81 / 0.19),
        Mistake("4.3 is the trace after eight steps. On a longer drive it climbs further: how high?", 1 / 4.3),
        Mistake("this is, rounded, how high the trace climbs. Which α times this gives 1?", 5.3),
        Mistake("this is, rounded, how high the trace climbs. Which α times this gives 1?", 5),
        Mistake("so high a trace would climb that keeps 0.9. Ours keeps γλ = 0.81; and asked is α.", 1 / (1 - 0.9)),
        Mistake("this is the trace after two visits. How high does it climb in the end, and which α fits that?", 1.81),
        Mistake("γλ is 0.9 · 0.9: two factors, not three.", 1 - 0.9**3),
        Mistake("the trace is not one for each of nine steps: the earlier ones have faded. It climbs to 1/(1 − 0.81).",
                1 / 9),
        Mistake("nearly. Which number is it exactly? The trace climbs to 1/(1 − 0.81).", 0.18),
        Mistake("nearly, but with 0.21 it does overshoot. The trace climbs to 1/(1 − 0.81).", 0.21),
        Mistake("this is half of it. Up to α · e = 1 nothing overshoots.", 0.095),
        Mistake("with α = 0 nothing would be learned, and nothing need be: a little α is safe. How much?", 0),
        Mistake("with this α the bump of lesson 06 did overshoot: the trace was 4.47 there.", 0.5),
        Mistake("a dutch trace may take any α. The question is about an accumulating one, which climbs by 1 a visit.",
                1 / (1 - 0.5 * 0.81)),
    ],
    hints=(
        "The trace climbs until it loses by fading what a visit adds. How high is that?",
        "Right after a visit it is e = γλ · e + 1. Solve this for e; and α · e must not exceed 1.",
        "e = 1/(1 − 0.9 · 0.9), and α is 1 divided by this.",
    ),
    gained="A rule of thumb for every accumulating trace: α at most 1 − γλ. Below, you see robots break it.",
)  # fmt: skip
