"""Exercises of lesson 10: bins once more, a robot on two wheels, and how near a wall may be."""

from __future__ import annotations

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_10 import solutions

__all__ = ["bins", "motion", "still_safe"]

bins = Question(
    task="five bins as a tuple, such as (0, 1, 2, 3, 0)",
    right=solutions.bins,
    because="0.53 lies exactly on a cut, and belongs to the bin below it, 0.54 to the one above. All beyond 0.80 m is "
    "bin 3, whether 0.9 or 5.",
    mistakes=[
        Mistake("0.53 m lies exactly on a cut: x ≤ 0.53 is still bin 1.", (2, 2, 3, 0, 3)),
        Mistake("0.27 m lies exactly on a cut: x ≤ 0.27 is still bin 0.", (1, 2, 3, 1, 3)),
        Mistake("a reading exactly on a cut belongs to the bin below it. Two of the five do.", (2, 2, 3, 1, 3)),
        Mistake("bins are counted from 0: the nearest is bin 0.", (2, 3, 4, 1, 4)),
        Mistake("bins are counted from 0, and a reading on a cut belongs to the bin below it.", (3, 3, 4, 2, 4)),
        Mistake("0.54 m is more than the cut at 0.53 m: one bin further.", (1, 1, 3, 0, 3)),
        Mistake("0.90 m is beyond the last cut, 0.80 m. That is the last bin, bin 3.", (1, 2, 3, 0, 2)),
        Mistake("2.10 m is beyond the last cut, 0.80 m: bin 3. There is no bin 4.", (1, 2, 4, 0, 3)),
        Mistake("near is bin 0, far is bin 3: yours are the other way round.", (2, 1, 0, 3, 0)),
        Mistake("these are the readings. How many cuts lie below each?", (0.53, 0.54, 2.10, 0.27, 0.90)),
    ],
    hints=(
        "How many of the three cuts lie below the reading? That is the number of its bin.",
        "Below 0.53 lies one cut, 0.27 (0.53 itself does not lie below 0.53). So the first is bin 1.",
        "(1, 2, …, 0, …), and the two that are missing lie beyond all cuts.",
    ),
    gained="You can read the rings: what the robot is told of five numbers in metres is five small whole numbers.",
)  # fmt: skip

still_safe = Question(
    task="a reading of the front laser in metres",
    right=solutions.still_safe,
    because="0.05 + 2 · 0.0975 = 0.245 m. The first cut, 0.27 m, lies just above it.",
    mistakes=[
        Mistake("that is at single speed. Both wheels backward means forward at double speed: twice as far.", 0.1475),
        Mistake("this is the way of one step at double speed. Behind it there must still be 0.05 m left.", 0.195),
        Mistake("this is the way of one step at single speed. It is driven at double speed, and 0.05 m must be left.",
                0.0975),
        Mistake("0.05 m must be left after the step. Add it, do not take it off.", 0.145),
        Mistake("0.05 m must be left after the step. Add it; and it is driven at double speed.", 0.0475),
        Mistake("0.05 m must be left only once, at the end of the step.", 0.295),
        Mistake("that is a reading which costs a reward already. From where may the robot still drive one step?", 0.05),
        Mistake("this is the first cut of the task. Where does it come from? Work it out.", 0.27),
        Mistake("in metres, please: 24.5 cm are 0.245 m.", 24.5),
        Mistake("2 rad/s is the speed of the wheels. How far does their rim get in one second? The radius is 0.0975 m.",
                2.05),
    ],
    hints=(
        "How far does one step at double speed go? And how much must be left after it?",
        "A wheel of 0.0975 m radius at 2 rad/s rolls 2 · 0.0975 m in a second.",
        "0.05 + 2 · …",
    ),
    gained="A cut is a decision: it should separate what calls for different actions.",
)  # fmt: skip

