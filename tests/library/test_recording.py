"""Recordings: what is written reads back exactly, and what is not whole and right is refused in one clear sentence."""

import json
import math
import os
import re
import shutil
import subprocess
import time
from collections import Counter
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from unittest.mock import Mock

import gymnasium
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import rlrobot_edu as rl
from rlrobot_edu.files import write_together, write_whole
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models import read_recording as reading
from rlrobot_edu.models.data_package import NAMES, ROW, to_files
from rlrobot_edu.models.source import Source

TASK = rl.Task(
    robot="mobile_base",
    scene="square_2x2",
    inputs=[
        rl.InputVariable("laser_front", cuts=[0.2], unit="m"),
        rl.InputVariable("theta", sectors=3, unit="rad"),
    ],
    outputs=[
        rl.OutputVariable("left_wheel", [-1, 1], "rad/s"),
        rl.OutputVariable("right_wheel", [-1, 0, 1], "rad/s"),
    ],
    rewards=[-10, -0.02, 1 / 3, 10],
    reward=lambda before, after: 10.0,
    episode_steps=40,
    name="small",
)
SOURCE = Source.of_task(
    TASK, method="TOSL+SR", seed=7, version="0.1.0", platform="test"
)


def make_recording(n=6, episode_ends=(), seed=0, **changes):
    """A random recording of TASK; `changes` replace columns."""
    rng = np.random.default_rng(seed)
    ends = np.isin(np.arange(n), list(episode_ends))
    columns = {
        "s": rng.integers(6, size=n),
        "a": rng.integers(6, size=n),
        "r": rng.choice(TASK.rewards, size=n),
        "s_next": rng.integers(6, size=n),
        "terminated": ends,
        "truncated": np.zeros(n, dtype=bool),
    }
    return rl.Recording(Transitions(**{**columns, **changes}), SOURCE, TASK)


@pytest.fixture
def saved(tmp_path):
    """Folder of a saved recording of 6 rows."""
    make_recording(episode_ends=[2]).save(tmp_path / "small")
    return tmp_path / "small"


def edit(path, old, new):
    text = path.read_bytes().decode()
    assert old in text
    path.write_bytes(text.replace(old, new, 1).encode())


def set_field(folder, row, column, value):
    """Put `value` into one field of transitions.csv."""
    lines = (folder / "transitions.csv").read_text().split("\n")
    fields = lines[row + 1].split(",")
    fields[NAMES.index(column)] = value
    lines[row + 1] = ",".join(fields)
    (folder / "transitions.csv").write_text("\n".join(lines))


def refusal(path, error=ValueError, **how):
    """The one sentence with which reading is refused."""
    with pytest.raises(error) as caught:
        rl.read_recording(path, **how)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def same(one, other):
    return all(
        np.array_equal(getattr(one, name), getattr(other, name)) for name in NAMES
    )


# --- writing and reading back ---


@settings(deadline=None, max_examples=40, suppress_health_check=list(HealthCheck))
@given(
    n=st.integers(1, 30),
    ends=st.sets(st.integers(0, 29)),
    seed=st.integers(0, 99),
    by_name=st.integers(0, 2),
)
def test_what_is_written_reads_back_exactly(tmp_path, n, ends, seed, by_name):
    recording = make_recording(n, ends, seed)
    recording.save(tmp_path / "r")
    name = ["", "transitions.csv", "datapackage.json"][by_name]
    back = rl.read_recording(tmp_path / "r" / name, task=TASK)
    assert (
        same(recording, back)
        and back.source == SOURCE
        and back.task is TASK
        and len(back) == n
    )
    assert same(recording, rl.Recording.load(tmp_path / "r" / name))
    assert all(
        getattr(back, name).dtype == (float if name == "r" else np.int64)
        for name in NAMES[:-1]
    )
    assert back.terminated.dtype == bool


def test_a_recording_is_read_without_its_task_and_still_knows_its_states(saved):
    recording = rl.read_recording(str(saved))
    assert recording.task is None
    source = recording.source
    assert (source.states.shape, source.states.n, source.actions.n) == ((2, 3), 6, 6)
    assert source.rewards == TASK.rewards and source.episode_steps == 40
    assert (source.method, source.seed, source.version) == ("TOSL+SR", 7, "0.1.0")
    assert source.states.decode(5) == TASK.states.decode(5)
    assert source.actions.label(4) == TASK.actions.label(4)


def test_a_recording_that_comes_with_the_toolkit_is_read_by_its_name(
    saved, monkeypatch
):
    monkeypatch.setattr(reading, "shipped", lambda folder: saved.parent)
    assert reading.available_recordings() == ["small"]
    assert same(rl.read_recording("small"), rl.read_recording(saved))
    assert refusal("smal", FileNotFoundError).endswith("or one of the toolkit's: small")


def test_the_same_recording_makes_the_same_bytes_and_so_does_the_one_read_back(
    saved, tmp_path
):
    rl.read_recording(saved).save(tmp_path / "again")
    for name in ("transitions.csv", "datapackage.json"):
        assert (saved / name).read_bytes() == (tmp_path / "again" / name).read_bytes()


def test_the_rows_are_plain_text_for_a_spreadsheet(saved):
    lines = (saved / "transitions.csv").read_bytes().decode().split("\n")
    assert (
        lines[0] == "episode,step,s,a,r,s_next,terminated"
        and lines[-1] == ""
        and len(lines) == 8
    )
    assert re.fullmatch(
        r"0,0,\d,\d,(-10\.0|-0\.02|0\.3333333333333333|10\.0),\d,0", lines[1]
    )
    assert (
        lines[3].startswith("0,2,")
        and lines[3].endswith(",1")
        and lines[4].startswith("1,0,")
    )


