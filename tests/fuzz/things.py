"""What the programs of the attack can name: environments that lie, objects that misbehave, uses of what came back."""

from __future__ import annotations

import contextlib
import copy
import dataclasses
import importlib
import io
import math
import os
import pickle
import runpy
import sys
from decimal import Decimal
from fractions import Fraction
from functools import cache
from pathlib import Path
from unittest import mock

import gymnasium
import numpy as np

import rlrobot_edu as rl
from fuzz import seeds
from fuzz.contract import Insane, Own
from rlrobot_edu.learning.history import History
from rlrobot_edu.models.value_iteration import best_average_reward
from rlrobot_edu.task.task_file import available_tasks  # noqa: F401 - programs use it, and these
from rlrobot_edu.widgets.bias_explorer.explorer import BiasExplorer  # noqa: F401
from rlrobot_edu.widgets.sliders import ParameterSliders  # noqa: F401

nan, inf = math.nan, math.inf


def expect(truth: object, what: str) -> None:
    """Raises Insane, which no call may, unless `truth`."""
    if not truth:
        raise Insane(what)


def usable_agent(
    agent: rl.Agent, env: gymnasium.Env | None = None, steps: int = 50
) -> None:
    """It learns, its numbers stay finite, it can be saved and read back as it was."""
    env = rl.make_env(seeds.model(), 0) if env is None else env
    rl.learn(agent, env, steps, progress=False)
    expect(np.isfinite(agent.q).all(), "q is not finite")
    expect(np.isfinite(agent.e).all(), "traces are not finite")
    expect(
        (agent.probabilities >= 0).all() and abs(agent.probabilities.sum() - 1) < 1e-9,
        "no probabilities",
    )
    expect((agent.visits >= 0).all(), "negative visits")
    agent.save("again.npz")
    again = rl.Agent.load("again.npz")
    expect(
        again.q.tobytes() == agent.q.tobytes() and again.parameters == agent.parameters,
        "another agent is read back",
    )
    repr(agent)


def usable_model(model: rl.SampleModel, planned: bool = True) -> None:
    """One can learn in it, plan in it, ask what it does not know, and keep it."""
    repr(model)
    agent = rl.Agent(model, seed=0)
    usable_agent(agent, rl.make_env(model, 0))
    env = rl.make_env(model, 0)
    env.reset()
    observation, r, *_ = env.step(model.n_actions - 1)
    expect(
        env.observation_space.contains(observation) and math.isfinite(r),
        "an impossible step",
    )
    model.save("again.npz")
    rl.SampleModel.load("again.npz")
    repr(model.diagnose())
    if planned:
        expect(np.isfinite(rl.value_iteration(model).q).all(), "Q* is not finite")
        expect(math.isfinite(best_average_reward(model)), "no best average reward")


def usable_recording(recording: rl.Recording) -> None:
    """It can be written, read back as it was, and made a model of."""
    repr(recording)
    recording.save("again")
    again = rl.read_recording("again")
    expect(
        all(
            (getattr(again, n) == getattr(recording, n)).all()
            for n in ("s", "a", "r", "s_next")
        ),
        "other rows",
    )
    usable_model(rl.SampleModel.from_recording(recording), planned=False)


def usable_history(history: History) -> None:
    """Its numbers can be had, and it can be kept."""
    repr(history), history.q, history.visits, history.average_reward, history.returns
    history.save("again.npz")
    History.load("again.npz")


def usable_comparison(result: rl.Comparison, forged: bool = False) -> None:
    """It is what the same call gives without a store; where numbers were `forged`, they can be shown."""
    if forged:
        result.table(), [runs.curves for runs in result.values()]
        return
    for label, runs in _undisturbed().items():
        for ours, theirs in zip(runs, result[label], strict=True):
            same = all(
                np.array_equal(a, b)
                for a, b in zip(ours.transitions, theirs.transitions, strict=True)
            )
            expect(same and ours.method == theirs.method, "other transitions")
            expect(np.array_equal(ours.q, theirs.q), "another q")


