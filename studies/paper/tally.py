"""The paper's pairs on our robots, counted by several tests: with unequal spreads, and corrected for many looks."""

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence

from holm import holm_corrected

from paper import paper
from paper.outcome import Judged, Outcome
from paper.verdicts import EVERYWHERE, LEVEL, NOT, SOMEWHERE, TENDENCY, mark, verdict
from rlrobot_edu.experiments.statistics import Pair
from rlrobot_edu.experiments.tables import Table

Outcomes = Mapping[str, Outcome]
Look = tuple[str, str, Judged]  # a task, a length, and a pair that is judged there
RULES = {"SR and QBIASSR": (), "QBIASSR alone": ("cause_evasion",)}


def looks(outcomes: Outcomes, instead: Iterable[str] = ()) -> list[Look]:
    """Each pair of the paper at each length on the robot; an experiment of a kind in `instead` takes its place."""
    found = []
    for task in paper.TUKEY:
        keys = [f"{kind}_{task}" for kind in (*instead, "robot")]
        ran = [key for key in keys if key in outcomes]
        if ran:
            outcome = outcomes[ran[0]]
            for length in outcome.final:
                for judged in outcome.judged(length):
                    found.append((task, str(length), judged))
    return found


def lost_by_holm(outcomes: Outcomes) -> set[tuple[str, str, str]]:
    """Task, length and name of each pair that is significant alone, and not after Holm's correction over all."""
    found = looks(outcomes)
    corrected = holm_corrected([judged.p for _, _, judged in found])
    lost = set()
    for (task, length, judged), p in zip(found, corrected, strict=True):
        if judged.p < LEVEL <= p:
            lost.add((task, length, judged.pair.name))
    return lost


def marks(
    found: Sequence[Look], p_values: Sequence[float]
) -> dict[tuple[str, str], str]:
    """What became of each pair that is significant in the paper, by these p; by task and name of the pair."""
    by_pair = defaultdict(list)
    for (task, _, judged), p in zip(found, p_values, strict=True):
        if judged.pair.p < LEVEL:
            one = verdict(judged.gain, float(p), judged.pair.p)
            by_pair[task, judged.pair.name].append(one)
    return {pair: mark(verdicts) for pair, verdicts in by_pair.items()}


def _tukey(pairs: Sequence[Pair]) -> list[float]:
    return [pair.p for pair in pairs]


def _games_howell(pairs: Sequence[Pair]) -> list[float]:
    return [pair.games_howell for pair in pairs]


TESTS: Mapping[str, Callable[[Sequence[Pair]], Sequence[float]]] = {
    "Tukey": _tukey,
    "Games-Howell": _games_howell,
    "Tukey, corrected by Holm": lambda pairs: holm_corrected(_tukey(pairs)),
    "Games-Howell, corrected by Holm": lambda pairs: holm_corrected(
        _games_howell(pairs)
    ),
}


def tally_table(outcomes: Outcomes) -> Table:
    """How many of the paper's pairs we find, by each test and by each rule of loop evasion."""
    rows: list[list[object]] = []
    for rule, instead in RULES.items():
        found = looks(outcomes, instead)
        for test, p_of in TESTS.items():
            p_values = p_of([judged.ours for _, _, judged in found])
            if found:
                its = list(marks(found, p_values).values())
                counts = [its.count(x) for x in (EVERYWHERE, SOMEWHERE, TENDENCY, NOT)]
                significant = sum(p < LEVEL for p in p_values)
                rows.append([rule, test, *counts, f"{significant} of {len(p_values)}"])
    columns = [
        "loop evasion in",
        "test",
        EVERYWHERE,
        SOMEWHERE,
        TENDENCY,
        NOT,
        "significant looks",
    ]
    return Table(
        f"The paper's significant pairs on our robots. {EVERYWHERE}: the same at every length; {SOMEWHERE}: at some; "
        f"{TENDENCY}: the same direction, never significant; {NOT}: never significant, and opposite at some",
        columns,
        rows,
    )
