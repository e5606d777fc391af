"""Exercises of lesson 12: the arm's kinematics, what a shuttle pays, and a reward that cannot be milked."""

from __future__ import annotations

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_12 import solutions
from rlrobot_edu.course.lesson_12.reward_exercise import RewardExercise

__all__ = ["arm_reward", "gripper", "pays"]

ANGLES = [(-0.42, 0.9, 0.26), (0.3, 0.5, 0.6), (0.7, 1.0, 0.0), (-0.7, 0.4, 0.1), (0.0, 0.7, 0.4), (0.14, 0.9, 0.39)]

gripper = Exercise(
    task="return x, y and z of the gripper",
    right=solutions.gripper,
    returns="gripper",
    tape=[{"arm": a, "biceps": b, "forearm": f} for a, b, f in ANGLES],
    mistakes=[
        Mistake("sine and cosine of arm have changed places: at arm = 0 the gripper is straight ahead, y = 0.",
                {"out * math.cos(arm), out * math.sin(arm)": "out * math.sin(arm), out * math.cos(arm)"}),
        Mistake("the arm turns to the left, and y grows to the left: y = out · sin(arm), without a minus.",
                {"out * math.sin(arm)": "-out * math.sin(arm)"}),
        Mistake("the lower arm's angle is biceps + forearm: the elbow is carried by the upper arm, which leans.",
                {"biceps + forearm": "forearm"}),
        Mistake("the angles are added: both a leaning biceps and a bent forearm point the lower arm further down.",
                {"biceps + forearm": "biceps - forearm"}),
        Mistake("the lower arm falls below the elbow: its part of the height is taken away, not added.",
                {"- lower * math.sin": "+ lower * math.sin"}),
        Mistake("the height begins at the shoulder, 0.12 m above the table.", {"shoulder + upper": "upper"}),
        Mistake("sine and cosine of the upper arm have changed places: upright (biceps = 0) it reaches out by nothing.",
                {"upper * math.sin(biceps)": "upper * math.cos(biceps)",
                 "upper * math.cos(biceps)": "upper * math.sin(biceps)"}),
        Mistake("sine and cosine of the lower arm have changed places: level (biceps + forearm = 0) it reaches out by "
                "its whole length.",
                {"lower * math.cos(biceps + forearm)": "lower * math.sin(biceps + forearm)",
                 "lower * math.sin(biceps + forearm)": "lower * math.cos(biceps + forearm)"}),
        Mistake("upper and lower arm have changed places.", {"upper *": "lower *", "lower *": "upper *"}),
        Mistake("only the upper arm is in out: add the lower arm's part.",
                {" + lower * math.cos(biceps + forearm)": ""}),
        Mistake("only the upper arm is in the height: take the lower arm's part away.",
                {" - lower * math.sin(biceps + forearm)": ""}),
        Mistake("this is seen from the side: out and up. Turned by arm, out becomes x and y.",
                {"out * math.cos(arm), out * math.sin(arm), up": "out, 0.0, up"}),
        Mistake("the height is missing: return x, y and z.", {"math.sin(arm), up": "math.sin(arm)"}),
        Mistake("sin and cos take radians, and these angles are in radians already.",
                {"math.sin(biceps)": "math.sin(math.radians(biceps))",
                 "math.cos(biceps)": "math.cos(math.radians(biceps))",
                 "biceps + forearm": "math.radians(biceps + forearm)", "(arm)": "(math.radians(arm))"}),
        Mistake("only out is turned by arm; the height stays as it is.", {"(arm), up": "(arm), up * math.cos(arm)"}),
    ],
    hints=(
        "First from the side: how far out is the gripper, and how high? Then turn what is out by the angle arm.",
        "out and up stand above as formulas. Then x is out · cos(arm) and y is out · sin(arm).",
        "out = upper * np.sin(biceps) + lower * np.cos(…); up = shoulder + …; return out * np.cos(arm), …, up",
    ),
    gained="With these three lines you can move an arm without any simulator: the next cells do.",
)  # fmt: skip

