"""Methods: what one consists of, and those of the toolkit, by name."""

from dataclasses import dataclass, field
from types import FunctionType
from typing import Any, TypeVar

from rlrobot_edu.checks import check_name, did_you_mean
from rlrobot_edu.jit.fingerprint import code_of
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.algorithm import Algorithm, Planner, Selection
from rlrobot_edu.learning.algorithms.expected_sarsa import EXPECTED_SARSA
from rlrobot_edu.learning.algorithms.q_learning import Q_LEARNING
from rlrobot_edu.learning.algorithms.sarsa import SARSA
from rlrobot_edu.learning.algorithms.sarsa_lambda import SARSA_LAMBDA
from rlrobot_edu.learning.algorithms.true_online_sarsa import TRUE_ONLINE_SARSA
from rlrobot_edu.learning.planning.dyna import DYNA
from rlrobot_edu.learning.selections.greedy import EG, GREEDY, RANDOM
from rlrobot_edu.learning.selections.least_explored import EGLE
from rlrobot_edu.learning.selections.qbiassr import QBIASSR
from rlrobot_edu.learning.selections.softmax import SR

ALGORITHMS = {
    a.name: a
    for a in (Q_LEARNING, SARSA, EXPECTED_SARSA, SARSA_LAMBDA, TRUE_ONLINE_SARSA)
}
SELECTIONS = {s.name: s for s in (SR, QBIASSR, EG, EGLE, GREEDY, RANDOM)}
PLANNERS = {p.name: p for p in (DYNA,)}
NAMES = [
    f"{algorithm}+{selection}" for algorithm in ALGORITHMS for selection in SELECTIONS
]
# What the literature calls the parts
IN_WORDS = {
    "Q-learning": "Q",
    "expected SARSA": "ESARSA",
    "SARSA(λ)": "SL",
    "SARSA(lambda)": "SL",
    "true online SARSA(λ)": "TOSL",
    "true online SARSA(lambda)": "TOSL",
    "softmax": "SR",
    "Q-biased softmax": "QBIASSR",
    "ε-greedy": "EG",
    "epsilon-greedy": "EG",
    "e-greedy": "EG",
}
T = TypeVar("T")


@suggests_keywords
@dataclass(frozen=True, init=False)
class Method:
    """How an agent learns and how it chooses. `Agent` takes one wherever it takes the name of one.

    Parameters
    ----------
    algorithm : Algorithm or str
        The update rule: your own, or the name of one of the toolkit's.
    selection : Selection or str
        The rule by which actions are selected.
    planner : Planner or str, optional
        How it learns between two steps from what was observed before.

    Raises
    ------
    ValueError
        If a name is unknown (the message suggests the nearest of the known ones), or if a part is not a function.
    """

    algorithm: Algorithm
    selection: Selection
    planner: Planner | None
    # The code of its parts and of all that they refer to, as it is now: kernels are made for it.
    _code: str = field(init=False, repr=False)

    def __init__(
        self,
        algorithm: Algorithm | str,
        selection: Selection | str,
        planner: Planner | str | None = None,
    ) -> None:
        algorithm = _part(Algorithm, algorithm, ALGORITHMS)
        selection = _part(Selection, selection, SELECTIONS)
        planner = None if planner is None else _part(Planner, planner, PLANNERS)
        check_function(f"the update of {algorithm.name}", algorithm.update)
        check_function(
            f"the selection {selection.name}", selection.compute_probabilities
        )
        if planner is not None:
            check_function(f"the planner {planner.name}", planner.plan)
        parts = (algorithm, selection, planner or ())
        code = code_of(tuple(tuple(part) for part in parts))
        # The dataclass is frozen: only object.__setattr__ can still set its fields.
        object.__setattr__(self, "algorithm", algorithm)
        object.__setattr__(self, "selection", selection)
        object.__setattr__(self, "planner", planner)
        object.__setattr__(self, "_code", code)

    @property
    def name(self) -> str:
        """In the paper's notation, ``ALGORITHM+SELECTION``."""
        return f"{self.algorithm.name}+{self.selection.name}"


def check_function(what: str, kernel: object) -> None:
    """Raises ValueError if `kernel` is not a function made with ``def``, compiled by numba or not."""
    if not isinstance(getattr(kernel, "py_func", kernel), FunctionType):
        raise ValueError(
            f"{what} must be a function that is written with def, got {kernel!r:.200}"
        )


def _check_facts(part: Any) -> None:
    """Raises ValueError unless the name of a part is a text, and what may be True or False is one of them."""
    words = {str: "a text", bool: "True or False"}
    for fact, kind in part.__annotations__.items():
        value = getattr(part, fact)
        if kind in words and not isinstance(value, kind):
            owner = type(part).__name__
            raise ValueError(
                f"{fact} of {owner} must be {words[kind]}, got {value!r:.200}"
            )


def _part(kind: type[T], given: T | str, toolkits: dict[str, T]) -> T:
    """The given part, or the toolkit's part of this name."""
    if isinstance(given, kind):
        _check_facts(given)
        return given
    what = kind.__name__.lower()
    meanings = {word: name for word, name in IN_WORDS.items() if name in toolkits}
    return toolkits[check_name(given, toolkits, what, "the toolkit", meanings)]


def parse_method(method: str | Method, planner: str | Planner | None = None) -> Method:
    """The method of this name, with this planner. Raises ValueError that lists the known names, the nearest first."""
    if not isinstance(method, Method):
        if method not in NAMES:
            algorithms, selections = ", ".join(ALGORITHMS), ", ".join(SELECTIONS)
            raise ValueError(
                f"unknown method {method!r:.200}{did_you_mean(method, NAMES, _meanings())} A method is "
                f"ALGORITHM+SELECTION, one of {algorithms} and one of {selections}; or an rl.Method"
            )
        method = Method(*method.split("+"))
    planner = method.planner if planner is None else planner
    return Method(method.algorithm, method.selection, planner)  # as its code is now


def _meanings() -> dict[str, str]:
    """Other words for methods, each with the method's name; a part that is not said is TOSL or SR."""
    words = IN_WORDS | {name: name for name in (*ALGORITHMS, *SELECTIONS)}
    algorithms = {word: name for word, name in words.items() if name in ALGORITHMS}
    selections = {word: name for word, name in words.items() if name in SELECTIONS}
    meanings = {}
    for selection, selected in selections.items():
        meanings[selection] = f"TOSL+{selected}"
        for algorithm, updated in algorithms.items():
            meanings[algorithm] = f"{updated}+SR"
            meanings[f"{algorithm}+{selection}"] = f"{updated}+{selected}"
    return meanings


def made_of(method: Method) -> dict[str, str | None]:
    """The name of a method's planner, and the code of each part that is not the toolkit's, as a short name.

    The code includes all that it refers to. These and the method's name identify it in a file.
    """
    brought = [*ALGORITHMS.values(), *SELECTIONS.values(), *PLANNERS.values()]
    toolkits = {code_of(tuple(part)) for part in brought}
    parts = (method.algorithm, method.selection, method.planner)
    codes = {f"the code of {part.name}": code_of(tuple(part)) for part in parts if part}
    own = {name: code for name, code in codes.items() if code not in toolkits}
    planner = method.planner.name if method.planner else None
    return {"planner": planner, **own}
