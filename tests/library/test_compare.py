"""Comparisons: the same numbers however they are run, and a store that survives."""

import contextlib
import copy
import dataclasses
import json
import os
import pickle
import signal
import subprocess
import sys
import time
import zlib
from collections.abc import Sequence
from pathlib import Path

import gymnasium
import joblib
import numpy as np
import psutil
import pytest
from hypothesis import given
from hypothesis import strategies as st
from worlds import same_histories as same

import rlrobot_edu as rl
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.learning.history import History, Learned
from rlrobot_edu.learning.size import Size
from rlrobot_edu.learning.transitions import Transitions

METHODS = ["TOSL+QBIASSR", "Q+SR"]


def small(model, **more):
    return rl.compare(
        model,
        METHODS,
        **{"repetitions": 5, "steps": 300, "seed": 1, "progress": False, **more},
    )


@pytest.mark.long
def test_the_result_depends_on_the_seed_and_not_on_the_number_of_cores(wander_model):
    one = small(wander_model, n_jobs=1)
    assert same(one, small(wander_model, n_jobs=2))
    with joblib.parallel_config("loky", n_jobs=2):
        assert same(one, small(wander_model, n_jobs=None))
    assert not np.array_equal(
        one.final["Q+SR"], small(wander_model, seed=2).final["Q+SR"]
    )


def test_a_repetition_does_not_depend_on_the_others(wander_model):
    both = small(wander_model)
    alone = rl.compare(wander_model, ["Q+SR"], 3, steps=300, seed=1, progress=False)
    assert np.array_equal(alone.final["Q+SR"], both.final["Q+SR"][:3])


def test_a_repetition_can_be_made_again_by_hand(wander_model):
    history = small(wander_model)["Q+SR"][2]
    seeds = np.random.SeedSequence(1, spawn_key=(zlib.crc32(b"Q+SR"), 2)).spawn(2)
    agent, env = (
        rl.Agent(wander_model, "Q+SR", seed=seeds[0]),
        rl.make_env(wander_model, seeds[1]),
    )
    assert np.array_equal(
        rl.learn(agent, env, 300, progress=False).rewards, history.rewards
    )
    assert np.array_equal(agent.q, history.q) and np.array_equal(
        agent.visits, history.visits
    )
    assert history.seconds > 0


def test_one_method_with_different_parameters_can_be_compared_under_labels_of_its_own(
    wander_model,
):
    sweep = {f"λ = {lam}": {"method": "TOSL+SR", "lam": lam} for lam in (0.0, 0.9)}
    result = rl.compare(
        wander_model, sweep, 2, steps=200, progress=False, temperature=2.0
    )
    assert (
        list(result) == ["λ = 0.0", "λ = 0.9"]
        and result["λ = 0.0"][0].method == "TOSL+SR"
    )


@pytest.mark.parametrize(
    "methods, more, match",
    [(["TOSL+QBIASR"], {}, "did you mean"), ([], {}, "at least one method"), (["Q+SR", "Q+SR"], {}, "named once"),
     (["Q+SR"], {"alpha": 2}, "alpha must be"), (["Q+SR"], {"repetitions": 0}, "repetitions must be a whole"),
     (["Q+SR"], {"episodes": 3}, "goes on for ever")],
)  # fmt: skip
def test_what_cannot_be_compared_is_refused_before_anything_runs(
    wander_model, methods, more, match
):
    with pytest.raises(ValueError, match=match):
        rl.compare(wander_model, methods, **{"steps": 10, **more})


def test_transitions_are_kept_on_request_and_join_up(wander_model):
    history = small(wander_model, keep=True)["Q+SR"][0]
    assert np.array_equal(history.s[1:], history.s_next[:-1])
    visits = np.zeros_like(history.visits)
    np.add.at(visits, (history.s, history.a), 1)
    assert np.array_equal(visits, history.visits)
    assert small(wander_model)["Q+SR"][0].s is None


