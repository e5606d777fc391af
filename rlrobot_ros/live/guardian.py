"""A second process that stops the robot when the first one ends, in whatever way, or does not run any more.

It has a connection of its own, and a pipe to the first process. The operating system closes a pipe when its writer is
gone, even if it was killed: then the guardian tells the robot to stop. While the first process runs, it writes a line
ten times a second. If there is none for half a second, it was stopped or is busy with something that lets nothing else
go on, and cannot stop the robot itself: then the guardian does so, too. It cannot help if the network or the whole
computer fails. In that case the robot's own watchdog has to stop it, see docs/real_robot.md.

    python -m rlrobot_ros.live.guardian    (the first process runs this, and writes to its standard input)
"""

import contextlib
import json
import queue
import signal
import subprocess
import sys
import threading
import time
from typing import Any

from rlrobot_ros.live.rosbridge import Rosbridge
from rlrobot_ros.live.velocity_publisher import VelocityPublisher

READY = "ready"
END = ""  # of the first process; a sign of life is a line
STOPS = 3  # more than one, because the last commands of the dead process may still be on their way
PAUSE = 0.1  # between two stops [s]
BEAT = 0.1  # between two signs of life [s]
SILENCE = 0.5  # without a sign of life, after which the robot is stopped [s]


class Guardian:
    """The first process's end of it; the guardian waits until this is closed.

    address: of rosbridge; topic, stamped: as for `VelocityPublisher`

    Raises ConnectionError if the second process cannot reach the robot.
    """

    def __init__(self, address: str, topic: str, stamped: bool) -> None:
        self._ends = threading.Event()
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
        self._heart = threading.Thread(
            target=self._beat, name="sign of life", daemon=True
        )
        self._heart.start()

    def _beat(self) -> None:
        """Give a sign of life now and then, until the end."""
        while not self._ends.wait(BEAT):
            try:
                print(file=self._process.stdin, flush=True)
            except (OSError, ValueError):  # it has ended, or its pipe is closed
                return

    def close(self) -> None:
        """Let it stop the robot and end."""
        self._ends.set()
        with contextlib.suppress(OSError):
            self._process.stdin.close()
        try:
            self._process.wait(5.0)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._process.stdout.close()


def watch() -> None:
    """The second process: stop the robot whenever the first one is silent, until that ends."""
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
    signs: queue.SimpleQueue[str] = queue.SimpleQueue()
    threading.Thread(target=_listen, args=[signs], daemon=True).start()
    is_running = True
    while is_running:
        try:
            is_running = signs.get(timeout=SILENCE) != END
        except queue.Empty:
            _stop(velocity)
            is_running = signs.get() != END
    _stop(velocity)
    connection.close()


def _listen(signs: queue.SimpleQueue[str]) -> None:
    """Pass on the first process's signs of life, and its end."""
    for line in sys.stdin:
        signs.put(line)
    signs.put(END)


def _stop(velocity: VelocityPublisher) -> None:
    """Tell the robot to stop, if it can be reached."""
    with contextlib.suppress(ConnectionError):
        for _ in range(STOPS):
            velocity.publish(0.0, 0.0)
            time.sleep(PAUSE)


if __name__ == "__main__":
    watch()