def test_the_data_package_describes_the_columns_and_names_no_place(saved):
    text = (saved / "datapackage.json").read_text()
    package = json.loads(text)
    resource, section = package["resources"][0], package["rlrobot"]
    fields = {field["name"]: field for field in resource["schema"]["fields"]}
    assert (
        package["profile"] == "tabular-data-package"
        and package["licenses"][0]["name"] == "CC0-1.0"
    )
    assert resource["bytes"] == (saved / "transitions.csv").stat().st_size
    assert tuple(fields) == NAMES
    assert fields["s"]["constraints"] == {"required": True, "minimum": 0, "maximum": 5}
    assert fields["r"]["constraints"]["enum"] == [-10.0, -0.02, 1 / 3, 10.0]
    assert section["inputs"][0] == {
        "name": "laser_front",
        "cuts": [0.2],
        "unit": "m",
        "low": 0.0,
        "high": 5.0,
    }
    theta = TASK.inputs[1]
    assert section["inputs"][1] == {
        "name": "theta",
        "sectors": 3,
        "unit": "rad",
        "low": theta.low,
        "high": theta.high,
    }
    assert (section["rows"], section["method"], section["seed"]) == (6, "TOSL+SR", 7)
    assert str(saved) not in text and text.endswith("}\n")


def test_the_columns_of_a_recording_cannot_be_changed():
    with pytest.raises(ValueError, match="read-only"):
        make_recording().r[0] = 1.0


def test_a_recording_with_an_impossible_row_cannot_be_made():
    with pytest.raises(
        ValueError,
        match="row 3 of the recording: s_next is 6, expected a whole number from 0 to 5",
    ):
        make_recording(s_next=[0, 1, 2, 6, 4, 5])
    with pytest.raises(ValueError, match="columns of one length"):
        make_recording(s=[0, 1])


ENDS = st.lists(st.tuples(st.booleans(), st.booleans()), min_size=1, max_size=8)


@given(ENDS)
@settings(max_examples=60, deadline=None)
def test_however_episodes_ended_the_recording_reads_back_as_it_was(ends):
    terminated, truncated = np.array(ends).T
    zeros = np.zeros(len(ends), dtype=int)
    recording = rl.read_recording("wander_simple")
    columns = Transitions(zeros, zeros, zeros + 10.0, zeros, terminated, truncated)
    recording = rl.Recording(columns, recording.source)
    csv, package = to_files(recording.source, recording.transitions)
    with TemporaryDirectory() as folder:
        recording.save(folder)
        again = rl.Recording.load(folder)
        again.save(folder)
        assert (Path(folder) / "transitions.csv").read_bytes() == csv
    assert same(again, recording)
    assert np.array_equal(again.truncated, truncated)
    # A file whose episodes tell it all has no column more.
    names = csv.decode().partition("\n")[0].split(",")
    fields = json.loads(package)["resources"][0]["schema"]["fields"]
    assert names == [field["name"] for field in fields]
    is_told = not truncated[-1] and not (terminated & truncated).any()
    assert ("truncated" in names) == (not is_told)


def test_a_world_that_ends_and_cuts_off_at_once_is_recorded_as_it_was(tmp_path):
    class Both(gymnasium.Env):
        observation_space = gymnasium.spaces.Discrete(2)
        action_space = gymnasium.spaces.Discrete(1)

        def reset(self, *, seed=None, options=None):
            return 0, {}

        def step(self, action):
            return 1, 1.0, True, True, {}

    env = Both()
    recording = rl.record(rl.Agent(env, "Q+EG", seed=0), env, 20)
    recording.save(tmp_path)
    for it in (recording, rl.Recording.load(tmp_path)):
        assert it.terminated.all() and it.truncated.all()
        assert it.episode.tolist() == list(range(20))


def test_a_cut_off_that_does_not_fit_the_episodes_is_refused(tmp_path):
    ends = np.array([False, True, False, False, False, True])
    make_recording(episode_ends=[3], truncated=ends).save(tmp_path)
    path = tmp_path / "transitions.csv"
    lines = path.read_text().split("\n")
    lines[1] = lines[1][:-1] + "1"  # the first episode goes on
    path.write_text("\n".join(lines))
    with pytest.raises(ValueError, match="episode 0, step 1 stands where episode 1"):
        rl.Recording.load(tmp_path)
    lines[1] = lines[1][:-1] + "2"
    path.write_text("\n".join(lines))
    with pytest.raises(ValueError, match="truncated is 2, expected a whole number"):
        rl.Recording.load(tmp_path)
    lines[1] = lines[1][:-2]
    path.write_text("\n".join(lines))
    with pytest.raises(ValueError, match="expected 8 numbers"):
        rl.Recording.load(tmp_path)


# --- recording an agent ---


def test_recording_an_agent_keeps_each_step_and_counts_episodes():
    env = gymnasium.make("FrozenLake-v1", is_slippery=False, max_episode_steps=12)
    env.reset(seed=3)
    recording = rl.record(rl.Agent(env, "Q+EG", seed=5), env, steps=300)
    source = recording.source
    assert (
        len(recording) == 300 and source.states.shape == (16,) and source.actions.n == 4
    )
    assert (source.method, source.seed, source.version) == ("Q+EG", 5, rl.__version__)
    joins = recording.s[1:] == recording.s_next[:-1]
    new = np.diff(recording.episode) == 1
    assert joins[~new].all() and (recording.s[1:][new] == 0).all()
    ended = recording.terminated | recording.truncated
    assert np.array_equal(new, ended[:-1]) and recording.step.max() <= 11
    assert (recording.step[recording.truncated] == 11).all()


def test_at_least_one_step_is_recorded():
    with pytest.raises(ValueError, match="at least 1"):
        rl.record(rl.Agent("wander_simple"), rl.make_env("wander_simple"), steps=0)


def test_a_recorded_environment_without_a_task_reads_back(tmp_path):
    env = gymnasium.make("CliffWalking-v1")
    recording = rl.record(
        rl.Agent(env, "SARSA+SR", seed=np.random.SeedSequence(1)), env, steps=50
    )
    recording.save(tmp_path)
    back = rl.read_recording(tmp_path)
    assert (
        same(recording, back)
        and back.source.seed is None
        and back.source == recording.source
    )
    assert (
        '"low": null' in (tmp_path / "datapackage.json").read_text()
    )  # JSON knows no infinity


# --- files that are refused ---


@pytest.mark.parametrize("missing", ["transitions.csv", "datapackage.json"])
def test_a_missing_file_of_the_pair_is_named(saved, missing):
    (saved / missing).unlink()
    message = refusal(saved, FileNotFoundError)
    assert message.startswith(str(saved / missing)) and "together" in message


def test_a_recording_that_does_not_exist_is_refused_with_what_there_is():
    assert refusal("wander_1kk", FileNotFoundError).startswith(
        "wander_1kk: there is no such recording; did you mean 'wander_1k'? Give"
    )
    assert "legacy=True" in refusal("file.npy", FileNotFoundError)