def test_episodes_are_compared_by_the_average_reward_of_the_last_one(episodes_model):
    result = rl.compare(
        episodes_model, METHODS, 3, episodes=5, progress=False, n_jobs=1
    )
    for history in result["Q+SR"]:
        ends = np.flatnonzero(history.terminated | history.truncated)
        assert len(ends) == 5 and ends[-1] == len(history) - 1
        last = history.rewards[ends[-2] + 1 :]
        expected = (last.sum() + 5.0 * (8 - len(last)) * history.terminated[-1]) / 8
        assert history.final_average_reward == pytest.approx(expected)
    assert result["Q+SR"].curves.shape == (3, 8)
    assert rl.compare(episodes_model, ["Q+SR"], 1, steps=30, progress=False)["Q+SR"][
        0
    ].last_episode.shape == (8,)
    assert (
        result.optimum == pytest.approx((8 - 3) * 5 / 8)
        and max(result.final["Q+SR"]) <= result.optimum
    )


def test_the_compiled_loop_and_the_steps_end_after_the_same_episode(episodes_model):
    histories = []
    for env in (
        rl.make_env(episodes_model, seed=1),
        gymnasium.Wrapper(rl.make_env(episodes_model, seed=1)),
    ):
        agent = rl.Agent(
            episodes_model, seed=0
        )  # behind a wrapper the loop is not compiled
        histories.append(
            rl.learn(agent, env, 100, episodes=4, keep=True, progress=False)
        )
    for name in ("s", "a", "rewards", "s_next", "terminated", "truncated"):
        assert np.array_equal(getattr(histories[0], name), getattr(histories[1], name))
    assert histories[0].terminated.sum() + histories[0].truncated.sum() == 4


def test_a_goal_counts_for_the_rest_of_its_episode():
    flags = np.array([False, True, False, False, False])
    transitions = Transitions.empty(5)._replace(
        r=np.array([0.0, 5.0, 1.0, 1.0, 1.0]), terminated=flags
    )
    nothing = Learned.of(np.zeros((1, 1)), np.zeros((1, 1), dtype=int))
    history = History("Q+SR", transitions, nothing, 0.0, Size((1,), 1, 10.0, 4))
    assert history.average_reward == pytest.approx([0, 25 / 4, 26 / 5, 27 / 6, 28 / 7])
    assert history.last_episode == pytest.approx([0, 2.5, 5, 6.25])


def test_a_history_knows_all_that_the_agent_knew_also_of_pairs_it_never_tried(
    wander_model,
):
    agent = rl.Agent(wander_model, seed=0)
    agent.q[1000] = 3.0
    history = rl.learn(agent, rl.make_env(wander_model, seed=0), 500, progress=False)
    assert np.array_equal(history.q, agent.q) and np.array_equal(
        history.visits, agent.visits
    )


@pytest.mark.parametrize("keep", [True, False])
def test_a_history_in_a_file_reads_back_as_it_was(wander_model, tmp_path, keep):
    history = small(wander_model, repetitions=1, keep=keep)["Q+SR"][0]
    history.save(tmp_path / "it.npz")
    again = History.load(tmp_path / "it.npz")
    assert (again.method, again.seconds, again.size) == (
        history.method,
        history.seconds,
        history.size,
    )
    for mine, its in zip(
        (*history.transitions, *history.learned),
        (*again.transitions, *again.learned),
        strict=True,
    ):
        assert mine.dtype == its.dtype and np.array_equal(mine, its)
    assert (
        np.array_equal(again.average_reward, history.average_reward)
        and (again.s is None) != keep
    )


@pytest.mark.parametrize(
    ("name", "change"),
    [("r", np.full(300, np.nan)), ("r", np.zeros((300, 1))), ("s", np.full(300, 9999)), ("s", np.zeros(299, int)),
     ("terminated", np.zeros(0, bool)), ("a", np.full(300, 0.5)), ("pair", np.full(2, -1)), ("q", np.zeros(1)),
     ("visits", np.array(["many"]))],
)  # fmt: skip
def test_a_history_that_cannot_be_is_refused_by_name(
    wander_model, tmp_path, name, change, monkeypatch
):
    history = small(wander_model, repetitions=1, keep=True)["Q+SR"][0]
    path = tmp_path / "it.npz"
    parts = {"transitions": history.transitions, "learned": history.learned}
    changed = {
        key: part._replace(**{name: change})
        for key, part in parts.items()
        if name in part._fields
    }
    impossible = dataclasses.replace(history, **changed)
    with pytest.raises(ValueError, match=rf"it\.npz: {name} of this history is not"):
        impossible.save(path)
    assert not path.exists()
    with monkeypatch.context() as unchecked:
        unchecked.setattr(History, "_parts", lambda self: ())
        impossible.save(path)
    with pytest.raises(
        ValueError,
        match=rf"it\.npz: this history is damaged.*\({name} does not fit this history",
    ):
        History.load(path)


