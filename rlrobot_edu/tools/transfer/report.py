"""What was carried over from one agent to another, in fields and as a table."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy import sparse

from rlrobot_edu.experiments.tables import Table, Tabled
from rlrobot_edu.tools.transfer.commands import ActionMatch


class InputMatch(NamedTuple):
    """What was done about an input.

    name: the sensor's name
    how: ``matched`` in both, ``copied`` to all bins of an input that the source lacks, or ``averaged`` over all bins
        of one that the target lacks
    weights: sparse array (bins of the target, bins of the source), the part of each bin that lies in each
    """

    name: str
    how: str
    weights: sparse.csr_array


@dataclass(frozen=True, repr=False)
class Report(Tabled):
    """What `rl.transfer` has carried over. It shows itself as a table.

    source, target: names of the tasks
    inputs, actions: what was done about each input, and what stands for each action of the target
    known: bool array (n_states, n_actions) of the target, whether a pair rests on the source's experience
    scale: by what the source's Q was multiplied
    source_actions: the values of the outputs in each of the source's actions; outputs: the names of the target's
    """

    source: str
    target: str
    inputs: tuple[InputMatch, ...]
    actions: tuple[ActionMatch, ...]
    known: np.ndarray
    scale: float
    source_actions: tuple[str, ...]
    outputs: str

    @property
    def share(self) -> float:
        """Share of the target's pairs (s, a) that rest on pairs which the source has visited."""
        return float(self.known.mean())

    def table(self) -> Table:
        """One line for each input and each action."""
        rows = [
            ("input " + match.name, self._input(match), "") for match in self.inputs
        ]
        shares = self.known.mean(axis=0)
        rows += [
            ("action " + m.label, self._action(m), f"{shares[m.action]:.0%}")
            for m in self.actions
        ]
        caption = (
            f"From {self.source} to {self.target}: {self.share:.0%} of the pairs (s, a) rest on visited pairs of the "
            f"source, the others begin with 0; Q was multiplied by {self.scale:.4g}; an action is ({self.outputs})"
        )
        return Table(caption, ("of the target", "comes from", "states known"), rows)

    @staticmethod
    def _input(match: InputMatch) -> str:
        n_target, n_source = match.weights.shape
        if match.how == "copied":
            return f"the source lacks it: copied to all {n_target} bins"
        if match.how == "averaged":
            return f"the target lacks it: mean over its {n_source} bins"
        if (
            n_target == n_source == match.weights.nnz
            and (match.weights.diagonal() == 1).all()
        ):
            return f"the same {n_target} bins"
        uncovered = int((match.weights.sum(axis=1) == 0).sum())
        return (
            f"{n_target} bins from {n_source} by overlap"
            + f", {uncovered} unknown" * bool(uncovered)
        )

    def _action(self, match: ActionMatch) -> str:
        if not match.sources:
            return "nothing like it: unknown"
        alike: dict[float, list[str]] = {}
        for b, weight in match.sources:
            alike.setdefault(weight, []).append(self.source_actions[b])
        parts = [
            (f"{weight * len(names):.0%} ", names)
            for weight, names in sorted(alike.items(), reverse=True)
        ]
        if len(parts) == 1:
            parts = [("mean of " if len(match.sources) > 1 else "", parts[0][1])]
        said = " + ".join(share + ", ".join(names) for share, names in parts)
        return said if match.miss < 0.005 else f"{said} (off by {match.miss:.0%})"
