"""Files in the places of people: links are followed and modes kept; devices and pipes are refused."""

import os
import stat
import sys
from pathlib import Path

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.files import ABANDONED, parts_of, write_together, write_whole

posix = pytest.mark.skipif(
    sys.platform == "win32", reason="Windows has neither modes nor pipes of this kind"
)
root = pytest.mark.skipif(
    getattr(os, "geteuid", lambda: 1)() != 0, reason="only root makes devices"
)


def mode(path):
    return stat.S_IMODE(os.stat(path).st_mode)


def only(folder, *names):
    return sorted(path.name for path in folder.iterdir()) == sorted(names)


@posix
@pytest.mark.parametrize("private", [0o600, 0o640, 0o660, 0o755, 0o200])
def test_a_file_that_is_replaced_keeps_its_mode(tmp_path, private):
    path = tmp_path / "marks.csv"
    path.write_text("old")
    path.chmod(private)
    write_whole(path, "new")
    path.chmod(mode(path) | 0o400)
    assert path.read_text() == "new" and mode(path) == private | 0o400
    assert only(tmp_path, "marks.csv")


@posix
def test_a_new_file_has_the_mode_that_the_user_asked_for(tmp_path):
    before = os.umask(0o027)
    try:
        write_whole(tmp_path / "new", "x")
    finally:
        os.umask(before)
    assert mode(tmp_path / "new") == 0o640


@posix
@pytest.mark.parametrize("depth", [1, 2])
@pytest.mark.parametrize("there", [True, False])
def test_a_link_is_followed_and_stays_a_link(tmp_path, depth, there):
    target = tmp_path / "elsewhere" / "real.npz"
    target.parent.mkdir()
    if there:
        target.write_bytes(b"old")
    (tmp_path / "link0").symlink_to(Path("elsewhere", "real.npz"))
    for i in range(1, depth):
        (tmp_path / f"link{i}").symlink_to(f"link{i - 1}")
    link = tmp_path / f"link{depth - 1}"
    rl.Agent("wander_simple").save(link)
    assert link.is_symlink() and not target.is_symlink()
    np.testing.assert_array_equal(rl.Agent.load(target).q, 0)
    assert only(target.parent, "real.npz")


@posix
def test_links_that_go_round_in_a_circle_are_refused(tmp_path):
    (tmp_path / "a").symlink_to("b")
    (tmp_path / "b").symlink_to("a")
    with pytest.raises(OSError, match="a"):
        write_whole(tmp_path / "a", "x")
    assert (tmp_path / "a").is_symlink() and only(tmp_path, "a", "b")


@posix
def test_two_names_of_one_place_leave_the_last_content_and_nothing_else(tmp_path):
    (tmp_path / "link").symlink_to("real")
    write_together({tmp_path / "real": "first", tmp_path / "link": "second"})
    assert (tmp_path / "real").read_text() == "second" and only(
        tmp_path, "link", "real"
    )


@posix
def test_another_name_of_a_file_keeps_the_old_content(tmp_path):
    (tmp_path / "one").write_text("old")
    os.link(tmp_path / "one", tmp_path / "other")
    write_whole(tmp_path / "one", "new")
    assert (tmp_path / "one").read_text() == "new" and (
        tmp_path / "other"
    ).read_text() == "old"


@pytest.mark.parametrize("protected", [0o444, 0o400, 0o555])
def test_a_read_only_file_is_refused_even_for_root(tmp_path, protected):
    path = tmp_path / "finished.npz"
    path.write_bytes(b"old")
    path.chmod(protected)
    with pytest.raises(PermissionError, match=r"protected from writing.*finished\.npz"):
        rl.Agent("wander_simple").save(path)
    with pytest.raises(PermissionError, match="protected from writing"):
        write_together({tmp_path / "first": "x", path: b"PK"})
    assert path.read_bytes() == b"old" and only(tmp_path, "finished.npz")
    path.chmod(0o644)


@posix
@root
def test_a_device_is_refused_and_stays_a_device(tmp_path):
    null = tmp_path / "null"
    os.mknod(null, 0o666 | stat.S_IFCHR, os.makedev(1, 3))
    with pytest.raises(OSError, match=r"this is a device or a pipe.*null"):
        rl.Agent("wander_simple").save(null)
    assert stat.S_ISCHR(null.lstat().st_mode) and only(tmp_path, "null")


@posix
def test_a_pipe_is_refused_and_stays_a_pipe(tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with pytest.raises(OSError, match=r"this is a device or a pipe.*pipe"):
        write_whole(pipe, b"lost")
    assert stat.S_ISFIFO(pipe.lstat().st_mode) and only(tmp_path, "pipe")


def test_a_name_as_long_as_a_file_system_takes_can_be_written(tmp_path):
    for name in ("x" * 255, "é" * 127):
        write_whole(tmp_path / name, "new")
        assert (tmp_path / name).read_text() == "new"


def test_what_a_killed_writer_left_is_removed_beside_the_file_itself(tmp_path):
    (tmp_path / "real").write_text("old")
    left = tmp_path / f".real.{'0' * 32}.part"
    left.write_text("half")
    os.utime(left, (1, 1))
    assert parts_of(tmp_path / "real") == [left] and ABANDONED < 1e9
    write_whole(tmp_path / "real", "new")
    assert only(tmp_path, "real")


def test_a_file_in_the_way_of_a_folder_is_named(tmp_path):
    (tmp_path / "my_course").write_text("not a folder")
    with pytest.raises(NotADirectoryError, match=r"part of it is a file.*my_course"):
        write_whole(tmp_path / "my_course" / "lesson.ipynb", "x")
    assert only(tmp_path, "my_course")


def test_an_error_names_the_file_and_not_its_temporary_one(tmp_path, monkeypatch):
    def refuse(*_, **__):
        raise PermissionError(13, "Permission denied", str(tmp_path / ".mine.0.part"))

    monkeypatch.setattr(os, "fsync", refuse)
    with pytest.raises(PermissionError) as caught:
        write_whole(tmp_path / "mine", "x")
    assert caught.value.filename == str(tmp_path / "mine") and only(tmp_path)