def test_a_comparison_says_what_it_found(wander_model):
    result = small(wander_model)
    assert result.table().rows[0][2] == pytest.approx(
        np.mean([h.average_reward[-1] for h in result["TOSL+QBIASSR"]])
    )
    picture = result.plot(title="Two methods")
    assert len(picture.axes[0].collections) == 2  # the bands
    assert (
        "between groups" in str(result.anova().table())
        and len(result.tukey().pairs) == 1
    )


# The store


def test_a_store_gives_back_what_was_run_and_runs_only_what_is_missing(
    wander_model, tmp_path
):
    first = small(wander_model, repetitions=3, store=tmp_path / "s")
    files = set((tmp_path / "s").glob("*/*.npz"))
    more = small(wander_model, store=tmp_path / "s", n_jobs=2)
    assert same(more, small(wander_model)) and files < set(
        (tmp_path / "s").glob("*/*.npz")
    )
    assert [h.seconds for h in first["Q+SR"]] == [
        h.seconds for h in more["Q+SR"][:3]
    ]  # not run again
    assert same(small(wander_model, store=tmp_path / "s"), more)


def test_a_store_is_a_folder_of_histories_that_can_be_opened_without_the_call(
    wander_model, tmp_path
):
    ran = small(wander_model, repetitions=2, store=tmp_path)
    names = [
        "experiment.json",
        "model.npz",
        *(f"{method}/{i:04d}.npz" for method in METHODS for i in range(2)),
    ]
    assert {
        path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*.*")
    } == set(names)
    assert np.array_equal(
        History.load(tmp_path / "Q+SR" / "0001.npz").q, ran["Q+SR"][1].q
    )
    opened = rl.Comparison.load(tmp_path)
    assert (
        same(opened, ran)
        and str(opened.table()) == str(ran.table())
        and opened.optimum == ran.optimum
    )
    assert opened.name == "model"


def test_a_store_of_a_task_is_opened_with_the_toolkits_task_or_the_given_one(tmp_path):
    ran = small(
        "wander_simple", repetitions=2, steps=40, store=tmp_path / "s", n_jobs=1
    )
    assert (
        same(rl.Comparison.load(tmp_path / "s"), ran)
        and rl.Comparison.load(tmp_path / "s").name == "wander_simple"
    )
    mine = dataclasses.replace(rl.load_task("wander_simple"), name="mine")
    small(mine, repetitions=1, steps=40, store=tmp_path / "mine", n_jobs=1)
    assert rl.Comparison.load(tmp_path / "mine", mine).world is mine


def test_what_is_no_store_or_an_empty_one_is_not_opened(wander_model, tmp_path):
    with pytest.raises(
        ValueError, match=r"holds no experiment\.json, so it is no store"
    ):
        rl.Comparison.load(tmp_path)
    small(wander_model, repetitions=1, store=tmp_path / "s")
    for path in (tmp_path / "s").glob("*/*.npz"):
        path.unlink()
    with pytest.raises(
        ValueError, match="no repetition has been finished in this store"
    ):
        rl.Comparison.load(tmp_path / "s")


def test_shares_are_counted_from_one_and_make_the_whole_together_and_the_same_call_adds_what_is_lost(
    wander_model, tmp_path
):
    whole, same_call = (
        small(wander_model, repetitions=3),
        {"repetitions": 3, "store": tmp_path},
    )
    first, second = (small(wander_model, share=(k, 2), **same_call) for k in (1, 2))
    assert sum(map(len, first.values())) + sum(map(len, second.values())) == sum(
        map(len, whole.values())
    )
    assert same(rl.Comparison.load(tmp_path), whole)
    for number in (0, 2):
        (tmp_path / "Q+SR" / f"{number:04d}.npz").unlink()
    assert "1 × Q+SR" in repr(rl.Comparison.load(tmp_path))
    assert same(small(wander_model, **same_call), whole)
    for share in ((0, 2), (3, 2), (1, 2, 3), (1.0, 2), (True, 2), 1, None):
        with pytest.raises(ValueError, match="share must be"):
            small(wander_model, share=share)


