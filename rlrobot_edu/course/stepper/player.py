"""The stepper goes forward by itself: at a speed, or as fast as it can to a step far ahead; it can be stopped."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
from typing import Any

from rlrobot_edu.course.stepper.controls import Controls
from rlrobot_edu.course.stepper.tape import Tape

FAR = 200  # steps; a longer way takes time, in which it can be stopped
AHEAD = 2  # steps; so far ahead of the page it may play
SLICE = 0.05  # seconds; so long it goes on before it listens to the reader again


class Player:
    """It does one thing at a time: it plays, it jumps to a step, or it stands still.

    show: function that shows the position of `tape`
    say: function that tells the reader a text, as a ``status`` or an ``alert``
    """

    def __init__(
        self, tape: Tape, controls: Controls, show: Callable[[], None], say: Callable[[str, str], None]
    ) -> None:
        self._tape, self._controls, self._show, self._say = tape, controls, show, say
        self._task: asyncio.Task[None] | None = None
        self._goal: int | None = None  # of a journey
        self._shown = 0  # steps that a page has told it has shown, since play began

    @property
    def runs(self) -> bool:
        """Whether it is going forward."""
        return self._task is not None and not self._task.done()

    def play(self) -> None:
        """Go forward at the speed of the controls. Raises RuntimeError without a running event loop."""
        if not self.runs:
            if not _loop_runs():
                raise RuntimeError(
                    "play() needs a running event loop, which a notebook has and a plain program has not: use forward()"
                )
            self._start(self._play)

    def must_travel(self, goal: int) -> bool:
        """Whether step `goal` is so far away that the reader would wait, and other code can run meanwhile."""
        return goal > self._tape.end + FAR and _loop_runs()

    def travel(self, goal: int) -> None:
        """Go forward to step `goal`, as fast as it can. Raises RuntimeError without a running event loop."""
        self._start(self._travel)
        self._goal = goal

    def stop(self) -> str:
        """Stop at once. Returns a message about a jump that was not finished."""
        if not self.runs:
            return ""
        self._task.cancel()
        self._task = None
        self._controls.say_playing(False)
        goal, self._goal = self._goal, None
        if goal is None:
            return ""
        self._show()
        return f"Stopped at step {self._tape.t}, on the way to step {goal}."

    def page_has_shown(self) -> None:
        """A page tells that it shows what it was sent."""
        self._shown += 1

    def _start(self, run: Callable[[], Coroutine[Any, Any, None]]) -> None:
        loop = asyncio.get_running_loop()
        self._task = loop.create_task(self._guard(run))
        self._controls.say_playing(True)

    async def _guard(self, run: Callable[[], Coroutine[Any, Any, None]]) -> None:
        """Run to the end; an error is told on the page."""
        said = ""
        try:
            await run()
        except Exception as error:
            said = str(error)
        self._task = self._goal = None
        self._controls.say_playing(False)
        self._show()
        self._say(said, "alert")

    async def _play(self) -> None:
        """Play without running ahead of the page by more than AHEAD steps, or else a pause would seem to come late."""
        loop = asyncio.get_running_loop()
        sent = self._shown = 0
        while True:
            due = loop.time() + 1 / self._controls.speed.value
            self._tape.forward()
            self._show()
            sent += 1
            await asyncio.sleep(max(due - loop.time(), 0.001))
            while 0 < self._shown < sent - AHEAD and loop.time() < due + 1:  # a page that was closed tells nothing
                await asyncio.sleep(0.005)

    async def _travel(self) -> None:
        """Take slices of time, and say four times a second how far it is."""
        loop, tape = asyncio.get_running_loop(), self._tape
        told = loop.time()
        while self._goal is not None and tape.t < self._goal:
            until = loop.time() + SLICE
            while tape.t < self._goal and loop.time() < until:
                tape.forward()
            if loop.time() > told + 0.25:
                told = loop.time()
                self._say(f"At step {tape.t}, on the way to step {self._goal}. Pause stops it.", "status")
            await asyncio.sleep(0.001)


def _loop_runs() -> bool:
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return False
    return True
