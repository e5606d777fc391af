"""A clinic for a task: what agents earn on it, compared with blind ones and with the best possible."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rlrobot_edu.environments import make_env
from rlrobot_edu.experiments.tables import Table, Tabled
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.models.recording import record
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.models.value_iteration import best_average_reward, value_iteration
from rlrobot_edu.show.film import Film, film
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.tools.check_task import TaskCheck, check_task

HARDLY = 1e-9  # learning rate of who follows a plan
FAR = (
    0.97  # discount rate of the plan: a loop of some steps is worth more than one step
)
LAST = 12  # rewards that are told of the plan


@dataclass(frozen=True, eq=False, repr=False)
class Clinic(Tabled):
    """What was found; a notebook shows it as a table.

    check: the report of `check_task`, whose last table this one goes on from
    best: the best average reward that the recorded model allows, which may be too much or too little
    planner: the agent that follows its plan
    rewards: what the planner got on the robot, array (steps,)
    """

    task: Task
    check: TaskCheck
    best: float
    planner: Agent
    rewards: np.ndarray

    def table(self) -> Table:
        """How much each agent earns a step, in the end."""
        learner = self.check.learner
        rows = [(who, mean, side) for who, mean, _, side, _ in learner.rows]
        rows.append(("the best loop in a model of what one robot met", self.best, ""))
        rows.append(("its plan on the robot itself", float(self.rewards.mean()), ""))
        return Table(
            f"{self.task.name}: what is there to be had?",
            (*learner.columns[:2], learner.columns[3]),
            rows,
        )

    @property
    def loop(self) -> str:
        """The last rewards of the plan on the robot, one after the other."""
        return " ".join(f"{r:g}" for r in self.rewards[-LAST:])

    def film(self, steps: int = 60) -> Film:
        """The robot that follows the plan."""
        return film(self.planner, make_env(self.task, seed=0), steps)


def clinic(task: Task | str | Path, steps: int = 2000) -> Clinic:
    """Measure a task: check it, record a robot that learns, and look for the best loop in a model of what it saw.

    steps: of each trial of `check_task`, and a third of the recording's
    What the recording does not know is planned with as the lowest reward, so the best loop leans on what was seen. In a
    task whose states hide something, the model may promise more than the robot keeps, or less than can be had.
    """
    task = load_task(task)
    recording = record(Agent(task, seed=0), make_env(task, seed=0), steps=3 * steps)
    model = SampleModel.from_recording(recording, unseen="stay")
    planner = follower(task, model)
    driven = learn(planner, make_env(task, seed=0), steps)
    return Clinic(
        task,
        check_task(task, steps),
        best_average_reward(model),
        planner,
        driven.rewards,
    )


def follower(task: Task, model: SampleModel) -> Agent:
    """An agent that follows the plan made in a model, and learns hardly anything from what happens."""
    agent = Agent(task, "Q+GREEDY", alpha=HARDLY, seed=0)
    agent.q[:] = value_iteration(model, gamma=FAR).q
    return agent
