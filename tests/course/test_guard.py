"""Submissions that mean harm: what they can do without a guard, and that with one they cannot, nor to each other."""

from __future__ import annotations

import contextlib
import csv
import os
import pwd
import shutil
import stat
import subprocess
import sys
import time
from pathlib import Path

import pytest
from test_grade import ALL, cells, points, write

from rlrobot_course.homework import COURSE
from rlrobot_grading.marking import guard, left_behind
from rlrobot_grading.marking.grade import marked_files
from rlrobot_grading.marking.guard import Digests, Guard
from rlrobot_grading.marking.marks import Limits

ROOT = Path(__file__).parents[2]
PACKAGES = ("rlrobot_edu", "rlrobot_ros", "rlrobot_grading", "rlrobot_course")
needs_root = pytest.mark.skipif(
    sys.platform != "linux"
    or os.getuid() != 0
    or None in map(shutil.which, guard.OTHER_USER),
    reason="needs root, setpriv and prlimit",
)
RESULTS = "id,score\n03_attacks,5\n"
# Each attack tells in a file that anybody may write what it has got; what it has got is also looked at from outside.
ATTACKS = {
    "results": f"""
for place in glob.glob("/proc/[0-9]*/cmdline"):
    words = open(place, "rb").read().split(b"\\0")
    if b"--csv" in words:
        os.chdir(os.path.join(os.path.dirname(place), "cwd"))
        open(words[words.index(b"--csv") + 1], "w").write({RESULTS!r})""",
    "neighbour": """
for place in glob.glob("/proc/[0-9]*/cmdline"):
    words = open(place, "rb").read().split(b"\\0")
    if b"grade" in words:
        try:
            os.chdir(os.path.join(os.path.dirname(place), "cwd"))
            tell("neighbour", open(os.path.join(words[words.index(b"grade") + 1], b"neighbour.txt")).read())
        except OSError:  # another grading, or none that it may look into
            pass""",
    "marking": """
from rlrobot_grading.marking import one_notebook
open(one_notebook.__file__, "a").write("\\nMOST_LEFT_OUT = 6\\n")""",
    "memory": """
import mmap
much = mmap.mmap(-1, 3 << 30)
tell("memory", "3 GiB")""",
    "child": """
import subprocess, sys
subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)", "OUTLIVES"], start_new_session=True)""",
    "grader": """
import signal
for place in glob.glob("/proc/[0-9]*/cmdline"):
    if b"--csv" in open(place, "rb").read() and int(place.split("/")[2]) != os.getpid():
        os.kill(int(place.split("/")[2]), signal.SIGKILL)""",
}


def attacking(told: Path, *names: str) -> dict[str, str]:
    """The cells of a submission that attacks, and then answers rightly."""
    first = f"import glob, os\ndef tell(what, text):\n    open({str(told)!r}, 'a').write(what + ' ' + text + '\\n')"
    return {"tell": first} | {name: ATTACKS[name] for name in names} | cells()


def graded(
    folder: Path, *more: str, package: Path = ROOT
) -> subprocess.CompletedProcess[str]:
    command = [
        sys.executable,
        "-m",
        "rlrobot_edu",
        "grade",
        "in",
        "--lesson",
        "03",
        "--memory",
        "1024",
        *more,
    ]
    return subprocess.run(
        command,
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(package)},
        capture_output=True,
        text=True,
        timeout=600,
    )


def outlived() -> bool:
    words = b""
    for place in Path("/proc").glob("[0-9]*/cmdline"):
        with contextlib.suppress(OSError):  # it has ended meanwhile
            words += place.read_bytes()
    return b"OUTLIVES" in words


@pytest.fixture
def folder(tmp_path) -> Path:
    (tmp_path / "in").mkdir()
    (tmp_path / "told").touch()
    (tmp_path / "told").chmod(0o666)
    return tmp_path


@pytest.mark.long
@needs_root
def test_behind_another_user_no_forgery_works_and_right_answers_count(folder):
    told = left_behind.SHARED[0] / f"told_{os.getpid()}"
    told.touch()
    told.chmod(0o666)
    write(folder / "in" / "03_attacks.ipynb", attacking(told, *ATTACKS).values())
    (folder / "in" / "neighbour.txt").write_text("5 of 5", encoding="utf-8")
    shutil.chown(folder / "in", 0, 0)
    (folder / "in").chmod(0o700)
    before = Digests(COURSE)
    try:
        done = graded(folder, "--user", "61000", "--csv", "points.csv")
        assert done.returncode == 0, done.stderr
        assert "run as user 61000" in done.stderr
        (row,) = csv.DictReader((folder / "points.csv").open(encoding="utf-8"))
        assert {name: float(row[f"03:{name}"]) for name in ALL} == ALL
        before.check("it")
        time.sleep(0.5)
        assert not outlived() and told.read_text() == ""
    finally:
        told.unlink()