@pytest.mark.parametrize(
    ("column", "value", "expected"),
    [
        ("s", "6", "s is 6, expected a whole number from 0 to 5"),
        ("s", "-1", "s is -1, expected"),
        ("s_next", "1.5", "s_next is 1.5, expected a whole number"),
        ("a", "6", "a is 6, expected a whole number from 0 to 5"),
        ("a", "left", "expected 7 numbers, found '1,1,"),
        ("a", "", "expected 7 numbers, found '1,1,"),
        ("a", "1,1", "expected 7 numbers, found '1,1,"),
        (
            "r",
            "nan",
            "r is nan, expected one of the rewards [-10.0, -0.02, 0.3333333333333333, 10.0]",
        ),
        ("r", "0.33", "r is 0.33, expected one of the rewards"),
        ("terminated", "2", "terminated is 2, expected a whole number from 0 to 1"),
        (
            "step",
            "2",
            "episode 1, step 2 stands where episode 1, step 1 is due: rows are missing or moved",
        ),
        ("episode", "1e300", "episode is 1e+300, expected a whole number from 0 on"),
    ],
)
def test_a_bad_row_is_named_with_its_line_even_though_the_checksum_is_wrong_too(
    saved, column, value, expected
):
    set_field(saved, 4, column, value)
    message = refusal(saved)
    assert message.startswith(
        f"{saved / 'transitions.csv'}, row 4 (line 6): {expected}"
    )
    assert message.endswith("put back the original file, or record again")


def test_an_episode_that_goes_on_after_its_end_is_refused(saved):
    set_field(saved, 4, "terminated", "1")
    assert (
        "row 5 (line 7): episode 1, step 2 stands where episode 2, step 0 is due"
        in refusal(saved)
    )


@pytest.mark.parametrize(
    "header",
    ["episode,step,s,a,r,s_next", "episode,step,s,a,reward,s_next,terminated", ""],
)
def test_a_wrong_or_missing_column_is_refused(saved, header):
    edit(saved / "transitions.csv", ",".join(NAMES), header)
    assert (
        f"line 1: the columns are {header!r}, expected 'episode,step,s,a,r,s_next,terminated'"
        in refusal(saved)
    )


@settings(deadline=None, suppress_health_check=list(HealthCheck))
@given(cut=st.floats(0, 1))
def test_a_recording_cut_off_anywhere_is_refused_and_nothing_changes(saved, cut):
    whole = (saved / "transitions.csv").read_bytes()
    part = whole[: int(cut * (len(whole) - 1))]
    (saved / "transitions.csv").write_bytes(part)
    message = refusal(saved)
    assert re.search(
        "cut off in the middle|has . rows, datapackage.json says 6|line 1: the col|no rows",
        message,
    )
    assert (saved / "transitions.csv").read_bytes() == part
    (saved / "transitions.csv").write_bytes(whole)


def test_a_row_cut_in_the_middle_and_missing_rows_are_told_apart(saved):
    whole = (saved / "transitions.csv").read_bytes()
    (saved / "transitions.csv").write_bytes(whole[:-4])
    assert "row 5 (line 7): the file is cut off in the middle of this row" in refusal(
        saved
    )
    (saved / "transitions.csv").write_bytes(
        b"".join(whole.splitlines(keepends=True)[:-2])
    )
    assert "it has 4 rows, datapackage.json says 6" in refusal(saved)


def test_good_rows_that_were_changed_are_refused_by_their_checksum(saved):
    recorded = rl.read_recording(saved)
    set_field(saved, 4, "s", str((recorded.s[4] + 1) % 6))
    message = refusal(saved)
    assert re.search(
        r"transitions.csv: its sha256 is [0-9a-f]{64}, datapackage.json says [0-9a-f]{64}",
        message,
    )


def test_bytes_that_are_no_text_are_refused(saved):
    (saved / "transitions.csv").write_bytes(b"\x80\x04\x95pickle\n")
    assert "line 1: the columns are" in refusal(saved)
    (saved / "datapackage.json").write_bytes(b"\x80\x04\x95pickle\n")
    assert "this is not JSON" in refusal(saved)


@pytest.mark.parametrize(
    ("spoil", "expected"),
    [
        (lambda p: p.pop("resources"), "the field resources is missing"),
        (lambda p: p["resources"].clear(), "the field resources.0.hash is missing"),
        (
            lambda p: p["resources"][0].pop("hash"),
            "the field resources.0.hash is missing",
        ),
        (lambda p: p.pop("rlrobot"), "the field rlrobot is missing"),
        (lambda p: p["rlrobot"].pop("rows"), "the field rlrobot.rows is missing"),
        (
            lambda p: p["rlrobot"].update(rows="6"),
            "the field rlrobot.rows must be of type int, found '6'",
        ),
        (lambda p: p["rlrobot"].pop("inputs"), "the field rlrobot.inputs is missing"),
        (
            lambda p: p["rlrobot"]["inputs"][0].pop("cuts"),
            "'laser_front': give exactly one of cuts, sectors and values",
        ),
        (
            lambda p: p["rlrobot"]["inputs"][0].pop("name"),
            "the field InputVariable.name is missing",
        ),
        (
            lambda p: p["rlrobot"].update(outputs=[]),
            "a task needs at least one output variable",
        ),
        (
            lambda p: p["rlrobot"].update(rewards=[]),
            "the rewards of a recording must be one or more finite numbers",
        ),
        (
            lambda p: p["rlrobot"].update(rewards=["high"]),
            "rlrobot.rewards must be a list of numbers",
        ),
    ],
)
def test_a_data_package_that_lacks_something_is_refused(saved, spoil, expected):
    package = json.loads((saved / "datapackage.json").read_text())
    spoil(package)
    (saved / "datapackage.json").write_text(json.dumps(package))
    message = refusal(saved)
    assert message.startswith(f"{saved / 'datapackage.json'}: ") and expected in message


def test_a_checksum_of_another_kind_is_refused(saved):
    edit(saved / "datapackage.json", "sha256:", "md5:")
    assert re.search(
        r"its sha256 is [0-9a-f]{64}, datapackage.json says md5:[0-9a-f]{64}",
        refusal(saved),
    )


