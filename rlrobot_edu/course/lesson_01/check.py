"""Exercises of lesson 01: bins, states and rewards."""

from __future__ import annotations

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.lesson_01 import solutions
from rlrobot_edu.course.lesson_01.design import PAIRS, Design

LASER = [0.27, 0.53, 0.80]  # cut points [m]
ANGLE = [-45, 0, 45, 90]  # cut points [deg]

bin_of = Exercise(
    task="return the number of the bin that the reading x falls into",
    right=solutions.bin_of,
    returns="bin",
    tape=[{"x": x, "cuts": LASER} for x in (0.53, 0.70, 0.10, 0.30, 2.00, 0.27, 0.80)]
    + [{"x": x, "cuts": [0.20]} for x in (0.20, 0.21)]
    + [{"x": x, "cuts": ANGLE} for x in (-30, -90, 90, 180, 0, 20)]
    + [{"x": x, "cuts": [1.5, 1.6, 4.0, 4.5, 9.0]} for x in (4.2, 1.55, 5, 9.1)],
    mistakes=[
        Mistake("a reading exactly on a cut point belongs to the bin below it: x ≤ c₁ is bin 0.",
                {"x > cut": "x >= cut"}),
        Mistake("bins are counted from 0, and yours from 1.", {"number = 0": "number = 1"}),
        Mistake("these are the cut points above x. The number of the bin is how many lie below it.",
                {"x > cut": "x <= cut"}),
        Mistake("these are the cut points above x. The number of the bin is how many lie below it.",
                {"x > cut": "x < cut"}),
        Mistake("this is the index of the last cut point below x; the bin's number is one more.",
                {"number = 0": "number = -1"}),
        Mistake("the first cut point does not count here. Is it left out, or is it its index that you return? The bin's "
                "number is how many cut points lie below x.", {"in cuts": "in cuts[1:]"}),
        Mistake("the last bin is missing: k cut points make k + 1 bins, and beyond the last cut is bin k. Do you go "
                "through all cut points?",
                {"return number": "return min(number, len(cuts) - 1)"}),
        Mistake("0 or 1: this tells only whether x lies above the first cut point. Compare x with every one of them, "
                "add 1 each time (number += 1), and return when the loop is over.", {"in cuts": "in cuts[:1]"}),
        Mistake("this is a cut point, and what is asked is the number of the bin.",
                {"if x > cut": "if x <= cut", "number += 1": "return cut", "return number": "return cut"}),
        Mistake("this is a cut point, and what is asked is the number of the bin.",
                {"number += 1": "number = cut"}),
        Mistake("this adds up the cut points below x. Count them: number += 1.", {"number += 1": "number += cut"}),
        Mistake("the bins are not equally wide, so dividing does not tell which it is. Compare with the cut points.",
                {"return number": "return int(x // cuts[0])"}),
        Mistake("this is the cut point nearest to x. Ask how many lie below it.",
                {"return number": "return min(range(len(cuts)), key=lambda i: abs(cuts[i] - x))"}),
        Mistake("a reading may be negative, as an angle is. Compare x itself, not abs(x).", {"x > cut": "abs(x) > cut"}),
        Mistake("every reading is cut at 0.27, 0.53 and 0.80 here. Use the list cuts that the function is given.",
                {"in cuts": "in [0.27, 0.53, 0.80]"}),
        Mistake("comparing rounded readings moves them into other bins. Compare x as it is.",
                {"x > cut": "round(x, 1) > cut"}),
        Mistake("comparing rounded readings moves them into other bins. Compare x as it is.",
                {"x > cut": "int(x) > cut"}),
        Mistake("the last bin's number is len(cuts), 1 more than the index of the last cut point.",
                {"return number": "return number if number < len(cuts) else len(cuts) + 1"}),
    ],
    hints=(
        "For x = 0.30 and the cuts 0.27, 0.53, 0.80 only one cut point lies below x. So the bin is 1.",
        "Begin with number = 0, go through the cut points with a loop, and add 1 for each that is smaller than x.",
        "for cut in cuts: if x > cut: number += 1. After the loop: return number.",
    ),
    gained="You have given a robot its eyes: from now on, every reading in this course goes through these few lines.",
)  # fmt: skip