@pytest.mark.long
@pytest.mark.skipif(sys.platform != "linux", reason="/proc is Linux's")
def test_without_a_guard_a_changed_grader_is_noticed_and_what_is_left_behind_is_ended(
    folder,
):
    package = folder / "package"
    for name in PACKAGES:
        shutil.copytree(
            ROOT / name, package / name, ignore=shutil.ignore_patterns("__pycache__")
        )
    where = [
        sys.executable,
        "-c",
        "import rlrobot_course; print(rlrobot_course.__file__)",
    ]
    environment = os.environ | {"PYTHONPATH": str(package)}
    if (
        str(package)
        not in subprocess.run(
            where, env=environment, capture_output=True, text=True, cwd=folder
        ).stdout
    ):
        pytest.skip(
            "this Python does not import the copy: the attack would change the checkout"
        )
    (folder / "in" / "neighbour.txt").write_text("5 of 5", encoding="utf-8")
    attacks = attacking(folder / "told", "neighbour", "marking", "memory", "child")
    write(folder / "in" / "attacks.ipynb", attacks.values())
    done = graded(folder, "--trust", "--csv", "points.csv", package=package)
    assert (
        done.returncode == 2
        and "trust no points" in done.stderr
        and "in/attacks.ipynb" in done.stderr
    )
    assert (
        "Without --container or --user a submission runs with your rights"
        in done.stderr
    )
    assert not (folder / "points.csv").exists() and not outlived()
    assert (folder / "told").read_text() == "neighbour 5 of 5\n", (
        "it can read, but memory has its limit, shared or not"
    )


@needs_root
def test_another_user_who_could_read_the_notebooks_is_refused(tmp_path):
    write(tmp_path / "a.ipynb", ["1"])
    with pytest.raises(ValueError, match="no such user"):
        Guard(user="nobody_of_this_name").check(COURSE, [])
    with pytest.raises(ValueError, match="another user than root"):
        Guard(user="0").check(COURSE, [])
    Guard(user="61000").check(
        COURSE, [tmp_path / "a.ipynb"]
    )  # pytest's folders are root's alone
    open_one = left_behind.SHARED[0] / f"open_{os.getpid()}.ipynb"
    open_one.touch()
    try:
        with pytest.raises(ValueError, match=r"could read .* chmod"):
            Guard(user="61000").check(COURSE, [open_one])
    finally:
        open_one.unlink()


ENGINE = """#!/bin/sh
# It stands in for podman: notes how it is called, and runs what the container would run, without one.
echo "$@" >> {calls}
case "$1" in rm) exit 0;; esac
while [ "$1" != IMAGE ]; do
    case "$1" in --env=*) export "${{1#--env=}}";; esac
    shift
done
shift 2
exec {python} "$@"
"""


