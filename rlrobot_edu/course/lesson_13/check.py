"""Exercises of lesson 13: two numbers for a pair, a world made of rows, how many samples, and what luck is worth."""

from __future__ import annotations

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_13 import solutions

# (s, a, r, s'): the pair (0, 1) leads to state 1 four times, to 2 twice and to 0 once; (2, 0) was seen only once
ROWS = [
    (0, 1, -2.0, 1), (1, 1, 10.0, 0), (0, 1, 10.0, 1), (0, 0, -0.02, 2), (2, 0, 10.0, 3), (0, 1, -0.02, 2),
    (0, 1, 10.0, 1), (3, 1, -2.0, 1), (1, 1, -0.02, 3), (0, 1, 10.0, 0), (0, 1, -0.02, 1), (0, 0, 10.0, 0),
    (1, 0, -2.0, 0), (0, 1, 10.0, 2), (1, 1, 10.0, 0), (3, 1, -2.0, 1),
]  # fmt: skip
ASKED = [(0, 1), (1, 1), (0, 0), (2, 0), (3, 1), (2, 1)]

BOTH = "(len(seen) / n, sum(seen) / len(seen))"
THE_PAIR = "(s_row, a_row) == (s, a)"

estimate = Exercise(
    task="return, for every next state that was seen after (s, a), its probability and its mean reward",
    right=solutions.estimate,
    returns="estimate",
    tape=[{"rows": ROWS, "s": s, "a": a} for s, a in ASKED],
    mistakes=[
        Mistake("the counts are divided by the number of all rows. Divide by how often this pair was tried.",
                {"sum(len(seen) for seen in rewards.values())": "len(rows)"}),
        Mistake("rows with other actions are counted, too. Both have to agree, s and a.", {THE_PAIR: "s_row == s"}),
        Mistake("rows from other states are counted, too. Both have to agree, s and a.", {THE_PAIR: "a_row == a"}),
        Mistake("these are counts. A probability is a count divided by how often the pair was tried.",
                {"len(seen) / n": "len(seen)"}),
        Mistake("the rewards are added up. Their mean is asked: divide by how many there are.",
                {"sum(seen) / len(seen)": "sum(seen)"}),
        Mistake("the rewards of one next state are divided by how often the pair was tried. Divide by how often it led "
                "to this next state.", {"sum(seen) / len(seen)": "sum(seen) / n"}),
        Mistake("the two have changed places: first the probability, then the mean reward.",
                {BOTH: "(sum(seen) / len(seen), len(seen) / n)"}),
        Mistake("this is the last reward that was seen there. Take the mean of all.",
                {"sum(seen) / len(seen)": "seen[-1]"}),
        Mistake("this is the first reward that was seen there. Take the mean of all.",
                {"sum(seen) / len(seen)": "seen[0]"}),
        Mistake("this is the largest reward that was seen there. Take the mean of all.",
                {"sum(seen) / len(seen)": "max(seen)"}),
        Mistake("each different reward counts once here. A reward counts as often as it was seen.",
                {"sum(seen) / len(seen)": "sum(set(seen)) / len(set(seen))"}),
        Mistake("all next states get the same probability. Count how often each of them came.",
                {"len(seen) / n": "1 / len(rewards)"}),
        Mistake("this is the mean reward of the pair, whatever came next. Each next state has a mean of its own.",
                {"sum(seen) / len(seen)": "sum(map(sum, rewards.values())) / n"}),
        Mistake("a row belongs to the pair by the state it begins in, its first number; s′ is its last.",
                {THE_PAIR: "(s_next, a_row) == (s, a)"}),
        Mistake("only the probability is here. The mean reward belongs beside it: a tuple of two for each next state.",
                {BOTH: "len(seen) / n"}),
        Mistake("only the mean reward is here. The probability stands before it: a tuple of two for each next state.",
                {BOTH: "sum(seen) / len(seen)"}),
        Mistake("// cuts off what comes after the point; divide with /.", {"len(seen) / n": "len(seen) // n"}),
        Mistake("the counts are divided by how often the state was visited. Divide by how often this pair was tried.",
                {"sum(len(seen) for seen in rewards.values())": "sum(row[0] == s for row in rows)"}),
        Mistake("this is in per cent. A probability lies between 0 and 1.", {"len(seen) / n": "100 * len(seen) / n"}),
        Mistake("the states in s are taken for those in s′: the keys are next states.",
                {"setdefault(s_next, [])": "setdefault(s_row, [])"}),
    ],
    hints=(
        "Go through the rows once, and keep for each next state the rewards that came with it. Their number gives the "
        "probability, their mean the reward.",
        "A dict of lists: rewards.setdefault(s_next, []).append(r) for each row of the pair. n is how many rows the "
        "pair has.",
        "return {s_next: (len(seen) / n, sum(seen) / len(seen)) for s_next, seen in rewards.items()}",
    ),
    gained="These are T and R, the two tables that a model of a world consists of.",
)  # fmt: skip

