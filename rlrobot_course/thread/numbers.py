"""An agent that learned in a model of rows alone, and what it earns, wherever it drives."""

import numpy as np

from rlrobot_edu import Agent, Recording, SampleModel, learn, make_env
from rlrobot_edu.learning.size import Env
from rlrobot_edu.show.numerals import with_minus

LESSON = 50_000  # steps in the model
STRETCHES = 10
STEPS = 20  # of a stretch


def learned(rows: Recording) -> tuple[Agent, SampleModel]:
    """An agent that has learned in the model of these rows, always the same one, and the model."""
    model = SampleModel.from_recording(rows, unseen="stay")
    agent = Agent(model, seed=0)
    learn(agent, make_env(model, seed=0), steps=LESSON, progress=False)
    return agent, model


def measured(agent: Agent, env: Env) -> np.ndarray:
    """The mean reward of each of ten stretches of 20 steps, one after the other; array (10,). It does not learn."""
    steps = STRETCHES * STEPS
    rewards = learn(agent.frozen(), env, steps=steps, progress=False).rewards
    means: np.ndarray = rewards.reshape(STRETCHES, STEPS).mean(axis=1)
    return means


def signed(number: float) -> str:
    """A number with one digit after the point and a proper minus; no minus before 0.0."""
    return with_minus(round(number, 1) + 0.0, 1)
