"""A robot learns to follow a wall by the learner's reward."""

from rlrobot_course.drives.by_your_code import Reel, number
from rlrobot_course.exercises.design import Readings, paid_by
from rlrobot_course.lesson_16.exercises import follow_reward
from rlrobot_course.lesson_16.situations import PAIRS
from rlrobot_edu import InputVariable, OutputVariable, Task
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn, steps
from rlrobot_grading.answers.values import Function

METHOD, SEED = "TOSL+QBIASSR", 3
LEARNED, FILMED = 1500, 60  # steps

# the task of the wall follower
TASK = Task(
    robot="mobile_base",
    scene="square_2x2",
    inputs=[
        InputVariable("laser_front", cuts=[0.3], unit="m"),
        InputVariable("laser_front_right", cuts=[0.2, 0.4], unit="m"),
        InputVariable("laser_right", cuts=[0.1, 0.2, 0.3, 0.4], unit="m"),
    ],
    outputs=[
        OutputVariable("left_wheel", values=[0, 1], unit="rad/s"),
        OutputVariable("right_wheel", values=[0, 1], unit="rad/s"),
    ],
    reward=follow_reward,
    rewards=[-0.6, -0.4, 10],
)


def by_reward(reward: Function, reel: Reel) -> None:
    """The robot learns by a reward; the film tells what the right reward would pay."""

    def pays(before: Readings, after: Readings) -> float:
        return number(reward(before, after))

    env = make_env(paid_by(TASK, pays, PAIRS), seed=SEED)
    agent = Agent(env.unwrapped.task, METHOD, seed=SEED)  # type: ignore[attr-defined]
    learn(agent, env, steps=LEARNED, progress=False)
    robot = env.unwrapped.robot  # type: ignore[attr-defined]
    walk = steps(agent, env, FILMED, resume=True)
    reel.follow(walk, robot, follow_reward, robot.readings)


drives = {"follow_reward": by_reward}