@pytest.mark.parametrize(
    "label", ["..", "a/b", "λ = 0.9", "", "C:*?", "50 %", ".hidden"]
)
def test_a_label_may_be_any_text_and_its_files_stay_inside_the_store(
    wander_model, tmp_path, label
):
    def compared(**more):
        return rl.compare(
            wander_model,
            {label: {"method": "Q+SR"}},
            1,
            steps=9,
            progress=False,
            **more,
        )

    ran = compared(store=tmp_path / "s")
    assert [path.name for path in tmp_path.iterdir()] == ["s"]
    assert same(compared(store=tmp_path / "s"), ran) and same(
        rl.Comparison.load(tmp_path / "s"), ran
    )


@pytest.mark.parametrize(
    "more, difference",
    [({"steps": 200}, "steps is 300 in the store, 200"), ({"seed": 9}, "seed is 1"), ({"alpha": 0.2}, "alpha of TOSL"),
     ({"keep": True}, "keep is False"), ({"unseen": "stay"}, "unseen is uniform"),
     ({"methods": ["Q+SR"]}, "methods is")],
)  # fmt: skip
def test_a_store_of_another_experiment_is_refused_with_the_difference(
    wander_model, tmp_path, more, difference
):
    small(wander_model, repetitions=1, store=tmp_path / "s")
    model = rl.SampleModel(
        **{**vars(wander_model), "unseen": more.pop("unseen", "uniform")}
    )
    arguments = {"repetitions": 1, "steps": 300, "seed": 1, "progress": False, **more}
    with pytest.raises(ValueError, match=difference):
        rl.compare(
            model, arguments.pop("methods", METHODS), store=tmp_path / "s", **arguments
        )


def test_a_store_of_another_version_task_or_folder_is_refused(
    wander_model, tmp_path, monkeypatch
):
    small(wander_model, repetitions=1, store=tmp_path / "s")
    with pytest.raises(
        ValueError, match="world is a sample model in the store, the task wander_simple"
    ):
        small("wander_simple", repetitions=1, store=tmp_path / "s")
    monkeypatch.setattr("rlrobot_edu.experiments.compare.__version__", "9.9")
    with pytest.raises(ValueError, match=r"version is .* in the store, 9\.9"):
        small(wander_model, repetitions=1, store=tmp_path / "s")
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "thesis.txt").write_text("mine")
    with pytest.raises(ValueError, match=r"holds no experiment\.json"):
        small(wander_model, repetitions=1, store=tmp_path / "other")


@pytest.mark.parametrize(
    "damage",
    [
        lambda data: data[:-20],
        lambda data: data[:500] + b"?" + data[501:],
        lambda _: b"",
    ],
)
def test_a_damaged_file_is_named_and_the_others_are_kept(
    wander_model, tmp_path, damage
):
    small(wander_model, store=tmp_path / "s")
    path = sorted((tmp_path / "s").glob("*/*.npz"))[1]
    path.write_bytes(damage(path.read_bytes()))
    with pytest.raises(ValueError, match=path.name):
        small(wander_model, store=tmp_path / "s")
    path.unlink()
    assert same(small(wander_model, store=tmp_path / "s"), small(wander_model))


def test_a_damaged_description_is_named(wander_model, tmp_path):
    small(wander_model, repetitions=1, store=tmp_path / "s")
    (tmp_path / "s" / "experiment.json").write_text("{")
    with pytest.raises(ValueError, match=r"experiment\.json"):
        small(wander_model, repetitions=1, store=tmp_path / "s")


LONG = """
import signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # under nohup or in the background it would be ignored
import rlrobot_edu as rl
rl.compare("wander_simple", ["TOSL+QBIASSR", "Q+SR"], 400, steps=1500, seed=3, n_jobs=2, store=sys.argv[1])
"""  # it would take minutes: however slowly the signal comes, much is left to do


def interrupted(store: Path, number: int) -> tuple[int, str]:
    """Run LONG until its store holds two files, then send the signal; returns its return code and what it said."""
    said = store.with_suffix(".txt")
    with open(said, "w") as file:
        process = subprocess.Popen(
            [sys.executable, "-c", LONG, store], stderr=file, start_new_session=True
        )
    while len(list(store.glob("*/*.npz"))) < 2:
        assert process.poll() is None, said.read_text()
        time.sleep(0.02)
    workers = psutil.Process(process.pid).children(recursive=True)
    assert len(workers) >= 2
    if number == signal.SIGINT:
        os.killpg(process.pid, number)  # Ctrl-C reaches the workers, too
    else:
        os.kill(process.pid, number)
    code = process.wait()
    for worker in workers:  # joblib's own end when they have had no work for minutes
        with contextlib.suppress(psutil.NoSuchProcess):
            worker.kill()
    return code, said.read_text()


