"""A task that pays what a learner's own reward pays."""

from rlrobot_course.grading.design import Pay, paid_by
from rlrobot_course.lesson_01.design import PAIRS
from rlrobot_edu.task.task import Task


def with_reward(task: Task, reward: Pay) -> Task:
    """`task` with a learner's own reward, which counts as the nearest of those paid in the situations of `design`."""
    return paid_by(task, reward, PAIRS)
