"""A full disk, a folder that nobody may write to, no home, and files that were tampered with: said, or lived with."""

import os
import shutil
import tempfile
from pathlib import Path

import pytest
from faults import as_nobody, full_disk, needs_limits
from worlds import same_histories as same

import rlrobot_edu as rl
from rlrobot_edu.tools.new_task import new_task


@pytest.fixture(scope="module")
def model():
    return rl.SampleModel.from_recording(rl.read_recording("worked_example"))


@pytest.fixture(scope="module")
def film():
    env = rl.make_env("wander_simple", seed=0)
    return rl.film(rl.Agent(env, seed=0), env, steps=2)


def compared(model, **more):
    return rl.compare(
        model, ["TOSL+QBIASSR", "Q+SR"], 2, steps=60, n_jobs=1, progress=False, **more
    )


def writes(model, film):
    """Everything that writes a file: by name, a function of the path."""
    agent = rl.Agent("wander_simple", seed=0)
    agent.q[:] = agent.rng.random(agent.q.shape)  # not to be packed into a few bytes
    return {
        "agent": agent.save,
        "model": model.save,
        "recording": rl.read_recording("worked_example").save,
        "film": film.save,
        "page": lambda path: film.show3d().save(path),
    }


KINDS = ["agent", "model", "recording", "film", "page"]


def content(folder):
    """Every file below a folder, and what it holds."""
    return {
        path.relative_to(folder): path.read_bytes()
        for path in Path(folder).rglob("*")
        if path.is_file()
    }


# Folders of any name

NAMES = ["ä 日本 😀", "a#b%20c%", "[x] {y} it's $HOME", "n" * 120 + "/" + "m" * 120]


@pytest.mark.parametrize("name", NAMES)
def test_what_is_written_in_a_folder_of_any_name_can_be_read_there(
    name, model, film, tmp_path, monkeypatch
):
    pytest.importorskip("meshcat")
    folder = tmp_path / name
    folder.mkdir(parents=True)
    monkeypatch.chdir(folder)
    for kind, write in writes(model, film).items():
        write(folder / kind)
    rl.playground("playground.html")
    rl.stage("stage.html")
    assert (
        rl.Agent.load("agent").q.shape == (4, 4)
        and rl.SampleModel.load(folder / "model").n_states == 24
    )
    assert len(rl.read_recording(folder / "recording")) == len(
        rl.read_recording("worked_example")
    )
    assert rl.load_task(folder / new_task("mine")).name == "mine"
    assert same(compared(model, store="store"), compared(model, store=folder / "store"))


# A full disk


@needs_limits
@pytest.mark.parametrize("kind", KINDS)
def test_on_a_full_disk_the_old_file_stays_nothing_is_left_behind_and_the_error_names_the_file(
    kind, model, film, tmp_path
):
    if kind == "page":
        pytest.importorskip("meshcat")
    write = writes(model, film)[kind]
    write(tmp_path / "it")
    old = content(tmp_path)
    for size in (0, 400):
        for name in ("it", "new"):
            with (
                full_disk(size),
                pytest.raises(OSError, match="File too large") as refusal,
            ):
                write(tmp_path / name)
            assert str(tmp_path / name) in str(refusal.value)
        assert content(tmp_path) == old


@needs_limits
def test_a_comparison_that_fills_the_disk_names_the_file_and_goes_on_when_there_is_room(
    model, tmp_path
):
    store = tmp_path / "s"
    with full_disk(100), pytest.raises(OSError, match=r"experiment\.json"):
        compared(model, store=store)
    assert content(store) == {}  # which makes it no folder of anybody else
    model.save(tmp_path / "model.npz")
    with (
        full_disk((tmp_path / "model.npz").stat().st_size),
        pytest.raises(OSError, match=r"0000\.npz"),
    ):
        compared(model, store=store, keep=True)
    assert set(content(store)) == {Path("experiment.json"), Path("model.npz")}
    assert same(compared(model, store=store, keep=True), compared(model))


# Places that cannot be written to


@pytest.fixture
def read_only():
    """A folder to which nobody may write, in a place that everybody can reach."""
    if not hasattr(os, "geteuid"):
        pytest.skip("folders have no owner here")
    with tempfile.TemporaryDirectory() as place:
        os.chmod(place, 0o755)
        folder = Path(place) / "read only"
        folder.mkdir(mode=0o555)
        yield folder
        folder.chmod(0o755)


