"""The parameters of a learning agent: what each one is, which values it may take, and its default."""

from collections.abc import Callable
from dataclasses import dataclass, field, fields
from typing import Any, Literal, get_args

import numpy as np

from rlrobot_edu.checks import LARGEST_NUMBER

INFINITE = float("inf")
Traces = Literal["reduced", "full"]
TRACES = get_args(Traces)
R_MAX = "between 1e-100 and 1e100 (if all rewards are negative, give the magnitude of a typical one)"
# Traces below this share of a fresh one are dropped (paper section 3)
TRACE_THRESHOLD = 0.01


def _parameter(default: Any, domain: str, holds: Callable[[Any], bool]) -> Any:
    return field(default=default, metadata={"domain": domain, "holds": holds})


@dataclass(frozen=True)
class Parameters:
    """The parameters of an agent.

    alpha: learning rate
    gamma: discount rate
    lam: decay of the eligibility traces, λ
    temperature: Boltzmann temperature while no loop is detected, for SR and the biased selections
    epsilon: probability of exploring, for EG and EGLE
    traces: ``reduced`` (the paper's RETR) or ``full``
    accumulating: whether SARSA(λ) adds to a trace instead of replacing it
    loop_evasion: whether the temperature rises in loops of low reward (LRLE)
    r_max: largest reward, which normalises Q
    planning_steps: imagined steps between two real ones, for an agent with a planner

    Raises ValueError that names the parameter, its domain and what was given.
    """

    alpha: float = _parameter(0.1, "in (0, 1]", lambda x: 0 < x <= 1)
    gamma: float = _parameter(0.9, "in [0, 1]", lambda x: 0 <= x <= 1)
    lam: float = _parameter(0.9, "in [0, 1]", lambda x: 0 <= x <= 1)
    temperature: float = _parameter(
        1.0, "a finite number above 0", lambda x: 0 < x < INFINITE
    )
    epsilon: float = _parameter(0.1, "in [0, 1]", lambda x: 0 <= x <= 1)
    traces: Traces = _parameter(
        "reduced", " or ".join(TRACES), lambda x: type(x) is str and x in TRACES
    )
    accumulating: bool = _parameter(
        False, "True or False", lambda x: isinstance(x, bool)
    )
    loop_evasion: bool = _parameter(
        True, "True or False", lambda x: isinstance(x, bool)
    )
    r_max: float = _parameter(1.0, R_MAX, lambda x: 1e-100 <= x <= LARGEST_NUMBER)
    planning_steps: int = _parameter(
        10,
        "a whole number from 0 to 1,000,000",
        lambda x: type(x) is int and 0 <= x <= 1_000_000,
    )

    def __post_init__(self) -> None:
        for parameter in fields(self):
            name = parameter.name
            value = getattr(self, name)
            if isinstance(value, np.generic):
                value = value.item()  # files keep Python's own numbers
                # The dataclass is frozen: only object.__setattr__ can still set its fields.
                object.__setattr__(self, name, value)
            if parameter.type is float and not isinstance(value, int | float):
                raise ValueError(f"{name} must be a number, got {value!r:.200}")
            if not parameter.metadata["holds"](value):
                raise ValueError(
                    f"{name} must be {parameter.metadata['domain']}, got {value!r:.200}"
                )

    @property
    def smallest_trace(self) -> float:
        """Smaller traces are dropped; full traces only when they have become negligible."""
        return TRACE_THRESHOLD if self.traces == "reduced" else 1e-100

    @property
    def q_scale(self) -> float:
        """100 / Qmax, which normalises Q before a softmax (paper equations 10 and 11); 0 for γ = 1."""
        q_max = self.r_max / (1 - self.gamma) if self.gamma < 1 else INFINITE
        return 100 / q_max
