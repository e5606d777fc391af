"""What the paper found (its tables, as printed), and the experiments that ask the same questions here."""

from collections.abc import Mapping
from typing import NamedTuple

from rlrobot_edu.experiments.statistics import Anova

THREE = ("TOSL+QBIASSR", "TOSL+SR", "Q+SR")


class PaperPair(NamedTuple):
    """A pair of methods in the paper. q, p: of its Tukey test, None where it gives none; `better` is the better one."""

    better: str
    worse: str
    q: float | None = None
    p: float | None = None


def _pairs(*q_and_p: tuple[float, float], order: tuple[str, ...] = THREE) -> tuple[PaperPair, ...]:
    # The tables print |Q|; the order of the means is the only one in which two of the Q add up to the third.
    couples = ((order[0], order[1]), (order[0], order[2]), (order[1], order[2]))
    return tuple(PaperPair(*couple, *numbers) for couple, numbers in zip(couples, q_and_p, strict=True))


# by task: sums of squares and degrees of freedom, and F and p as printed
ANOVA = {
    "wander_simple": (Anova(125.41, 2, 476.37, 297), 39.09, 8.88e-16),
    "wander_1k": (Anova(27.47, 2, 6.58, 15), 31.29, 4.44e-6),
    "wander_4k": (Anova(14.96, 2, 3.50, 15), 32.05, 3.84e-6),
    "arm_1k": (Anova(136.21, 2, 456.23, 69), 10.30, 0.0001),
    "arm_4k": (Anova(278.65, 2, 414.97, 69), 23.17, 2.01e-8),
    "navigation_1k": (Anova(7.62, 2, 5.51, 6), 4.15, 0.070),
    "giraff_wander_1k": (Anova(31.73, 2, 55.26, 57), 16.36, 0.000002),
}
TUKEY = {
    "wander_simple": _pairs((0.80, 0.820), (11.21, 0.001), (10.41, 0.001), order=("TOSL+SR", "TOSL+QBIASSR", "Q+SR")),
    "wander_1k": _pairs((6.17, 0.002), (11.17, 0.001), (5.00, 0.008)),
    "wander_4k": _pairs((7.92, 0.001), (10.97, 0.001), (3.05, 0.111)),
    "arm_1k": _pairs((1.68, 0.465), (6.20, 0.001), (4.52, 0.006)),
    "arm_4k": _pairs((2.60, 0.165), (9.33, 0.001), (6.73, 0.001)),
    "navigation_1k": _pairs((1.95, 0.410), (4.07, 0.063), (2.13, 0.354)),
    "giraff_wander_1k": _pairs((4.3491, 0.0089151), (8.0827, 0.0010053), (3.7336, 0.0283548)),
}
# CPU time a step [s] in the sample-modelled wander-1K: method, traces, time
COST = (
    ("Q+SR", "reduced", 0.19e-3),
    ("SARSA+SR", "reduced", 0.20e-3),
    ("SL+SR", "reduced", 0.31e-3),
    ("TOSL+SR", "reduced", 0.31e-3),
    ("TOSL+QBIASSR", "reduced", 0.45e-3),
    ("TOSL+SR", "full", 5.32e-3),
)


class Experiment(NamedTuple):
    """One comparison. model: on a sample model, or else on the robot; says: the paper's finding, in words.

    repetitions: of the full set, and of the quick one
    """

    key: str
    title: str
    task: str
    model: bool
    methods: Mapping[str, Mapping] | tuple[str, ...]
    steps: int
    repetitions: tuple[int, int]
    says: str
    pairs: tuple[PaperPair, ...] = ()


def _sweep(name: str, symbol: str, values: tuple[float, ...]) -> dict[str, dict]:
    return {f"{symbol} = {value:g}": {"method": "TOSL+SR", name: value} for value in values}


def _chosen(methods: Mapping[str, Mapping] | tuple[str, ...], best: str) -> tuple[PaperPair, ...]:
    return tuple(PaperPair(best, other) for other in methods if other != best)


def _preliminary(key: str, title: str, methods, best: str, says: str) -> Experiment:
    pairs = _chosen(methods, best)
    return Experiment(f"preliminary_{key}", title, "wander_1k", True, methods, 3600, (1000, 100), says, pairs)


_ALGORITHMS = ("TOSL+SR", "SL+SR", "SARSA+SR", "Q+SR")
_LAMBDA = _sweep("lam", "λ", (0, 0.3, 0.5, 0.7, 0.9, 0.95))
_ALPHA, _GAMMA = _sweep("alpha", "α", (0.03, 0.1, 0.3, 0.5)), _sweep("gamma", "γ", (0.5, 0.8, 0.9, 0.95))
_TEMPERATURE = _sweep("temperature", "T", (0.3, 1, 3, 10))
_TRACES = {traces: {"method": "TOSL+SR", "traces": traces} for traces in ("reduced", "full")}

# Learning processes last from 1 to 60 minutes in the paper, which does not say which: here one minute for the tasks
# with 4 states, half an hour for the Giraff robot, an hour for all others (30 episodes of an arm, one of navigation).
STEPS = {"wander_simple": 60, "giraff_wander_simple": 60, "giraff_wander_1k": 1800, "giraff_wander_4k": 1800}
_ON_MODELS = ("wander_simple", "wander_1k", "arm_1k", "navigation_1k")
_SIMULATED = ("wander_simple", "wander_1k", "wander_4k", "arm_1k", "arm_4k", "navigation_1k")
_GIRAFF = ("giraff_wander_simple", "giraff_wander_1k", "giraff_wander_4k")
_REPETITIONS = {"wander_simple": (100, 30), "arm_1k": (30, 4), "arm_4k": (30, 4)}

EXPERIMENTS = (
    _preliminary("algorithms", "Which algorithm?", _ALGORITHMS, "TOSL+SR", "TOSL is the best algorithm."),
    _preliminary("lambda", "How long a trace?", _LAMBDA, "λ = 0.9", "λ = 0.9 works well."),
    _preliminary("alpha", "How fast to learn?", _ALPHA, "α = 0.1", "α = 0.1 works well."),
    _preliminary("gamma", "How far to look ahead?", _GAMMA, "γ = 0.9", "γ = 0.9 works well."),
    _preliminary("temperature", "How hot?", _TEMPERATURE, "T = 1", "The best results have T = 1."),
    _preliminary("exploration", "How to explore?", ("TOSL+SR", "TOSL+EG"), "TOSL+SR", "Softmax does best."),
    *(
        Experiment(
            f"model_{task}", f"On a sample model: {task}", task, True, THREE, STEPS.get(task, 3600),
            (200, 50) if task == "navigation_1k" else (1000, 100),
            "TOSL+QBIASSR outperforms TOSL+SR in two of the four tasks (its figure; it does not say which).",
        )
        for task in _ON_MODELS
    ),
    *(
        Experiment(
            f"robot_{task}", f"Physical simulation: {task}", task, False, THREE, STEPS.get(task, 3600),
            _REPETITIONS.get(task, (30, 10)), "See its numbers beside ours.", TUKEY.get(task, ()),
        )
        for task in (*_SIMULATED, *_GIRAFF)
    ),
    Experiment(
        "traces", "Reduced against full traces", "wander_1k", True, _TRACES, 600, (1000, 100),
        "Reduced traces have a negligible effect on learning.",
    ),
)  # fmt: skip
