"""A robot that hears its command anew in every tenth of a second, as one behind a link does, but driven directly."""

from rlrobot_edu.robots.giraff import Giraff


class Ticking:
    """A Giraff in its hexagon, as make_env takes it for a link."""

    def __init__(self) -> None:
        self._giraff = Giraff("hexagon_giraff", 0.1)
        self.reset, self.scene, self.close = (
            self._giraff.reset,
            self._giraff.scene,
            self._giraff.close,
        )

    def prepare(self, task):
        self._ticks = round(task.step_time / 0.1)

    @property
    def readings(self):
        return self._giraff.readings

    def act(self, command):
        for _ in range(self._ticks):
            self._giraff.act(command)
        return self.readings
