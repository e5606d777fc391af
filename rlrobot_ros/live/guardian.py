"""A second process that stops the robot when the first one ends, in whatever way.

It has a connection of its own, and a pipe to the first process. The operating system closes a pipe when its writer is
gone, even if it was killed: then the guardian tells the robot to stop. It cannot help if the network or the whole
computer fails. In that case the robot's own watchdog has to stop it, see docs/real_robot.md.

    python -m rlrobot_ros.live.guardian    (the first process runs this, and writes to its standard input)
"""

import contextlib
import json
import signal
import subprocess
import sys
import time
from typing import Any

from rlrobot_ros.live.rosbridge import Rosbridge
from rlrobot_ros.live.velocity_publisher import VelocityPublisher

READY = "ready"
STOPS = 3  # more than one, because the last commands of the dead process may still be on their way
PAUSE = 0.1  # between two stops [s]


class Guardian:
    """The first process's end of it; the guardian waits until this is closed.

    address: of rosbridge; topic, stamped: as for `VelocityPublisher`

    Raises ConnectionError if the second process cannot reach the robot.
    """

    def __init__(self, address: str, topic: str, stamped: bool) -> None:
        # In a session of its own: ending the kernel with all its processes must not end this one.
        self._process: Any = subprocess.Popen(
            [sys.executable, "-m", __name__],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            encoding="utf-8",
            start_new_session=True,
        )
        with contextlib.suppress(BrokenPipeError):
            settings = json.dumps([address, topic, stamped])
            print(settings, file=self._process.stdin, flush=True)
        assert self._process.stdout is not None
        answer = self._process.stdout.readline().strip()
        if answer != READY:
            self.close()
            raise ConnectionError(
                f"no second connection that would stop the robot if this process died: {answer}"
            )

    def close(self) -> None:
        """Let it stop the robot and end."""
        with contextlib.suppress(OSError):
            self._process.stdin.close()
        try:
            self._process.wait(5.0)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._process.stdout.close()


def watch() -> None:
    """The second process: wait for the end of the first one, and stop the robot."""
    # Ctrl-C is for the first process, which stops the robot itself
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    address, topic, stamped = json.loads(sys.stdin.readline())
    try:
        connection = Rosbridge(address)
        velocity = VelocityPublisher(connection, topic, stamped)
    except (ValueError, OSError) as error:
        print(error)
        sys.exit(1)
    print(READY, flush=True)
    sys.stdin.read()
    with contextlib.suppress(ConnectionError):
        for _ in range(STOPS):
            velocity.publish(0.0, 0.0)
            time.sleep(PAUSE)
    connection.close()


if __name__ == "__main__":
    watch()
