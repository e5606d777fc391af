"""The returns of all steps of a day."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import NO_GAMMA


def returns(rewards, ends, gamma):
    g, follows = [0.0] * len(rewards), 0.0
    for t in range(len(rewards) - 1, -1, -1):
        if ends[t]:
            follows = 0.0
        g[t] = rewards[t] + gamma * follows
        follows = g[t]
    return g


WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the list of the returns G, one for each step of the day",
    right=returns,
    returns="returns",
    tape=[
        {"rewards": [-1.0, -1.0, 20.0], "ends": [False, False, True], "gamma": 0.5},
        {"rewards": [-1.0, 20.0, -1.0, -20.0], "ends": [False, True, False, True], "gamma": 0.9},
        {"rewards": [4.0, 2.5, 1.5], "ends": [False, False, False], "gamma": 0.8},
        {"rewards": [7.5], "ends": [True], "gamma": 0.9},
        {"rewards": [3.0, -2.0, 5.0, 1.25, 6.0], "ends": [True, True, False, True, False], "gamma": 0.6},
        {"rewards": [], "ends": [], "gamma": 0.6},
        {"rewards": [-1, 2, 5], "ends": [False, False, True], "gamma": 0.5},  # whole numbers, whose returns are none
    ],
    mistakes={
        "across_the_end": Mistake(
            "the day has several episodes: where one ends, nothing of the next counts any more.",
            {"if ends[t]:": "if False:"},
        ),
        "no_gamma": Mistake(NO_GAMMA, {"gamma * ": ""}),
        "nothing_at_the_end": Mistake(
            "the reward of the step at which an episode ends counts in full: 0 is what follows it, not its return.",
            {"g[t] = rewards[t] + gamma * follows": "g[t] = 0.0 if ends[t] else rewards[t] + gamma * follows"},
        ),
        "discounts_the_reward": Mistake(
            "γ discounts what follows; the reward of the step itself counts in full.",
            {"rewards[t] + gamma * follows": "gamma * (rewards[t] + follows)"},
        ),
        "forwards": Mistake(
            "this goes from the morning on: so it adds what has been, and a return is of what is to come.",
            {"range(len(rewards) - 1, -1, -1)": "range(len(rewards))"},
        ),
        "rewards_alone": Mistake(
            "these are the rewards. A return adds what follows, γ times.", {" + gamma * follows": ""}
        ),
        "ends_too_early": Mistake(
            "ends[t] says that step t is the last of its episode. You let what follows be 0 one step too early.",
            {"if ends[t]:": "if t + 1 < len(ends) and ends[t + 1]:"},
        ),
        "next_reward_alone": Mistake(
            "only the next reward is added. What follows is the next return, which holds all that is still to come.",
            {"follows = g[t]": "follows = rewards[t]"},
        ),
        "nothing_before_an_end": Mistake(
            "follows is 0 for good after the first end. Set it to 0 only at an end, and to g[t] after each step.",
            {"follows = g[t]": "follows = 0.0 if any(ends[t:]) else g[t]"},
        ),
    },
    hints=(
        "The return of a step is its reward, plus γ times the return of the next step. So begin at the last one.",
        "Go backward: for t in range(len(rewards) - 1, -1, -1). Keep the return that follows in a variable, and set it "
        "to 0 where ends[t] is true.",
        "In the loop, in this order: if ends[t]: follows = 0.0, then g[t] = rewards[t] + gamma * follows, then follows "
        "= …",
    ),
    gained="One pass from the evening to the morning, and each step knows what came of it. The next exercise does so "
    "with Q.",
    witnesses=WITNESSES,
)
