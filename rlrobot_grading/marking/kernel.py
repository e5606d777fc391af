"""A fresh kernel for one submission: started, asked with a time limit, and ended with all that it has started."""

from __future__ import annotations

import ast
import ctypes
import glob
import os
import queue
import shutil
import signal
import sys
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from subprocess import DEVNULL
from typing import Any

from rlrobot_grading.answers.values import one_line
from rlrobot_grading.marking.course import Course
from rlrobot_grading.marking.guard import NO_GUARD, Guard
from rlrobot_grading.marking.left_behind import end_all_but, processes

START = 120.0  # until a kernel is ready, on a machine with much to do [s]
STARTS = 3  # of a kernel that does not become ready
# after which a kernel that was asked to end, as by a restart, is gone [s]
SETTLED = 0.5
GRACE = 5.0  # in which a cell that is interrupted has to end [s]
LOOK = 0.2  # between two looks at whether the kernel still lives [s]
TIME_OUT = (
    "TimeoutError"  # the name of the exception of a cell that had to be interrupted
)
END_WITH_PARENT = 1  # PR_SET_PDEATHSIG of Linux
KERNEL_SIDE = "__import__('rlrobot_grading.marking.kernel_side', fromlist=['x'])"
# What a submission sees of the environment; passwords and tokens of whoever grades are not among it.
PASSED_ON = (
    "LANG",
    "LC_ALL",
    "LD_LIBRARY_PATH",
    "VIRTUAL_ENV",
    "SYSTEMROOT",
    "NUMBA_CACHE_DIR",
)


INSTALLERS = (
    "conda",
    "mamba",
    "micromamba",
    "uv",
    "apt",
    "apt-get",
    "sudo",
    "brew",
)  # they do nothing here
NOTHING = "#!/bin/sh\necho While a notebook is graded, nothing is installed.\n"


class EndedError(Exception):
    """The kernel is gone, or does not come back; the text says why, as what follows “the cell …”."""


class GoneError(EndedError):
    """The kernel is gone. That may have begun a cell earlier: some ends come a moment after a cell has answered."""


class NotStartedError(Exception):
    """No kernel has become ready. No cell has run by then, so it is not for what the notebook does."""