@pytest.mark.parametrize("kind", KINDS)
def test_a_folder_that_cannot_be_written_to_is_named(kind, model, film, read_only):
    if kind == "page":
        pytest.importorskip("meshcat")
        film.show3d()  # what it imports, nobody might not be allowed to read
    write = writes(model, film)[kind]
    with (
        as_nobody(),
        pytest.raises(PermissionError, match="choose a folder of your own") as refusal,
    ):
        write(read_only / "it")
    assert str(read_only) in str(refusal.value)
    with as_nobody(), pytest.raises(PermissionError) as refusal:
        compared(model, store=read_only / "s")
    assert str(read_only) in str(refusal.value)
    assert content(read_only) == {}


def test_a_whole_store_in_a_read_only_folder_can_be_read(model, read_only):
    read_only.chmod(0o755)
    whole = compared(model, store=read_only)
    read_only.chmod(0o555)
    with as_nobody():
        assert same(compared(model, store=read_only), whole)
    read_only.chmod(0o755)
    (read_only / "Q+SR" / "0000.npz").unlink()
    (read_only / "Q+SR").chmod(0o555)
    with as_nobody(), pytest.raises(PermissionError, match=r"0000\.npz"):
        compared(model, store=read_only)
    (read_only / "Q+SR").chmod(0o755)


# A store that was tampered with


@pytest.mark.parametrize(
    "leftover", [".experiment.json.0123.part", "Q+SR/.0000.npz.0123.part", "model.npz"]
)
def test_a_start_that_was_killed_goes_on(model, tmp_path, leftover):
    compared(model, store=tmp_path / "whole")
    if leftover[0] != ".":
        shutil.copytree(
            tmp_path / "whole",
            tmp_path / "s",
            ignore=shutil.ignore_patterns("0*.npz", "model.npz"),
        )
    (tmp_path / "s" / leftover).parent.mkdir(parents=True, exist_ok=True)
    (tmp_path / "s" / leftover).write_bytes(
        (tmp_path / "whole" / "model.npz").read_bytes()
    )
    assert same(compared(model, store=tmp_path / "s"), compared(model))
    assert same(rl.Comparison.load(tmp_path / "s"), compared(model))


@pytest.mark.parametrize(
    "name", ["TOSL+QBIASSR/0000.npz", "Q+SR/0001.npz", "Q+SR/0007.npz"]
)
def test_a_file_of_a_store_that_was_renamed_is_refused_by_name(model, tmp_path, name):
    compared(model, store=tmp_path)
    os.replace(tmp_path / "Q+SR" / "0000.npz", tmp_path / name)
    opens = [lambda: rl.Comparison.load(tmp_path)]
    opens += (
        [lambda: compared(model, store=tmp_path)] if "0007" not in name else []
    )  # which asks for two repetitions
    for open_it in opens:
        with pytest.raises(
            ValueError,
            match=rf"{Path(name).name}.* 0 of Q\+SR .*, expected .*delete this file",
        ):
            open_it()
    (tmp_path / name).unlink()
    assert same(compared(model, store=tmp_path), compared(model))


@pytest.mark.parametrize("whose", ["another experiment", "no experiment"])
def test_a_file_of_another_origin_is_refused_by_name(model, tmp_path, whose):
    for seed in (0, 1):
        result = compared(model, store=tmp_path / str(seed), seed=seed)
    path = tmp_path / "0" / "Q+SR" / "0000.npz"
    if whose == "another experiment":
        shutil.copy(tmp_path / "1" / "Q+SR" / "0000.npz", path)
    else:
        result["Q+SR"][0].save(path)
    with pytest.raises(
        ValueError, match=r"0000\.npz.*, expected 'repetition 0 of Q\+SR of experiment"
    ):
        compared(model, store=tmp_path / "0")


NO_STORE = [
    b"", b"null", b"[]", b"3", b'"methods"', b"{}", b'{"methods": null}', b'{"methods": 3}',
    b'{"methods": {"Q+SR": 1}}', b"[" * 10**5, b'{"methods":' * 10**5, b"\x00\xff" * 99, b"\xef\xbb\xbf{}", b"NaN",
    b"9" * 10**4,
]  # fmt: skip


@pytest.mark.parametrize("text", NO_STORE, ids=lambda text: str(text[:20]))
def test_what_is_no_description_of_a_store_is_refused_by_name_and_stays(
    model, tmp_path, text
):
    compared(model, store=tmp_path)
    (tmp_path / "experiment.json").write_bytes(text)
    before = content(tmp_path)
    for open_it in (
        lambda: compared(model, store=tmp_path),
        lambda: rl.Comparison.load(tmp_path),
    ):
        with pytest.raises(ValueError) as refusal:
            open_it()
        assert "experiment.json: this file of the store is damaged" in str(
            refusal.value
        )
        assert len(str(refusal.value)) < 500
    assert content(tmp_path) == before
