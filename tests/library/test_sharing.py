"""One experiment on many computers: shares of any division make the same comparison, and what is wrong is named."""

import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import rlrobot_edu as rl
from rlrobot_edu.files import load_arrays, save_arrays

WHAT = {"methods": ["Q+SR", "SARSA+EG"], "repetitions": 3, "steps": 30, "seed": 4}
N = len(WHAT["methods"]) * WHAT["repetitions"]


@pytest.fixture(scope="module")
def plan(tmp_path_factory):
    return rl.plan(tmp_path_factory.mktemp("class") / "plan.json", "wander_simple", **WHAT, alpha=0.2)


@pytest.fixture(scope="module")
def in_one_go():
    return rl.compare("wander_simple", **WHAT, alpha=0.2, n_jobs=1, progress=False)


def share(plan, number, of):
    """The file of a share, run if it was not before."""
    return rl.shard(plan, number, of, n_jobs=1, progress=False)


def assert_same(merged, whole):
    assert merged.groups.keys() == whole.groups.keys() and merged.seed == whole.seed
    for label in whole.groups:
        for x, y in zip(merged[label], whole[label], strict=True):
            assert np.array_equal(x.rewards, y.rewards) and np.array_equal(x.q, y.q)
            assert np.array_equal(x.visits, y.visits)
    assert str(merged.anova()) == str(whole.anova())


@settings(max_examples=8, deadline=None)
@given(st.data())
def test_any_division_in_any_order_makes_the_comparison_to_the_last_bit(plan, in_one_go, data):
    of = data.draw(st.integers(1, N))
    numbers = data.draw(st.permutations(range(1, of + 1)))
    assert_same(rl.merge([share(plan, number, of) for number in numbers], again=0), in_one_go)


def test_divisions_may_be_mixed(plan, in_one_go):
    quarters = [share(plan, 1, 2), share(plan, 2, 4), share(plan, 4, 4)]
    assert_same(rl.merge(quarters, plan), in_one_go)


def test_missing_shares_are_named_by_their_numbers(plan):
    with pytest.raises(ValueError, match="missing are the shares 2, 5 of 6"):
        rl.merge([share(plan, number, 6) for number in (6, 1, 4, 3)], again=0)


def test_a_share_that_is_there_twice_is_named_with_the_other_one(plan, tmp_path):
    first, second = share(plan, 1, 2), share(plan, 2, 2)
    again = shutil.copy(first, tmp_path / "again.npz")
    with pytest.raises(ValueError) as error:
        rl.merge([first, second, again], again=0)
    assert f"{again}: {first} also holds repetition 0 of Q+SR" in str(error.value)


def test_a_share_of_another_seed_is_named_and_what_differs(plan, tmp_path):
    other = rl.plan(tmp_path / "plan.json", "wander_simple", **{**WHAT, "seed": 5}, alpha=0.2)
    strange = share(other, 3, 3)
    with pytest.raises(ValueError) as error:
        rl.merge([share(plan, 1, 3), strange, share(plan, 2, 3)], again=0)
    assert str(error.value).splitlines() == [
        f"{strange}: it is of another plan: its seed is 5, not 4",
        "missing are the shares 3 of 3",
    ]


def forge(path: Path, to: Path, change) -> Path:
    """The same share with another history in the place of one of its own."""
    about, arrays = load_arrays(path, "share", lambda about, arrays: (about, arrays))
    name = next(name for name in arrays if name.endswith(".npz"))
    (to.parent / "history.npz").write_bytes(arrays[name].tobytes())
    history = rl.History.load(to.parent / "history.npz")
    change(history)
    history.save(to.parent / "history.npz")
    arrays[name] = np.frombuffer((to.parent / "history.npz").read_bytes(), np.uint8)
    save_arrays(to, "share", about, arrays)
    return to


def test_a_forged_repetition_is_found_when_it_is_run_again(plan, tmp_path):
    def better(history):
        history.transitions.r[:] = 10.0

    forged = forge(share(plan, 1, 6), tmp_path / "forged.npz", better)
    honest = [share(plan, number, 6) for number in range(2, 7)]
    rl.merge([forged, *honest], again=0)  # nobody can see it
    with pytest.raises(ValueError) as error:
        rl.merge([forged, *honest])
    (line,) = str(error.value).splitlines()
    assert line.startswith(f"{forged}: repetition 0 of Q+SR gave other rewards here")


