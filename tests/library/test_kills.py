"""kill -9 at any moment: a file holds the old or the new content, and an experiment goes on to the same numbers."""

import os
import shutil
import subprocess
import sys
import time

import numpy as np
import pytest
from faults import TESTS, alone, kills, parts
from worlds import same_histories as same

import rlrobot_edu as rl
from rlrobot_edu.files import ABANDONED
from rlrobot_edu.models.data_package import NAMES

KILLS = 50


def grow_old(folder):
    """Let all that writers have left behind in a folder be older than any writer at work could be."""
    for part in parts(folder):
        os.utime(part, (0, time.time() - ABANDONED - 1))


@alone
def test_an_agents_file_is_the_old_or_the_new_one_whenever_its_writer_is_killed(
    tmp_path,
):
    path, contents = tmp_path / "agent.npz", []
    agents = [rl.Agent("wander_simple", seed=seed) for seed in range(2)]
    for agent in agents:
        agent.q[:] = agent.rng.random(agent.q.shape)
        agent.save(path)
        contents.append(path.read_bytes())
    old, new = contents

    found = set()
    for _ in kills(
        lambda: [agent.save(path) for agent in agents[::-1]],
        KILLS,
        size=len(new),
        seconds=0.03,
    ):
        found.add(path.read_bytes())
    assert found == {old, new}
    assert parts(tmp_path)
    rl.Agent.load(path)  # they do no harm
    agents[0].save(path)
    assert parts(tmp_path)  # they might be those of a writer at work
    grow_old(tmp_path)
    agents[0].save(path)
    assert os.listdir(tmp_path) == ["agent.npz"]


@pytest.mark.long
@alone
def test_a_recording_is_the_old_or_the_new_one_or_refused_whenever_its_writer_is_killed(
    tmp_path,
):
    def recorded(seed):
        agent, env = (
            rl.Agent("worked_example", seed=seed),
            rl.make_env("worked_example", seed=seed),
        )
        return rl.record(agent, env, steps=40)

    def rows(recording):
        return np.stack([getattr(recording, name) for name in NAMES]).tobytes()

    folder, seeds, found = tmp_path / "r", (1, 0), set()
    recorded(0).save(folder)
    old, new = (rows(recorded(seed)) for seed in (0, 1))
    size = (folder / "datapackage.json").stat().st_size
    for _ in kills(
        lambda: [recorded(seed).save(folder) for seed in seeds],
        KILLS,
        size,
        seconds=0.1,
    ):
        try:
            found.add(rows(rl.read_recording(folder)))
        except ValueError as error:  # killed between its two files
            assert "its sha256 is" in str(error)
    assert found == {old, new}
    grow_old(folder)
    recorded(0).save(folder)
    assert sorted(os.listdir(folder)) == ["datapackage.json", "transitions.csv"]
    assert rows(rl.read_recording(folder)) == old


@pytest.mark.long
@alone
def test_a_comparison_goes_on_to_the_same_numbers_whenever_it_is_killed(tmp_path):
    model = rl.SampleModel.from_recording(rl.read_recording("worked_example"))
    store = tmp_path / "s"

    def compared(n_jobs=1, **more):
        return rl.compare(
            model,
            ["TOSL+QBIASSR", "Q+SR"],
            3,
            steps=60,
            n_jobs=n_jobs,
            progress=False,
            **more,
        )

    undisturbed = compared()
    for _ in kills(lambda: compared(store=store), KILLS, size=1000, seconds=0.2):
        assert same(compared(n_jobs=1, store=store), undisturbed)
        assert same(rl.Comparison.load(store), undisturbed)
        shutil.rmtree(store)


# Two processes


AT_WORK = """
import sys
import rlrobot_edu as rl
from rlrobot_edu.experiments.store import Store

save = Store.save
def save_and_wait(*repetition):
    save(*repetition)
    print("saved", flush=True)
    sys.stdin.readline()
Store.save = save_and_wait
model = rl.SampleModel.from_recording(rl.read_recording("worked_example"))
rl.compare(model, ["Q+SR"], 3, steps=60, n_jobs=1, progress=False, store=sys.argv[1])
"""


@pytest.mark.long
@pytest.mark.parametrize("end", ["done", "killed"])
def test_two_processes_on_one_store_come_to_the_same_numbers_and_neither_spoils_what_the_other_kept(
    tmp_path, end
):
    model = rl.SampleModel.from_recording(rl.read_recording("worked_example"))

    def compared(**more):
        return rl.compare(
            model, ["Q+SR"], 3, steps=60, n_jobs=1, progress=False, **more
        )

    command = [sys.executable, "-c", AT_WORK, tmp_path / "s"]
    with subprocess.Popen(
        command, cwd=TESTS, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as first:
        assert first.stdout.readline() == "saved\n"
        first_file = tmp_path / "s" / "Q+SR" / "0000.npz"
        kept = first_file.stat().st_mtime_ns
        assert same(compared(store=tmp_path / "s"), compared())
        assert first_file.stat().st_mtime_ns == kept
        if end == "killed":
            first.kill()
        first.communicate()  # its input ends, so it waits no more
    assert (first.returncode == 0) == (end == "done")
    assert same(rl.Comparison.load(tmp_path / "s"), compared()) and not parts(tmp_path)
