"""The commands ``serve-robot`` and ``score``."""

from pathlib import Path
from typing import Any

from rlrobot_course.unknown_robot.body import SecretBody
from rlrobot_course.unknown_robot.scoring import HOUR, save_log, score
from rlrobot_course.unknown_robot.secret import Secret, unlock
from rlrobot_edu.__main__ import serve_robot
from rlrobot_ros.live.served_body import TICK

LOG = Path("drive.npz")
MINUTE = round(60 / TICK)  # [ticks]


class _Logging(SecretBody):
    """A secret body that keeps its log in a file, minute by minute, until its hour is over."""

    def __init__(self, task: str, secret: Secret) -> None:
        super().__init__(task, secret)
        self._secret = secret

    def move(self, v: float, omega: float) -> None:
        """Drive for a tick."""
        super().move(v, omega)
        ticks, hour = len(self.log), round(HOUR / TICK)
        if ticks <= hour and ticks % MINUTE == 0:
            save_log(LOG, self, self._secret)
        if ticks == hour:
            print(f"Its hour is over: {LOG} is complete.", flush=True)


def serve(task: str, secret: str, **arguments: Any) -> None:
    """Serve a task's robot until Ctrl-C, with the weaknesses of a secret if there is one.

    Raises ValueError for a task or secret that cannot be, OSError if the log of an earlier drive is still here.
    """
    if secret and LOG.exists():
        raise FileExistsError(
            f"{LOG}: here is the log of an earlier drive; keep it under another name, or remove it"
        )
    serve_robot(_Logging(task, unlock(secret)) if secret else task, **arguments)


def tell_score(log: str, secret: str) -> None:
    """Print what a drive is worth."""
    result = score(log, unlock(secret))
    print(f"mean reward a step in the second half hour: {result.earned:.2f}")
    print(
        f"random actions {result.random:.2f}, the best that we found {result.found:.2f}"
    )
    print(
        f"score: {result.points:.0f}  (0 is chance, 100 the best found; it is not clipped)"
    )
