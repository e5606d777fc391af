"""An agent in a file: all that it is goes there, and only what learning can have left comes back."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from rlrobot_edu.files import load_arrays, save_arrays
from rlrobot_edu.learning.border import changing, check_pair, contents, restore
from rlrobot_edu.learning.methods import Method, own_parts
from rlrobot_edu.learning.remembered import recall, remembered
from rlrobot_edu.learning.size import Size

if TYPE_CHECKING:
    from rlrobot_edu.learning.agent import Agent


def write(agent: "Agent", path: str | Path) -> None:
    """See `Agent.save`. Raises ValueError for an agent that `read` would refuse, such as one of infinite values."""
    if wrong := [name for name, is_sound in contents(agent.memory) if not is_sound]:
        raise ValueError(f"{path}: {wrong[0]} of this agent is out of range, so it could not be read again")
    about = {
        "method": agent.method, "own_parts": own_parts(agent.made_of[0]), "settings": asdict(agent.parameters),
        "shape": agent.shape, "n_actions": agent.q.shape[1], "pending": agent.pending,
        "rng": agent.rng.bit_generator.state,
    }  # fmt: skip
    met = {} if agent.experience is None else remembered(agent.experience)
    save_arrays(path, "agent", about, {**changing(agent.memory), **met})


def read(kind: type["Agent"], path: str | Path, method: Method | None) -> "Agent":
    """See `Agent.load`."""

    def make(about: dict[str, Any], arrays: dict[str, np.ndarray]) -> "Agent | str":
        if refusal := _other_method(about["method"], about["own_parts"], method):
            return refusal
        agent = kind(Size(tuple(about["shape"]), about["n_actions"]), method or about["method"], **about["settings"])
        agent.rng.bit_generator.state = about["rng"]
        agent.pending = about["pending"] and check_pair(agent.memory, *about["pending"])
        restore(agent.memory, arrays)
        if agent.experience is not None:
            agent.experience = recall(agent.experience, arrays)
        return agent

    agent = load_arrays(path, "agent", make)
    if isinstance(agent, str):  # the file is whole
        raise ValueError(f"{path}: {agent}")
    return agent


def _other_method(name: str, own: dict[str, str], method: Method | None) -> str:
    """What is wrong with `method` for an agent in a file with this method and parts of its own; empty if nothing is."""
    code = "\n\n".join(own.values())
    if method is None:
        return f"this agent has a method of its own; give method=rl.Method(…) made of this code:\n{code}" if own else ""
    if (method.name, own_parts(method)) != (name, own):
        return f"this agent's method, {name}, is not the {method.name} that was given. {code}".rstrip()
    return ""
