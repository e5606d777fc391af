"""What a cause of a difference is, and the words in which causes are told."""

from collections.abc import Mapping
from typing import NamedTuple

from rlrobot_edu.experiments.tables import as_text
from rlrobot_edu.reproduction import verdicts
from rlrobot_edu.reproduction.experiments import Length
from rlrobot_edu.reproduction.outcome import Outcome
from rlrobot_edu.reproduction.verdicts import Verdict

SHOWN, NOT_SHOWN, NOTHING, NOT_RUN = "shown", "not shown", "nothing to explain", "not run"

Outcomes = Mapping[str, Outcome]
Place = tuple[str, Length, str]  # an experiment, its length, and a pair of methods


class Cause(NamedTuple):
    """A supposed cause.

    status: SHOWN, NOT_SHOWN, NOTHING or NOT_RUN; summary: what was found, for the first screen; body: more of it
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


def opposites(outcome: Outcome, length: Length) -> dict[str, Verdict]:
    """The pairs in which the other method is better here, and their verdicts."""
    found = {}
    for pair in outcome.pairs[length]:
        its = verdicts.papers(pair, outcome.experiment.pairs)
        if its and (said := verdicts.of_pair(pair, its)).is_opposite:
            found[its.name] = said
    return found


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
