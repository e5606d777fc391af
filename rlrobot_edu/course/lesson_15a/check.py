"""Exercises of appendix 15a: learning from a recording, what two pupils look at, and where a recording ends."""

from __future__ import annotations

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.grading.tapes import Q_START, TAPE
from rlrobot_edu.course.lesson_15a import solutions

_ROWS = [tuple(row[name] for name in ("s", "a", "r", "s_next", "terminated")) for row in TAPE]
# Recordings of one row, of an episode, of what was cut off, of several episodes; and one that comes back to its pairs.
_PARTS = ((0, 1), (4, 5), (0, 5), (5, 8), (0, 9), (0, 0))
_BEST = "0 if terminated else max(q[s_next])"
_STEP = "q[s, a] + alpha * (r + gamma * best - q[s, a])"

learn_from = Exercise(
    task="go through the rows and let Q-learning learn from each",
    right=solutions.learn_from,
    memory={"q": Q_START},
    tape=[
        {"rows": _ROWS[first:last], "alpha": alpha, "gamma": gamma}
        for (first, last), alpha, gamma in zip(_PARTS, (0.1, 0.5, 0.2, 0.3, 0.1, 0.1), (0.9, 0.8, 0.9, 0.7, 0.95, 0.9),
                                               strict=True)
    ],
    mistakes=[
        Mistake("this bootstraps past the end. After a terminal row nothing follows, so the target is the reward "
                "alone.", {_BEST: "max(q[s_next])"}),
        Mistake("the if is the wrong way round: nothing follows where the episode has ended.",
                {"0 if terminated else max": "0 if not terminated else max"}),
        Mistake("only one row has been learned: is return, or break, inside the loop?",
                {_STEP: f"{_STEP}\n        break"}),
        Mistake("a terminal row is a row to learn from, too, often the best one. Do not skip it.",
                {f"best = {_BEST}": "if terminated:\n            continue\n        best = max(q[s_next])"}),
        Mistake("the rows go on after an episode has ended: do not stop at terminated.",
                {_STEP: f"{_STEP}\n        if terminated:\n            break"}),
        Mistake("the rows are gone through backwards. A clever idea, but the exercise asks for their order.",
                {"in rows": "in rows[::-1]"}),
        Mistake("the last row is left out. Q-learning needs no next row, so it can learn from it.",
                {"in rows": "in rows[:-1]"}),
        Mistake("the recorded action takes the place of the best one only in SARSA. Q-learning looks at max Q(s', ·).",
                {"max(q[s_next])": "q[s_next, a]"}),
        Mistake("look ahead into the row of s', not of s.", {"max(q[s_next])": "max(q[s])"}),
        Mistake("you forgot γ.", {"gamma * ": ""}),
        Mistake("the reward is missing in the target: r + γ · the best of s'.", {"(r + gamma": "(gamma"}),
        Mistake("you forgot − Q(s, a): the update goes a part α of the way from Q(s, a) to the target.",
                {" - q[s, a])": ")"}),
        Mistake("you forgot α: the update goes only a part of the way.", {"alpha * ": ""}),
        Mistake("the old Q(s, a) is lost: add to it.", {f"= {_STEP}": f"= {_STEP.partition(' + ')[2]}"}),
        Mistake("the sign: Q(s, a) moves towards the target.", {"q[s, a] + alpha": "q[s, a] - alpha"}),
        Mistake("this learns in the row of s'. It is Q(s, a), of the state in which the action was taken.",
                {f"q[s, a] = {_STEP}": f"q[s_next, a] = {_STEP.replace('q[s, a]', 'q[s_next, a]')}"}),
        Mistake("the mean over the actions is not Q-learning: it takes the best one.",
                {"max(q[s_next])": "q[s_next].mean()"}),
        Mistake("what the teacher did is not made better by hand: learn from r, whatever the action was.",
                {_STEP: "q[s, a] + 1"}),
    ],
    hints=(
        "Nobody chooses here: s, a, r and s' all stand in the row. Of the loop of lesson 02 its update is left.",
        "for s, a, r, s_next, terminated in rows: and inside it the two lines of an update.",
        "best = 0 if terminated else max(q[s_next]); then q[s, a] = q[s, a] + alpha * (… − q[s, a])",
    ),
    gained="Two lines and a loop turn what a person did into what an agent knows. Below it teaches your own agent.",
)  # fmt: skip

two_targets = Question(
    task="the target of Q-learning and the target of SARSA, as (…, …)",
    right=solutions.two_targets,
    because="Q-learning counts on the best of s', 10 + 0.9 · 40; SARSA on what the teacher did there, 10 + 0.9 · 5.",
    mistakes=[
        Mistake("these are the right numbers in the wrong order: Q-learning's first.", (10 + 0.9 * 5, 10 + 0.9 * 40)),
        Mistake("both look at the best action here. SARSA looks at the one that the teacher took next.",
                (46.0, 46.0)),
        Mistake("both look at the teacher's next action here. Q-learning looks at the best one.", (14.5, 14.5)),
        Mistake("you forgot γ.", (50, 15)),
        Mistake("the reward of the step is missing.", (36, 4.5)),
        Mistake("a target is r + γ · …; the γ does not belong to r.", (45.0, 13.5)),
    ],
    hints=(
        "Both targets are r + 0.9 · a value of s'. Which one does each take?",
        "Q-learning: the largest of the three. SARSA: that of a' = 2.",
        "(10 + 0.9 * 40, 10 + 0.9 * …)",
    ),
    gained="This one number is why the same bad teacher teaches them different things.",
)  # fmt: skip

last_action = Question(
    task='a letter, such as "A"',
    right=solutions.last_action,
    because="The robot was still on its way, so something follows; what the driver would have pressed, nobody knows. "
    "The agent's own choice is the only one that can be had.",
    mistakes=[
        Mistake("the episode has not ended: the driver stopped, the robot did not. To count nothing after it says that "
                "all is over there, and makes a good place look bad.", "A"),
        Mistake("the first row of a recording is no answer to its last state: it was pressed somewhere else.", "B"),
        Mistake("not every driver repeats the last button. Nobody knows what this one would have pressed.", "D"),
    ],
    hints=(
        "Was the step terminated? Then what does follow?",
        "Only one of the four does not make up what the driver did, nor an end.",
        "Who else can choose an action in s'?",
    ),
    gained="It is one row of 300. With many short lessons it would be many.",
)  # fmt: skip
