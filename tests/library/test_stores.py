"""A store believes nothing: what lies in it is what was put there, under names that every computer can write."""

import json
import re
import shutil
import unicodedata

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from worlds import same_histories as same

import rlrobot_edu as rl
from rlrobot_edu.experiments.store import Store
from rlrobot_edu.tools.new_task import new_task


@pytest.fixture(scope="module")
def model():
    return rl.SampleModel.from_recording(rl.read_recording("wander_simple"))


def compared(world, repetitions=2, **more):
    return rl.compare(
        world,
        ["Q+SR"],
        repetitions,
        **{"steps": 30, "n_jobs": 1, "progress": False, **more},
    )


@pytest.mark.parametrize(
    "name", ["1.npz", "00001.npz", "١.npz", "0001 copy.npz", "+001.npz", "7.npz"]
)
def test_a_file_under_another_spelling_of_its_number_does_not_count(
    model, tmp_path, name
):
    ran = compared(model, store=tmp_path)
    shutil.copy(tmp_path / "Q+SR" / "0001.npz", tmp_path / "Q+SR" / name)
    assert same(rl.Comparison.load(tmp_path), ran)


def test_what_an_operating_system_puts_beside_the_files_is_no_repetition(
    model, tmp_path
):
    ran = compared(model, store=tmp_path)
    (tmp_path / "Q+SR" / "._0001.npz").write_bytes(b"Mac OS X")
    assert same(rl.Comparison.load(tmp_path), ran)


def test_ten_thousand_repetitions_stay_in_order(model, tmp_path):
    compared(model, 1, store=tmp_path)
    store = Store.at(tmp_path)
    for number in (9999, 10000):
        store.save("Q+SR", number, store.load("Q+SR", 0))
    origins = [history.origin.split()[1] for history in store.histories("Q+SR")]
    assert origins == ["0", "9999", "10000"]


def test_another_model_in_the_place_of_the_stores_own_is_refused(model, tmp_path):
    compared(model, store=tmp_path)
    rl.SampleModel.from_recording(rl.read_recording("worked_example")).save(
        tmp_path / "model.npz"
    )
    for open_it in (rl.Comparison.load, lambda path: compared(model, 3, store=path)):
        with pytest.raises(
            ValueError, match=r"was made in another world: shape is \[2, 2\] in the"
        ):
            open_it(tmp_path)
    (tmp_path / "model.npz").unlink()
    assert len(compared(model, 3, store=tmp_path)["Q+SR"]) == 3  # which writes it anew
    assert rl.Comparison.load(tmp_path).optimum is not None


def test_a_model_of_the_same_size_with_other_rewards_is_refused_too(model, tmp_path):
    compared(model, store=tmp_path)
    rl.SampleModel(**{**vars(model), "r": model.r[::-1]}).save(tmp_path / "model.npz")
    with pytest.raises(ValueError, match="what the model has recorded is"):
        rl.Comparison.load(tmp_path)


def test_a_task_that_is_not_the_stores_is_refused(model, tmp_path):
    ran = compared("wander_simple", store=tmp_path)
    assert same(rl.Comparison.load(tmp_path, "wander_simple"), ran)
    for other in ("arm_1k", model):
        with pytest.raises(
            ValueError,
            match="was made in another world: world is the task wander_simple in",
        ):
            rl.Comparison.load(tmp_path, other)


def test_a_task_that_was_changed_since_is_not_the_stores(tmp_path):
    path = new_task("mine", tmp_path)
    compared(path, store=tmp_path / "s")
    assert rl.Comparison.load(tmp_path / "s", path).name == "mine"
    path.write_text(
        path.read_text(encoding="utf-8").replace("0.07 else", "0.05 else"),
        encoding="utf-8",
    )
    with pytest.raises(ValueError, match="the content of the task's file is"):
        rl.Comparison.load(tmp_path / "s", path)


def test_numpys_numbers_are_kept_as_pythons(model, tmp_path):
    n = np.int64
    numbers = {"seed": n(0), "steps": n(30), "keep": np.bool_(True)}
    ran = compared(model, n(2), store=tmp_path, **numbers)
    assert same(compared(model, store=tmp_path, seed=0, keep=True), ran)
    assert json.loads((tmp_path / "experiment.json").read_text())["steps"] == 30
    assert (
        len(
            compared(
                "arm_1k",
                1,
                steps=None,
                episodes=n(1),
                engine="kinematic",
                store=tmp_path / "arm",
            )["Q+SR"][0]
        )
        == 120
    )


def test_a_model_with_numpys_sizes_is_like_any_other(model, tmp_path):
    sizes = {
        "n_actions": np.int64(model.n_actions),
        "shape": tuple(map(np.int64, model.shape)),
    }
    its = rl.SampleModel(**{**vars(model), **sizes, "episode_steps": np.int64(50)})
    its.save(tmp_path / "model.npz")
    assert repr(rl.SampleModel.load(tmp_path / "model.npz")) == repr(model)
    ran = compared(its, steps=60, store=tmp_path / "s")
    assert same(rl.Comparison.load(tmp_path / "s"), ran)


@pytest.mark.parametrize("seed", [3, np.int64(3), np.uint8(3)])
def test_a_recording_keeps_the_seed_of_its_agent_whatever_kind_of_number_it_is(seed):
    agent = rl.Agent("wander_simple", seed=seed)
    recording = rl.record(agent, rl.make_env("wander_simple", seed=0), 5)
    assert type(recording.source.seed) is int and recording.source.seed == 3


# Names of folders

RESERVED = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?$", re.IGNORECASE)
ODD = [
    "CON",
    "nul.txt",
    "a.",
    "a",
    "A",
    "é",
    unicodedata.normalize("NFD", "é"),
    "x" * 300,
    "é" * 200,
    "",
    "..",
    " ",
    "q+sr",
]


def folder(label):
    return Store(".", {}).path(label, 0).parent.name


@given(
    st.lists(
        st.one_of(st.sampled_from(ODD), st.text(st.characters(codec="utf-8"))),
        unique=True,
    )
)
def test_every_label_has_a_folder_of_its_own_on_every_computer(labels):
    names = [folder(label) for label in [*labels, "Q+SR", "TOSL+QBIASSR", "MY-OWN2+SR"]]
    for name in names:
        assert re.fullmatch(r"[A-Za-z0-9+=_-]{1,64}", name) and not RESERVED.match(name)
    assert len({name.casefold() for name in names}) == len(names)


def test_a_methods_folder_has_its_name_and_any_other_label_can_be_read_in_its_folders():
    assert folder("TOSL+QBIASSR") == "TOSL+QBIASSR"
    assert folder("alpha = 0.1").startswith("alpha_=_0_1_")


def test_labels_that_differ_in_case_alone_are_kept_apart(model, tmp_path):
    methods = {
        label: {"method": "Q+SR", "alpha": alpha}
        for label, alpha in {"a": 0.1, "A": 0.2}.items()
    }
    ran = rl.compare(
        model, methods, 2, steps=30, n_jobs=1, progress=False, store=tmp_path
    )
    assert same(rl.Comparison.load(tmp_path), ran) and len({*ran}) == 2
