"""The rows of the benchmark table that compare with others are made from what they print; none is installed here."""

import runpy
import subprocess
from pathlib import Path

import pytest

BENCH = Path(__file__).parents[2] / "studies/benchmarks" / "bench.py"


@pytest.fixture(scope="module")
def bench_peers():
    return runpy.run_path(str(BENCH))["bench_peers"]


def test_a_row_of_others_has_medians_of_their_times_and_of_the_ratios_of_each_round(
    bench_peers,
):
    ours = {"Q+SR": 0.1e-6, "SL+SR": 0.2e-6}
    rounds = [
        ({"Q+SR": {"MushroomRL": 80e-6, "plain NumPy": 20e-6}, "SL+SR": {"MushroomRL": 300e-6}}, ours),
        ({"Q+SR": {"MushroomRL": 90e-6, "plain NumPy": 30e-6}, "SL+SR": {"MushroomRL": 310e-6}}, ours),
        ({"Q+SR": {"MushroomRL": 990e-6, "plain NumPy": 900e-6}, "SL+SR": {"MushroomRL": 900e-6}},
         {"Q+SR": 99e-6, "SL+SR": 90e-6}),
    ]  # fmt: skip
    (q, q_measured, _), (sarsa, sarsa_measured, _) = bench_peers(rounds)
    assert "Q+SR" in q and "SL+SR" in sarsa
    assert (
        q_measured
        == "here 0.10 µs; MushroomRL 90 µs: 800 times as long; plain NumPy 30 µs: 200 times as long"
    )
    assert sarsa_measured == "here 0.20 µs; MushroomRL 310 µs: 1,500 times as long"


def test_where_others_cannot_be_installed_the_row_says_so_and_the_terminal_why(
    bench_peers, capsys
):
    def rounds():
        raise subprocess.CalledProcessError(1, "uv", stderr=b"no network")
        yield

    ((_, measured, _),) = bench_peers(rounds())
    assert (
        measured
        == "not measured: mushroom-rl==1.10.2 could not be installed or run here"
    )
    assert "no network" in capsys.readouterr().err
