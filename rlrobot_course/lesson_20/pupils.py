"""Agents that are taught by a recording and then learn by themselves, and those that only copy it."""

from typing import Any

import numpy as np
from joblib import Parallel, delayed

from rlrobot_course.worlds.short_world import ShortWorld
from rlrobot_edu import Agent, Recording, learn, make_env
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.learning.history import History
from rlrobot_edu.widgets.driving.teaching import learn_from


def pupils(recording: Recording | None, *, steps: int, repetitions: int = 20) -> Runs:
    """The results of agents that are taught by `recording` (None: not at all) and then learn on the robot.

    Agents and robots of the same number have the same random numbers in each call. The histories keep
    their states and actions; the steps of the recording are not among them.
    """
    seeds = np.random.SeedSequence(0).spawn(repetitions)
    jobs = (delayed(_once)(recording, steps, each) for each in seeds)
    return Runs(Parallel(n_jobs=-1)(jobs))


def _once(recording: Recording | None, steps: int, seed: Any) -> History:
    agent_seed, env_seed = seed.spawn(2)
    agent = Agent("wander_1k", seed=agent_seed)
    if recording is not None:
        learn_from(agent, recording)
    with make_env("wander_1k", env_seed) as env:
        return learn(agent, env, steps=steps, progress=False, keep=True)


def copies(recording: Recording, *, steps: int, repetitions: int = 20) -> Runs:
    """The results of robots that only copy: in a state that was shown they do the same action, elsewhere any action.

    An action that was done in a state twice as often as another is taken twice as often. They learn nothing.
    """
    assert recording.task is not None
    counts = np.zeros((recording.source.states.n, recording.source.actions.n))
    np.add.at(counts, (recording.s, recording.a), 1)
    counts[counts.sum(axis=1) == 0] = 1
    ladders = np.cumsum(counts / counts.sum(axis=1, keepdims=True), axis=1)
    runs = Runs()
    for each in np.random.SeedSequence(0).spawn(repetitions):
        agent_seed, env_seed = each.spawn(2)
        with make_env(recording.task, env_seed) as env:
            world = ShortWorld(env, agent_seed)
            s = world.reset()
            for _ in range(steps):
                s = world.step(
                    int(
                        np.searchsorted(ladders[s], world.u, side="right").clip(
                            max=counts.shape[1] - 1
                        )
                    )
                )[0]
            runs.append(world.history(counts * 0, "copy"))
    return runs
