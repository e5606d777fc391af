"""What stands between a submission and the computer that grades: another user, a container, or nothing but a warning.

The judging process stays outside in each case, and nothing but values comes out to it.
"""

from __future__ import annotations

import hashlib
import itertools
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from rlrobot_grading.marking.course import Course
from rlrobot_grading.marking.left_behind import removed_in_the_end

NOT_IN_CONTAINERS = ("PATH", "PYTHONPATH", "VIRTUAL_ENV", "TMPDIR")
NOBODY = 65534  # the user in a container, if root grades
OTHER_USER = ("setpriv", "prlimit")  # programs of util-linux
PROCESSES = 512  # of a user who runs a notebook, threads counted
LOCKS = Path(
    "/run/rlrobot-grading"
)  # root's: in it, each job locks the number of its user
OPEN = (
    "Without --container or --user a submission runs with your rights: it can read, change and delete your files, the "
    "other notebooks and this grader, and use the network."
)
CHOOSE = (
    "Choose a guard, --container IMAGE (needs podman or docker) or --user 61000 (needs root on Linux); or say --trust "
    "if you trust all who wrote these notebooks."
)


@dataclass(frozen=True)
class Guard:
    """Another user, by name or number, whom the notebooks' kernels run as; or the image of a container for each.

    trust: whether the notebooks may run without a guard
    """

    user: str = ""
    container: str = ""
    trust: bool = False

    def __bool__(self) -> bool:
        return bool(self.user or self.container)

    @property
    def uid(self) -> int:
        """The number of the user who runs the notebooks. Raises ValueError if there is none of this name."""
        if self.container:
            return os.getuid() or NOBODY
        if self.user.isdecimal():
            return int(self.user)
        import pwd

        try:
            return pwd.getpwnam(self.user).pw_uid
        except KeyError:
            raise ValueError(
                f"--user {self.user}: there is no such user; a number will do, too, as 61000"
            ) from None

    @contextmanager
    def of_one_job(self) -> Iterator[Guard]:
        """This guard with a user whom no other job has at the same time: its own, or the next number of nobody.

        What this user has left where everybody may leave something is removed in the end.
        """
        if not self.user:
            yield self
            return
        import fcntl

        LOCKS.mkdir(mode=0o700, exist_ok=True)
        for uid in itertools.count(self.uid):
            with Path(LOCKS, str(uid)).open("w") as lock:
                try:
                    fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                except BlockingIOError:
                    continue
                if uid != self.uid and _is_somebody(uid):
                    continue
                guard = replace(self, user=str(uid))
                guard._end_processes()  # of a grading that was killed
                with removed_in_the_end(uid):
                    yield guard
                return

    @property
    def protects(self) -> str:
        """What protects this computer from the notebooks, in a sentence."""
        if self.container:
            return f"Each notebook runs in a container of its own ({self.container}), without a network."
        if self.user:
            return f"The notebooks run as user {self.user} and the next numbers; they can use the network."
        return OPEN

    def check(self, course: Course, notebooks: Sequence[Path]) -> None:
        """Raise ValueError if there is no guard and no trust.

        Also if this guard cannot be set up, or would let a submission read the notebooks of others.
        """
        if not self and not self.trust:
            raise ValueError(f"{OPEN} {CHOOSE}")
        if self.user and self.container:
            raise ValueError("--user and --container: choose one of them")
        if self.user:
            self._check_user(course, notebooks)
        if self.container:
            self._check_container(course)

    def _check_user(self, course: Course, notebooks: Sequence[Path]) -> None:
        programs = [shutil.which(name) for name in OTHER_USER]
        if sys.platform != "linux" or os.getuid() != 0 or None in programs:
            raise ValueError(
                f"--user needs Linux, root, {' and '.join(OTHER_USER)}; --container does not"
            )
        if self.uid == 0:
            raise ValueError("--user must be another user than root")
        # another grading ends all processes of the number that it uses
        with self.of_one_job() as guard:
            guard._check_rights(course, notebooks)

    def _check_rights(self, course: Course, notebooks: Sequence[Path]) -> None:
        imports = f"import {course.package}, ipykernel"
        self._output(
            [sys.executable, "-c", imports], f"--user {self.user}: no Python for it"
        )
        readable = [
            "sh",
            "-c",
            'for file; do if test -r "$file"; then echo "$file"; fi; done',
            "sh",
        ]
        paths = [str(path.resolve()) for path in notebooks]
        seen = self._output([*readable, *paths], f"--user {self.user}").splitlines()
        if seen:
            raise ValueError(
                f"--user {self.user} could read {seen[0]}: chmod -R o-rwx {Path(seen[0]).parent}"
            )

    def _check_container(self, course: Course) -> None:
        version = (
            f"import sys, {course.package}, ipykernel; print(*sys.version_info[:2])"
        )
        command = [
            self.engine,
            "run",
            "--rm",
            "--network=none",
            self.container,
            "python",
            "-c",
            version,
        ]
        said = self._output(command, f"--container {self.container} cannot be run")
        if said.split()[-2:] != [str(number) for number in sys.version_info[:2]]:
            raise ValueError(
                f"--container {self.container} must have the Python of the grader, {sys.version[:4]}"
            )

    def _output(self, command: Sequence[str], fault: str) -> str:
        """What a command prints, as the other user if there is one. Raises ValueError if it fails."""
        done = subprocess.run(
            [*self._other_user(), *command], capture_output=True, text=True, cwd="/"
        )
        if done.returncode:
            why = (done.stderr.strip() or f"exit code {done.returncode}").splitlines()
            raise ValueError(f"{fault}: {why[0]}")
        return done.stdout

    @property
    def engine(self) -> str:
        """The program that runs containers: podman or docker. Raises ValueError if there is none."""
        found = [name for name in ("podman", "docker") if shutil.which(name)]
        if not found:
            raise ValueError(
                "--container needs podman or docker, and neither is installed"
            )
        return found[0]

    def _other_user(self) -> list[str]:
        if not self.user:
            return []
        return ["prlimit", f"--nproc={PROCESSES}", *self._without_limit()]

    def _without_limit(self) -> list[str]:
        rights = [
            "--clear-groups",
            "--no-new-privs",
            "--inh-caps=-all",
            "--bounding-set=-all",
        ]
        return [
            "setpriv",
            f"--reuid={self.uid}",
            f"--regid={self.uid}",
            *rights,
            "--",
        ]

    def command(
        self,
        argv: Sequence[str],
        folder: Path,
        home: Path,
        memory: int,
        environment: dict[str, str],
    ) -> list[str]:
        """The command that runs a kernel behind this guard.

        folder: of the notebook, which is all that a container has of it, read-only; home: of settings and sockets
        """
        if not self.container:
            return [*self._other_user(), *argv]
        own = {
            name: environment[name]
            for name in environment
            if name not in NOT_IN_CONTAINERS
        }
        notebooks = [f"--volume={path}:{path}:ro" for path in sorted(folder.iterdir())]
        return [
            self.engine, "run", "--rm", f"--name={home.parent.name}", "--network=none", "--read-only", "--cap-drop=ALL",
            "--security-opt=no-new-privileges", "--pids-limit=256", f"--memory={memory + 1024}m", "--shm-size=64m",
            f"--user={self.uid}:{self.uid}", "--tmpfs=/tmp:size=512m", f"--tmpfs={folder}:size=512m,mode=1777",
            # without root, podman would have the notebook's user be another one outside
            *(["--userns=keep-id"] if self.engine == "podman" and os.getuid() else []),
            *notebooks, f"--volume={home}:{home}", f"--workdir={folder}",
            *(f"--env={name}={value}" for name, value in own.items()), self.container, "python", *argv[1:],
        ]  # fmt: skip

    def hand_over(self, *paths: Path) -> None:
        """Make files and folders those of the user who runs the notebooks."""
        if self and os.getuid() == 0:
            for path in paths:
                os.chown(path, self.uid, self.uid)

    def end(self, home: Path) -> None:
        """End what `command` has started, where killing that command does not."""
        if self.container:
            subprocess.run(
                [self.engine, "rm", "--force", home.parent.name], capture_output=True
            )
        self._end_processes()

    def _end_processes(self) -> None:
        """End all processes of the other user, unless it is an account, which may have processes of its own.

        All at once: one that starts another and ends is gone whenever one looks for it. The user may have as many as
        are allowed, so the one that ends them is not limited.
        """
        if self.user and not _is_somebody(self.uid):
            end_all = ["sh", "-c", "kill -KILL -1"]
            subprocess.run([*self._without_limit(), *end_all], capture_output=True)


NO_GUARD = Guard()


def _is_somebody(uid: int) -> bool:
    import pwd

    try:
        return bool(pwd.getpwuid(uid))
    except KeyError:
        return False


class Digests:
    """Of the grader's own files and of the course's, taken when this is made."""

    def __init__(self, course: Course) -> None:
        self._folders = (Path(__file__).parents[1], course.path)
        self._taken = self._digests()

    def check(self, notebook: str) -> None:
        """Raise ValueError if they have changed since; `notebook`: the one that has just been graded."""
        now = self._digests()
        changed = []
        for path in self._taken.keys() | now.keys():
            if self._taken.get(path) != now.get(path):
                changed.append(str(path))
        if changed:
            raise ValueError(
                f"{min(changed)} has changed by the time {notebook} was graded: trust no points, install rlrobot-edu "
                "anew, look into that notebook and the next ones, and grade with --user or --container"
            )

    def _digests(self) -> dict[Path, str]:
        """SHA-256 of each file."""
        digests = {}
        for folder in self._folders:
            for kind in ("py", "md", "toml"):
                for path in folder.resolve().rglob(f"*.{kind}"):
                    digests[path] = hashlib.sha256(path.read_bytes()).hexdigest()
        return digests
