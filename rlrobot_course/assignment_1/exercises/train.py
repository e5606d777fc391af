"""Q-learning, episode by episode."""

from __future__ import annotations

from rlrobot_course.assignment_1.given import TARGET
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import NO_GAMMA, PAST_THE_END
from rlrobot_course.tapes import Q_START, Chooser, PatientWorld


def train(env, q, choose, episodes, alpha, gamma):
    sums = []
    for _ in range(episodes):
        s, total, over = env.reset(), 0.0, False
        while not over:
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            target = r if terminated else r + gamma * max(q[s_next])
            q[s, a] += alpha * (target - q[s, a])
            s, total, over = s_next, total + r, terminated or truncated
        sums.append(total)
    return sums


CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="learn for so many episodes, and return the list of their sums of rewards",
    right=train,
    returns="sums",
    memory={"env": PatientWorld(), "q": Q_START},
    tape=[
        {"choose": Chooser(rank), "episodes": n, "alpha": alpha, "gamma": gamma}
        for rank, n, alpha, gamma in ((0, 1, 0.5, 0.9), (1, 1, 0.1, 0.8), (2, 3, 0.25, 0.9), (0, 2, 0.4, 0.7))
    ],
    mistakes={
        "past_the_end": Mistake(PAST_THE_END, {TARGET: "r + gamma * max(q[s_next])"}),
        "truncated_as_terminated": Mistake(
            "a truncated episode has only run out of time: its last target keeps γ · max Q(s', ·).",
            {"r if terminated else": "r if terminated or truncated else"},
        ),
        "only_terminated_is_over": Mistake(
            "an episode is over when it is truncated, too.", {"terminated or truncated": "terminated"}
        ),
        "sums_run_on": Mistake(
            "each episode has its own sum: set it back to 0 when one begins.",
            {
                "s, total, over = env.reset(), 0.0, False": (
                    "s, total, over = env.reset(), sums[-1] if sums else 0.0, False"
                )
            },
        ),
        "resets_once": Mistake("the world is reset once an episode, before its first step.", CHANGED["resets_once"]),
        "no_last_reward": Mistake(
            "the reward of an episode's last step counts in its sum, too.",
            {"total + r,": "total + r * (not (terminated or truncated)),"},
        ),
        "discounted_sums": Mistake(
            "the sums here are not discounted: add the rewards as they are.", {"total + r": "gamma * total + r"}
        ),
        "stays": Mistake(
            "s stays where it was: go on from s_next.", {"s, total, over = s_next,": "s, total, over = s,"}
        ),
        "chooses_once": Mistake(
            "the action is chosen once and kept. Choose anew in each step, inside the inner loop.",
            CHANGED["chooses_once"],
        ),
        "last_sum_alone": Mistake(
            "the last sum alone is returned. Keep one sum for each episode, in a list.",
            {"return sums": "return sums[-1]"},
        ),
        "no_gamma": Mistake(NO_GAMMA, {"gamma * max": "max"}),
        "no_alpha": Mistake("α is missing: go that share of the way, not the whole.", {"alpha * (": "("}),
    },
    hints=(
        "Two loops, one in the other: episodes, and the steps of one. An episode begins with a reset and a sum of 0.",
        "Inside: choose, step, target, q[s, a], add r to the sum, go on from s_next. It is over when terminated or "
        "truncated; only terminated makes the target r alone.",
        "s, total, over = env.reset(), 0.0, False; then while not over: …; and below that loop sums.append(total).",
    ),
    gained="A learner, written by you from its equations. Now let it work.",
    witnesses=WITNESSES,
)
