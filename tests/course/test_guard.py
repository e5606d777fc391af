"""Two submissions at the same time, behind other users: neither reads, ends or fills what is the other's."""

from __future__ import annotations

import os
import pwd
import shutil
import stat
import subprocess
import sys
from pathlib import Path

import pytest
from test_grade import ALL, cells, points, write

from rlrobot_course.homework import guard
from rlrobot_course.homework.grade import marked_files
from rlrobot_course.homework.guard import OPEN_HOUSE, Guard
from rlrobot_course.homework.marks import Limits

pytestmark = pytest.mark.skipif(
    sys.platform != "linux" or os.getuid() != 0 or None in map(shutil.which, guard.OTHER_USER),
    reason="needs root, setpriv and prlimit",
)
FIRST = 61_300  # users that no other test uses at the same time
# It waits until its neighbour is there, looks for its notebook, and then ends all processes of its own user but itself.
SPY = """
import glob, os, signal, time
mine, found, end = os.getcwd(), [], time.monotonic() + {seconds}
while time.monotonic() < end and not found:
    for path in glob.glob("/tmp/rlrobot-grade-*/work/*.ipynb") + glob.glob("/proc/[0-9]*/cwd/*.ipynb"):
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
for folder in ("/tmp", "/var/tmp", "/dev/shm"):
    pathlib.Path(folder, "left_by_a_submission_{n}").write_text("the answer is 42")
pathlib.Path("/tmp/left_folder_{n}").mkdir()
assert tempfile.gettempdir().endswith("/home/tmp")
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
def test_two_jobs_are_two_users_who_find_nothing_of_each_other_and_leave_nothing(tmp_path):
    n = os.getpid()
    spy = {"spy": SPY.format(seconds=12)} | cells()
    victim = {"waits": "import time\ntime.sleep(10)", "leaves": LEAVES.format(n=n), "forks": FORKS} | cells()
    paths = [write(tmp_path / f"{name}.ipynb", one.values()) for name, one in (("spy", spy), ("victim", victim))]
    limits = Limits(seconds=600, memory=1500, guard=Guard(user=str(FIRST)))
    for one in marked_files(paths, "02", 7, limits, jobs=2):
        assert points(one) == ALL and one.notes == [], one
    assert not [path for folder in guard.SHARED for path in folder.glob(f"left_*_{n}")]


def test_jobs_have_the_next_numbers_of_nobody_and_give_them_back():
    somebody = max(user.pw_uid for user in pwd.getpwall() if user.pw_uid < 60_000)
    with Guard(user=str(FIRST)).of_one_job() as one, Guard(user=str(FIRST)).of_one_job() as other:
        assert (one.uid, other.uid) == (FIRST, FIRST + 1)
    with Guard(user=str(FIRST)).of_one_job() as again:
        assert again.uid == FIRST
    with Guard(user=str(somebody - 1)).of_one_job(), Guard(user=str(somebody - 1)).of_one_job() as other:
        assert other.uid > somebody, "not an account of somebody else"
    assert stat.S_IMODE(guard.LOCKS.stat().st_mode) == 0o700


def test_only_what_is_new_and_the_users_own_is_removed(tmp_path, monkeypatch):
    monkeypatch.setattr(guard, "SHARED", (tmp_path,))
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
    assert sorted(path.name for path in tmp_path.iterdir()) == ["another's", "before"] and (outside / "kept").exists()


def test_a_process_of_a_submission_has_a_limit_of_processes_and_no_rights():
    with Guard(user=str(FIRST)).of_one_job() as one:
        shown = "import os, resource; print(os.getuid(), os.getgroups(), resource.getrlimit(resource.RLIMIT_NPROC)[1])"
        command = one.command([sys.executable, "-c", shown], Path("/"), Path("/"), 1000, {})
        done = subprocess.run(command, capture_output=True, text=True, cwd="/")
    assert done.stdout.split() == [str(FIRST), "[]", str(guard.PROCESSES)], done


def test_without_another_user_nothing_is_locked():
    with OPEN_HOUSE.of_one_job() as one:
        assert one is OPEN_HOUSE