def stand_in(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A program podman, first in PATH; returns the file in which it notes its calls."""
    engine, calls = folder / "bin" / "podman", folder / "calls"
    engine.parent.mkdir()
    engine.write_text(
        ENGINE.format(calls=calls, python=sys.executable), encoding="utf-8"
    )
    engine.chmod(0o755)
    monkeypatch.setenv("PATH", f"{engine.parent}{os.pathsep}{os.environ['PATH']}")
    return calls


@pytest.mark.long
@pytest.mark.skipif(
    sys.platform == "win32", reason="a script of sh stands in for podman"
)
def test_a_container_gets_its_notebook_alone_no_network_and_limits_and_the_judge_stays_outside(
    folder, monkeypatch
):
    calls = stand_in(folder, monkeypatch)
    write(folder / "in" / "02_mine.ipynb", cells().values())
    done = graded(folder, "--container", "IMAGE")
    assert done.returncode == 0, done.stderr
    run, end = calls.read_text(encoding="utf-8").splitlines()[1:]
    words = run.split()
    for word in ("--network=none", "--read-only", "--cap-drop=ALL", "--pids-limit=256", "--memory=2048m",
                 "--security-opt=no-new-privileges", "--rm"):  # fmt: skip
        assert word in words
    volumes = [
        word.removeprefix("--volume=").split(":")
        for word in words
        if word.startswith("--volume=")
    ]
    (notebook, inside, how), (home, home_inside) = volumes
    assert notebook == inside and Path(notebook).name == "02_mine.ipynb" and how == "ro"
    assert home == home_inside and Path(home).name == "home"
    assert str(folder) not in run.replace(str(folder / "bin"), ""), (
        "it knows nothing of where the notebooks are"
    )
    assert end.split()[:2] == ["rm", "--force"] and f"--name={end.split()[2]}" in words


def test_a_container_of_another_python_is_refused(folder, monkeypatch):
    stand_in(folder, monkeypatch)
    (folder / "bin" / "podman").write_text("#!/bin/sh\necho 3 7\n", encoding="utf-8")
    with pytest.raises(ValueError, match="must have the Python of the grader"):
        Guard(container="IMAGE").check(COURSE, [])
    with pytest.raises(ValueError, match="choose one"):
        Guard("61000", "IMAGE").check(COURSE, [])


# --- two submissions at the same time, behind other users

FIRST = 61_300  # users that no other test uses at the same time
# It waits until its neighbour is there, looks for its notebook, and then ends all processes of its own user but itself.
SPY = """
import glob, os, signal, time
mine, found, end = os.getcwd(), [], time.monotonic() + {seconds}
while time.monotonic() < end and not found:
    for path in glob.glob("{shared}/rlrobot-grade-*/*/*.ipynb") + glob.glob("/proc/[0-9]*/cwd/*.ipynb"):
        if not os.path.samefile(os.path.dirname(path), mine):
            found.append(path)
    time.sleep(0.2)
for place in glob.glob("/proc/[0-9]*"):
    try:
        if os.stat(place).st_uid == os.getuid() and int(place[6:]) != os.getpid():
            os.kill(int(place[6:]), signal.SIGKILL)
            found.append(place)
    except OSError:
        pass
assert not found, found
"""
LEAVES = """
import pathlib, tempfile
for folder in {shared}:
    pathlib.Path(folder, "left_by_a_submission_{n}").touch()
pathlib.Path({shared}[0], "left_folder_{n}").mkdir()
assert pathlib.Path(tempfile.gettempdir()).parts[-2:] == ("home", "tmp")
"""
FORKS = """
import os, signal, time
children = []
try:
    while len(children) < 3000 and (child := os.fork()):
        children.append(child)
    if len(children) < 3000:
        time.sleep(60)
        os._exit(0)
except OSError:
    pass
for child in children:
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
assert len(children) < 3000, "there is no limit"
"""


@pytest.mark.long
@needs_root
def test_two_jobs_are_two_users_who_find_nothing_of_each_other_and_leave_nothing(
    tmp_path,
):
    n = os.getpid()
    shared = [str(folder) for folder in left_behind.SHARED if folder.is_dir()]
    spy = {"spy": SPY.format(seconds=12, shared=shared[0])} | cells()
    leaves = LEAVES.format(n=n, shared=shared)
    victim = {
        "waits": "import time\ntime.sleep(10)",
        "leaves": leaves,
        "forks": FORKS,
    } | cells()
    paths = [
        write(tmp_path / f"{name}.ipynb", one.values())
        for name, one in (("spy", spy), ("victim", victim))
    ]
    limits = Limits(seconds=600, memory=1500, guard=Guard(user=str(FIRST)))
    for one in marked_files(COURSE, paths, "03", 7, limits, jobs=2):
        assert points(one) == ALL and one.notes == [], one
    assert not [
        path for folder in left_behind.SHARED for path in folder.glob(f"left_*_{n}")
    ]


@needs_root
def test_jobs_have_the_next_numbers_of_nobody_and_give_them_back():
    somebody = max(user.pw_uid for user in pwd.getpwall() if user.pw_uid < 60_000)
    with (
        Guard(user=str(FIRST)).of_one_job() as one,
        Guard(user=str(FIRST)).of_one_job() as other,
    ):
        assert (one.uid, other.uid) == (FIRST, FIRST + 1)
    with Guard(user=str(FIRST)).of_one_job() as again:
        assert again.uid == FIRST
    with (
        Guard(user=str(somebody - 1)).of_one_job(),
        Guard(user=str(somebody - 1)).of_one_job() as other,
    ):
        assert other.uid > somebody, "not an account of somebody else"
    assert stat.S_IMODE(guard.LOCKS.stat().st_mode) == 0o700


@needs_root
def test_only_what_is_new_and_the_users_own_is_removed(tmp_path, monkeypatch):
    monkeypatch.setattr(left_behind, "SHARED", (tmp_path,))
    (tmp_path / "before").touch()
    os.chown(tmp_path / "before", FIRST, FIRST)
    (outside := tmp_path.parent / "outside").mkdir()
    (outside / "kept").touch()
    with Guard(user=str(FIRST)).of_one_job():
        for name in ("mine", "another's"):
            (tmp_path / name).touch()
        (tmp_path / "link").symlink_to(outside)
        (tmp_path / "folder").mkdir()
        (tmp_path / "folder" / "deep").touch()
        for name in ("mine", "link", "folder"):
            os.chown(tmp_path / name, FIRST, FIRST, follow_symlinks=False)
    assert (
        sorted(path.name for path in tmp_path.iterdir()) == ["another's", "before"]
        and (outside / "kept").exists()
    )
