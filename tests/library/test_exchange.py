"""Recordings to and from Minari: the same numbers come back, others' files are understood or refused."""

import json
import sys
import warnings
from pathlib import Path

import gymnasium
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from test_recording import TASK, make_recording

import rlrobot_edu as rl

ID = "small/random-v0"
few = settings(max_examples=15, deadline=None, suppress_health_check=list(HealthCheck))


@pytest.fixture
def minari():
    pytest.importorskip(
        "h5py", reason="Minari's datasets need h5py: pip install 'minari[hdf5]'"
    )
    return pytest.importorskip(
        "minari", reason="Minari is missing: pip install 'minari[hdf5]'"
    )


def one_after_the_other(
    n: int, ends: list[int], seed: int = 0, cut: bool = False
) -> rl.Recording:
    """A random recording of TASK in which each step begins where the one before has ended, except after `ends`."""
    rng = np.random.default_rng(seed)
    s, s_next = rng.integers(6, size=(2, n))
    ended = np.isin(np.arange(n), ends)
    s[1:][~ended[:-1]] = s_next[:-1][~ended[:-1]]
    terminated = ended & (rng.random(n) < 0.5)
    truncated = ended & ~terminated
    truncated[-1] |= cut and not terminated[-1]
    return make_recording(
        n, seed=seed, s=s, s_next=s_next, terminated=terminated, truncated=truncated
    )


def assert_same(one: rl.Recording, two: rl.Recording) -> None:
    assert one.source == two.source
    for a, b in zip(
        (*one.transitions, one.episode), (*two.transitions, two.episode), strict=True
    ):
        assert np.array_equal(a, b) and a.dtype == b.dtype


def foreign(
    minari,
    root: Path,
    monkeypatch,
    observations,
    actions,
    rewards,
    spaces,
    ends=True,
    **named,
):
    """A dataset that another program wrote: one episode a list of rewards."""
    monkeypatch.setenv("MINARI_DATASETS_PATH", str(root))
    buffers = [
        minari.data_collector.EpisodeBuffer(
            observations=np.array(o), actions=np.array(a), rewards=r,
            terminations=[False] * len(r), truncations=[False] * (len(r) - 1) + [ends],
        )
        for o, a, r in zip(observations, actions, rewards, strict=True)
    ]  # fmt: skip
    space = dict(zip(("observation_space", "action_space"), spaces, strict=True))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # Minari misses author and licence
        minari.create_dataset_from_buffers(
            ID, buffers, data_format="hdf5", **space, **named
        )


def about(root: Path) -> Path:
    return root / ID / "data" / "metadata.json"


@few
@given(
    st.integers(1, 40), st.lists(st.integers(0, 39)), st.integers(0, 99), st.booleans()
)
def test_what_comes_back_from_minari_is_what_was_written(
    minari, tmp_path, n, ends, seed, cut
):
    recording = one_after_the_other(n, ends, seed, cut)
    recording.to_minari(ID, tmp_path)
    assert_same(rl.Recording.from_minari(ID, tmp_path), recording)
    assert rl.Recording.from_minari(ID, tmp_path, TASK).task is TASK


def test_a_recording_of_the_toolkit_is_written_the_same_each_time_and_finds_its_task_and_world(
    minari, tmp_path
):
    recording = rl.read_recording("wander_1k")
    written = []
    for root in (tmp_path / "1", tmp_path / "2"):
        recording.to_minari("wander_1k/tosl-v0", root)
        written.append(
            [
                file.read_bytes()
                for file in sorted((root / "wander_1k/tosl-v0/data").iterdir())
            ]
        )
    assert written[0] == written[1] and len(written[0]) == 2
    again = rl.Recording.from_minari("wander_1k/tosl-v0", root)
    assert_same(again, recording)
    assert again.task is not None
    with pytest.raises(ValueError, match="not a recording of task arm_1k"):
        rl.Recording.from_minari("wander_1k/tosl-v0", root, "arm_1k")


