"""RLROBOT-EDU: tabular reinforcement learning on simulated robots, to read, to run and to watch.

    import rlrobot_edu as rl

Names load when they are first used, so importing the package is quick.
"""

from __future__ import annotations

import importlib

import gymnasium

from rlrobot_edu.task import Task, available_tasks, load_task
from rlrobot_edu.variables import InputVariable, OutputVariable

__version__ = "0.1.0"

_HOME = {
    "Agent": "learning.agent",
    "History": "learning.history",
    "Step": "learning.loop",
    "learn": "learning.loop",
    "steps": "learning.loop",
    "make_env": "worlds",
    "Realism": "robots.realism",
    "Recording": "models.recording",
    "read_recording": "models.recording",
    "record": "models.recording",
    "SampleModel": "models.sample_model",
    "value_iteration": "models.planning",
    "best_average_reward": "models.planning",
    "repeat": "experiments.repeat",
    "compare": "experiments.compare",
    "Comparison": "experiments.comparison",
    "film": "show.film",
    "plot_learning": "show.curves",
    "plot_scene": "show.top_down",
    "show_scene": "show.scene3d",
    "LiveView": "show.scene3d",
    "ParameterSliders": "show.sliders",
    "BiasExplorer": "explain.bias_explorer",
    "Stepper": "stepper.stepper",
}

__all__ = ["InputVariable", "OutputVariable", "Task", "available_tasks", "load_task", *_HOME]


def __getattr__(name: str):
    if name not in _HOME:
        raise AttributeError(f"module 'rlrobot_edu' has no attribute {name!r}")
    value = getattr(importlib.import_module(f"rlrobot_edu.{_HOME[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])


for _name in available_tasks():
    gymnasium.register(f"rlrobot/{_name}-v0", entry_point="rlrobot_edu.worlds:make_env", kwargs={"task": _name})