def test_any_json_in_place_of_the_data_package_is_refused_in_one_sentence(saved):
    for text in (
        "",
        "[]",
        "3",
        "null",
        '{"resources": 3}',
        '{"resources": [[]]}',
        "[" * 100_000,
    ):
        (saved / "datapackage.json").write_text(text)
        assert refusal(saved).startswith(str(saved / "datapackage.json"))


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        (
            {"inputs": [TASK.inputs[0]]},
            "the list of inputs is ['laser_front', 'theta'] in the recording, ['laser_front']",
        ),
        (
            {
                "inputs": [
                    rl.InputVariable("laser_front", cuts=[0.3], unit="m"),
                    TASK.inputs[1],
                ]
            },
            "cuts of laser_front is (0.2,) in the recording, (0.3,) in the task",
        ),
        (
            {"rewards": [-10, 10]},
            "the set of rewards is [-10.0, -0.02, 0.3333333333333333, 10.0] in the recording",
        ),
        ({"step_time": 0.5}, "step_time is 1.0 in the recording, 0.5 in the task"),
    ],
)
def test_a_recording_of_another_task_is_refused_with_the_difference(
    saved, change, expected
):
    message = refusal(saved, task=replace(TASK, **change))
    assert "not a recording of task small" in message and expected in message


def test_numbers_of_another_type_are_no_difference(saved):
    source = rl.read_recording(saved, task=TASK).source
    whole = replace(source, step_time=1, rewards=list(source.rewards))
    assert whole.difference(TASK) == "" and hash(whole.rewards) == hash(source.rewards)


@pytest.mark.parametrize(
    "wrong",
    [{"step_time": "0.5"}, {"step_time": True}, {"step_time": np.inf}, {"seed": -3.5}],
)
def test_a_source_that_cannot_be_is_refused_with_its_name(saved, wrong):
    source = rl.read_recording(saved, task=TASK).source
    (name,) = wrong
    with pytest.raises(ValueError, match=f"the {name} of a recording must be"):
        replace(source, **wrong)


def test_a_toolkit_task_that_has_changed_since_is_told_and_the_recording_still_read(
    tmp_path,
):
    make_recording().save(tmp_path)
    edit(tmp_path / "datapackage.json", '"task": "small"', '"task": "wander_1k"')
    with pytest.warns(
        UserWarning, match="task wander_1k has changed since: the list of inputs is"
    ):
        assert rl.read_recording(tmp_path).task is None


# --- files as other programs leave them ---

LINE_ENDS = {"of Windows": "\r\n", "of an old Mac": "\r", "as written": "\n"}
ENCODINGS = {"utf-8": "utf-8", "with a byte order mark": "utf-8-sig"}


@pytest.mark.parametrize("ends", LINE_ENDS)
@pytest.mark.parametrize("encoding", ENCODINGS)
@pytest.mark.parametrize(
    "names",
    [
        ["transitions.csv"],
        ["datapackage.json"],
        ["transitions.csv", "datapackage.json"],
    ],
)
def test_line_ends_and_encodings_change_no_recording(saved, ends, encoding, names):
    before = rl.read_recording(saved)
    for name in names:
        text = (saved / name).read_bytes().decode()
        (saved / name).write_bytes(
            text.replace("\n", LINE_ENDS[ends]).encode(ENCODINGS[encoding])
        )
    np.testing.assert_equal(
        [*rl.read_recording(saved).transitions], [*before.transitions]
    )


SPREADSHEETS = {
    "semicolons": lambda text: text.replace(",", ";"),
    "semicolons and decimal commas": lambda text: text.replace(",", ";").replace(
        ".", ","
    ),
    "tabs": lambda text: text.replace(",", "\t"),
    "quotes": lambda text: re.sub(r"[^,\n]+", r'"\g<0>"', text),
    "a column of its own": lambda text: re.sub("^", "7,", text, flags=re.MULTILINE),
    "decimal commas": lambda text: re.sub(r"(\d)\.(\d)", r"\1,\2", text),
    "words for truth": lambda text: re.sub(
        ",([01])$", lambda m: ",TRUE" if m[1] == "1" else ",FALSE", text, flags=re.M
    ),
    "powers of ten": lambda text: text.replace("-0.02", "-2.00E-02").replace(
        "10.0", "1.00E+01"
    ),
    "integers": lambda text: text.replace(".0,", ","),
    "another encoding": lambda text: text.encode("utf-16").decode(
        "utf-8", errors="replace"
    ),
}


@pytest.mark.parametrize("habit", SPREADSHEETS)
def test_what_a_spreadsheet_made_of_a_recording_is_refused_with_that_cause(
    saved, habit
):
    text = (saved / "transitions.csv").read_text()
    changed = SPREADSHEETS[habit](text)
    assert changed != text
    (saved / "transitions.csv").write_text(changed)
    assert "spreadsheet" in refusal(saved)


