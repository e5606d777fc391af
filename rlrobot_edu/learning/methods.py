"""The methods by name, in the paper's notation: ``ALGORITHM+SELECTION``, for example ``TOSL+QBIASSR``."""

from rlrobot_edu.learning.algorithm import Algorithm, Selection
from rlrobot_edu.learning.dyna import DYNA
from rlrobot_edu.learning.expected_sarsa import EXPECTED_SARSA
from rlrobot_edu.learning.fbiassr import FBIASSR
from rlrobot_edu.learning.greedy import EG, GREEDY, RANDOM
from rlrobot_edu.learning.least_explored import EGLE
from rlrobot_edu.learning.obiassr import OBIASSR
from rlrobot_edu.learning.q_learning import Q_LEARNING
from rlrobot_edu.learning.qbiassr import QBIASSR
from rlrobot_edu.learning.sarsa import SARSA
from rlrobot_edu.learning.sarsa_lambda import SARSA_LAMBDA
from rlrobot_edu.learning.softmax import SR
from rlrobot_edu.learning.sweeping import SWEEPING
from rlrobot_edu.learning.tbiassr import TBIASSR
from rlrobot_edu.learning.true_online_sarsa import TRUE_ONLINE_SARSA
from rlrobot_edu.learning.vbiassr import VBIASSR
from rlrobot_edu.task.messages import did_you_mean

# A new algorithm, selection or planner is a file of its own and a place in one of these lines.
ALGORITHMS = {a.name: a for a in (Q_LEARNING, SARSA, EXPECTED_SARSA, SARSA_LAMBDA, TRUE_ONLINE_SARSA)}
_BIASED = (VBIASSR, OBIASSR, FBIASSR, TBIASSR)  # other than the paper's
SELECTIONS = {s.name: s for s in (SR, QBIASSR, EG, EGLE, GREEDY, RANDOM, *_BIASED)}
PLANNERS = {p.name: p for p in (DYNA, SWEEPING)}
ALIASES = {"SARSA(lambda)": "SL", "SARSA(λ)": "SL"}


def parse_method(method: str) -> tuple[Algorithm, Selection]:
    """Algorithm and selection of a method. Raises ValueError that lists the known names and suggests the nearest."""
    algorithm, _, selection = str(method).partition("+")
    algorithm = ALIASES.get(algorithm, algorithm)
    if algorithm in ALGORITHMS and selection in SELECTIONS:
        return ALGORITHMS[algorithm], SELECTIONS[selection]
    known = [f"{a}+{s}" for a in ALGORITHMS for s in SELECTIONS]
    hint = did_you_mean(f"{algorithm}+{selection}".upper(), known, cutoff=0.0)
    raise ValueError(
        f"unknown method {method!r:.200}; {hint}A method is ALGORITHM+SELECTION with an algorithm of "
        f"{', '.join(ALGORITHMS)} (SL is SARSA(lambda)) and a selection of {', '.join(SELECTIONS)}"
    )


def check_planner(planner: str | None) -> None:
    """Raises ValueError that lists the known names, unless `planner` is one of them or None."""
    if not (planner is None or (isinstance(planner, str) and planner in PLANNERS)):
        hint = did_you_mean(planner, PLANNERS)
        raise ValueError(f"planner must be None or one of {', '.join(PLANNERS)}, got {planner!r:.200}. {hint}".rstrip())
