"""What a check hands to a learner's loop to be called: choices without chance, and updates that note what they get."""

import inspect
from abc import abstractmethod
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from rlrobot_course.worlds.tapes import TapeWorld
from rlrobot_grading.answers.values import same, show


def taken(
    name: str,
    function: Callable[..., Any],
    arguments: Sequence[Any],
    by_name: Mapping[str, Any],
) -> list[Any]:
    """The arguments with which a learner's loop calls `name`, by place or by name, in the order of `function`'s.

    Raises TypeError, which names them, where they are more or fewer, or others.
    """
    signature = inspect.signature(function)
    try:
        return list(signature.bind(*arguments, **by_name).args)
    except TypeError:
        raise TypeError(
            f"{name} takes ({', '.join(signature.parameters)}), in this order"
        ) from None


def in_order(
    name: str,
    function: Callable[..., Any],
    arguments: Sequence[Any],
    by_name: Mapping[str, Any],
) -> list[Any]:
    """What `taken` returns: the table q and then numbers. Raises TypeError where the table stands elsewhere."""
    q, *numbers = given = taken(name, function, arguments, by_name)
    if (q is not None and np.ndim(q) != 2) or any(map(np.ndim, numbers)):
        raise TypeError(
            f"{name} takes ({', '.join(inspect.signature(function).parameters)}), in this order"
        )
    return given


class Choice:
    """choose(q, s) without chance."""

    @property
    def __signature__(self) -> inspect.Signature:
        """The names of its arguments, as Python tells them."""
        return inspect.signature(self._action)

    def __call__(self, *arguments: Any, **by_name: Any) -> int:
        """An action. Raises TypeError for other arguments than (q, s)."""
        return self._action(*in_order("choose", self._action, arguments, by_name))

    @abstractmethod
    def _action(self, q: np.ndarray, s: int) -> int:
        """The action that is chosen."""


class Ranked(Choice):
    """Chooses the best action, or that of another rank, 0 for the worst."""

    def __init__(self, rank: int) -> None:
        self.rank = rank

    def _action(self, q: np.ndarray, s: int) -> int:
        return int(q[s].argsort(kind="stable")[self.rank])


class Chooser(Ranked):
    """Chooses without chance, by the state and by where the table is largest and smallest; its scale has no effect."""

    def _action(self, q: np.ndarray, s: int) -> int:
        return int(
            q[s].argsort(kind="stable")[
                (self.rank + int(q.argmax() + q.argmin())) % q.shape[1]
            ]
        )


class Wavering(Ranked):
    """A choice that the smallest change of the table changes: it reveals a loop that chooses before the update."""

    def _action(self, q: np.ndarray, s: int) -> int:
        return (super()._action(q, s) + int(1000 * q.sum())) % 3


def weighed(q: np.ndarray) -> int:
    """A whole number that the smallest change of any entry of the table changes, but not its scale."""
    places = np.arange(1, q.size + 1)
    mean = (q.ravel() @ places) / max(np.abs(q).sum(), 1e-9)
    return int(1e6 * mean) if np.isfinite(mean) else 0


class Weighing(Ranked):
    """A choice that the smallest change of any entry of the table changes, but not its scale."""

    def _action(self, q: np.ndarray, s: int) -> int:
        return (super()._action(q, s) + weighed(q)) % q.shape[1]


class Fickle(Choice):
    """Asked twice at the same moment it answers differently, so that asking again shows.

    world: the TapeWorld whose clock it reads
    """

    def __init__(self, world: TapeWorld) -> None:
        self.world, self.asked = world, 0
        self.moment: tuple[int, int] | None = None

    def __repr__(self) -> str:
        return "choose"

    def __eq__(self, other: object) -> bool:
        return isinstance(
            other, Fickle
        )  # how often it was asked is judged by what follows from it

    def _action(self, q: np.ndarray, s: int) -> int:
        """The best, second or third best action in `s`, as the time and the number of times asked will have it."""
        moment = (self.world.episode, self.world.t)
        self.asked = self.asked + 1 if moment == self.moment else 0
        self.moment = moment
        turn = sum(moment) + self.asked + weighed(q)
        return int(np.argsort(-q[s])[turn % 3])


class Update:
    """What a loop calls to learn from a step; it notes what it is given, for that counts, not only what comes of it.

    given: the arguments of each call but the table
    """

    def __init__(self) -> None:
        self.given: list[list[Any]] = []

    @property
    def __signature__(self) -> inspect.Signature:
        """The names of its arguments, as Python tells them."""
        return inspect.signature(self.learn_from)

    def __repr__(self) -> str:
        calls = [f"({', '.join(map(show, one))})" for one in self.given]
        return f"called with {', '.join(calls)}" if calls else "never called"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Update) and same(self.given, other.given)

    def __call__(self, *arguments: Any, **by_name: Any) -> None:
        """Learn from a step. Raises TypeError for other arguments than those of `learn_from`."""
        q, *numbers = in_order("update", self.learn_from, arguments, by_name)
        self.given.append(numbers)
        self.learn_from(q, *numbers)

    learn_from: Callable[..., None]


class QLearner(Update):
    """update(q, s, a, r, s_next, terminated) of Q-learning."""

    def __init__(self, alpha: float, gamma: float) -> None:
        super().__init__()
        self.alpha, self.gamma = alpha, gamma

    def learn_from(
        self,
        q: np.ndarray,
        s: int,
        a: int,
        r: float,
        s_next: int,
        terminated: bool,
    ) -> None:
        """Change the table by what a step says."""
        best = 0.0 if terminated else self.gamma * q[s_next].max()
        q[s, a] += self.alpha * (r + best - q[s, a])


class SarsaLearner(Update):
    """update(q, s, a, r, s_next, a_next, terminated) of SARSA, with α = 0.5 and γ = 0.9."""

    def __eq__(self, other: object) -> bool:
        """As of any update; but where a step has terminated, a_next means nothing."""
        if not isinstance(other, SarsaLearner):
            return False
        return same(self._that_counts(), other._that_counts())

    def _that_counts(self) -> list[list[Any]]:
        return [
            [*step[:4], None if terminated else a_next, bool(terminated)]
            for *step, a_next, terminated in self.given
        ]

    def learn_from(
        self,
        q: np.ndarray,
        s: int,
        a: int,
        r: float,
        s_next: int,
        a_next: int | None,
        terminated: bool,
    ) -> None:
        """Change the table by what a step says. Raises ValueError if a_next is missing where the world goes on."""
        if a_next is None and not terminated:
            raise ValueError(
                "update needs a_next, for the world goes on: only terminated ends it for good"
            )
        follows = 0.0 if terminated else 0.9 * q[s_next, a_next]
        q[s, a] += 0.5 * (r + follows - q[s, a])
