"""An agent in a file: all that it is goes there, and only what learning can have left comes back."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from rlrobot_edu.files import load_arrays, save_arrays
from rlrobot_edu.learning.border import changing, check_pair, contents, restore
from rlrobot_edu.learning.remembered import recall, remembered
from rlrobot_edu.learning.size import Size

if TYPE_CHECKING:
    from rlrobot_edu.learning.agent import Agent


def write(agent: "Agent", path: str | Path) -> None:
    """See `Agent.save`. Raises ValueError for an agent that `read` would refuse, such as one of infinite values."""
    if wrong := [name for name, is_sound in contents(agent.memory) if not is_sound]:
        raise ValueError(f"{path}: {wrong[0]} of this agent is out of range, so it could not be read again")
    about = {
        "method": agent.method, "settings": asdict(agent.parameters), "shape": agent.shape,
        "n_actions": agent.q.shape[1], "pending": agent.pending, "rng": agent.rng.bit_generator.state,
    }  # fmt: skip
    met = {} if agent.experience is None else remembered(agent.experience)
    save_arrays(path, "agent", about, {**changing(agent.memory), **met})


def read(kind: type["Agent"], path: str | Path) -> "Agent":
    """See `Agent.load`."""

    def make(about: dict[str, Any], arrays: dict[str, np.ndarray]) -> "Agent":
        agent = kind(Size(tuple(about["shape"]), about["n_actions"]), about["method"], **about["settings"])
        agent.rng.bit_generator.state = about["rng"]
        agent.pending = about["pending"] and check_pair(agent.memory, *about["pending"])
        restore(agent.memory, arrays)
        if agent.experience is not None:
            agent.experience = recall(agent.experience, arrays)
        return agent

    return load_arrays(path, "agent", make)
