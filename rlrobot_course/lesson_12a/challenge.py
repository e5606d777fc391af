"""Open challenge of lesson 12a: a reward of one's own that cannot be milked."""

from __future__ import annotations

from typing import Any

from rlrobot_course.arm_world import ArmWorld, with_reward
from rlrobot_course.challenge import Challenge, Watched, number
from rlrobot_course.lesson_12a.loops import best_loop
from rlrobot_course.lesson_12a.reward_exercise import CONTACT, NOTHING
from rlrobot_course.lesson_12a.runs import last_episodes
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task


def read(reward: Any) -> Task:
    """The arm's task with the learner's reward, a number from −10 to 10. Raises ValueError if a loop can milk it."""
    watched = Watched(reward, "my_reward(before, after)", number(-10, 10))
    task = with_reward(load_task("arm_1k"), watched, "my_arm")
    world = ArmWorld(task)
    loop = best_loop(world.places.next, world.rewards, world.places.distance > CONTACT)
    if loop.pays > NOTHING:
        way = " → ".join(f"{100 * world.places.distance[i]:.1f}" for i in (*loop.places, loop.places[0]))
        raise ValueError(f"it can be milked: the loop {way} cm from the object pays {loop.pays:.2g} a step")
    return task


def in_contact(task: Task, seed: int) -> float:
    """For how many seconds of the tenth episode, of 120, an arm of geometry touches the object."""
    return 120 * float(last_episodes(task, arms=1, seed=seed).contact[0])


challenge = Challenge(
    "12a",
    "Write my_reward(before, after), any number from −10 to 10, of the gripper's distances to the object before and "
    "after a step, in metres; no loop outside contact may pay more than 0. The arm of geometry learns with it for ten "
    "episodes. What counts is for how many of the 120 s of the tenth it touches the object (5 cm or nearer).",
    "s of 120", read, in_contact, seeds=20,
)  # fmt: skip
