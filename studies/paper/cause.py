"""What a cause of a difference is, and the words in which causes are told."""

from collections.abc import Mapping
from typing import NamedTuple

from paper import verdicts
from paper.experiments import Length
from paper.outcome import Outcome
from paper.paper import PaperPair
from paper.verdicts import Verdict
from rlrobot_edu.experiments.statistics import Pair
from rlrobot_edu.experiments.tables import as_text

SHOWN, PARTLY, NOT_SHOWN = "shown", "shown in part", "not shown"
NOTHING, NOT_RUN = "nothing to explain", "not run"
DECIDES, NO_MATTER = "verdicts hang on it", "no verdict hangs on it"  # of a choice of ours

Outcomes = Mapping[str, Outcome]
Place = tuple[str, Length, str]  # an experiment, its length, and a pair of methods


class Cause(NamedTuple):
    """A supposed cause.

    status: SHOWN, PARTLY, NOT_SHOWN, NOTHING or NOT_RUN; of a choice of ours DECIDES or NO_MATTER
    summary: what was found, for the first screen; body: more of it
    explains: these pairs, in which ours is opposite to the paper's
    """

    title: str
    status: str
    summary: str
    body: str = ""
    explains: frozenset[Place] = frozenset()

    @property
    def text(self) -> str:
        """Its section of the report."""
        return "\n\n".join(
            part for part in (f"### {self.title}", f"*{self.status}.* {self.summary}", self.body) if part
        )


def paired(outcome: Outcome, length: Length) -> list[tuple[Pair, PaperPair]]:
    """Our pairs that the paper speaks of, and the paper's."""
    both = ((pair, verdicts.papers(pair, outcome.experiment.pairs)) for pair in outcome.pairs[length])
    return [(pair, its) for pair, its in both if its]


def of_pairs(outcome: Outcome, length: Length) -> dict[str, Verdict]:
    """The verdict on each of these pairs, by its name."""
    return {its.name: verdicts.of_pair(pair, its) for pair, its in paired(outcome, length)}


def opposites(outcome: Outcome, length: Length) -> dict[str, Verdict]:
    """The pairs in which the other method is better here, and their verdicts."""
    return {name: said for name, said in of_pairs(outcome, length).items() if said.is_opposite}


def ahead(outcome: Outcome, length: Length) -> list[str]:
    """The pairs in which the paper's better method is significantly better here, whether or not in the paper."""
    both = paired(outcome, length)
    return [its.name for pair, its in both if verdicts.gain(pair, its) > 0 and pair.p < verdicts.LEVEL]


def cured(*before_and_after: tuple[str, Outcome, Outcome]) -> tuple[str, frozenset[Place]]:
    """A cause's status, and what it explains: the pairs that are opposite to the paper's before, and not after.

    before_and_after: keys of experiments, their outcomes, and those without the cause. Each length is judged by itself.
        Another sign does not suffice: afterwards the paper's better method must be significantly better.
    """
    bad, good = set(), set()
    for key, before, after in before_and_after:
        for length in before.final:
            for name in opposites(before, length):
                bad.add((key, length, name))
                if name in ahead(after, length):
                    good.add((key, length, name))
    return (NOTHING if not bad else SHOWN if good == bad else PARTLY if good else NOT_SHOWN), frozenset(good)


def of_value(outcome: Outcome) -> verdicts.ValueVerdict:
    """The verdict on the value that the paper chose, at the longest length."""
    return verdicts.of_value(outcome.final[outcome.longest], outcome.pairs[outcome.longest], outcome.experiment.best)


def value_words(said: verdicts.ValueVerdict) -> str:
    """The verdict as the rest of a sentence."""
    if said.name == verdicts.BEST:
        return f"is {said.name}"
    return f"is {said.name} ({said.best} is better by {said.loss:.2f}, {p_words(said.p)})"


def mean_words(means: Mapping[str, float]) -> str:
    """Means by label, as a sentence."""
    return "Mean final average rewards: " + ", ".join(f"{label} {mean:.2f}" for label, mean in means.items()) + "."


def p_words(p: float) -> str:
    """A p-value in a sentence."""
    return "p < 1e-15" if p < 1e-15 else f"p = {as_text(p)}"


def signed(x: float) -> str:
    """A difference with its sign."""
    return f"{x:+.2f}".replace("-", "−")