def test_minari_itself_finds_episodes_bins_and_the_environment(
    minari, tmp_path, monkeypatch
):
    monkeypatch.setenv("MINARI_DATASETS_PATH", str(tmp_path))
    recording = rl.read_recording("navigation_1k")
    recording.to_minari("navigation_1k/q-v0")  # None is Minari's own place
    dataset = minari.load_dataset("navigation_1k/q-v0")
    assert (
        dataset.total_steps == len(recording)
        and dataset.total_episodes == recording.episode[-1] + 1
    )
    assert dataset.recover_environment().unwrapped.task.name == "navigation_1k"
    rows = recording.episode == 3
    episode = dataset[3]
    assert len(episode.observations) == rows.sum() + 1
    states = [recording.source.states.number(bins) for bins in episode.observations]
    assert states == [*recording.s[rows], recording.s_next[rows][-1]]
    assert np.array_equal(episode.actions, recording.a[rows]) and np.array_equal(
        episode.rewards, recording.r[rows]
    )
    assert_same(rl.Recording.from_minari("navigation_1k/q-v0"), recording)


def test_an_episode_longer_than_what_minaris_arrow_keeps_is_not_cut(minari, tmp_path):
    recording = one_after_the_other(33_000, [])
    recording.to_minari(ID, tmp_path)
    assert_same(rl.Recording.from_minari(ID, tmp_path), recording)


def test_steps_that_do_not_follow_each_other_are_no_minari_episode(minari, tmp_path):
    with pytest.raises(
        ValueError,
        match=r"row 1 of the recording begins in state 1, the row before ended in state 2",
    ):
        make_recording(2, s=[0, 1], s_next=[2, 3]).to_minari(ID, tmp_path)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "name", ["no_version", "a b-v0", "../up-v0", "/tmp/x-v0", "", 5]
)
def test_a_name_that_minari_does_not_take_is_refused(minari, tmp_path, name):
    for use in (
        lambda: make_recording(1).to_minari(name, tmp_path),
        lambda: rl.Recording.from_minari(name, tmp_path),
    ):
        with pytest.raises(ValueError, match="a Minari dataset's name is letters"):
            use()


def test_another_programs_dataset_is_read_with_its_task_or_by_itself(
    minari, tmp_path, monkeypatch
):
    spaces = gymnasium.spaces.MultiDiscrete([2, 3]), gymnasium.spaces.Discrete(6)
    bins = [[(0, 1), (1, 2), (1, 0)], [(0, 0), (0, 1)]]
    foreign(
        minari,
        tmp_path,
        monkeypatch,
        bins,
        [[5, 0], [3]],
        [[10, -10], [-0.02]],
        spaces,
        algorithm_name="theirs",
    )
    for task, name in ((TASK, "small"), (None, ID)):
        recording = rl.Recording.from_minari(ID, tmp_path, task)
        assert (
            recording.source.task_name == name
            and recording.source.method == "theirs"
            and recording.task is task
        )
        assert recording.s.tolist() == [1, 5, 0] and recording.s_next.tolist() == [
            5,
            3,
            1,
        ]
        assert recording.a.tolist() == [5, 0, 3] and recording.r.tolist() == [
            10,
            -10,
            -0.02,
        ]
        assert recording.truncated.tolist() == [
            False,
            True,
            True,
        ] and recording.episode.tolist() == [0, 0, 1]
    assert recording.source.rewards == (-10, -0.02, 10)
    with pytest.raises(
        ValueError,
        match=r"its bins are \(2, 3\), its actions 6; task wander_simple has",
    ):
        rl.Recording.from_minari(ID, tmp_path, "wander_simple")