DRAWN = "seen[int(u * len(seen))]"
DRAWS = [(0, 1, 0.5), (0, 1, 0.0), (0, 1, 0.2), (0, 1, 0.93), (0, 1, 0.72), (1, 1, 0.6), (1, 1, 0.99), (0, 0, 0.51),
         (2, 0, 0.99), (2, 0, 0.0), (3, 1, 0.4), (2, 1, 0.3), (0, 1, 0.14), (0, 1, 0.45), (0, 1, 0.36)]  # fmt: skip

sample = Exercise(
    task="return s′ and r of one of the rows of (s, a), the row number int(u · n) of the n that there are; None if "
    "there is none",
    right=solutions.sample,
    returns="outcome",
    tape=[{"rows": ROWS, "s": s, "a": a, "u": u} for s, a, u in DRAWS],
    mistakes=[
        Mistake("the two have changed places: first s′, then r.", {"(s_next, r) for": "(r, s_next) for"}),
        Mistake("rows with other actions are drawn, too. Both have to agree, s and a.", {THE_PAIR: "s_row == s"}),
        Mistake("rows from other states are drawn, too. Both have to agree, s and a.", {THE_PAIR: "a_row == a"}),
        Mistake("with n − 1 the last row is never drawn, for u stays below 1. Multiply by n.",
                {"u * len(seen)": "u * (len(seen) - 1)"}),
        Mistake("round goes up as well as down, so the first and the last row come half as often as the others. "
                "int(u · n) gives each the same share.", {"int(u * len(seen))": "round(u * (len(seen) - 1))"}),
        Mistake("this is always the first row. Which one it is, u decides.", {DRAWN: "seen[0]"}),
        Mistake("this is always the last row. Which one it is, u decides.", {DRAWN: "seen[-1]"}),
        Mistake("this is always the most frequent outcome. Then nothing is left to chance; u decides which one it is.",
                {DRAWN: "max(seen, key=seen.count)"}),
        Mistake("every different outcome is equally probable here. One that was seen three times has to come three "
                "times as often: keep all its rows.",
                {DRAWN: "list(dict.fromkeys(seen))[int(u * len(set(seen)))]"}),
        Mistake("this is the state that the row begins in. What comes next is its last number, s′.",
                {"(s_next, r) for": "(s_row, r) for"}),
        Mistake("this is the whole row. Return s′ and r alone.", {"(s_next, r) for": "(s_row, a_row, r, s_next) for"}),
        Mistake("this is one row too early: int(u · n) is 0 for the first row.",
                {"int(u * len(seen))": "int(u * len(seen)) - 1"}),
        Mistake("a pair that was never tried has nothing to draw from: return None.", {"else None": "else (s, 0.0)"}),
        Mistake("a row belongs to the pair by the state it begins in, its first number; s′ is its last.",
                {THE_PAIR: "(s_next, a_row) == (s, a)"}),
        Mistake("this counts from the last row back. Row number int(u · n) is counted from the first.",
                {DRAWN: "seen[-1 - int(u * len(seen))]"}),
        Mistake("the rows are sorted first. Leave them in the order in which they were recorded.",
                {DRAWN: "sorted(seen)[int(u * len(seen))]"}),
        Mistake("only s′ is here. The reward belongs to it.", {DRAWN: f"{DRAWN}[0]"}),
        Mistake("only the reward is here. s′ stands before it.", {DRAWN: f"{DRAWN}[1]"}),
    ],
    hints=(
        "First collect (s′, r) of all rows of the pair, in their order. Then take one of them by its number.",
        "A list: seen = [(s_next, r) for …, if state and action agree]. u · n lies between 0 and n, and int cuts off "
        "what comes after the point.",
        "return seen[int(u * len(seen))] if seen else None",
    ),
    gained="With this one function a list of rows becomes a world to learn in. Yours will be one in a moment.",
)  # fmt: skip