def test_a_bad_line_takes_time_in_proportion_to_its_length():
    def seconds(n):
        begin = time.process_time()
        for line in (
            "1" * n + "x",
            "1," * (n // 2) + "x",
            "1." + "1" * n + "x",
            "1e" + "1" * n + "x",
        ):
            assert not ROW.fullmatch(line)
        return time.process_time() - begin

    assert seconds(200_000) < 5  # quadratic, it would be half an hour


def test_version_control_of_windows_changes_no_file(tmp_path):
    root = Path(__file__).parents[2]
    git = shutil.which("git")
    if git is None or not (root / ".git").exists():
        pytest.skip("git or the history is not here")
    clone = [
        "clone",
        "-q",
        "--no-checkout",
        "--shared",
        "-c",
        "core.autocrlf=true",
        str(root),
        str(tmp_path / "clone"),
    ]
    for command in (clone, ["-C", str(tmp_path / "clone"), "checkout", "-q", "HEAD"]):
        if (
            done := subprocess.run([git, *command], capture_output=True, text=True)
        ).returncode:
            pytest.skip(f"git cannot copy this history: {done.stderr}")
    listed = subprocess.run(
        [git, "-C", str(tmp_path / "clone"), "ls-files", "--eol"],
        capture_output=True,
        text=True,
    )
    kinds = [line.split()[:2] for line in listed.stdout.splitlines()]
    assert len(kinds) > 500 and not [
        pair for pair in kinds if pair[0][2:] != pair[1][2:]
    ]
    for folder in (tmp_path / "clone" / "datasets").iterdir():
        if folder.is_dir():
            assert len(rl.Recording.load(folder)) > 0


# --- writing whole or not at all ---


def test_a_write_that_fails_leaves_the_old_files_and_nothing_else(saved, monkeypatch):
    before = {path.name: path.read_bytes() for path in saved.iterdir()}

    for results in (
        [OSError("disk full")],
        [None, OSError("disk full")],
    ):  # at the first file, at the second
        monkeypatch.setattr(os, "fsync", Mock(side_effect=results))
        with pytest.raises(OSError, match="disk full"):
            make_recording(9).save(saved)
        assert {path.name: path.read_bytes() for path in saved.iterdir()} == before


def test_a_pair_written_by_half_is_refused(saved, monkeypatch):
    def stop_at_the_package(part, path, rename=os.replace):
        if Path(path).name == "datapackage.json":
            raise KeyboardInterrupt
        rename(part, path)

    monkeypatch.setattr(os, "replace", stop_at_the_package)
    with pytest.raises(KeyboardInterrupt):
        make_recording(9).save(saved)
    assert "it has 9 rows, datapackage.json says 6" in refusal(saved)


def test_files_are_written_as_they_are_and_folders_are_made(tmp_path):
    write_whole(tmp_path / "new" / "text", "λ\n")
    write_together({tmp_path / "text": "a\r\n", tmp_path / "bytes": b"\x00"})
    assert (tmp_path / "new" / "text").read_bytes() == "λ\n".encode()
    assert (tmp_path / "text").read_bytes() == b"a\r\n" and (
        tmp_path / "bytes"
    ).read_bytes() == b"\x00"
    with pytest.raises(TypeError):
        write_whole(tmp_path / "text", None)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["bytes", "new", "text"]


ENDINGS = {".npz", ".gif", ".png", ".html", ".json", ".csv", ".mp4"}
WRITERS = {
    ".npz": lambda path: rl.Agent("wander_simple").save(path),
    ".html": lambda path: write_whole(path, "<!DOCTYPE html>"),
    ".json": lambda path: write_whole(path, "{}"),
    ".gif": lambda path: write_whole(path, b"GIF89a"),
}


@pytest.mark.parametrize("kind", WRITERS)
@pytest.mark.parametrize("ending", sorted(ENDINGS))
def test_a_file_never_has_the_ending_of_another_kind(tmp_path, kind, ending):
    path = tmp_path / f"it{ending}"
    if ending == kind or {kind, ending} == {
        ".json",
        ".csv",
    }:  # JSON in a .csv is text in a .csv
        WRITERS[kind](path)
        assert path.is_file()
    else:
        with pytest.raises(
            ValueError, match=rf"its content is no \{ending} but \{kind}"
        ):
            WRITERS[kind](path)
        assert not path.exists()


@pytest.mark.parametrize("ending", sorted(ENDINGS))
def test_a_recording_is_no_file(tmp_path, ending):
    with pytest.raises(ValueError, match="a recording is a folder"):
        make_recording().save(tmp_path / f"mine{ending}")
    assert not any(tmp_path.iterdir())


def test_a_film_is_not_saved_as_what_its_name_does_not_say(tmp_path):
    film = rl.film(
        rl.Agent("wander_simple", seed=0), rl.make_env("wander_simple", seed=0), steps=2
    )
    film.save(tmp_path / "film.gif")
    assert (tmp_path / "film.gif").read_bytes() == film.gif()
    for ending in ("png", "html", "npz", "csv"):
        with pytest.raises(ValueError, match=rf"no \.{ending} but \.gif"):
            film.save(tmp_path / f"other.{ending}")


# --- the paper's own format ---


def fortran(recording, order):
    """The rows (s, a, s', r) of a recording in the paper's numbering, with the inputs in another order."""
    states = recording.source.states
    shape = [states.shape[i] for i in order]

    def renumber(numbers):
        bins = np.unravel_index(numbers, states.shape)
        return np.ravel_multi_index([bins[i] for i in order], shape, order="F")

    actions = np.unravel_index(recording.a, recording.source.actions.shape)
    a = np.ravel_multi_index(actions, recording.source.actions.shape, order="F")
    return np.column_stack(
        [renumber(recording.s), a, renumber(recording.s_next), recording.r]
    ).astype(float)


@pytest.mark.parametrize(
    ("inputs", "order"), [(None, [0, 1]), (["theta", "laser_front"], [1, 0])]
)
def test_the_papers_numbers_become_the_tasks(tmp_path, inputs, order):
    recording = make_recording(200)
    np.save(tmp_path / "old.npy", fortran(recording, order))
    back = rl.read_recording(
        tmp_path / "old.npy", legacy=True, task=TASK, inputs=inputs
    )
    assert all(
        np.array_equal(getattr(back, name), getattr(recording, name))
        for name in ("s", "a", "r", "s_next")
    )
    joins = back.s[1:] == back.s_next[:-1]
    assert np.array_equal(np.diff(back.episode), ~joins) and not back.terminated.any()


@pytest.mark.parametrize(
    ("row", "column", "value", "expected"),
    [
        (3, 0, 6, "row 3: s is 6, expected a whole number from 0 to 5"),
        (3, 1, 0.5, "row 3: a is 0.5, expected a whole number from 0 to 5"),
        (3, 2, np.nan, "row 3: s_next is nan, expected a whole number from 0 to 5"),
        (
            3,
            3,
            np.nan,
            "row 3: r is nan, expected one of the rewards [-10.0, -0.02, 0.3333333333333333, 10.0]",
        ),
    ],
)
def test_a_bad_row_of_the_papers_format_is_named(
    tmp_path, row, column, value, expected
):
    table = fortran(make_recording(), [0, 1])
    table[row, column] = value
    np.save(tmp_path / "old.npy", table)
    message = refusal(tmp_path / "old.npy", legacy=True, task=TASK)
    assert message.startswith(f"{tmp_path / 'old.npy'}, {expected}")


@pytest.mark.parametrize(
    "table",
    [np.zeros((3, 5)), np.zeros(4), np.zeros((3, 4), complex), np.zeros((0, 4))],
)
def test_an_array_of_another_kind_is_refused(tmp_path, table):
    np.save(tmp_path / "old.npy", table)
    message = refusal(tmp_path / "old.npy", legacy=True, task=TASK)
    assert (
        "expected one array of numbers with 4 columns (s, a, s', r)" in message
        or "no rows" in message
    )


def test_a_damaged_file_and_a_pickle_are_refused_and_not_unpickled(tmp_path):
    path = tmp_path / "old.npy"
    np.save(path, fortran(make_recording(), [0, 1]))
    whole = path.read_bytes()
    for n in (0, 5, 40, len(whole) - 8):
        path.write_bytes(whole[:n])
        assert "not a whole NumPy array file" in refusal(path, legacy=True, task=TASK)
    np.save(path, np.array([[print, 1, 2, 3]], dtype=object), allow_pickle=True)
    assert "not a whole NumPy array file" in refusal(path, legacy=True, task=TASK)
    np.savez(tmp_path / "old.npz", np.zeros((3, 4)))
    assert "several arrays" in refusal(tmp_path / "old.npz", legacy=True, task=TASK)


def test_the_papers_format_needs_its_task_and_inputs(tmp_path):
    np.save(tmp_path / "old.npy", fortran(make_recording(), [0, 1]))
    assert "give task=" in refusal(tmp_path / "old.npy", legacy=True)
    message = refusal(
        tmp_path / "old.npy", legacy=True, task=TASK, inputs=["theta", "laser_rear"]
    )
    assert (
        "inputs must be the task's in some order, ['laser_front', 'theta']" in message
    )
    many = refusal(tmp_path / "old.npy", legacy=True, task=TASK, inputs=["x"] * 1000)
    assert "inputs must be the task's in some order" in many and len(many) < 800
    assert "there is no such file" in refusal(
        tmp_path / "no.npy", FileNotFoundError, legacy=True, task=TASK
    )
    assert "inputs= is for legacy=True" in refusal(tmp_path, inputs=["theta"])


def test_the_papers_own_recording_has_the_known_facts(vrep):
    assert len(vrep) == 18_000 and vrep.s[0] == 1023
    assert len(np.unique(vrep.s)) == 298
    assert len(set(zip(vrep.s, vrep.a, strict=True))) == 1691
    assert len(set(zip(vrep.s, vrep.a, vrep.s_next, strict=True))) == 4294
    assert Counter(vrep.r.tolist()) == {-2.0: 1555, -0.02: 10048, 10.0: 6397}
    assert vrep.r.mean() == pytest.approx(3.36995, abs=5e-6)
    assert (vrep.episode == 0).all() and np.array_equal(vrep.s[1:], vrep.s_next[:-1])


def test_in_the_papers_own_recording_each_collision_shows_on_a_front_laser(vrep):
    front = ("laser_front", "laser_front_left", "laser_front_right")
    for s in np.unique(vrep.s_next[vrep.r == -2]):
        bins = vrep.task.states.decode(int(s))
        assert min(bins[laser].index for laser in front) == 0


def test_in_the_papers_own_recording_turning_right_lowers_the_left_laser(vrep):
    def mean_change(left, right):
        speeds, actions = {"left_wheel": left, "right_wheel": right}, vrep.task.actions
        rows = vrep.a == next(
            a for a in range(actions.n) if actions.decode(a) == speeds
        )
        shape = vrep.task.states.shape
        bins, bins_next = (
            np.unravel_index(s[rows], shape)[2] for s in (vrep.s, vrep.s_next)
        )
        return (bins_next - bins).mean()

    assert mean_change(1, -1) < 0 < mean_change(-1, 1)


def test_the_papers_own_recording_reads_back_from_our_format(vrep, tmp_path):
    vrep.save(tmp_path)
    back = rl.read_recording(tmp_path)
    assert same(vrep, back) and back.task.name == "wander_1k"


# --- rows of one's own ---

SQUARE = rl.load_task("wander_simple")
DRIVE = [
    {"s": 3, "a": 3, "r": 10, "s_next": 3},
    {"s": 3, "a": 3, "r": 10, "s_next": 2},
    {"s": 2, "a": 1, "r": -0.02, "s_next": 3},
]  # forward, forward, turn left: by numbers
READ = [
    {"laser_front_left": 1.2, "laser_front_right": 0.85, "left_wheel": 1, "right_wheel": 1, "r": 10},
    {"laser_front_left": 1.1, "laser_front_right": 0.75, "left_wheel": 1, "right_wheel": 1, "r": 10},
    {"laser_front_left": 1.0, "laser_front_right": 0.18, "left_wheel": -1, "right_wheel": 1, "r": -0.02},
    {"laser_front_left": 1.0, "laser_front_right": 0.31},
]  # fmt: skip
COLUMNS = {name: [row[name] for row in DRIVE] for name in DRIVE[0]}
TUPLES = [(3, 3, 10, 3), (3, 3, 10, 2), (2, 1, -0.02, 3)]


class Frame:
    """What a data frame of pandas or Polars has in common: the names of its columns, and each by its name."""

    def __init__(self, columns):
        self.columns = list(columns)
        self._cells = columns

    def __getitem__(self, name):
        return np.array(self._cells[name])

    def __iter__(self):
        return iter(self.columns)


SAME = {
    "dicts": DRIVE,
    "dicts of texts": [{k: str(v) for k, v in row.items()} for row in DRIVE],
    "tuples": TUPLES,
    "lists": [list(row) for row in TUPLES],
    "a generator": (row for row in TUPLES),
    "an array": np.array(TUPLES),
    "an array of texts": np.array(TUPLES).astype(str),
    "a structured array": np.array(
        TUPLES, dtype=[("s", int), ("a", "i2"), ("r", float), ("s_next", float)]
    ),
    "columns": COLUMNS,
    "a data frame": Frame(COLUMNS),
    "with flags": [(*row, False, np.False_) for row in TUPLES],
    "one row a step": [*((s, a, r) for s, a, r, _ in TUPLES), (3, None, None)],
    "steps in an array": np.array(
        [[3, 3, 10], [3, 3, 10], [2, 1, -0.02], [3, np.nan, np.nan]]
    ),
    "readings": READ,
    "readings before and after": [
        before | {f"{n}_next": after[n] for n in after if n.startswith("laser")}
        for before, after in pairwise(READ)
    ],
}


@pytest.mark.parametrize("kind", SAME)
def test_rows_of_each_kind_make_the_same_recording(kind):
    recording = rl.Recording.from_rows(SAME[kind], "wander_simple")
    expected = rl.Recording(
        Transitions(
            [3, 3, 2],
            [3, 3, 1],
            [10, 10, -0.02],
            [3, 2, 3],
            np.zeros(3, bool),
            np.zeros(3, bool),
        ),
        Source.of_task(SQUARE),
        SQUARE,
    )
    np.testing.assert_equal([*recording.transitions], [*expected.transitions])
    assert recording.source == expected.source and recording.task is SQUARE


def test_data_frames_of_pandas_are_rows():
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(DRIVE)
    assert rl.Recording.from_rows(frame, SQUARE).s_next.tolist() == [3, 2, 3]


@settings(deadline=None, max_examples=40, suppress_health_check=list(HealthCheck))
@given(
    n=st.integers(1, 30),
    ends=st.sets(st.integers(0, 29)),
    seed=st.integers(0, 99),
    separator=st.sampled_from([",", ";", "\t"]),
    ending=st.sampled_from(["\n", "\r\n"]),
    blank=st.sampled_from(["", "\n", "\n\n", "{s}{s}{s}{s}{s}{s}\n"]),
    is_quoted=st.booleans(),
)
def test_the_rows_of_any_recording_read_back_from_any_spreadsheet(
    tmp_path, n, ends, seed, separator, ending, blank, is_quoted
):
    recording = make_recording(n, ends, seed)
    recording.save(tmp_path)
    text = (tmp_path / "transitions.csv").read_text()
    if is_quoted:
        text = re.sub(r"[^,\n]+", r'"\g<0>"', text)
    text = text.replace(",", separator)
    if separator != ",":
        text = text.replace(".", ",")
    text += blank.replace("{s}", separator)
    path = tmp_path / "mine.csv"
    path.write_text(text, encoding="utf-8-sig", newline=ending)
    back = rl.read_recording(path, task=TASK)
    np.testing.assert_equal([*back.transitions], [*recording.transitions])
    assert same(back, recording)


@settings(deadline=None, max_examples=60, suppress_health_check=list(HealthCheck))
@given(
    rows=st.lists(
        st.tuples(
            st.integers(0, 3),
            st.integers(0, 3),
            st.sampled_from(SQUARE.rewards),
            st.sampled_from([(0, 0), (1, 0), (0, 1)]),
        ),
        min_size=1,
        max_size=20,
    ),
    last=st.integers(0, 3),
)
def test_rows_of_steps_are_the_transitions_between_them(rows, last):
    steps = []
    pairs = []
    for number, (s, a, r, flags) in enumerate(rows):
        ends = any(flags) or number == len(rows) - 1
        s_next = last if ends else rows[number + 1][0]
        steps.append((s, a, r, None, *flags))
        if ends:
            steps.append((s_next, "", None, None, "", 0))
        pairs.append((s, a, r, s_next, *flags))
    names = ("s", "a", "r", "terminated", "truncated")
    dicts = [dict(zip(names, row[:3] + row[4:], strict=True)) for row in steps]
    recording = rl.Recording.from_rows(dicts, SQUARE)
    expected = Transitions.of_rows(pairs)
    np.testing.assert_equal([*recording.transitions], [*expected])


def test_episodes_end_where_the_rows_say_so_or_do_not_join():
    def ends(rows):
        return rl.Recording.from_rows(rows, SQUARE).episode.tolist()

    apart = [(3, 3, 10, 3), (2, 1, -0.02, 3), (3, 3, 10, 3)]
    assert ends(apart) == [0, 1, 1]
    named = [dict(zip(DRIVE[0], row, strict=True)) for row in apart]
    days = [row | {"episode": day} for row, day in zip(named, (4, 4, 7), strict=True)]
    assert ends(days) == [0, 0, 1]
    assert ends([(3, 3, 10, 3, 1), (3, 3, 10, 3, 0), (3, 3, 10, 3, 0)]) == [0, 1, 1]


def refused_rows(rows, task="wander_simple"):
    """The one sentence with which rows are refused."""
    with pytest.raises(ValueError) as caught:
        rl.Recording.from_rows(rows, task)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def changed_row(number, rows=DRIVE, **cells):
    """The rows with other cells in one of them."""
    return [row | cells if i == number else row for i, row in enumerate(rows)]


@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        ("mine.csv", "an array or a data frame, got 'mine.csv'; a file is read by rl.read_recording(path, task=…)"),
        (Path("mine.csv"), "a file is read by rl.read_recording"),
        (None, "rows must be a list"),
        (3, "rows must be a list"),
        ({"s": 3, "a": 3, "r": 10, "s_next": 3}, "rows must be a list"),
        ([], "rows: there are none, expected one or more"),
        ({}, "rows: there are none"),
        (np.zeros((0, 4)), "rows: there are none"),
        ({name: [] for name in COLUMNS}, "rows: there are no rows, expected one or more"),
        ([3, 3],
         "is 3, expected a dict or 3 to 6 values (s, a, r, s_next, terminated, truncated), as many in each row"),
        (np.zeros(4), "row 0 (counted from 0) is np.float64(0.0), expected a dict"),
        ([*TUPLES, (3, 3, 10)], "row 3 (counted from 0) is (3, 3, 10), expected a dict or 3 to 6 values"),
        ([*TUPLES, DRIVE[0]], "row 3 (counted from 0) is {'s': 3, "),
        ([(3, 3)], "row 0 (counted from 0) is (3, 3), expected a dict or 3 to 6 values"),
        (COLUMNS | {"a": [3]}, "rows: columns must be of one length, got {'s': 3, 'a': 1"),
        ([{"s": 3, "a": 3, "reward": 10}],
         "rows: there is no column r, only 's, a, reward'; expected are the state (s, or laser_front_left, "
         "laser_front_right), the action (a, or left_wheel, right_wheel) and the reward (r)"),
        ([{"state": 3}], "rows: there is no column s, only 'state'"),
        (changed_row(1, done=1),
         "rows: there is no use for column 'done'. Leave it out, or rename it to one of s, a, r, s_next, "
         "episode, step, terminated, truncated"),
        (changed_row(1, terminatd=1),
         "there is no use for column 'terminatd'; did you mean 'terminated'? Leave it out"),
        (changed_row(1, s=4),
         "row 1 (counted from 0): s is 4, expected a whole number from 0 to 3; correct it, or is it a row of "
         "another task than wander_simple?"),
        (changed_row(1, a=0.5), "row 1 (counted from 0): a is 0.5, expected a whole number from 0 to 3"),
        (changed_row(1, s_next=math.inf), "row 1 (counted from 0): s_next is inf, expected a whole number from 0 to 3"),
        (changed_row(1, r=5),
         "row 1 (counted from 0): r is 5, expected one of the rewards [-10.0, -2.0, -0.02, 10.0]; correct it"),
        (changed_row(1, terminated=2), "row 1 (counted from 0): terminated is 2, expected a whole number from 0 to 1"),
        (changed_row(1, a="left"), "row 1 (counted from 0): a is 'left', expected a number; correct it"),
        (changed_row(1, a=1j), "row 1 (counted from 0): a is 1j, expected a number"),
        (changed_row(1, a=np.complex128(1)), "row 1 (counted from 0): a is np.complex128(1+0j), expected a number"),
        (changed_row(1, a=[1]), "row 1 (counted from 0): a is [1], expected a number"),
        (changed_row(1, a=10**400), "row 1 (counted from 0): a is 1000"),
        (changed_row(1, s=None), "row 1 (counted from 0): s is empty, expected a number; fill it in"),
        (changed_row(1, episode=2), "row 0 (counted from 0): episode is empty"),
        ([row | {"step": 1} for row in DRIVE],
         "row 0 (counted from 0): step is 1, expected 0; put missing or moved rows back, or leave out the "
         "column step"),
        (changed_row(1, READ, laser_front_left=7),
         "row 1 (counted from 0), column laser_front_left: input 'laser_front_left': reading 7 is outside 0 "
         "to 5 m; check the sensor"),
        (changed_row(1, READ, left_wheel=0.5),
         "row 1 (counted from 0): left_wheel is 0.5, expected one of [-1.0, 1.0] rad/s; correct it"),
        (changed_row(1, READ, left_wheel=None), "row 1 (counted from 0): left_wheel is empty"),
        (READ[:3],
         "row 2 (counted from 0): the state after this step is missing, expected in the next row; add a row "
         "with this state, its action and reward empty"),
        (changed_row(1, READ, terminated=1), "row 1 (counted from 0): the state after this step is missing"),
        (changed_row(3, READ, terminated=1),
         "row 3 (counted from 0): without action and reward it is no step, so it cannot end the episode; mark "
         "the row before it"),
        ([row | {"episode": i // 2} for i, row in enumerate(READ)],
         "row 1 (counted from 0): the state after this step is missing"),
        ([(3, None, None)], "rows: all actions and rewards are empty; fill them in"),
    ],
)  # fmt: skip
def test_what_is_wrong_in_rows_is_said_in_one_sentence(rows, expected):
    assert expected in refused_rows(rows)


def test_rows_of_an_unknown_task_are_refused():
    assert "did you mean 'wander_simple'?" in refused_rows(DRIVE, "wander_simpel")


SHEET = "s,a,r,s_next\n3,3,10,3\n3,3,10,2\n2,1,-0.02,3\n"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "mine.csv: it is empty, expected names of columns and rows"),
        ("\n\n", "mine.csv: it is empty"),
        ("s,a,r,s_next\n", "mine.csv, line 1: there are no rows, expected one or more"),
        (SHEET.split("\n", 1)[1], "line 1: '3' stands twice, expected a name of its own for each column"),
        (SHEET.replace("r,", "a,"), "mine.csv, line 1: 'a' stands twice, expected a name"),
        (SHEET.replace("0.02", "0,02"),
         "mine.csv, line 4: 5 cells, expected 4 as in line 1; with decimal commas, columns are separated by "
         "semicolons"),
        (SHEET.replace("2,1", "\n2,1"), "mine.csv, line 4: s is empty, expected a number; fill it in"),
        (SHEET.replace("2,1", "2,left"), "mine.csv, line 4: a is 'left', expected a number; correct it"),
        (SHEET.replace("2,1", '"2,1'), "mine.csv, line 4: s is '2,1,-0.02,3\\n', expected a number"),
        (SHEET.replace("2,1", "2,4"), "mine.csv, line 4: a is 4, expected a whole number from 0 to 3"),
        (SHEET.replace("-0.02,3", "-0.02"), "mine.csv, line 4: s_next is empty"),
        (SHEET + "1" * 200_000, "mine.csv, line 5: field larger than field limit (131072); save it as CSV again"),
        ("PK\x03\x04\x00\x00", "mine.csv, line 1: there is no column s"),
    ],
)  # fmt: skip
def test_what_is_wrong_in_a_spreadsheet_is_said_with_its_line(tmp_path, text, expected):
    path = tmp_path / "mine.csv"
    path.write_text(text)
    assert expected in refusal(path, task="wander_simple")


