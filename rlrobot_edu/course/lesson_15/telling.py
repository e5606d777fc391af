"""What each input of a task tells while its robot acts at random, as `rl.check_task` reports it."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.experiments.tables import Table
from rlrobot_edu.task.task import Task
from rlrobot_edu.workshop.information import Information, information
from rlrobot_edu.workshop.trial import at_random


def what_inputs_tell(task: Task, steps: int, seed: int = 0) -> dict[str, dict[str, Information]]:
    """What each input tells, given the action: about "the reward", and about each other input after the step."""
    seen, rng = at_random(task, steps, np.random.SeedSequence(seed)).transitions, np.random.default_rng(seed)
    names = [variable.name for variable in task.states.inputs]
    now, then = (dict(zip(names, np.unravel_index(s, task.states.shape), strict=True)) for s in (seen.s, seen.s_next))
    rewards = np.unique(seen.r, return_inverse=True)[1]
    about = {name: {"the reward": rewards} | {other: then[other] for other in names if other != name} for name in names}
    return {name: {y: information(now[name], about[name][y], seen.a, rng) for y in about[name]} for name in names}


def table_of_inputs(task: Task, steps: int) -> Table:
    """What each input tells in so many random steps: of the reward, and of the other input of which it tells most."""
    rows = []
    for name, told in what_inputs_tell(task, steps).items():
        reward = told.pop("the reward")
        best = max(told, key=lambda other: told[other].bits)
        real = reward.is_real or any(known.is_real for known in told.values())
        rows.append((name, f"{reward.bits:.3f}", f"{told[best].bits:.3f} ({best})", "yes" if real else "no"))
    head = ("input", "of the reward [bit]", "of another input [bit]", "more than chance?")
    return Table(f"What each input tells, {steps} steps at random", head, rows)