@pytest.mark.long
def test_what_was_finished_before_kill_9_is_not_lost(tmp_path):
    store = tmp_path / "s"
    assert interrupted(store, signal.SIGKILL)[0] == -signal.SIGKILL
    kept = {path.name: path.stat().st_mtime_ns for path in store.glob("*/*.npz")}
    assert len(kept) >= 2
    arguments = {"repetitions": 4, "steps": 1500, "seed": 3, "progress": False}
    resumed = rl.compare("wander_simple", METHODS, store=store, n_jobs=2, **arguments)
    assert (
        kept.items()
        <= {
            path.name: path.stat().st_mtime_ns for path in store.glob("*/*.npz")
        }.items()
    )
    assert same(resumed, rl.compare("wander_simple", METHODS, n_jobs=2, **arguments))


@pytest.mark.long
def test_ctrl_c_leaves_a_usable_store_and_says_how_to_go_on(tmp_path):
    code, said = interrupted(tmp_path / "s", signal.SIGINT)
    assert code != 0 and "the same call goes on" in said and str(tmp_path / "s") in said
    assert "repetition" in said and "<" in said  # the progress bar, with the time left
    assert (
        json.loads((tmp_path / "s" / "experiment.json").read_text())["alpha of Q+SR"]
        == 0.1
    )
    assert sum(map(len, rl.Comparison.load(tmp_path / "s").values())) >= 2


def test_a_comparison_on_a_weak_robot_is_another_experiment_and_a_model_has_no_robot(
    tmp_path,
):
    weak = rl.Realism(wheel_slip=0.5)
    ideal, slipping = (
        rl.compare(
            "wander_simple",
            ["Q+SR"],
            2,
            steps=30,
            n_jobs=1,
            progress=False,
            realism=realism,
        )
        for realism in (None, weak)
    )
    assert not np.array_equal(ideal["Q+SR"][0].rewards, slipping["Q+SR"][0].rewards)
    rl.compare(
        "wander_simple",
        ["Q+SR"],
        2,
        steps=30,
        n_jobs=1,
        progress=False,
        realism=weak,
        store=tmp_path / "s",
    )
    with pytest.raises(
        ValueError,
        match=r"realism is .*wheel_slip=0.5.* in the store, None in this call",
    ):
        rl.compare(
            "wander_simple",
            ["Q+SR"],
            2,
            steps=30,
            n_jobs=1,
            progress=False,
            store=tmp_path / "s",
        )
    model = rl.SampleModel.from_recording(rl.read_recording("worked_example"))
    with pytest.raises(ValueError, match="only a task has a robot"):
        rl.compare(model, ["Q+SR"], 2, steps=30, progress=False, realism=weak)


# What a comparison is to Python


def test_a_comparison_is_a_mapping_of_labels_to_runs(wander_model):
    result = small(wander_model, repetitions=2)
    assert (
        list(result) == METHODS
        and len(result) == 2
        and "Q+SR" in result
        and "SARSA+SR" not in result
    )
    assert (
        result.get("no") is None and next(iter(result.values())) is result[METHODS[0]]
    )
    assert result == result and result != small(
        wander_model, repetitions=2
    )  # other histories
    for again in (copy.copy(result), pickle.loads(pickle.dumps(result))):
        assert same(again, result) and repr(again) == repr(result)
    with pytest.raises(KeyError):
        result["no"]


