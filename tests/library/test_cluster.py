"""A comparison on a real Dask cluster of two workers, one of which is killed half-way."""

import os
import signal

import joblib
import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.experiments.store import Store

distributed = pytest.importorskip("distributed")


@pytest.mark.long
def test_a_worker_that_is_killed_half_way_changes_no_bit_of_the_result(
    tmp_path, monkeypatch
):
    def compare(**more):
        methods = ["TOSL+QBIASSR", "Q+SR"]
        return rl.compare(
            "wander_simple", methods, 8, steps=1500, seed=5, progress=False, **more
        )

    save, killed = Store.save, []

    def save_and_kill(*batch):
        save(*batch)
        done = len(list(tmp_path.glob("s/*/*.npz")))
        if done >= 2 and not killed:
            os.kill(min(before), signal.SIGKILL)
            killed.append(done)

    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        before = set(client.run(os.getpid).values())
        monkeypatch.setattr(Store, "save", save_and_kill)
        with joblib.parallel_config("dask"):
            result = compare(store=tmp_path / "s")
        after = set(client.run(os.getpid).values())

    (done,) = killed
    assert min(before) not in after and 2 <= done < 16
    serial = compare(n_jobs=1)
    for label in serial:
        for x, y in zip(serial[label], result[label], strict=True):
            assert np.array_equal(x.rewards, y.rewards) and np.array_equal(x.q, y.q)
            assert np.array_equal(x.visits, y.visits)
