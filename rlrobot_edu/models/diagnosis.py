"""A diagnosis: what a sample model does not know, and where it may promise more than its recording shows."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


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
  between several       {len(self.loops) - len(one)}
not looked for: states that lump together what differs, see SampleModel.hold_back"""


class Suspects(NamedTuple):
    """Pairs (s, a) that look better than their few samples can tell, see `SampleModel.diagnose`.

    pair, s, s_next: arrays (n,), number of the pair, its state, and the only state that it was seen to lead to
    samples, reward: arrays (n,), how often it was seen, and the sum of its rewards
    """

    pair: NDArray[np.intp]
    s: NDArray[np.intp]
    s_next: NDArray[np.int64]
    samples: NDArray[np.int64]
    reward: NDArray[np.float64]


def find_loops(suspects: Suspects, n_states: int, n_actions: int) -> tuple[Loop, ...]:
    """The loops that suspect pairs make.

    A pair is a loop by itself if it leads back to its own state. Several are one if they lead from each of their
    states to every other (a strongly connected component).
    """
    from scipy import sparse  # here, because a browser may do without it

    pair, s, s_next, samples, reward = suspects
    graph = sparse.csr_array((np.ones(len(s)), (s, s_next)), shape=(n_states, n_states))
    _, group = sparse.csgraph.connected_components(
        graph, directed=True, connection="strong"
    )
    is_inside = group[s] == group[s_next]
    # a pair that leads back to its own state is a loop by itself
    loop = np.where(s == s_next, np.arange(-len(s), 0), group[s])
    loops = []
    for number in np.unique(loop[is_inside]):
        is_in_loop = is_inside & (loop == number)
        its_pairs = tuple(divmod(p, n_actions) for p in pair[is_in_loop].tolist())
        its_samples = int(samples[is_in_loop].sum())
        loops.append(
            Loop(
                states=tuple(np.unique(s[is_in_loop]).tolist()),
                pairs=its_pairs,
                reward=float(reward[is_in_loop].sum() / its_samples),
                samples=its_samples,
            )
        )
    return tuple(loops)
