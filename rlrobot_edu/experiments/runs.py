"""The repetitions of one method, to look at one by one or all together."""

from collections import UserList
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.learning.history import History


def padded(curves: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
    """Curves as rows of one array, as long as the longest; NaN where a shorter one has ended."""
    longest = max(map(len, curves), default=0)
    rows = []
    for curve in curves:
        missing = longest - len(curve)
        rows.append(np.pad(curve, (0, missing), constant_values=np.nan))
    return np.array(rows)


class Runs(UserList[History]):  # whose slices and sums are Runs, too
    """The histories of one method's repetitions, in order: a list with their curves and final rewards.

    Parameters
    ----------
    initlist : iterable of History, optional
        The histories; none makes an empty list.
    """

    def __repr__(self) -> str:
        if not self:
            return "<no repetitions>"
        return f"<{len(self)} repetitions of {self[0].method}>"

    @property
    def curves(self) -> NDArray[np.float64]:
        """The learning curve of each repetition, array (repetitions, steps): the average reward so far.

        In a task with episodes it is the average reward of the last episode alone. Where a repetition is shorter than
        the longest, its row ends in NaN.
        """
        curves = []
        for history in self:
            is_episodic = history.size.episode_steps is not None
            its_curve = history.last_episode if is_episodic else history.average_reward
            curves.append(its_curve)
        return padded(curves)

    @property
    def final(self) -> NDArray[np.float64]:
        """The final average reward of each repetition, array (repetitions,)."""
        return np.array([history.final_average_reward for history in self])
