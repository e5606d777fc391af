"""A diagnosis: what a sample model does not know, and where it may promise more than its recording shows."""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy import sparse

if TYPE_CHECKING:
    from rlrobot_edu.models.sample_model import SampleModel


class Loop(NamedTuple):
    """States among which the model lets an agent go round for ever, always well rewarded.

    states: numbers of the states; pairs: the (s, a) that make the loop
    reward: mean reward of a step in it; samples: recorded transitions that this belief rests on
    """

    states: tuple[int, ...]
    pairs: tuple[tuple[int, int], ...]
    reward: float
    samples: int


class Diagnosis(NamedTuple):
    """The weak points of a model, shown in words.

    states_seen of n_states, pairs_seen of n_pairs: coverage; pairs_seen_once: pairs with one sample
    loops: loops of above-average reward, each pair of which has one certain outcome that rests on few samples
    """

    n_states: int
    states_seen: int
    n_pairs: int
    pairs_seen: int
    pairs_seen_once: int
    mean_reward: float
    loops: tuple[Loop, ...]

    def __repr__(self) -> str:
        one = [loop for loop in self.loops if len(loop.states) == 1]
        lucky = sum(loop.samples == 1 for loop in one)
        return f"""\
states seen        {self.states_seen} of {self.n_states} ({self.states_seen / self.n_states:.0%})
pairs (s, a) seen  {self.pairs_seen} of {self.n_pairs} ({self.pairs_seen / self.n_pairs:.0%})
  seen only once   {self.pairs_seen_once} of {self.pairs_seen} ({self.pairs_seen_once / self.pairs_seen:.0%})
mean reward        {self.mean_reward:.3f} a step in the recording
loops of high reward that rest on few samples: {len(self.loops)}
  a state on itself     {len(one)}, of these {lucky} on a single sample
  between several       {len(self.loops) - len(one)}"""


def diagnose(model: "SampleModel") -> Diagnosis:
    """Look for what was not seen and for loops that look too good.

    A pair is suspect if all its recorded outcomes lead to one state with a mean reward above the recording's
    mean, and there are at most three of them. Such a pair is a loop by itself if it leads back to its own
    state; several are one if they lead from each of their states to every other (a strongly connected
    component).
    """
    n_states, n_actions = model.n_states, model.n_actions
    pair_count = model.pair_count.ravel()
    seen = np.flatnonzero(pair_count)
    reward = model.sum_by_pair(model.r)
    mean_reward = reward.sum() / pair_count.sum()

    first = model.offsets[seen].astype(np.intp)
    lowest = np.minimum.reduceat(model.s_next, first)
    highest = np.maximum.reduceat(model.s_next, first)
    ends = np.add.reduceat(model.terminated, first) > 0
    suspect = (
        (lowest == highest) & ~ends & (reward[seen] / pair_count[seen] > mean_reward)
    )
    suspect &= pair_count[seen] <= 3
    s, target, pair = seen[suspect] // n_actions, lowest[suspect], seen[suspect]

    graph = sparse.csr_array((np.ones(len(s)), (s, target)), shape=(n_states, n_states))
    _, group = sparse.csgraph.connected_components(
        graph, directed=True, connection="strong"
    )
    is_inside = group[s] == group[target]
    # a pair that leads back to its own state is a loop by itself
    loop = np.where(s == target, np.arange(-len(s), 0), group[s])
    loops = []
    for number in np.unique(loop[is_inside]):
        members = pair[is_inside & (loop == number)]
        samples = int(pair_count[members].sum())
        states = tuple(np.unique(members // n_actions).tolist())
        its_pairs = tuple(divmod(p, n_actions) for p in members.tolist())
        loops.append(
            Loop(states, its_pairs, float(reward[members].sum() / samples), samples)
        )
    states_seen = len(np.union1d(seen // n_actions, model.s_next))
    coverage = (
        n_states,
        states_seen,
        pair_count.size,
        len(seen),
        int((pair_count == 1).sum()),
    )
    return Diagnosis(*coverage, float(mean_reward), tuple(loops))