def test_a_comparison_cannot_be_changed_but_tells_of_some_of_its_methods(wander_model):
    methods = ["Q+EG", "Q+RANDOM", "SARSA+EG"]
    result = rl.compare(wander_model, methods, 4, steps=300, progress=False)
    with pytest.raises(TypeError):
        result["mine"] = result["Q+EG"]
    with pytest.raises(TypeError):
        del result["Q+RANDOM"]
    assert len(result.tukey().pairs) == 3
    two = result.only("SARSA+EG", "Q+EG")
    assert list(two) == ["SARSA+EG", "Q+EG"] and two.world is wander_model
    assert two["Q+EG"] is result["Q+EG"]
    assert two.anova().df_between == 1
    assert [(pair.first, pair.second) for pair in two.tukey().pairs] == [
        ("SARSA+EG", "Q+EG")
    ]
    with pytest.raises(ValueError, match=r"no method 'Q\+GE'; did you mean 'Q\+EG'"):
        result.only("Q+GE")
    with pytest.raises(ValueError, match="at least one method"):
        result.only()


def test_repeat_is_a_comparison_of_one_method(wander_model):
    few = {"steps": 200, "seed": 3, "progress": False}
    alone = rl.repeat(wander_model, "Q+SR", repetitions=2, temperature=2, **few)
    result = rl.compare(wander_model, METHODS, 3, temperature=2, **few)
    assert isinstance(alone, Runs) and len(alone) == 2
    for mine, its in zip(alone, result["Q+SR"], strict=False):
        assert np.array_equal(mine.rewards, its.rewards)
        assert np.array_equal(mine.q, its.q)


def test_two_labels_that_are_the_same_text_are_refused(wander_model):
    with pytest.raises(ValueError, match="each method must be named once, got 1, 1"):
        rl.compare(wander_model, {1: {"method": "Q+SR"}, "1": {"method": "Q+EG"}}, 1)


def test_a_comparison_says_how_it_is_drawn(wander_model):
    with pytest.raises(ValueError, match=r"draws itself: result\.plot\(\)"):
        rl.plot_learning(small(wander_model, repetitions=1))


def test_what_is_made_of_runs_is_runs_again(wander_model):
    runs = small(wander_model)["Q+SR"]
    for part in (
        runs[:3],
        runs[::-1],
        runs[1:] + runs[:1],
        runs.copy(),
        copy.deepcopy(runs),
        pickle.loads(pickle.dumps(runs)),
    ):
        assert isinstance(part, Runs) and part.final.shape == (len(part),)
    assert np.array_equal(runs[:3].final, runs.final[:3]) and runs[-1] is list(runs)[-1]
    assert (
        isinstance(runs, Sequence)
        and repr(runs[:2]) == "<2 repetitions of Q+SR>"
        and repr(runs[:0]) == "<no repetitions>"
    )


# Lengths


@pytest.mark.parametrize(
    "length, match",
    [({"steps": 0}, "steps must be None or a whole number of at least 1, got 0"), ({"steps": -5}, "got -5"),
     ({"steps": "3600"}, "steps must be None or a whole number of at least 1, got '3600'"), ({"steps": 8.5}, "got 8.5"),
     ({"episodes": 0}, "episodes must be None or a whole number of at least 1, got 0"), ({"episodes": "2"}, "episodes"),
     ({"steps": 7}, "an episode may take 8 steps, more than 7; give more steps"),
     ({"steps": 9, "episodes": 4}, "in 9 steps only [0-3] episodes have ended; give more steps")],
)  # fmt: skip
def test_a_length_that_cannot_be_is_refused(episodes_model, length, match):
    with pytest.raises(ValueError, match=match):
        rl.compare(episodes_model, ["Q+RANDOM"], 1, progress=False, **length)


@given(st.integers(8, 200))
def test_as_many_episodes_are_run_as_fit_into_the_steps_if_all_are_long(
    episodes_model, steps
):
    history = rl.compare(
        episodes_model, ["Q+RANDOM"], 1, steps=steps, n_jobs=1, progress=False
    )["Q+RANDOM"][0]
    assert len(history.returns) == steps // 8 and len(history) <= steps


