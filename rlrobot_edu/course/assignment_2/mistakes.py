"""The typical wrong answers to the exercises of assignment 2 that ask for a function, each an edit of the right one."""

from rlrobot_edu.course.grading.mistake import Mistake

PAST_THE_END = "this looks past the end. After a terminated step nothing follows, so the target is the reward alone."
STEP = "double_update(q1, q2, s, a, r, s_next, terminated, toss(), alpha, gamma)"

EPSILON_AT = [
    Mistake("this goes to 0 in the end. What is halved is the part above end.",
            {"end + (start - end)": "start"}),
    Mistake("end is forgotten: what is halved is the part above end, and end comes on top.", {"end + ": ""}),
    Mistake("start - end comes to nothing in the end, and end is added: so at t = 0 it must be start. Yours is more.",
            {"(start - end)": "start"}),
    Mistake("this falls by one half in each step. It should take half_life steps for that: t / half_life.",
            {"t / half_life": "t"}),
    Mistake("t and half_life have changed places.", {"t / half_life": "half_life / (t + 1e-9)"}),
    Mistake("e instead of 2: after half_life steps exactly one half must be left, not 37 %.",
            {"0.5 **": "float(np.exp(-1)) **"}),
    Mistake("whole half-lives alone are counted. Halving goes on in between, too: / instead of //.",
            {"t / half_life": "t // half_life"}),
    Mistake("this falls along a straight line. Halving is a power: 0.5 ** (t / half_life).",
            {"0.5 ** (t / half_life)": "max(0.0, 1 - 0.5 * t / half_life)"}),
]  # fmt: skip

POLICY_VALUE = [
    Mistake("e to the power of some hundreds is too large for a computer. Take the largest value off first: "
            "the probabilities stay the same.", {"(q_s - q_s.max()) / temperature": "q_s / temperature"}),
    Mistake("this is what the best action is worth. The policy takes the others, too, now and then.",
            {"sum(powers * q_s) / sum(powers)": "q_s.max()"}),
    Mistake("this is the plain mean. Each value counts with its probability.",
            {"sum(powers * q_s) / sum(powers)": "q_s.mean()"}),
    Mistake("the probabilities must sum to 1: divide by the sum of the powers.", {" / sum(powers)": ""}),
    Mistake("the temperature divides the values: a high one makes them alike.",
            {"/ temperature": "* temperature"}),
    Mistake("the temperature is not used.", {" / temperature": ""}),
    Mistake("this is 0 for the best action: the values that are averaged are those of q_s, with nothing taken off.",
            {"powers * q_s": "powers * (q_s - q_s.max())"}),
    Mistake("the sign is the wrong way round: this policy prefers the worst action.",
            {"(q_s - q_s.max())": "(q_s.min() - q_s)"}),
]  # fmt: skip

DOUBLE_UPDATE = [
    Mistake(PAST_THE_END, {"r if terminated else": ""}),
    Mistake("this is Q-learning in one table: what learns picks the best action of s' and tells its worth, too. "
            "The worth must come from the other one.", {"judges[s_next, best]": "learns[s_next, best]"}),
    Mistake("the other table picks and judges. The table that learns picks the action; the other tells its worth.",
            {"learns[s_next].argmax()": "judges[s_next].argmax()"}),
    Mistake("picker and judge have changed places: the table that learns picks, the other judges.",
            {"learns[s_next].argmax()": "judges[s_next].argmax()", "judges[s_next, best]": "learns[s_next, best]"}),
    Mistake("heads is the wrong way round: with heads q1 learns.", {"if heads": "if not heads"}),
    Mistake("the coin is not looked at: q1 learns always.", {"if heads": "if True"}),
    Mistake("both tables change. A step teaches one of them, as the coin has fallen.",
            {"learns[s, a] += alpha * (target - learns[s, a])":
             "learns[s, a] += alpha * (target - learns[s, a]); judges[s, a] += alpha * (target - judges[s, a])"}),
    Mistake("the TD error is the target minus the old value of the table that learns.",
            {"target - learns[s, a]": "target - judges[s, a]"}),
    Mistake("γ is missing: what comes a step later counts γ times.", {"gamma * ": ""}),
    Mistake("argmax tells which action is best; the target needs how much it is worth, in the other table.",
            {"judges[s_next, best]": "best"}),
    Mistake("the action is picked in s. It is s' in which the best action is looked for.",
            {"learns[s_next].argmax()": "learns[s].argmax()"}),
]  # fmt: skip

DOUBLE_LEARN = [
    Mistake("only q1 chooses. Both tables have learned: choose by their sum.", {"q1 + q2": "q1"}),
    Mistake("only q2 chooses. Both tables have learned: choose by their sum.", {"q1 + q2": "q2"}),
    Mistake("the coin is tossed anew for each step; yours always falls the same way.", {"toss()": "True"}),
    Mistake("one toss for a whole episode is too few: toss the coin in each step.",
            {"env.reset(), False": "env.reset(), False\n        heads = toss()", "toss()": "heads"}),
    Mistake("an episode is over when it is truncated, too.", {"terminated or truncated": "terminated"}),
    Mistake("a truncated step has only run out of time: hand over terminated alone.",
            {"s_next, terminated, toss()": "s_next, terminated or truncated, toss()"}),
    Mistake("s stays where it was: go on from s_next.", {"s, over = s_next,": "s, over = s,"}),
    Mistake("a terminated step teaches, too: its target is the reward alone. Update in every step.",
            {STEP: f"if not terminated: {STEP}"}),
    Mistake("s and s_next have changed places in the update.",
            {STEP: "double_update(q1, q2, s_next, a, r, s, terminated, toss(), alpha, gamma)"}),
    Mistake("α and γ have changed places in the update.",
            {STEP: "double_update(q1, q2, s, a, r, s_next, terminated, toss(), gamma, alpha)"}),
    Mistake("the world is reset at the start of each episode.",
            {"for _ in range(episodes):\n        s, over = env.reset(), False":
             "s = env.reset()\n    for _ in range(episodes):\n        over = False"}),
]  # fmt: skip
