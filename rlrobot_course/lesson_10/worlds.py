"""The world in which lesson 10 tries a learner: its episodes end in both ways."""

import numpy as np

from rlrobot_course.worlds.tapes import with_action


class Ring:
    """States in a ring, without chance: action 0 stays, 1 goes on, 2 goes back, 3 goes on by two.

    n_states: how many; ends: number of steps of each episode in turn, and whether it terminates there (or is truncated)
    sticky: only one step in so many leads anywhere
    r_max: reward for arriving in a state that can be divided by 5; otherwise −2 for action 0, −0.5 for any other
    pays: instead of that, the rewards of the steps of an episode, again and again, whatever the steps do
    reset() -> state; step(action) -> state, reward, terminated, truncated
    """

    def __init__(
        self,
        n_states: int,
        ends: tuple[tuple[int, bool], ...],
        sticky: int = 1,
        r_max: float = 6.0,
        pays: tuple[float, ...] = (),
    ) -> None:
        self.n_states, self.ends, self.sticky = n_states, ends, sticky
        self.r_max, self.pays = r_max, pays
        self.episode, self.t, self.s = -1, 0, 0

    def __repr__(self) -> str:
        return f"a ring of {self.n_states} states, episode {self.episode + 1}, step {self.t}"

    def reset(self) -> int:
        """Start an episode; returns its first state."""
        self.episode, self.t = self.episode + 1, 0
        self.s = 7 * self.episode % self.n_states
        return self.s

    @with_action
    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Do action `a`: returns next state, reward, terminated, truncated."""
        if a not in range(4):
            raise ValueError(f"env.step takes an action, and {a} is none.")
        self.t += 1
        moves = a > 0 and self.t % self.sticky == 0
        self.s = (self.s + (0, 1, -1, 2)[a] * moves) % self.n_states
        steps, terminates = self.ends[self.episode % len(self.ends)]
        ended = self.t >= steps
        return (
            self.s,
            self._reward(a, moves),
            ended and terminates,
            ended and not terminates,
        )

    def _reward(self, a: int, moves: bool) -> float:
        if self.pays:
            return self.pays[(self.t - 1) % len(self.pays)]
        if a == 0:
            return -2.0
        return self.r_max if moves and self.s % 5 == 0 else -0.5


class Dice:
    """Random numbers that depend on the moment in a world alone, not on how many were drawn before.

    So it does not matter whether a' is drawn where an episode has terminated, where it plays no part.
    """

    def __init__(self, world: Ring) -> None:
        self.world = world

    def moment(self) -> tuple[int, int]:
        """The number of the episode, and of the step in it."""
        return max(self.world.episode, 0), self.world.t

    def random(self) -> float:
        """A number in [0, 1)."""
        return float(np.random.default_rng(self.moment()).random())


class SharpDice(Dice):
    """Dice that show numbers chosen beforehand.

    numbers: by the moment, numbers so near to a border between two actions that whoever chooses by a slightly different
    temperature, or value, takes the other action. At other moments they are as those of `Dice`
    """

    def __init__(self, world: Ring, numbers: dict[tuple[int, int], float]) -> None:
        super().__init__(world)
        self.numbers = numbers

    def random(self) -> float:
        """A number in [0, 1)."""
        known = self.numbers.get(self.moment())
        return super().random() if known is None else known
