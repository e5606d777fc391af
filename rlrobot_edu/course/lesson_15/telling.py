"""What each input of a task tells while its robot acts at random, as `rl.check_task` reports it."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.experiments.tables import Table
from rlrobot_edu.task.task import Task
from rlrobot_edu.workshop.check_task import told_by_inputs
from rlrobot_edu.workshop.trial import at_random


def table_of_inputs(task: Task, steps: int, seed: int = 0) -> Table:
    """What each input tells in so many random steps: of the reward, and of the other input of which it tells most."""
    seen, rows = at_random(task, steps, np.random.SeedSequence(seed)).transitions, []
    for variable, told in zip(task.inputs, told_by_inputs(task, seen, np.random.default_rng(seed)), strict=True):
        reward = told.pop("the reward")
        best = max(told, key=lambda other: told[other].bits)
        real = reward.is_real or any(known.is_real for known in told.values())
        rows.append((variable.name, f"{reward.bits:.3f}", f"{told[best].bits:.3f} ({best})", "yes" if real else "no"))
    head = ("input", "of the reward [bit]", "of another input [bit]", "more than chance?")
    return Table(f"What each input tells, {steps} steps at random", head, rows)