pays = Question(
    task="what the two loops pay a step on average, as (first, second)",
    right=solutions.pays,
    because="(−1 + 5) / 2 and (−1 + 10) / 2. Keep both in mind: you will meet them again.",
    mistakes=[
        Mistake("these are the sums of both steps. An average a step is half of that.", (4, 9)),
        Mistake("retreat costs 1: it is −1 + 5, not 1 + 5.", (3, 5.5)),
        Mistake("retreat is not free, it costs 1: each of the loops has one step of −1.", (2.5, 5)),
        Mistake("the second loop is right. In the first, one step pays −1 and the other 5.", (2.5, 4.5)),
        Mistake("the first loop is right. In the second, one step pays −1 and the other 10.", (2, 5)),
        Mistake("the first loop is right. In the second, the step back into contact pays 10, not 5.", (2, 2)),
        Mistake("this is the second loop first.", (4.5, 2)),
        Mistake("these are the values with γ. Asked is the plain average of two rewards.", (21.57894737, 47.89473684)),
        Mistake("this is what the good step pays. The other one counts, too.", (5, 10)),
    ],
    hints=(
        "Each loop has two steps, and goes on for ever: the average of two rewards is all you need.",
        "Away: −1, in both loops. Back: 5 where the gripper stays outside 5 cm, 10 where it gets within.",
        "(−1 + 5) / 2, and for the second loop 10 in place of 5.",
    ),
    gained="An agent's average reward can tell you where it is stuck, without a look at the robot.",
)

STEPS = [(0.20, 0.17), (0.17, 0.20), (0.12, 0.105), (0.105, 0.12), (0.15, 0.15), (0.06, 0.04), (0.04, 0.03),
         (0.03, 0.08), (0.09, 0.05), (0.085, 0.0501), (0.30, 0.24), (0.10, 0.135)]  # fmt: skip

WAY = "return 100 * (before - after)"
BY_SIGN = "return {0} if before - after > {2} else -{1} if after - before > {2} else {3}"

arm_reward = RewardExercise(
    task="return the reward of a step, from the distances before and after it",
    right=solutions.arm_reward,
    returns="reward",
    tape=[{"before": before, "after": after} for before, after in STEPS],
    mistakes=[
        Mistake("this is the task's own reward: away costs 1 and nearer pays 5, so to and fro pays.",
                {WAY: BY_SIGN.format(5.0, 1.0, 0.02, -0.02)}),
        Mistake("away by less than 2 cm costs next to nothing: it creeps away, and gets 5 for each larger step back. "
                "What a step away costs must grow with its length.", {WAY: BY_SIGN.format(5.0, 5.0, 0.02, -0.02)}),
        Mistake("away by less than 2 cm is free: it creeps away, and gets paid for each larger step back. What a step "
                "away costs must grow with its length.", {WAY: BY_SIGN.format(1.0, 1.0, 0.02, 0.0)}),
        Mistake("each step counts the same, however long: one long step away, several short ones back. What a step "
                "pays must grow with its length.", {WAY: BY_SIGN.format(1.0, 1.0, 0.0, 0.0)}),
        Mistake("the same for every step, however long: one long step away, several short ones back.",
                {WAY: BY_SIGN.format(5.0, 5.0, 0.0, 0.0)}),
        Mistake("this is contact alone. It cannot be milked, but it does not show the way: let a step that leads "
                "nearer pay a little.", {WAY: "return -0.02"}),
        Mistake("this is contact alone. It cannot be milked, but it does not show the way: let a step that leads "
                "nearer pay something.", {WAY: "return 0.0"}),
        Mistake("this pays for the way out: it is before − after that is above 0 for a step nearer.",
                {"(before - after)": "(after - before)"}),
        Mistake("a step away costs nothing here, so to and fro pays. What is given for the way in must be taken back "
                "for the way out.", {WAY: "return max(0.0, 100 * (before - after))"}),
        Mistake("this pays for being near, not for getting nearer: whoever stands still is paid.",
                {WAY: "return 0.1 / after"}),
        Mistake("this only costs: a step nearer should pay more than 0. Compare before with after.",
                {WAY: "return -100 * after"}),
        Mistake("contact is missing: within 0.05 m a step pays 10.", {"if after <= 0.05": "if False"}),
        Mistake("what counts is where the step ends: after, not before.", {"after <= 0.05": "before <= 0.05"}),
        Mistake("the distances are in metres: 5 cm are 0.05.", {"<= 0.05": "<= 5"}),
        Mistake("a step towards the object pays more than contact here. With 1000 a metre a step of 4 cm is worth 40.",
                {"100 *": "1000 *"}),
        Mistake("contact pays 10, whatever the step before.", {"return 10.0": "return 10.0 + 100 * (before - after)"}),
        Mistake("each step pays a little, wherever it leads: standing still pays, too.",
                {WAY: "return 0.1 + 100 * (before - after)"}),
    ],
    hints=(
        "Give each centimetre a price: paid for on the way in, taken back on the way out. Then every loop sums to 0.",
        "before − after is the way gained, in metres; it is negative for a step away. Contact comes first.",
        "if after <= 0.05: return 10.0, and below it: return 100 * (…)",
    ),
    gained="You know a way to guide a robot that no robot can turn against you: pay for a change, and take it back.",
)  # fmt: skip
