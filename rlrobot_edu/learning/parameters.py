"""The parameters of a learning agent: what each one is, which values it may take, and its default."""

import math
import sys
from collections.abc import Callable
from dataclasses import dataclass, field, fields
from typing import Any, Literal, get_args

import numpy as np

from rlrobot_edu.checks import LARGEST_NUMBER

Traces = Literal["reduced", "full"]
TRACES = get_args(Traces)
SMALLEST_R_MAX = 1e-100
R_MAX_DOMAIN = "between 1e-100 and 1e100 (if all rewards are negative, give the magnitude of a typical one)"
# Traces smaller than this are dropped; a fresh one is 1.
SMALLEST_REDUCED_TRACE = 0.01  # paper section 3
SMALLEST_FULL_TRACE = 1e-100  # next to nothing


def _parameter(default: Any, domain: str, holds: Callable[[Any], bool]) -> Any:
    return field(default=default, metadata={"domain": domain, "holds": holds})


def _is_number(x: Any) -> bool:
    """Whether `x` is a number; to Python True and False are some, too."""
    return isinstance(x, int | float) and not isinstance(x, bool)


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
        1.0, "a finite number above 0", lambda x: 0 < x <= sys.float_info.max
    )
    epsilon: float = _parameter(0.1, "in [0, 1]", lambda x: 0 <= x <= 1)
    traces: Traces = _parameter(
        "reduced", " or ".join(TRACES), lambda x: isinstance(x, str) and x in TRACES
    )
    accumulating: bool = _parameter(
        False, "True or False", lambda x: isinstance(x, bool)
    )
    loop_evasion: bool = _parameter(
        True, "True or False", lambda x: isinstance(x, bool)
    )
    r_max: float = _parameter(
        1.0, R_MAX_DOMAIN, lambda x: SMALLEST_R_MAX <= x <= LARGEST_NUMBER
    )
    planning_steps: int = _parameter(
        10,
        "a whole number from 0 to 1,000,000",
        lambda x: _is_number(x) and isinstance(x, int) and 0 <= x <= 1_000_000,
    )

    def __post_init__(self) -> None:
        for parameter in fields(self):
            name = parameter.name
            value = getattr(self, name)
            if isinstance(value, np.generic):
                value = value.item()  # files keep Python's own numbers
                # The dataclass is frozen: only object.__setattr__ can still set its fields.
                object.__setattr__(self, name, value)
            if isinstance(parameter.default, float) and not _is_number(value):
                raise ValueError(f"{name} must be a number, got {value!r:.200}")
            if not parameter.metadata["holds"](value):
                raise ValueError(
                    f"{name} must be {parameter.metadata['domain']}, got {value!r:.200}"
                )

    @property
    def smallest_trace(self) -> float:
        """Smaller traces are dropped; full traces only when they have become negligible."""
        if self.traces == "reduced":
            return SMALLEST_REDUCED_TRACE
        return SMALLEST_FULL_TRACE

    @property
    def q_scale(self) -> float:
        """100 / Qmax, which normalises Q before a softmax (paper equations 10 and 11); 0 for γ = 1."""
        q_max = self.r_max / (1 - self.gamma) if self.gamma < 1 else math.inf
        return 100 / q_max