def test_without_a_length_a_repetition_has_an_hour_or_one_whole_episode(
    episodes_model, wander_model
):
    longer = rl.SampleModel(**{**vars(episodes_model), "episode_steps": 5000})
    counts = [
        len(
            rl.compare(model, ["Q+RANDOM"], 1, n_jobs=1, progress=False)["Q+RANDOM"][
                0
            ].returns
        )
        for model in (episodes_model, longer)
    ]
    assert counts == [3600 // 8, 1]
    assert (
        len(rl.compare(wander_model, ["Q+SR"], 1, n_jobs=1, progress=False)["Q+SR"][0])
        == 3600
    )


def test_a_model_that_nothing_cuts_off_has_episodes_if_it_can_end(episodes_model):
    endless = rl.SampleModel(**{**vars(episodes_model), "episode_steps": None})
    history = rl.compare(
        endless, ["Q+RANDOM"], 1, episodes=7, n_jobs=1, progress=False
    )["Q+RANDOM"][0]
    assert history.terminated.sum() == 7 and history.terminated[-1]


# Curves


def ragged():
    """Three repetitions of an episodic task, two that have reached the goal and one that was not yet there."""
    return Runs(history_of(rewards, 6) for rewards in ([0, 5], [1, 0, 5], [0, 0, 0, 0]))


def history_of(rewards, episode_steps=None):
    flags = np.array(rewards) == 5
    transitions = Transitions.empty(len(rewards))._replace(
        r=np.array(rewards, float),
        terminated=flags,
        truncated=np.zeros(len(rewards), bool),
    )
    nothing = Learned.of(np.zeros((1, 1)), np.zeros((1, 1), dtype=int))
    return History(
        "Q+SR", transitions, nothing, 1.0, Size((1,), 1, 10.0, episode_steps)
    )


def test_curves_of_different_lengths_end_in_nan():
    curves = ragged().curves
    assert (
        curves.shape == (3, 6)
        and np.isnan(curves[2, 4:]).all()
        and not np.isnan(curves[:, :4]).any()
    )
    for row, history in zip(curves, ragged(), strict=True):
        assert np.array_equal(row[~np.isnan(row)], history.last_episode)
    assert Runs().curves.shape[0] == 0


def test_a_comparison_and_plot_learning_draw_the_same_as_far_as_all_repetitions_go():
    result = rl.Comparison(rl.load_task("navigation_1k"), {"Q+SR": ragged()})
    drawn = [
        picture.axes[0].lines[0].get_xydata()
        for picture in (result.plot(), rl.plot_learning(result["Q+SR"]))
    ]
    assert np.array_equal(*drawn) and drawn[0][:, 0].tolist() == [1, 2, 3, 4]
    assert np.allclose(drawn[0][:, 1], ragged().curves[:, :4].mean(axis=0))
    assert rl.plot_learning(ragged()).axes[0].get_xlabel() == "step of the last episode"


def test_a_list_of_histories_is_drawn_over_all_steps_as_far_as_all_go():
    picture = rl.plot_learning([history_of([0, 1, 1]), history_of([1, 1])])
    assert picture.axes[0].lines[0].get_ydata() == pytest.approx([0.5, 0.75])


def test_sums_that_differ_by_rounding_alone_prove_nothing():
    """Ten rewards of 0.1, −0.1 and so on, in two orders: one average is 0, the other 1e-18 or so."""
    one, other = [0.1, -0.1, 0.3, -0.3] * 50, [0.3, 0.1, -0.1, -0.3] * 50
    groups = {"A": Runs([history_of(one)] * 10), "B": Runs([history_of(other)] * 10)}
    assert groups["A"].final[0] != groups["B"].final[0]
    result = rl.Comparison(rl.load_task("wander_1k"), groups)
    assert not result.anova().p < 0.05 and result.tukey().pairs[0].inference == ""
    assert [row[4] for row in result.table().rows] == [0, 0]


# Arguments and surroundings


@pytest.mark.parametrize(
    "arguments, match",
    [({"methods": 3}, "unknown method 3"), ({"methods": None}, "unknown method None"),
     ({"methods": {"a": 3}}, "needs parameters by name"),
     ({"n_jobs": 0}, "n_jobs must be"), ({"seed": "x"}, "seed must be"), ({"realism": 3}, "realism must be"),
     ({"repetitions": 2.5}, "repetitions must be"), ({"no": 1}, "compare has no setting 'no'")],
)  # fmt: skip
def test_an_argument_of_another_kind_is_refused_in_a_sentence(
    wander_model, arguments, match
):
    with pytest.raises(ValueError, match=match):
        rl.compare(
            wander_model,
            arguments.pop("methods", ["Q+SR"]),
            **{"steps": 10, "progress": False, **arguments},
        )


def test_the_methods_may_come_from_a_generator(wander_model):
    assert same(
        small(wander_model),
        rl.compare(
            wander_model, (m for m in METHODS), 5, steps=300, seed=1, progress=False
        ),
    )
