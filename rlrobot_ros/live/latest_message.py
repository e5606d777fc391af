"""The latest message of a topic, and its age by our own clock: the sender's may be wrong."""

import math
from typing import Generic, TypeVar

T = TypeVar("T")

DRIFT = 1e-3  # rate at which two clocks may run apart [s/s], far more than they do


class LatestMessage(Generic[T]):
    """The newest message of a topic. A message that comes twice, or after a newer one, is dropped.

    If the two clocks disagree, we cannot tell how old a message was when it came. But we can tell how much longer it
    took than the quickest ones, and this counts as its age. A message without a time ages from its arrival.

    value: its content, None before the first one; stamp: its time by the sender's clock [s], 0 if it has none
    received: how many messages came; dropped: how many of them were not new; in_a_row: how many since the newest
    """

    def __init__(self) -> None:
        self.value: T | None = None
        self.stamp = 0.0
        self.received = 0
        self.dropped = 0
        self.in_a_row = 0
        self._came = -math.inf
        self._quickest = math.inf  # least of (time here − stamp)

    def take(self, stamp: float, value: T, now: float) -> None:
        """Take in one more message, at the time `now` by our clock [s]."""
        self.received += 1
        if self.value is not None and 0 < stamp <= self.stamp:
            self.dropped += 1
            self.in_a_row += 1
            return
        self.in_a_row = 0
        if stamp < self.stamp:  # after `forget` the sender began anew, with its clock
            self._quickest = math.inf
        drift = DRIFT * max(now - self._came, 0.0)
        self._quickest = min(self._quickest + drift, now - stamp)
        self.value = value
        self.stamp = stamp
        self._came = now

    def age(self, now: float) -> float:
        """How old the newest message is [s]; infinity before the first one."""
        if self.value is None:
            return math.inf
        late = self._came - self.stamp - self._quickest if self.stamp else 0.0
        return now - self._came + late

    def forget(self) -> None:
        """Accept the next message as new, whatever its time is."""
        self.value = None
