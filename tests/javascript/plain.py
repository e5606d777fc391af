"""What the kernels do as plain Python: a job in a line of stdin, what came of it in a line of stdout."""

import json
import sys

import numpy as np

import rlrobot_edu as rl
from rlrobot_edu.learning.compiled_loop import make_run
from rlrobot_edu.learning.memory import new_memory
from rlrobot_edu.learning.methods import parse_method
from rlrobot_edu.learning.parameters import Parameters
from rlrobot_edu.learning.step import begin_episode, make_step
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.sampling import begin, outcome


class Given:
    """A generator whose numbers are given."""

    def __init__(self, numbers):
        self.numbers = iter(numbers)

    def random(self):
        return next(self.numbers)


def steps(job):
    """A tape of transitions, learned from step by step."""
    m = new_memory(
        tuple(job["shape"]), job["n_actions"], Parameters(**job["parameters"])
    )
    kernels = make_step(parse_method(job["method"]))
    told = []
    for s, a, r, s_next, terminated, u in job["tape"]:
        a_next, delta = kernels.learn_step(m, s, a, r, s_next, terminated, u)
        told.append([int(a_next), float(delta)])
        if terminated:
            begin_episode(m)
    return m, {"told": told}


def run(job):
    """A whole run in a sample model of the toolkit's."""
    model = rl.SampleModel.from_recording(rl.read_recording(job["model"]))
    tables = rl.make_env(model).unwrapped._tables
    m = new_memory(
        tuple(tables.shape.tolist()), tables.n_actions, Parameters(**job["parameters"])
    )
    log = Transitions.empty(job["steps"])
    at = np.array([0, -1, 0, 0, 0])
    run = make_run(parse_method(job["method"]), begin, outcome)
    run(tables, m, None, Given(job["u"]), Given(job["v"]), at, log)
    return m, {"rewards": log.r.tolist(), "at": at.tolist()}


for line in sys.stdin:
    job = json.loads(line)
    m, told = {"steps": steps, "run": run}[job["kind"]](job)
    told |= {
        name: getattr(m, name).tolist()
        for name in ("q", "e", "visits", "probabilities")
    }
    print(json.dumps(told | {"temperature": float(m.now.temperature)}), flush=True)