def test_another_programs_grid_world_becomes_a_sample_model(
    minari, tmp_path, monkeypatch
):
    env = gymnasium.make("FrozenLake-v1")
    spaces = env.observation_space, env.action_space
    foreign(
        minari, tmp_path, monkeypatch, [[0, 4, 8], [0, 1]], [[1, 1], [2]], [[0, 0], [0]], spaces,
        ends=False, env="FrozenLake-v1",
    )  # fmt: skip
    recording = rl.Recording.from_minari(ID, tmp_path)
    assert (
        recording.source.task_name == "FrozenLake-v1"
        and recording.source.time_limit == 100
    )
    assert recording.s_next.tolist() == [4, 8, 1] and recording.episode.tolist() == [
        0,
        0,
        1,
    ]
    assert rl.SampleModel.from_recording(recording).n_states == 16


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"data_format": "arrow"}, "data_format is 'arrow', expected 'hdf5'"),
        (
            {"observation_space": json.dumps({"type": "Discrete", "n": 6, "start": 0})},
            "this is not a whole",
        ),
        (
            {
                "observation_space": json.dumps(
                    {"type": "Box", "dtype": "f8", "shape": [], "low": 0, "high": 1}
                )
            },
            "need",
        ),
        ({"action_space": None}, "this is not a whole"),
        ({"rlrobot_edu": {}}, "the field resources is missing"),
        ({"rlrobot_edu": 5}, "the field resources is missing"),
    ],
)
def test_metadata_that_cannot_be_are_refused_in_one_sentence(
    minari, tmp_path, change, said
):
    one_after_the_other(9, [4]).to_minari(ID, tmp_path)
    about(tmp_path).write_text(
        json.dumps(json.loads(about(tmp_path).read_text()) | change)
    )
    with pytest.raises(ValueError, match=said) as refused:
        rl.Recording.from_minari(ID, tmp_path)
    assert (
        str(tmp_path) in str(refused.value)
        and len(str(refused.value).splitlines()) == 1
    )


def test_rows_that_were_changed_or_cut_off_are_refused(minari, tmp_path):
    import h5py

    one_after_the_other(9, [4]).to_minari(ID, tmp_path)
    rows = about(tmp_path).with_name("main_data.hdf5")
    with h5py.File(rows, "a") as file:
        a = file["episode_1/actions"]
        a[0] = (a[0] + 1) % 6
    with pytest.raises(
        ValueError, match="its rows are not the ones that its data package describes"
    ):
        rl.Recording.from_minari(ID, tmp_path)
    with h5py.File(rows, "a") as file:
        del file["episode_1/rewards"]
        # a small file all the same
        file.create_dataset(
            "episode_1/rewards", shape=(10**12,), dtype="f8", chunks=(1000,)
        )
    with pytest.raises(ValueError, match="it claims to hold more than 256 MB"):
        rl.Recording.from_minari(ID, tmp_path)
    rows.write_bytes(rows.read_bytes()[:1000])
    with pytest.raises(ValueError, match="this is not a whole Minari dataset"):
        rl.Recording.from_minari(ID, tmp_path)
    with pytest.raises(
        FileNotFoundError,
        match="there is no Minari dataset 'other-v0'; nothing is downloaded",
    ):
        rl.Recording.from_minari("other-v0", tmp_path)


def test_no_code_that_a_dataset_names_is_run(minari, tmp_path, monkeypatch):
    (tmp_path / "trap.py").write_text("raise SystemExit('imported')")
    monkeypatch.syspath_prepend(tmp_path)
    one_after_the_other(3, []).to_minari(ID, tmp_path)
    spec = {"id": "trap-v0", "entry_point": "trap:env"}
    without = {
        "env_spec": json.dumps(spec),
        "observation_space": None,
    }  # Minari makes the environment to find it out
    about(tmp_path).write_text(
        json.dumps(json.loads(about(tmp_path).read_text()) | without)
    )
    with pytest.raises(ValueError, match="this is not a whole Minari dataset"):
        rl.Recording.from_minari(ID, tmp_path)
    assert "trap" not in sys.modules


@pytest.mark.parametrize(
    ("module", "use"),
    [
        ("minari", lambda: make_recording(1).to_minari(ID)),
        ("minari", lambda: rl.Recording.from_minari(ID)),
        ("h5py", lambda: rl.Recording.from_minari(ID)),
    ],
)
def test_where_a_package_is_missing_one_sentence_says_what_to_install(
    monkeypatch, module, use
):
    for name in [name for name in sys.modules if name.startswith(f"{module}.")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(
        ImportError, match=r"(minari|h5py) is not installed: .*'minari\[hdf5\]'"
    ):
        use()