class Kernel:
    """A context manager. Entering it raises NotStartedError if no kernel becomes ready.

    folder: where the notebook runs, empty but for it; home: of its settings
    course, lesson, exercises: whose notebook it is, the lesson's number, and the names of its exercises
    memory: limit [MiB]; guard: what it runs behind
    """

    def __init__(
        self,
        folder: Path,
        home: Path,
        course: Course,
        lesson: str,
        exercises: Sequence[str],
        memory: int,
        guard: Guard = NO_GUARD,
    ) -> None:
        try:
            import jupyter_client  # noqa: F401
        except ImportError:
            raise ImportError(
                "grading needs Jupyter: run pip install ipykernel jupyter_client psutil"
            ) from None
        self._memory = memory
        self._file = home / "kernel.json"
        command = "from rlrobot_grading.marking.kernel_side import start; start()"
        self._argv = [
            sys.executable,
            "-c",
            command,
            course.to_json(),
            lesson,
            ",".join(exercises),
            str(memory),
            "{connection_file}",
        ]
        self._folder = folder
        self._environment = _environment(home)
        self._guard = guard
        self._home = home
        self._before: list[Any] = []

    def __enter__(self) -> Kernel:
        for _ in range(STARTS):
            try:
                self._start()
                return self
            except GoneError:  # another program may have taken a port that was free
                fault = "it ended before it could be asked anything"
            except TimeoutError:
                fault = f"it did not answer within {START:.0f} seconds"
            except OSError as error:
                fault = str(error)
        raise NotStartedError(
            f"No kernel started for this notebook in {STARTS} tries: {fault}. No cell had run, so this is not the "
            "notebook's fault: see whether this computer has processes, memory and space on its disk left, and whether "
            f"--memory {self._memory} is enough, and grade it again."
        )

    def _start(self) -> None:
        from jupyter_client.kernelspec import KernelSpec
        from jupyter_client.manager import KernelManager

        self._file.unlink(missing_ok=True)
        self._before = processes()
        # behind a guard they talk by sockets that are files, since there may be no network
        by_files = (
            {"transport": "ipc", "ip": str(self._home / "k")} if self._guard else {}
        )
        self._manager: Any = KernelManager(connection_file=str(self._file), **by_files)
        argv = self._guard.command(
            self._argv, self._folder, self._home, self._memory, self._environment
        )
        self._manager._kernel_spec = KernelSpec(
            argv=argv
        )  # not one of those that are installed
        if self._guard:
            self._manager.write_connection_file()
            self._guard.hand_over(
                self._folder.parent, self._folder, *self._folder.iterdir(), self._home
            )
            self._guard.hand_over(*self._home.rglob("*"))
        self._manager.start_kernel(
            cwd=str(self._folder), env=self._environment, stdout=DEVNULL, stderr=DEVNULL
        )
        self._client = self._manager.client()
        self._client.start_channels(
            shell=True, iopub=False, stdin=False, hb=False, control=False
        )
        try:
            self._answer(self._client.kernel_info(), START)
        except BaseException:
            self.__exit__()
            raise

    def __exit__(self, *_: object) -> None:
        self._client.stop_channels()
        self._manager.shutdown_kernel(now=True)
        self._guard.end(self._home)
        end_all_but(self._before)

    def run(self, source: str, seconds: float) -> tuple[str, str]:
        """Run a cell; returns name and text of the exception that it ends with, or two empty ones.

        Raises EndedError if it ends the kernel, or if it has to be ended.
        """
        reply = self._asked(source, {}, seconds)
        return str(reply.get("ename", "")), str(reply.get("evalue", ""))

    def ask(self, call: str, seconds: float) -> str:
        """Return the text that a function of `kernel_side` returns.

        Raises EndedError as `run` does; TimeoutError if it takes longer, and then the kernel can be asked again.
        """
        reply = self._asked("", {"result": f"{KERNEL_SIDE}.{call}"}, seconds)
        if reply.get("ename") == TIME_OUT:
            raise TimeoutError(f"has not ended after {seconds:.0f} seconds")
        result = reply.get("user_expressions", {}).get("result", {})
        try:
            return str(ast.literal_eval(result["data"]["text/plain"]))
        except (
            KeyError,
            ValueError,
            SyntaxError,
            TypeError,
            RecursionError,
            MemoryError,
        ):
            said = f"{result.get('ename', '')}: {result.get('evalue', '')}"
            raise EndedError(
                f"leaves the kernel in a state in which it can tell nothing ({said:.200})"
            ) from None

    def settle(self) -> None:
        """Wait a moment. Raises GoneError if the kernel ends meanwhile."""
        time.sleep(SETTLED)
        self._look()

    def _look(self) -> None:
        if not self._manager.is_alive():
            raise GoneError(
                f"ends the whole kernel: os._exit, a crash, or more memory than the {self._memory} MiB allowed"
            )

    def _asked(
        self, source: str, expressions: dict[str, str], seconds: float
    ) -> dict[str, Any]:
        request = self._client.execute(
            source,
            store_history=False,
            allow_stdin=False,
            stop_on_error=False,
            user_expressions=expressions,
        )
        try:
            return self._answer(request, seconds)
        except TimeoutError:
            self._manager.interrupt_kernel()
        try:
            reply = self._answer(request, GRACE)
        except TimeoutError:
            raise EndedError(
                f"has not ended after {seconds:.0f} seconds and cannot be interrupted"
            ) from None
        return reply | {
            "ename": TIME_OUT,
            "evalue": f"it has not ended after {seconds:.0f} seconds",
        }

    def _answer(self, request: str, seconds: float) -> dict[str, Any]:
        """The content of the reply to a request. Raises TimeoutError; GoneError if the kernel is gone."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            with suppress(queue.Empty):
                message = self._client.get_shell_msg(
                    timeout=min(LOOK, max(0.01, end - time.monotonic()))
                )
                if message["parent_header"].get("msg_id") == request:
                    return dict(message["content"])
                continue
            self._look()
        raise TimeoutError(f"has not answered for {seconds:.0f} seconds")


def ended(kind: str, text: str, memory: int) -> str:
    """How a cell ends that does not end well."""
    if "MemoryError" in kind:
        return f"wants more memory than the {memory} MiB that a submission may use."
    if kind == "SystemExit":
        return "calls exit(): what stands below that in the cell does not run."
    if kind == TIME_OUT:
        return f"is endless: {text}."
    return f"stops with {one_line(f'{kind}: {text}')}"


def _environment(home: Path) -> dict[str, str]:
    """The environment of a kernel, with a home of its own, in which matplotlib need not look for fonts again.

    Notebooks for Colab begin with ``%pip install …``, which would change what grades them; so nothing is installed.
    """
    import matplotlib

    settings = home / "matplotlib"
    temporary = home / "tmp"
    programs = home / "programs"
    for folder in (settings, temporary, programs):
        folder.mkdir(parents=True, exist_ok=True)
    for fonts in glob.glob(f"{glob.escape(matplotlib.get_cachedir())}/fontlist-*.json"):
        shutil.copy(fonts, settings)
    for name in INSTALLERS:
        (programs / name).write_text(NOTHING, encoding="utf-8")
        (programs / name).chmod(0o755)
    paths = [
        str(Path(__file__).parents[2]),
        *filter(None, [os.environ.get("PYTHONPATH")]),
    ]
    return {name: os.environ[name] for name in PASSED_ON if name in os.environ} | {
        "HOME": str(home), "USERPROFILE": str(home), "TMPDIR": str(temporary), "IPYTHONDIR": str(home / "ipython"),
        "MPLCONFIGDIR": str(settings), "MPLBACKEND": "agg",
        "PYTHONPATH": os.pathsep.join(paths), "PIP_NO_INDEX": "1",
        "PATH": os.pathsep.join([str(programs), os.environ.get("PATH", "")]),
        "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1",
    }  # fmt: skip


def end_with_parent() -> None:
    """Have this process end when the one that started it is killed; on Linux."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(END_WITH_PARENT, signal.SIGKILL)
