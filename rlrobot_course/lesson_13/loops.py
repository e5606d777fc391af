"""The loop that pays most: what a reward can be milked for."""

from typing import NamedTuple

import numpy as np


class Loop(NamedTuple):
    """A closed path: the mean of its rewards, the rewards one by one, and the numbers of the places it leads through.

    Step i leads from places[i] to places[i + 1]; the last one leads back to places[0].
    """

    pays: float
    rewards: list[float]
    places: list[int]


def best_loop(following: np.ndarray, rewards: np.ndarray, allowed: np.ndarray) -> Loop:
    """The closed path through allowed places with the largest mean reward.

    following, rewards: arrays (places, actions), where an action leads and what that pays; allowed: array (places,)
    Source: Karp (1978), A characterization of the minimum cycle mean in a digraph.
    """
    inside = np.flatnonzero(allowed)
    n, number = len(inside), np.full(len(allowed), -1)
    number[inside] = np.arange(n)
    start, action = np.nonzero(allowed[following] & allowed[:, None])
    source, target, pay = (
        number[start],
        number[following[start, action]],
        rewards[start, action],
    )
    most = np.full((n + 1, n), -np.inf)  # of a path of k steps that ends here
    most[0], last = 0.0, np.zeros((n + 1, n), dtype=int)
    for k in range(1, n + 1):
        for i, j, value in zip(source, target, most[k - 1, source] + pay, strict=True):
            if value > most[k, j]:
                most[k, j], last[k, j] = value, i
    ends = np.isfinite(most[n])  # where no path of n steps ends, no loop is looked for
    mean = np.where(
        ends,
        ((np.where(ends, most[n], 0.0) - most[:n]) / (n - np.arange(n))[:, None]).min(
            axis=0
        ),
        -np.inf,
    )
    path = [
        int(mean.argmax())
    ]  # backward: a path of n steps through n places passes one of them twice
    for k in range(n, 0, -1):
        path.append(int(last[k, path[-1]]))
    return max(
        _cycles(path[::-1], inside, following, rewards), key=lambda loop: loop.pays
    )


def _cycles(
    path: list[int], inside: np.ndarray, following: np.ndarray, rewards: np.ndarray
) -> list[Loop]:
    """The closed paths that a path consists of: each is cut out as soon as it closes."""
    found, way = [], []
    for place in (int(inside[i]) for i in path):
        if place in way:
            cycle = way[way.index(place) :]
            del way[way.index(place) :]
            steps = zip(cycle, cycle[1:] + cycle[:1], strict=True)
            paid = [float(rewards[i, following[i] == j].max()) for i, j in steps]
            found.append(Loop(float(np.mean(paid)), paid, cycle))
        way.append(place)
    return found