ROBOT = [2, 2, 3, 2]  # bins of the inputs of worked_example

state_number = Exercise(
    task="return the number of the state that has these bins",
    right=solutions.state_number,
    returns="state",
    tape=[{"bins": bins, "shape": ROBOT} for bins in ([1, 0, 1, 1], [0, 1, 2, 0], [0, 0, 0, 1], [1, 1, 2, 1])]
    + [
        {"bins": [2, 1], "shape": [3, 4]},
        {"bins": [1, 3, 0, 2], "shape": [2, 5, 3, 4]},
        {"bins": [4], "shape": [6]},
        {"bins": [0, 1, 3, 3, 1], "shape": [4, 4, 4, 4, 4]},
        {"bins": [2, 6, 11], "shape": [3, 7, 12]},
        {"bins": [0, 0, 0], "shape": [3, 2, 5]},
    ],
    mistakes=[
        Mistake("here the first input varies fastest. It should vary slowest: begin with the first bin.",
                {"zip(bins, shape": "zip(bins[::-1], shape[::-1]"}),
        Mistake("each bin is multiplied by the size of its own input, too. Multiply first, then add the bin.",
                {"s * n + b": "(s + b) * n"}),
        Mistake("this is the sum of the bins, which different states share. Each input needs its own weight.",
                {"s * n + b": "s + b"}),
        Mistake("all inputs were taken to have as many bins as the first one. Each has its own number in shape.",
                {"s * n": "s * shape[0]"}),
        Mistake("all inputs were taken to have two bins. Each has its own number in shape.", {"s * n": "s * 2"}),
        Mistake("all inputs were taken to have as many bins as the last one. Each has its own number in shape.",
                {"s * n": "s * shape[-1]"}),
        Mistake("all inputs were taken to have as many bins as the largest. Each has its own number in shape.",
                {"s * n": "s * max(shape)"}),
        Mistake("what you have is multiplied by how many inputs there are. Multiply it by how many bins the input has.",
                {"s * n": "s * len(shape)"}),
        Mistake("these are the bins read as a decimal number. A place is worth as much as the inputs after it have "
                "combinations.", {"s * n": "s * 10"}),
        Mistake("these are the bins read as a decimal number. A place is worth as much as the inputs after it have "
                "combinations.", {"return s": "return int(''.join(map(str, bins)))"}),
        Mistake("states are counted from 0, and yours from 1.", {"return s": "return s + 1"}),
        Mistake("each bin is multiplied by the size of its own input alone. What has been added up so far is to be "
                "multiplied.", {"s * n + b": "s + b * n"}),
        Mistake("the last input is left out.", {"zip(bins, shape": "zip(bins[:-1], shape[:-1]"}),
        Mistake("the first input is left out. Begin with s = 0 and go through all the inputs.",
                {"zip(bins, shape": "zip(bins[1:], shape[1:]"}),
        Mistake("the first bin is counted twice: it is in s already when the loop begins. Begin with s = 0.",
                {"s = 0": "s = bins[0]"}),
        Mistake("counting begins at 0: with s = 1 at the start, every state has a number too large.",
                {"s = 0": "s = 1"}),
        Mistake("a bin of 0 adds nothing, but what has been added up so far is still to be multiplied.",
                {"s * n + b": "s * n + b if b else s"}),
        Mistake("you multiply by the size of the input before this one. Take the input's own: b₂ goes with n₂.",
                {"s * n + b": "s * m + b; m = n", "s = 0": "s, m = 0, 1"}),
        Mistake("the bins come in their order and the sizes in reverse. Go through both from first to last.",
                {"zip(bins, shape": "zip(bins, shape[::-1]"}),
        Mistake("the bins come in reverse. Go through bins and shape together, from first to last.",
                {"zip(bins, shape": "zip(bins[::-1], shape"}),
        Mistake("bin and size have changed places: multiply by the number of bins n, and add the bin b.",
                {"s * n + b": "s * b + n"}),
        Mistake("the return is inside the loop, so the function ends after the first input. Move it to the left.",
                {"s = s * n + b": "return s * n + b"}),
        Mistake("what has been added up so far is lost in each round. It is s · n + b, with s from the round before.",
                {"s * n + b": "b"}),
        Mistake("what has been added up so far is lost in each round. It is s · n + b, with s from the round before.",
                {"s * n + b": "b * n"}),
        Mistake("what has been added up is to be multiplied by n, and the bin is to be added. You do it twice: "
                "s += adds s once more; write s = .", {"s = s * n + b": "s += s * n + b"}),
        Mistake("you add the number of bins to what you have. Multiply by it: s * n + b.", {"s * n + b": "s + n + b"}),
        Mistake("this multiplies all bins together, and a single 0 makes it 0. It is s · n + b for each input.",
                {"return s": "import math; return math.prod(bins)"}),
        Mistake("this is how many states there are, for any bins. The bins say which of them it is.",
                {"return s": "import math; return math.prod(shape)"}),
        Mistake("here the size of every input before it is the weight of a bin. Its weight is the product of the sizes "
                "after it.", {"return s": "w = 1; t = 0\n    for b, n in zip(bins, shape): w *= n; t += b * w\n"
                              "    return t"}),
    ],
    hints=(
        "A mileage counter: when the next wheel comes in, all that you have so far counts n times as much.",
        "Begin with s = 0. For each input, with its bin b and its number of bins n, make s · n + b of s.",
        "for b, n in zip(bins, shape): s = s * n + b. After the loop: return s.",
    ),
    gained="Any robot of this course, whatever it senses, is now one number to you. Lesson 07 will use this function to "
    "find states that are alike.",
)  # fmt: skip

