"""The program of learners in their worlds, as the playground and the stage have it; no page is needed to run it."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from importlib.resources import files
from typing import Any

import numpy as np

from rlrobot_edu.learning.memory import SETTINGS
from rlrobot_edu.learning.parameters import Parameters
from rlrobot_edu.seeds import ENVIRONMENT, generator
from rlrobot_edu.widgets.playground.worlds import World

SLIDERS = ("alpha", "gamma", "lam", "temperature", "epsilon")


def script_of(
    program: str,
    worlds: Mapping[str, World],
    methods: Mapping[str, str],
    lucks: Iterable[int],
) -> str:
    """JavaScript in which ``newSimulation(settings)`` is a learner in its world, see new_simulation.js.

    program: the kernels, as `kernels` gives them for the same methods in the same order
    methods: how each is called; lucks: seeds, of which the page has the random numbers
    """
    about = {
        "worlds": worlds,
        "methods": [{"name": name, "called": text} for name, text in methods.items()],
        "lucks": [luck_of(seed) for seed in lucks],
        "parameters": _defaults(SLIDERS),
        "defaults": _defaults(SETTINGS.names or ()),
    }
    about_text = json.dumps(about, ensure_ascii=False, separators=(",", ":"))
    simulation = files("rlrobot_edu.widgets.javascript") / "simulation.js"
    here = files(__package__)
    parts = [
        simulation.read_text("utf-8"),
        f"const kernels = {program};",
        f"const about = {about_text};",
        (here / "walls.js").read_text("utf-8"),
        (here / "new_simulation.js").read_text("utf-8"),
    ]
    return "\n".join(parts)


def _defaults(names: Iterable[str]) -> dict[str, Any]:
    parameters = Parameters()
    return {name: getattr(parameters, name) for name in names}


def luck_of(seed: int) -> dict[str, dict[str, str]]:
    """The states, in hex, in which the random numbers of an agent and of a world with this seed begin."""
    return {
        "agent": _hex_state(generator(seed, ())),
        "world": _hex_state(generator(seed, ENVIRONMENT)),
    }


def _hex_state(rng: np.random.Generator) -> dict[str, str]:
    """The state of PCG64 in hex, for simulation.js."""
    state: Any = rng.bit_generator.state["state"]
    return {"state": hex(state["state"]), "inc": hex(state["inc"])}
