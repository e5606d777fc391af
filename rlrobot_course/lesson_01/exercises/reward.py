"""What a learner's own reward pays for."""

from __future__ import annotations

from math import hypot

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.design import Design
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.lesson_01.design import PAIRS, words


def reward(before, after):
    left, right = after["laser_front_left"], after["laser_front_right"]
    dx, dy = after["x"] - before["x"], after["y"] - before["y"]
    if min(left, right) < 0.10:
        return -2
    return 10 if hypot(dx, dy) > 0.07 else -0.02


PAY = "10 if hypot(dx, dy) > 0.07 else -0.02"

CHANGED, WITNESSES = read_answers(__file__, {"hypot": hypot})

exercise = Design(
    task="return a number that is larger for what the robot should do than for what it should not",
    right=reward,
    returns="more is paid when it",
    words=words,
    tape=[{"wanted": wanted, "unwanted": unwanted} for wanted, unwanted in PAIRS],
    mistakes={
        "all_alike": Mistake(
            "every step is paid the same, so nothing is wanted more than anything else.",
            {"return -2": "pass", PAY: "1"},
        ),
        "for_not_touching": Mistake(
            "you pay for not touching anything, and who stands still touches nothing. Pay for driving: "
            "more than 0.07 m, and all readings are in metres.",
            {PAY: "1"},
        ),
        "standing_pays": Mistake(
            "you pay for standing still. Is the sign of > the wrong way round, or that of the reward?",
            {"> 0.07": "< 0.07"},
        ),
        "open_space_nearest": Mistake(
            "you pay for open space, and the robot need not move to have it. Compare x and y before and after.",
            CHANGED["open_space_nearest"],
        ),
        "open_space_sum": Mistake(
            "you pay for open space, and the robot need not move to have it. Compare x and y before and after.",
            CHANGED["open_space_sum"],
        ),
        "change_of_readings": Mistake(
            "you pay for a change of the lasers' readings, and turning on the spot changes them, too.",
            CHANGED["change_of_readings"],
        ),
        "change_as_the_way": Mistake(
            "you pay for a change of the lasers' readings, and turning on the spot changes them, too.",
            {"hypot(dx, dy)": "abs(left - before['laser_front_left'])"},
        ),
        "x_signed": Mistake(
            "only one direction pays. Driving back along x counts as well: is a minus sign in the way?",
            {"hypot(dx, dy)": "dx"},
        ),
        "y_signed": Mistake(
            "only one direction pays. Driving back along y counts as well: is a minus sign in the way?",
            {"hypot(dx, dy)": "dy"},
        ),
        "sum_of_x_and_y": Mistake(
            "dx + dy is negative when it drives back, and 0 when it drives askew. Take the length of the way: "
            "Pythagoras.",
            {"hypot(dx, dy)": "(dx + dy)"},
        ),
        "abs_of_the_sum": Mistake(
            "dx + dy is 0 when it drives askew, and abs leaves it so. Take the length of the way: Pythagoras.",
            {"hypot(dx, dy)": "abs(dx + dy)"},
        ),
        "larger_signed": Mistake(
            "only one direction pays, +x or +y. Driving back counts as well: is a minus sign in the way?",
            {"hypot(dx, dy)": "max(dx, dy)"},
        ),
        "smaller_of_both": Mistake(
            "to drive, it need not move along x and y at once. Take the length of the way: Pythagoras.",
            {"hypot(dx, dy)": "min(abs(dx), abs(dy))"},
        ),
        "place_as_the_way": Mistake(
            "this is where the robot is, not how far it has moved. Take the difference of after and before.",
            {' - before["x"]': "", ' - before["y"]': ""},
        ),
        "place_itself": Mistake(
            "this is where the robot is, not how far it has moved. Take the difference of after and before.",
            {' - before["x"]': "", ' - before["y"]': "", "hypot(dx, dy)": "dx"},
        ),
        "only_x": Mistake("driving along y is driving, too.", {"hypot(dx, dy)": "abs(dx)"}),
        "only_y": Mistake("driving along x is driving, too.", {"hypot(dx, dy)": "abs(dy)"}),
        "larger_of_both": Mistake(
            "askew, it goes 0.06 m in each direction, and 0.085 m in all. Take the length of the way: Pythagoras.",
            {"hypot(dx, dy)": "max(abs(dx), abs(dy))"},
        ),
        "sum_of_both": Mistake(
            "0.045 m along x and 0.045 m along y are a way of 0.064 m, not of 0.09 m. Pythagoras, again.",
            {"hypot(dx, dy)": "(abs(dx) + abs(dy))"},
        ),
        "square": Mistake(
            "this is the square of the way: 0.1 m gives 0.01, which is not above 0.07. Take the root.",
            {"hypot(dx, dy)": "(dx**2 + dy**2)"},
        ),
        "creeping_pays": Mistake(
            "driving and creeping are paid alike. Only more than 0.07 m in a step is driving; a turn on the spot "
            "moves x and y a little, too.",
            {"> 0.07": "> 0.04"},
        ),
        "turning_pays": Mistake(
            "driving, creeping and turning are paid alike. Only more than 0.07 m in a step is driving; a turn on "
            "the spot moves x and y a little, too.",
            {"> 0.07": "> 0.01"},
        ),
        "asks_for_0_09": Mistake("driving begins at 0.07 m in a step. Yours asks for more.", {"> 0.07": "> 0.09"}),
        "asks_for_0_1": Mistake("driving begins at 0.07 m in a step. Yours asks for more.", {"> 0.07": "> 0.1"}),
        "touches_at_0_12": Mistake("a wall 0.11 m away is not touched; the limit is 0.10 m.", {"0.10": "0.12"}),
        "touches_at_0_20": Mistake("a wall 0.11 m away is not touched; the limit is 0.10 m.", {"0.10": "0.20"}),
        "touches_at_0_05": Mistake("a wall is touched below 0.10 m, not only below 0.05 m.", {"0.10": "0.05"}),
        "touching_is_free": Mistake(
            "touching a wall costs nothing. What is forbidden needs a reward below that of standing still.",
            {"return -2": "pass"},
        ),
        "touching_free_and_pay_by_the_way": Mistake(
            "touching a wall costs nothing. What is forbidden needs a reward below that of standing still.",
            {"return -2": "pass", PAY: "hypot(dx, dy)"},
        ),
        "touching_as_standing": Mistake(
            "touching a wall is paid as standing still. Nothing keeps the robot from it: pay less.",
            {"return -2": "return -0.02"},
        ),
        "touching_pays_2": Mistake(
            "touching a wall is paid better than standing still: has its reward the wrong sign, or none? Or does "
            "standing cost more than the wall?",
            {"return -2": "return 2"},
        ),
        "touching_pays_10": Mistake(
            "touching a wall pays as much as driving, or more: has its reward the wrong sign?",
            {"return -2": "return 10"},
        ),
        "touching_pays_20": Mistake(
            "touching a wall pays as much as driving, or more: has its reward the wrong sign?",
            {"return -2": "return 20"},
        ),
        "touch_inverted": Mistake(
            "has the sign < the wrong way round? A wall is touched when a laser reads less than 0.10 m.",
            {"< 0.10": "> 0.10"},
        ),
        "touching_while_driving": Mistake(
            "touching counts only while it drives. Leaning on a wall is forbidden, too.",
            {"if min(": "if hypot(dx, dy) > 0.07 and min("},
        ),
        "touching_while_not_driving": Mistake(
            "touching counts only while it does not drive. Scraping along a wall is forbidden, too.",
            {"if min(": "if hypot(dx, dy) <= 0.07 and min("},
        ),
        "both_lasers": Mistake(
            "one laser is enough to see a wall that is touched. Here both are needed.", {"min(": "max("}
        ),
        "left_alone": Mistake(
            "only the left laser is watched, and walls are on the right, too.", {"min(left, right)": "left"}
        ),
        "right_alone": Mistake(
            "only the right laser is watched, and walls are on the left, too.", {"min(left, right)": "right"}
        ),
        "lasers_before": Mistake(
            "whether a wall is touched must be asked of the readings after the step; that is where the action led.",
            {'after["laser': 'before["laser'},
        ),
        "lasers_before_too": Mistake(
            "a wall that it has just turned away from is no longer touched. Look at the readings after the step alone.",
            {"min(left, right)": "min(left, right, before['laser_front_left'])"},
        ),
        "scraping_pays": Mistake(
            "scraping along a wall still pays, because what driving earns is more than what touching costs.",
            {"return -2": "return 10 * (hypot(dx, dy) > 0.07) - 2"},
        ),
        "scraping_pays_by_the_way": Mistake(
            "scraping along a wall still pays, because what driving earns is more than what touching costs.",
            {"return -2": "return 100 * hypot(dx, dy) - 2", PAY: "100 * hypot(dx, dy)"},
        ),
        "touching_pays_by_the_way": Mistake(
            "who runs into a wall has still moved a little, and is paid for it. What is forbidden needs a reward "
            "below that of standing still.",
            {"return -2": "return hypot(dx, dy) * min(left, right)", PAY: "hypot(dx, dy) * min(left, right)"},
        ),
        "scraping_as_standing": Mistake(
            "scraping along a wall pays as much as standing still. Touching must be worse than that.",
            {"return -2": "return -0.02 if hypot(dx, dy) > 0.07 else -2"},
        ),
    },
    hints=(
        "Two questions, in this order: does it touch a wall after the step? If not, has it moved more than 0.07 m?",
        'The way is the root of dx² + dy², with dx = after["x"] - before["x"]; math.hypot(dx, dy) computes it.',
        "If either laser of after is below 0.10, return -2. Else return 10 if the way is above 0.07, and -0.02 if not.",
    ),
    gained="The order is right: what is wanted pays more. In the next cells a robot learns with it, and shows whether "
    "the sizes are right, too.",
    witnesses=WITNESSES,
)
