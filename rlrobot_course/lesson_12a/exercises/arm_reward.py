"""A reward for the arm that cannot be milked."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.lesson_12a.reward_exercise import RewardExercise


def arm_reward(before, after):
    if after <= 0.05:
        return 10.0
    return 100 * (before - after)


STEPS = [
    (0.20, 0.17),
    (0.17, 0.20),
    (0.12, 0.105),
    (0.105, 0.12),
    (0.15, 0.15),
    (0.06, 0.04),
    (0.04, 0.03),
    (0.03, 0.08),
    (0.09, 0.05),
    (0.085, 0.0501),
    (0.30, 0.24),
    (0.10, 0.135),
]

WAY = "return 100 * (before - after)"

BY_SIGN = "return {0} if before - after > {2} else -{1} if after - before > {2} else {3}"

WITNESSES = read_answers(__file__, {})[1]

exercise = RewardExercise(
    task="return the reward of a step, from the distances before and after it",
    right=arm_reward,
    returns="reward",
    tape=[{"before": before, "after": after} for before, after in STEPS],
    mistakes={
        "as_the_task": Mistake(
            "this is the task's own reward: away costs 1 and nearer pays 5, so to and fro pays.",
            {WAY: BY_SIGN.format(5.0, 1.0, 0.02, -0.02)},
        ),
        "creeps_away": Mistake(
            "away by less than 2 cm costs next to nothing: it creeps away, and gets 5 for each larger step back. "
            "What a step away costs must grow with its length.",
            {WAY: BY_SIGN.format(5.0, 5.0, 0.02, -0.02)},
        ),
        "away_is_free": Mistake(
            "away by less than 2 cm is free: it creeps away, and gets paid for each larger step back. What a step "
            "away costs must grow with its length.",
            {WAY: BY_SIGN.format(1.0, 1.0, 0.02, 0.0)},
        ),
        "step_is_a_step": Mistake(
            "each step counts the same, however long: one long step away, several short ones back. What a step "
            "pays must grow with its length.",
            {WAY: BY_SIGN.format(1.0, 1.0, 0.0, 0.0)},
        ),
        "sign_of_the_step": Mistake(
            "the same for every step, however long: one long step away, several short ones back.",
            {WAY: BY_SIGN.format(5.0, 5.0, 0.0, 0.0)},
        ),
        "contact_alone": Mistake(
            "this is contact alone. It cannot be milked, but it does not show the way: let a step that leads "
            "nearer pay a little.",
            {WAY: "return -0.02"},
        ),
        "contact_alone_for_nothing": Mistake(
            "this is contact alone. It cannot be milked, but it does not show the way: let a step that leads "
            "nearer pay something.",
            {WAY: "return 0.0"},
        ),
        "inverted": Mistake(
            "this pays for the way out: it is before − after that is above 0 for a step nearer.",
            {"(before - after)": "(after - before)"},
        ),
        "retreat_is_free": Mistake(
            "a step away costs nothing here, so to and fro pays. What is given for the way in must be taken back "
            "for the way out.",
            {WAY: "return max(0.0, 100 * (before - after))"},
        ),
        "pays_for_being_near": Mistake(
            "this pays for being near, not for getting nearer: whoever stands still is paid.",
            {WAY: "return 0.1 / after"},
        ),
        "only_costs": Mistake(
            "this only costs: a step nearer should pay more than 0. Compare before with after.",
            {WAY: "return -100 * after"},
        ),
        "no_contact": Mistake("contact is missing: within 0.05 m a step pays 10.", {"if after <= 0.05": "if False"}),
        "where_it_began": Mistake(
            "what counts is where the step ends: after, not before.", {"after <= 0.05": "before <= 0.05"}
        ),
        "centimetres": Mistake("the distances are in metres: 5 cm are 0.05.", {"<= 0.05": "<= 5"}),
        "above_contact": Mistake(
            "a step towards the object pays more than contact here. With 1000 a metre a step of 4 cm is worth 40.",
            {"100 *": "1000 *"},
        ),
        "contact_and_step": Mistake(
            "contact pays 10, whatever the step before.", {"return 10.0": "return 10.0 + 100 * (before - after)"}
        ),
        "pays_each_step": Mistake(
            "each step pays a little, wherever it leads: standing still pays, too.",
            {WAY: "return 0.1 + 100 * (before - after)"},
        ),
    },
    hints=(
        "Give each centimetre a price: paid for on the way in, taken back on the way out. Then every loop sums to 0.",
        "before − after is the way gained, in metres; it is negative for a step away. Contact comes first.",
        "if after <= 0.05: return 10.0, and below it: return 100 * (…)",
    ),
    gained="You know a way to guide a robot that no robot can turn against you: pay for a change, and take it back.",
    witnesses=WITNESSES,
)