def test_a_lone_csv_file_is_read_with_its_task_and_columns_without_a_name_are_left_out(
    tmp_path, saved
):
    path = tmp_path / "Mine.CSV"
    path.write_text(SHEET.replace("s,", ",s,").replace("\n", "\n7,").rstrip("7,"))
    assert rl.read_recording(path, task="wander_simple").a.tolist() == [3, 3, 1]
    assert refusal(path) == (
        f"{path}: a CSV file alone does not say of which task its rows are; give task="
    )
    missing = tmp_path / "no.csv"
    assert "there is no such file" in refusal(missing, FileNotFoundError, task=TASK)
    recording = rl.read_recording(saved)
    (saved / "datapackage.json").unlink()
    assert "with task=" in refusal(saved, FileNotFoundError)
    alone = rl.read_recording(saved / "transitions.csv", task=TASK)
    assert same(alone, recording)


def test_two_columns_of_the_same_name_are_refused_however_they_are_given():
    columns = {"s": [0], "a": [0], "r": [10], "s_next": [0], 1: [0], "1": [1]}
    row = {name: cells[0] for name, cells in columns.items()}

    class Frame:  # as a data frame with a name that stands twice
        columns = ("s", "a", "r", "s")

        def __getitem__(self, name):
            return [0]

    for rows, name in ((columns, "1"), ([row], "1"), (Frame(), "s")):
        with pytest.raises(ValueError, match=f"rows: '{name}' stands twice"):
            rl.Recording.from_rows(rows, "wander_simple")