enough = Question(
    task="the number of samples that bring two standard errors down to 0.1, for p = 0.5",
    right=solutions.enough,
    because="2 · √(0.25 / 100) = 0.1. For half of that, ±0.05, it takes four times as many.",
    mistakes=[
        Mistake("this is √n. What is n?", 10),
        Mistake("this is with one standard error. Two of them shall be 0.1.", 25),
        Mistake("this is with 1.96 standard errors. Take two.", 96.04),
        Mistake("this is with 1.96 standard errors. Take two.", 97),
        Mistake("this is with 1.96 standard errors. Take two.", 96),
        Mistake("this would be ±0.05. The 0.1 is the distance to either side.", 400),
        Mistake("the 2 stands before the root: in n it counts squared, as 4.", 50),
        Mistake("the root is missing: 0.1 counts squared, too.", 5),
        Mistake("p (1 − p) is 0.5 · 0.5.", 200),
        Mistake("this is the standard error squared. How many samples make it so small?", 0.0025),
    ],
    hints=(
        "Put p = 0.5 into 2 √(p (1 − p) / n), set it to 0.1, and solve for n.",
        "2 · √(0.25 / n) = 2 · 0.5 / √n = 1 / √n.",
        "1 / √n = 0.1, so √n = 10.",
    ),
    gained="Of the pairs that a robot has tried in five hours, few have so many samples. You will see how few.",
)

second_look = Question(
    task="Q(s, a) of a pair that was seen twice, once as a loop and once on its way to a state of value 40",
    right=solutions.second_look,
    because="x = 0.5 (10 + 0.9 x) + 0.5 (−0.02 + 36), so x = 22.99 / 0.55. From 100 to 42, by one more sample.",
    mistakes=[
        Mistake("this is with the first sample alone. Now each of the two has the probability 0.5.", 100),
        Mistake("this is with the second sample alone. Each of the two has the probability 0.5.", 35.98),
        Mistake("this is the mean of 100 and 35.98. But the loop is worth 100 only if it never ends: behind the first "
                "outcome stands the value x that you are looking for, not 100.", 67.99),
        Mistake("the loop leads back to s: in that half the value 0.9 x comes on top.", 22.99),
        Mistake("the loop leads back to s: in that half the value 0.9 x comes on top. And the 40 is discounted.",
                24.99),
        Mistake("the 40 is one step away: it counts 0.9 times.", 24.99 / 0.55),
        Mistake("0.9 x stands there only in half of the cases: x = 22.99 + 0.45 x.", 229.9),
        Mistake("the two halves are missing: each outcome counts 0.5 times.", 459.8),
        Mistake("the outcomes count 0.5 times each, and so does what they pay.", 45.98 / 0.55),
        Mistake("the way back to s is discounted, too: it is 0.5 · 0.9 x.", 45.98),
        Mistake("this is the mean reward for ever. But the second outcome leads away, to the value 40.", 49.9),
        Mistake("what does the loop's half pay now, and what comes after it?", 17.99 / 0.55),
    ],
    hints=(
        "Call the value x. It is the mean of two outcomes, and in one of them x itself comes next.",
        "x = 0.5 · (10 + 0.9 x) + 0.5 · (−0.02 + 0.9 · 40)",
        "x (1 − 0.45) = 5 + 17.99",
    ),
    gained="So a trap is not a matter of the method: it stands and falls with a single row.",
)  # fmt: skip
