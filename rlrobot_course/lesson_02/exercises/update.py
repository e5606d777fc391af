"""The update of Q-learning."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import ADDS_TARGET, DISCOUNTS_THE_REWARD, FORGOT_GAMMA, PAST_THE_END
from rlrobot_course.lesson_02.exercises.target import INVERTED, TILDE, Q, target
from rlrobot_course.tapes import TAPE


def update(q, s, a, r, s_next, terminated, alpha, gamma):
    delta = target(q, r, s_next, terminated, gamma) - q[s, a]
    q[s, a] = q[s, a] + alpha * delta


ALPHAS = (0.1, 0.5, 0.25, 0.1, 0.1, 0.3, 0.7, 0.05, 0.2, 0.4, 0.3)

GAMMAS = (0.9, 0.5, 0.8, 0.9, 0.9, 0.95, 0.9, 0.6, 0.9, 0.7, 0.8)

AT_A_WALL = (
    {"s": 4, "a": 1, "r": -2.0, "s_next": 4, "terminated": False},
    {"s": 4, "a": 0, "r": -0.02, "s_next": 4, "terminated": False},  # it stays, and a is the best action there
)

IF_ELSE = "what stands after else reaches to the end of the line, − q[s, a] with it. Set (… if … else …) in brackets."

CHANGED, WITNESSES = read_answers(__file__, {"target": target})

exercise = Exercise(
    task="change q[s, a] by α times the TD error",
    right=update,
    memory={"q": Q},
    lenders={"target": "your function of the exercise above: run its cell first"},
    tape=[
        {name: row[name] for name in ("s", "a", "r", "s_next", "terminated")} | {"alpha": alpha, "gamma": gamma}
        for row, alpha, gamma in zip((*TAPE, *AT_A_WALL), ALPHAS, GAMMAS, strict=True)
    ],
    mistakes={
        "past_the_end": Mistake(PAST_THE_END, {"terminated": "False"}),
        "inverted": Mistake(INVERTED, {"terminated": "not terminated"}),
        "no_gamma": Mistake(FORGOT_GAMMA, {"gamma": "1"}),
        "adds_target": Mistake(ADDS_TARGET, {" - q[s, a]": ""}),
        "replaces": Mistake(
            "q[s, a] should change by α · δ. You replaced it: write += instead of =.", {"q[s, a] + alpha": "alpha"}
        ),
        "jumps": Mistake(
            "q[s, a] jumps to the target. It should go only the share α of the way.", {"alpha * delta": "delta"}
        ),
        "one_minus_alpha": Mistake(
            "the share to go is α, and 1 − α stays. Here the two have changed places.",
            {"alpha * delta": "(1 - alpha) * delta"},
        ),
        "alpha_and_gamma_swapped": Mistake("α and γ have changed places.", {"gamma": "alpha", "alpha": "gamma"}),
        "downwards": Mistake(
            "the sign: δ is the target minus the old value, and α · δ is added. Yours moves away from the target.",
            {"+ alpha": "- alpha"},
        ),
        "starts_from_s_next": Mistake(
            "the pair that learns is (s, a), where the step began, not s'.", {"q[s, a]": "q[s_next, a]"}
        ),
        "writes_to_s_next": Mistake(
            "the new value belongs to s, where the step began. You have written it to s'.",
            {"q[s, a] = ": "q[s_next, a] = "},
        ),
        "row_alike": Mistake(
            "only the action that was taken learns: change q[s, a], not the whole row q[s].", {"q[s, a]": "q[s]"}
        ),
        "row_each": Mistake(
            "only the action that was taken learns: change q[s, a], not the whole row q[s].",
            {"q[s, a] = q[s, a] + alpha": "q[s] = q[s] + alpha"},
        ),
        "whole_table": Mistake(
            "only the pair (s, a) learns: change q[s, a], not the whole table.",
            {"q[s, a] = q[s, a] + alpha": "q[:] = q + alpha"},
        ),
        "column": Mistake(
            "only the pair (s, a) learns: q[:, a] is a whole column, one action in all states.",
            {"q[s, a] = q[s, a] + alpha": "q[:, a] = q[:, a] + alpha"},
        ),
        "value_of_s": Mistake("the value of what follows is that of the next state s', not of s.", {"s_next": "s"}),
        "old_action": Mistake(
            "in s' the best action counts, not the old action a once more.",
            {"target(q, r, s_next, terminated, gamma)": "r + (not terminated) * gamma * q[s_next, a]"},
        ),
        "mean": Mistake(
            "in s' the best action counts: max, not the mean.",
            {"target(q, r, s_next, terminated, gamma)": "r + (not terminated) * gamma * q[s_next].mean()"},
        ),
        "sum": Mistake(
            "in s' the best action counts: max, not the sum.",
            {"target(q, r, s_next, terminated, gamma)": "r + (not terminated) * gamma * q[s_next].sum()"},
        ),
        "argmax": Mistake(
            "argmax tells which action is best; you need how much it is worth. That is max.",
            {"target(q, r, s_next, terminated, gamma)": "r + (not terminated) * gamma * q[s_next].argmax()"},
        ),
        "best_of_the_table": Mistake(
            "this is the best value in the whole table. Only the row of s' counts.",
            {"target(q, r, s_next, terminated, gamma)": "r + (not terminated) * gamma * q.max()"},
        ),
        "not_below_zero": Mistake(
            "values may be negative. Where all actions are bad, the best of them is still below 0: leave it so.",
            {"target(q, r, s_next, terminated, gamma)": "r + (not terminated) * gamma * max(0, max(q[s_next]))"},
        ),
        "reward_alone": Mistake(
            "this learns from the reward alone: γ times the best value of s' is missing.",
            {"target(q, r, s_next, terminated, gamma)": "r"},
        ),
        "no_reward": Mistake(
            "the reward is missing from your target: r + γ · max Q(s', ·).",
            {"target(q, r, s_next, terminated, gamma)": "target(q, 0, s_next, terminated, gamma)"},
        ),
        "nothing_at_the_end": Mistake(
            "after a terminated step there is still something to learn: there the target is r.",
            {"alpha * delta": "alpha * delta * (not terminated)"},
        ),
        "no_reward_at_the_end": Mistake(
            "after a terminated step the reward still counts: there the target is r, not 0.",
            {"target(q, r, ": "target(q, r * (not terminated), "},
        ),
        "becomes_the_reward": Mistake(
            "after a terminated step q[s, a] does not become the reward; it goes the share α of the way to it.",
            {"q[s, a] = q[s, a] + alpha * delta": "q[s, a] = r if terminated else q[s, a] + alpha * delta"},
        ),
        "adds_reward_at_the_end": Mistake(
            "after a terminated step, too, the old value is taken off: δ is r − Q(s, a) there.",
            {"terminated, gamma) - q[s, a]": "terminated, gamma) - (not terminated) * q[s, a]"},
        ),
        "counts_twice": Mistake(
            "the old value is counted twice: += adds to it already. Write either += or q[s, a] + …, not both.",
            {"q[s, a] = q[s, a]": "q[s, a] += q[s, a]"},
        ),
        "changes_before_the_target": Mistake(
            "q[s, a] has changed before the target looks at it. Where a step leads back to the same state, that is "
            "another number. Compute δ first, then change q[s, a] in one line.",
            CHANGED["changes_before_the_target"],
        ),
        "best_action_learns": Mistake(
            "the action that was taken learns, a. Here it is the best one of s, whatever was done.",
            {"delta = target": "a = q[s].argmax(); delta = target"},
        ),
        "both_ends": Mistake(
            "only (s, a) learns. Here an entry of s' changes, too.",
            {"q[s, a] + alpha * delta": "q[s, a] + alpha * delta; q[s_next, a] += alpha * delta"},
        ),
        "twice": Mistake(
            "the update is made twice. Write either q[s, a] = q[s, a] + … or q[s, a] += …, in one line.",
            {"alpha * delta": "2 * alpha * delta"},
        ),
        "loop_over_actions": Mistake(
            "there is no loop over actions in it: only the action that was taken learns, q[s, a].",
            CHANGED["loop_over_actions"],
        ),
        "own_alpha_and_gamma": Mistake(
            "α and γ are arguments. Use them in place of the numbers 0.1 and 0.9.", {"alpha": "0.1", "gamma": "0.9"}
        ),
        "own_alpha": Mistake("α is an argument. Use it in place of the number 0.1.", {"alpha": "0.1"}),
        "divides_by_alpha": Mistake(
            "δ is multiplied by α, and made smaller so. You divide by it.", {"alpha * delta": "delta / alpha"}
        ),
        "squares_delta": Mistake("δ counts as it is, not its square.", {"alpha * delta": "alpha * delta ** 2"}),
        "adds_alpha": Mistake("α and δ are multiplied: q[s, a] changes by α · δ.", {"alpha * delta": "alpha + delta"}),
        "own_gamma": Mistake("γ is an argument. Use it in place of the number 0.9.", {"gamma": "0.9"}),
        "discounts_the_reward": Mistake(
            DISCOUNTS_THE_REWARD,
            {"target(q, r, s_next, terminated, gamma)": "gamma * target(q, r, s_next, terminated, 1)"},
        ),
        "gamma_times_delta": Mistake(
            "only the best value of s' is multiplied by γ. Mind the brackets: γ · max Q(s', ·) − Q(s, a).",
            {
                "target(q, r, s_next, terminated, gamma)": "r",
                "- q[s, a]": "+ gamma * (max(q[s_next]) * (not terminated) - q[s, a])",
            },
        ),
        "alpha_on_target_alone": Mistake(
            "α multiplies the whole of δ, the old value in it, too: α · (target − Q(s, a)). Mind the brackets.",
            {"alpha * delta": "alpha * (delta + q[s, a]) - q[s, a]"},
        ),
        "gap_from_s_next": Mistake(
            "δ is measured from the old value of the pair that learns, q[s, a], not from s'.",
            {" - q[s, a]": " - q[s_next, a]"},
        ),
        "gap_from_the_best": Mistake(
            "δ is measured from q[s, a], the pair that learns, not from the best action of s.",
            {" - q[s, a]": " - max(q[s])"},
        ),
        "q_a_s": Mistake("state and action have changed places: it is q[s, a].", {"q[s, a]": "q[a, s]"}),
        "column_of_s_next": Mistake(
            "q[:, s_next] is a column: one action in all states. The row of s' is q[s_next].",
            {"target(q, r, s_next, terminated, gamma)": "r + (not terminated) * gamma * max(q[:, s_next])"},
        ),
        "abs_of_delta": Mistake(
            "δ may be negative, and then Q must fall. Leave its sign as it is.", {"alpha * delta": "alpha * abs(delta)"}
        ),
        "never_falls": Mistake(
            "δ may be negative, and then Q must fall. Leave its sign as it is.",
            {"alpha * delta": "max(0, alpha * delta)"},
        ),
        "alpha_twice": Mistake("α is in it twice: the step is α · δ.", {"alpha * delta": "alpha * alpha * delta"}),
        "if_else_to_the_end": Mistake(IF_ELSE, CHANGED["if_else_to_the_end"]),
        "if_else_to_the_end_with_r": Mistake(IF_ELSE, CHANGED["if_else_to_the_end_with_r"]),
        "tilde": Mistake(TILDE, CHANGED["tilde"]),
        "gamma_twice": Mistake(
            "γ is in the target already. The step towards it is α · δ alone.",
            {"alpha * delta": "alpha * gamma * delta"},
        ),
        "alpha_on_the_reward_alone": Mistake(
            "brackets: α multiplies the whole of δ, not the reward alone.", {"alpha * delta": "alpha * r + delta - r"}
        ),
        "target_in_full": Mistake(
            "α multiplies the target, too: (1 − α) · Q(s, a) + α · target.",
            {"q[s, a] + alpha * delta": "(1 - alpha) * q[s, a] + delta + q[s, a]"},
        ),
        "rounds": Mistake(
            "you round. Small changes add up, so keep all digits.",
            {"q[s, a] + alpha * delta": "round(q[s, a] + alpha * delta, 2)"},
        ),
        "only_returns": Mistake(
            "the table is as it was: the new value is in a copy or a variable, or only returned. Write q[s, a] += …",
            {"q[s, a] = ": "return "},
        ),
    },
    hints=(
        "Only one number of the table changes, q[s, a]. It goes the share α of the way to the target.",
        "Give the gap a name: delta = target(q, r, s_next, terminated, gamma) - q[s, a]. Then change q[s, a].",
        "Below delta = … comes one more line: q[s, a] += alpha * delta. Nothing is returned.",
    ),
    gained="This is Q-learning, the whole of it. In the next section it gets the steps of a robot.",
    witnesses=WITNESSES,
)