PAY = "10 if hypot(dx, dy) > 0.07 else -0.02"
reward = Design(
    task="return a number that is larger for what the robot should do than for what it should not",
    right=solutions.reward,
    returns="more is paid when it",
    tape=[{"wanted": wanted, "unwanted": unwanted} for wanted, unwanted in PAIRS],
    mistakes=[
        Mistake("every step is paid the same, so nothing is wanted more than anything else.",
                {"return -2": "pass", PAY: "1"}),
        Mistake("you pay for not touching anything, and who stands still touches nothing. Pay for driving: "
                "more than 0.07 m, and all readings are in metres.", {PAY: "1"}),
        Mistake("you pay for standing still. Is the sign of > the wrong way round, or that of the reward?",
                {"> 0.07": "< 0.07"}),
        Mistake("you pay for open space, and the robot need not move to have it. Compare x and y before and after.",
                {"dx, dy = ": "return min(left, right)\n    dx, dy = "}),
        Mistake("you pay for a change of the lasers' readings, and turning on the spot changes them, too.",
                {"dx, dy = ": "return abs(left - before['laser_front_left'])\n    dx, dy = "}),
        Mistake("only one direction pays. Driving back along x counts as well: is a minus sign in the way?",
                {"hypot(dx, dy)": "dx"}),
        Mistake("only one direction pays. Driving back along y counts as well: is a minus sign in the way?",
                {"hypot(dx, dy)": "dy"}),
        Mistake("dx + dy is negative when it drives back, and 0 when it drives askew. Take the length of the way: "
                "Pythagoras.", {"hypot(dx, dy)": "(dx + dy)"}),
        Mistake("driving along y is driving, too.", {"hypot(dx, dy)": "abs(dx)"}),
        Mistake("driving along x is driving, too.", {"hypot(dx, dy)": "abs(dy)"}),
        Mistake("askew, it goes 0.06 m in each direction, and 0.085 m in all. Take the length of the way: Pythagoras.",
                {"hypot(dx, dy)": "max(abs(dx), abs(dy))"}),
        Mistake("0.045 m along x and 0.045 m along y are a way of 0.064 m, not of 0.09 m. Pythagoras, again.",
                {"hypot(dx, dy)": "(abs(dx) + abs(dy))"}),
        Mistake("this is the square of the way: 0.1 m gives 0.01, which is not above 0.07. Take the root.",
                {"hypot(dx, dy)": "(dx**2 + dy**2)"}),
        Mistake("driving and creeping are paid alike. Only more than 0.07 m in a step is driving; a turn on the spot "
                "moves x and y a little, too.", {"> 0.07": "> 0.04"}),
        Mistake("driving, creeping and turning are paid alike. Only more than 0.07 m in a step is driving; a turn on the "
                "spot moves x and y a little, too.", {"> 0.07": "> 0.01"}),
        Mistake("driving begins at 0.07 m in a step. Yours asks for more.", {"> 0.07": "> 0.09"}),
        Mistake("a wall 0.11 m away is not touched; the limit is 0.10 m.", {"0.10": "0.12"}),
        Mistake("a wall 0.11 m away is not touched; the limit is 0.10 m.", {"0.10": "0.20"}),
        Mistake("a wall is touched below 0.10 m, not only below 0.05 m.", {"0.10": "0.05"}),
        Mistake("touching a wall costs nothing. What is forbidden needs a reward below that of standing still.",
                {"return -2": "pass"}),
        Mistake("touching a wall is paid as standing still. Nothing keeps the robot from it: pay less.",
                {"return -2": "return -0.02"}),
        Mistake("touching a wall is paid better than standing still: has its reward the wrong sign, or none?",
                {"return -2": "return 2"}),
        Mistake("touching a wall pays as much as driving, or more: has its reward the wrong sign?",
                {"return -2": "return 20"}),
        Mistake("has the sign < the wrong way round? A wall is touched when a laser reads less than 0.10 m.",
                {"< 0.10": "> 0.10"}),
        Mistake("touching counts only while it drives. Leaning on a wall is forbidden, too.",
                {"if min(": "if hypot(dx, dy) > 0.07 and min("}),
        Mistake("touching counts only while it does not drive. Scraping along a wall is forbidden, too.",
                {"if min(": "if hypot(dx, dy) <= 0.07 and min("}),
        Mistake("one laser is enough to see a wall that is touched. Here both are needed.", {"min(": "max("}),
        Mistake("only the left laser is watched, and walls are on the right, too.", {"min(left, right)": "left"}),
        Mistake("only the right laser is watched, and walls are on the left, too.", {"min(left, right)": "right"}),
        Mistake("whether a wall is touched must be asked of the readings after the step; that is where the action led.",
                {'after["laser': 'before["laser'}),
        Mistake("a wall that it has just turned away from is no longer touched. Look at the readings after the step "
                "alone.", {"min(left, right)": "min(left, right, before['laser_front_left'])"}),
        Mistake("scraping along a wall still pays, because what driving earns is more than what touching costs.",
                {"return -2": "return 10 * (hypot(dx, dy) > 0.07) - 2"}),
        Mistake("scraping along a wall pays as much as standing still. Touching must be worse than that.",
                {"return -2": "return -0.02 if hypot(dx, dy) > 0.07 else -2"}),
    ],
    hints=(
        "Two questions, in this order: does it touch a wall after the step? If not, has it moved more than 0.07 m?",
        "The way is the root of dx² + dy², with dx = after[\"x\"] - before[\"x\"]; math.hypot(dx, dy) computes it.",
        "If either laser of after is below 0.10, return -2. Else return 10 if the way is above 0.07, and -0.02 if not.",
    ),
    gained="A robot takes you at your word, and this word holds. In the next cells one learns with it.",
)  # fmt: skip
