"""The typical wrong answers to the exercises of assignment 5 that ask for a function, each an edit of the right one."""

from rlrobot_edu.course.grading.mistake import Mistake

NEAR = 'min(front, after["laser_front_left"], after["laser_front_right"])'
COMING = '1 if front > 0.35 and front < before["laser_front"] - 0.01 else 0'
SEEN = "[r + gamma * old[s_next] for s_row, a, r, s_next in rows if (s_row, a) == (s, policy[s])]"

PARK = [
    Mistake("driving through the right place is paid as parking there. Parked is who has not moved: less than 0.01 m.",
            {" and moved < 0.01": ""}),
    Mistake("too near is paid as well: at 0.15 m or less the robot is not parked well.", {"0.15 < front": "front"}),
    Mistake("too far is paid as well: beyond 0.35 m the robot is not parked.", {"front <= 0.35": "front"}),
    Mistake("nothing leads the robot to the wall: from afar, coming nearer must be worth more than standing there.",
            {COMING: "0"}),
    Mistake("whoever drives afar is paid, also away from the wall. Is the wall ahead nearer than before?",
            {COMING: "1 if moved > 0.01 else 0"}),
    Mistake("leaving the wall is paid, and coming is not: compare the front laser after and before the step.",
            {'front < before["laser_front"] - 0.01': 'front > before["laser_front"] + 0.01'}),
    Mistake("touching costs nothing. What is forbidden must be the smallest reward.", {"return -2": "pass"}),
    Mistake("only touching in front costs. The two lasers beside it count, too.", {NEAR: "front"}),
    Mistake("the laser at the front right is forgotten.", {', after["laser_front_right"]': ""}),
    Mistake("the laser at the front left is forgotten.", {', after["laser_front_left"]': ""}),
    Mistake("coming nearer is paid as well as being there. Then why should it ever stop?", {"return 10": "return 1"}),
    Mistake("standing anywhere is paid. Only 0.15 to 0.35 m in front of a wall is parked.",
            {"0.15 < front <= 0.35 and moved": "moved"}),
]  # fmt: skip

VALUE = [
    Mistake("this is the value of the best actions. Asked is that of the policy: only rows in which a is policy[s].",
            {"if (s_row, a) == (s, policy[s])": "if s_row == s"}),
    Mistake("γ is missing: what comes a step later counts γ times.", {"gamma * ": ""}),
    Mistake("the rewards are missing.", {"r + gamma": "gamma"}),
    Mistake("these are rewards alone: what follows counts γ times, by the values of the sweep before.",
            {"r + gamma * old[s_next]": "r"}),
    Mistake("this adds up all rows. Each of them is one of several things that may happen: take their mean.",
            {"sum(seen) / len(seen)": "sum(seen)"}),
    Mistake("values change within the sweep. All of a sweep come from those of the sweep before: keep a copy.",
            {"old = v.copy()": "old = v"}),
    Mistake("the share of a row is among those of its pair (s, a), not among all rows.",
            {"/ len(seen)": "/ len(rows)"}),
    Mistake("a pair that was never tried counts 0 here.", {"if seen else 0": "if seen else 1"}),
    Mistake("a sweep is missing.", {"range(sweeps)": "range(sweeps - 1)"}),
    Mistake("what follows is worth v[s'], not v[s].", {"old[s_next]": "old[s]"}),
    Mistake("not the luckiest row counts, but the mean of them.", {"sum(seen) / len(seen)": "max(seen)"}),
]  # fmt: skip

INTERVAL = [
    Mistake("divide the sum of squares by n − 1, not by n: np.std(…, ddof=1).", {", ddof=1": ""}),
    Mistake("this is how far single robots spread. The mean of n is surer: divide by the root of n.",
            {" / np.sqrt(n)": ""}),
    Mistake("the spread of a mean goes with the root of n, not with n.", {"np.sqrt(n)": "n"}),
    Mistake("t is missing.", {"t * ": ""}),
    Mistake("this is the variance. Take its root, the standard deviation.", {"np.std": "np.var"}),
    Mistake("these are the ends of an interval around 0. Add the mean.",
            {"[mean - half, mean + half]": "[-half, half]"}),
    Mistake("asked are the two ends, the lower first: mean − half and mean + half.",
            {"[mean - half, mean + half]": "[mean, half]"}),
    Mistake("the lower end comes first.", {"[mean - half, mean + half]": "[mean + half, mean - half]"}),
    Mistake("the interval is twice as wide as it should be: half of it lies on each side.",
            {"half = t": "half = 2 * t"}),
    Mistake("this is the median. The interval is around the mean.", {"np.mean(values)": "np.median(values)"}),
    Mistake("these are the smallest and the largest value. The interval is that of their mean.",
            {"[mean - half, mean + half]": "[np.min(values), np.max(values)]"}),
]  # fmt: skip

DIFFERENCES = "low, high = interval(np.subtract(first, second), t)"

VERDICT = [
    Mistake("this only asks whose mean is larger, and chance alone makes one of them larger. Look at the interval.",
            {"low > 0": "low + high > 0", "high < 0": "low + high < 0"}),
    Mistake("the robots are compared as if they were strangers. Number i of both had the same world: take the "
            "differences of the pairs first.",
            {DIFFERENCES: "one, other = interval(first, t), interval(second, t)\n"
                          "    low, high = one[0] - other[1], one[1] - other[0]"}),
    Mistake("first and second have changed places.", {'return "first"': 'return "second"',
                                                      'return "second"': 'return "first"'}),
    Mistake("an interval that reaches 0 leaves it open: only above 0, or below it, is decided.",
            {"low > 0": "low >= 0"}),
    Mistake("this never finds the second better: what if the whole interval lies below 0?",
            {'return "second"': 'return "open"'}),
    Mistake("this never leaves it open. Where the interval holds 0, nobody knows.",
            {'return "open"': 'return "second"'}),
    Mistake("low is the end nearer to minus infinity: first is better if even that end lies above 0.",
            {"low > 0": "high > 0"}),
]  # fmt: skip