@cache
def _undisturbed() -> rl.Comparison:
    return rl.compare(seeds.model(), **seeds.STORE)


class Foreign(gymnasium.Env):
    """Somebody's own environment: states (2, 3), two actions, and whatever else it is told to say.

    observation, reward, terminated, info: what each step shows instead; shape, n: of its spaces
    **attributes: its own, such as `drive` or `state`
    """

    def __init__(
        self,
        shape=(2, 3),
        n=2,
        observation=None,
        reward=1.0,
        terminated=False,
        info=None,
        **attributes,
    ):
        self.observation_space = (
            gymnasium.spaces.MultiDiscrete(shape)
            if np.ndim(shape)
            else gymnasium.spaces.Discrete(shape)
        )
        self.action_space = gymnasium.spaces.Discrete(n)
        self.told = observation, reward, terminated, {} if info is None else info
        self.count = 0
        vars(self).update(attributes)

    def seen(self):
        if self.told[0] is not None:
            return self.told[0]
        space = self.observation_space
        if isinstance(space, gymnasium.spaces.Discrete):
            return int(space.start + self.count % space.n)
        return np.array(space.nvec * 0 + self.count) % space.nvec + space.start

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        return self.seen(), copy.copy(self.told[3])

    def step(self, action):
        self.count += 1
        return self.seen(), self.told[1], self.told[2], False, copy.copy(self.told[3])


class Odd:
    """An object none of whose methods does what it should; `how` names what each raises."""

    def __init__(self, how=Own):
        self.how = how

    def _raise(self, *_):
        raise self.how("an odd object")

    __repr__ = __eq__ = __len__ = __iter__ = __float__ = __bool__ = __call__ = (
        __array__
    ) = __fspath__ = _raise
    __hash__ = object.__hash__


def raising(error):
    """A function that raises."""

    def answer(*_):
        raise error

    return answer


def endless():
    """A generator without end."""
    while True:
        yield 1


def recursive():
    """A list that holds itself."""
    numbers = [1, 2]
    numbers.append(numbers)
    return numbers


def check(lesson, name):
    """The check of an exercise."""
    return vars(importlib.import_module(f"rlrobot_course.{lesson}.exercises").check)[
        name
    ]


def judged(verdict):
    """A verdict says waiting, right or wrong, in a text that fits on a page."""
    expect(verdict.status in ("waiting", "right", "wrong"), "no verdict")
    expect(0 < len(repr(verdict)) < 20_000, "a verdict that fills pages")


def command_line(*arguments):
    """``rlrobot-edu`` with these arguments; what it prints."""
    text = io.StringIO()
    called = mock.patch.object(sys, "argv", ["rlrobot-edu", *arguments])
    with contextlib.redirect_stdout(text), contextlib.redirect_stderr(text), called:
        runpy.run_module("rlrobot_course", run_name="__main__", alter_sys=False)
    return text.getvalue()


def drawn(picture):
    """A picture shows itself as a notebook would ask it to."""
    if hasattr(picture, "figure"):
        picture = picture.figure
    picture._repr_mimebundle_() if hasattr(
        picture, "_repr_mimebundle_"
    ) else picture._repr_png_()
    repr(picture)


def walk(*arguments, **named):
    """All steps of `rl.steps`."""
    return list(rl.steps(*arguments, **named))


def pipe(name):
    """A file that nobody ever writes to; whoever reads it waits for ever."""
    if not Path(name).exists():
        os.mkfifo(name)
    return name


def names() -> dict[str, object]:
    """All that a program can name, before its first line."""
    return {
        **{name: thing for name, thing in globals().items() if not name.startswith("_")},
        "task": rl.load_task(seeds.TASK), "model": seeds.model(), "recording": seeds.recording(),
        "history": seeds.history(), "learned": copy.deepcopy(seeds.agent()),
        "math": math, "copy": copy, "pickle": pickle, "replace": dataclasses.replace,
        "Decimal": Decimal, "Fraction": Fraction, "Path": Path,
    }  # fmt: skip