WHEELS = [(1.0, 2.0, 0.1, 0.5), (2.0, 2.0, 0.0975, 0.331), (-1.0, 1.0, 0.0975, 0.331), (0.0, 1.0, 0.0975, 0.331),
          (1.0, 0.0, 0.2, 0.4), (0.0, 0.0, 0.1, 0.3), (-0.5, -0.5, 0.1, 0.3), (0.5, -1.0, 0.075, 0.46)]  # fmt: skip
V, TURN = "radius * (left + right) / 2", "radius * (right - left) / separation"

motion = Exercise(
    task="return the robot's forward speed in m/s and its turning rate in degrees per second",
    right=solutions.motion,
    returns="motion",
    tape=[dict(zip(("left", "right", "radius", "separation"), wheels, strict=True)) for wheels in WHEELS],
    mistakes=[
        Mistake("the turning rate is in radians per second. The robot's is asked in degrees: math.degrees(…).",
                {"math.degrees(omega)": "omega"}),
        Mistake("your robot turns the wrong way: it turns to the left, which counts positive, if the right wheel is "
                "the faster one.", {"right - left": "left - right"}),
        Mistake("the speed is the mean of both wheels' speeds, and yours is their sum: divide by 2.",
                {"(left + right) / 2": "(left + right)"}),
        Mistake("the turning rate is the difference of both wheels' speeds over their separation, not over half of "
                "it. (Or is the factor for degrees 360 / π? It is 180 / π.)",
                {"/ separation": "/ (separation / 2)"}),
        Mistake("the turning rate is half of what it should be: divide by the separation, not by twice that.",
                {"/ separation": "/ (2 * separation)"}),
        Mistake("the speed is in rad/s: a wheel of radius r rolls r metres for each radian. Multiply by the radius.",
                {V: "(left + right) / 2"}),
        Mistake("the turning rate lacks the radius: radius · right and radius · left are the speeds of the wheels in "
                "m/s.", {TURN: "(right - left) / separation"}),
        Mistake("both numbers lack the radius: a wheel at 1 rad/s rolls one radius a second.",
                {V: "(left + right) / 2", TURN: "(right - left) / separation"}),
        Mistake("the turning rate is not divided by the separation of the wheels.", {" / separation": ""}),
        Mistake("the wheels' difference is multiplied by their separation: divide by it. The further apart the wheels "
                "are, the less the robot turns.", {"/ separation": "* separation"}),
        Mistake("degrees to radians is the wrong way round: math.degrees turns radians into degrees.",
                {"math.degrees": "math.radians"}),
        Mistake("the two numbers have changed places: first the speed, then the turning rate.",
                {"v, math.degrees(omega)": "math.degrees(omega), v"}),
        Mistake("the turning rate comes from the difference of the wheels' speeds, right less left.",
                {"right - left": "right + left"}),
        Mistake("the speed comes from the sum of the wheels' speeds, and yours from their difference.",
                {"left + right": "right - left"}),
        Mistake("π is not 3.14: math.degrees(…) knows it better.", {"math.degrees(omega)": "omega * 180 / 3.14"}),
        Mistake("this is the speed alone. Return both numbers: return v, omega.",
                {"v, math.degrees(omega)": "v"}),
        Mistake("this is the turning rate alone. Return both numbers: return v, omega.",
                {"v, math.degrees(omega)": "math.degrees(omega)"}),
        Mistake("the radius and the separation are arguments; yours holds for one robot only.",
                {"radius": "0.0975", "separation": "0.331"}),
    ],
    hints=(
        "Each wheel rolls radius · its speed metres a second. The robot's middle moves at the mean of both; their "
        "difference turns it.",
        "v = radius * (left + right) / 2, and the turning rate is radius * (right - left) / separation in rad/s.",
        "return radius * (left + right) / 2, math.degrees(…)",
    ),
    gained="With this you can read any command of a robot on two wheels. It draws the arrows of all that follows.",
)  # fmt: skip