def test_a_last_bit_that_differs_is_no_forgery(plan, in_one_go, tmp_path):
    def nudged(history):
        history.learned.q[:] = np.nextafter(history.learned.q, np.inf)

    nudged = forge(share(plan, 1, 6), tmp_path / "nudged.npz", nudged)
    rl.merge([nudged, *(share(plan, number, 6) for number in range(2, 7))])


def test_a_repetition_in_the_place_of_another_is_named(plan, tmp_path):
    path = share(plan, 1, 3)
    about, arrays = load_arrays(path, "share", lambda about, arrays: (about, arrays))
    names = [name for name in arrays if name.endswith(".npz")]
    arrays[names[0]] = arrays[names[1]]
    save_arrays(tmp_path / "moved.npz", "share", about, arrays)
    with pytest.raises(ValueError, match=r"moved\.npz: .*it holds 'repetition 0 of SARSA\+EG"):
        rl.merge([tmp_path / "moved.npz"], again=0)


@pytest.mark.parametrize("name", ["../out.npz", "experiment.txt"])
def test_a_file_that_does_not_belong_into_a_share_is_not_written(plan, tmp_path, name):
    about, arrays = load_arrays(share(plan, 1, 3), "share", lambda about, arrays: (about, arrays))
    save_arrays(tmp_path / "more.npz", "share", about, {**arrays, name: np.zeros(3, np.uint8)})
    with pytest.raises(ValueError, match=f"more.npz: it does not hold {re.escape(name)}"):
        rl.merge([tmp_path / "more.npz"], again=0)


def test_a_damaged_share_is_named_beside_all_else(plan, tmp_path):
    (tmp_path / "cut.npz").write_bytes(share(plan, 1, 2).read_bytes()[:1000])
    with pytest.raises(ValueError) as error:
        rl.merge([tmp_path / "cut.npz", tmp_path / "none.npz", share(plan, 2, 2)], again=0)
    first, second, third = str(error.value).splitlines()
    assert "cut.npz: this is not a whole file" in first and "none.npz: there is no such file" in second
    assert third == "missing are the shares 1 of 2"


def test_a_plan_that_was_changed_is_not_run(plan, tmp_path):
    changed = tmp_path / "plan.json"
    changed.write_text(plan.read_text().replace('"steps": 30', '"steps": 3'))
    with pytest.raises(ValueError, match="was changed after it was written"):
        rl.shard(changed, 1, 2)
    changed.write_text("[]")
    with pytest.raises(ValueError, match="this is no plan"):
        rl.shard(changed, 1, 2)


def test_a_plan_of_another_version_is_not_run(plan, monkeypatch):
    monkeypatch.setattr("rlrobot_edu.sharing.plan.__version__", "7.0")
    with pytest.raises(ValueError, match=r"the version is .* in this plan and 7\.0 on this computer"):
        rl.shard(plan, 1, 2)


def test_what_no_json_can_hold_is_no_plan(tmp_path):
    with pytest.raises(ValueError, match="names and numbers alone"):
        rl.plan(tmp_path / "plan.json", "wander_simple", [rl.Method], steps=10)
    assert not list(tmp_path.iterdir())


def test_there_are_no_more_shares_than_repetitions(plan):
    with pytest.raises(ValueError, match="there is no share 7 of 9; it has 6 repetitions"):
        rl.shard(plan, 7, 9)


def test_a_share_that_was_stopped_goes_on(plan, in_one_go):
    path = share(plan, 1, 1)
    folder = path.with_suffix("")
    kept = sorted(folder.glob("*/*.npz"))
    kept[0].unlink()
    times = {one: one.stat().st_mtime_ns for one in kept[1:]}
    assert_same(rl.merge([share(plan, 1, 1)], again=0), in_one_go)
    assert times == {one: one.stat().st_mtime_ns for one in kept[1:]}
