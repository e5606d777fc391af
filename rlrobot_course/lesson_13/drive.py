"""The arm of geometry learns by the learner's reward."""

from rlrobot_course.drives.by_your_code import Reel, Stopped, number
from rlrobot_course.exercises.design import Readings
from rlrobot_course.lesson_13.exercises import arm_reward
from rlrobot_course.worlds.arm_world import ArmWorld, with_reward
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn, steps
from rlrobot_edu.task.rewards import gripper_to_object
from rlrobot_edu.task.task_file import load_task
from rlrobot_grading.answers.values import Function

TASK, METHOD, SEED = "arm_1k", "TOSL+QBIASSR", 7
LEARNED, FILMED = 1200, 40  # steps: ten episodes, and the beginning of the next


def by_reward(reward: Function, reel: Reel) -> None:
    """The arm learns by a reward, and then drives an episode; the film tells what the right reward would pay."""
    known: dict[tuple[float, float], float] = {}

    def pays(before: float, after: float) -> float:
        if (before, after) not in known:
            known[before, after] = number(reward(before, after))
        return known[before, after]

    task = with_reward(load_task(TASK), pays, TASK)
    if max(task.rewards) <= 0:
        raise Stopped("pays more than 0 for no step, and an agent needs one that does")
    world = ArmWorld(task)
    agent = Agent(world, METHOD, seed=SEED)
    learn(agent, world, steps=LEARNED, progress=False)
    walk = steps(agent, world, FILMED)
    reel.follow(walk, world.robot, rightly_paid, world.places.readings[0])


def rightly_paid(before: Readings, after: Readings) -> float:
    """What the right reward pays."""
    return arm_reward(gripper_to_object(before), gripper_to_object(after))


drives = {"arm_reward": by_reward}
