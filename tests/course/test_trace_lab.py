"""The trace lab: what it learns is what the library's agents and the ideal learn, and what it says is true."""

import json
import re

import numpy as np
import pytest
from in_node import run
from test_handles import LETTER, PHONE, asked

from rlrobot_course.lesson_07.handles import traces_on_a_path
from rlrobot_course.lesson_08.exercises import true_online_update
from rlrobot_course.lesson_08.forward_view import online_lambda_return as ideal_of
from rlrobot_course.lesson_08.forward_view import replay
from rlrobot_course.lesson_08.handles import traces_and_ideal, with_and_without_q_old
from rlrobot_course.trace_lab import kernels
from rlrobot_course.trace_lab.lab import CELLS, COLUMNS, PATHS, PAYS, numbered
from rlrobot_edu.learning.size import Size

N = len(CELLS)
REPLACING, ACCUMULATING, TRUE_ONLINE = range(3)


def random_path(seed: int, steps: int = 25) -> list[int]:
    rng = np.random.default_rng(seed)
    path = [int(rng.integers(N))]
    while len(path) <= steps:
        row, column = divmod(path[-1], COLUMNS)
        down, right = [(0, 0), (0, 1), (1, 0), (0, -1), (-1, 0)][rng.integers(5)]
        if 0 <= row + down < N // COLUMNS and 0 <= column + right < COLUMNS:
            path.append((row + down) * COLUMNS + column + right)
    return path


def rewards_of(path: list[int]) -> np.ndarray:
    return np.array([PAYS.get(CELLS[cell], 0.0) for cell in path[1:]])


def steps_of(path: list[int]) -> list[tuple]:
    rewards = rewards_of(path).tolist()
    return [
        (s, 0, r, s_next, 0, False)
        for s, r, s_next in zip(path, rewards, path[1:], strict=False)
    ]


def tables(path: list[int]) -> tuple[np.ndarray, ...]:
    """q, e, delta and q_old for a kernel."""
    n = len(path)
    return np.zeros((n, N)), np.zeros((n, N)), np.zeros(n), np.zeros(n)


SETTINGS = [(0.5, 0.9, 0.9), (0.1, 0.95, 0.4), (1.0, 0.7, 1.0), (0.3, 0.9, 0.0)]
PATHS_AND_SETTINGS = [(seed, *settings) for seed, settings in enumerate(SETTINGS)]


@pytest.mark.parametrize("seed, alpha, gamma, lam", PATHS_AND_SETTINGS)
def test_each_kernel_learns_what_the_librarys_agent_learns(seed, alpha, gamma, lam):
    path = random_path(seed)
    settings = np.array(path), rewards_of(path), alpha, gamma, lam
    for trace in ("replacing", "accumulating", "dutch"):
        q, e, delta, q_old = tables(path)
        if trace == "dutch":
            kernels.true_online(q, e, delta, q_old, *settings, 1, 1)
        else:
            kernels.sarsa_lambda(q, e, delta, *settings, int(trace == "accumulating"))
        own = {"alpha": alpha, "gamma": gamma, "lam": lam, "traces": "full"}
        agents = replay(trace, steps_of(path), Size((N,), 1), **own)
        for t, agent in enumerate(agents, start=1):
            np.testing.assert_allclose(q[t], agent.q[:, 0], rtol=1e-9, atol=1e-9)
            faded = gamma * lam * e[t]  # the agent's traces have faded by then
            np.testing.assert_allclose(faded, agent.e[:, 0], rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("seed, alpha, gamma, lam", PATHS_AND_SETTINGS)
def test_the_ideal_is_the_lessons_and_true_online_meets_it(seed, alpha, gamma, lam):
    path = random_path(seed)
    settings = np.array(path), rewards_of(path), alpha, gamma, lam
    ideal = np.zeros((len(path), N))
    kernels.online_lambda_return(ideal, *settings)
    theirs = ideal_of(steps_of(path), np.zeros((N, 1)), alpha, gamma, lam)
    for t, q in enumerate(theirs, start=1):
        np.testing.assert_allclose(ideal[t], q[:, 0], rtol=1e-12, atol=1e-12)
    q, *more = tables(path)
    kernels.true_online(q, *more, *settings, 1, 1)
    np.testing.assert_allclose(q, ideal, rtol=1e-9, atol=1e-9)


def test_q_old_is_what_the_learners_update_returns():
    path = random_path(7)
    settings = 0.4, 0.9, 0.8
    q, e, delta, q_old = tables(path)
    kernels.true_online(
        q, e, delta, q_old, np.array(path), rewards_of(path), *settings, 1, 1
    )
    mine, traces, noted = np.zeros((N, 1)), np.zeros((N, 1)), 0.0
    for t, step in enumerate(steps_of(path), start=1):
        assert q_old[t] == pytest.approx(noted)
        noted = true_online_update(mine, traces, noted, *step, *settings)
        np.testing.assert_allclose(q[t], mine[:, 0], rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("seed", range(3))
def test_the_page_computes_what_python_computes(seed):
    path = random_path(seed)
    settings = {"alpha": 0.35, "gamma": 0.8, "lam": 0.95}
    given = np.array(path), rewards_of(path), *settings.values()
    change = {"path": path, "step": len(path) - 1, **settings}
    told = asked(traces_and_ideal(), *({**change, "kind": kind} for kind in range(3)))
    for kind, each in enumerate(told[1:]):
        q, e, delta, q_old = tables(path)
        if kind == TRUE_ONLINE:
            kernels.true_online(q, e, delta, q_old, *given, 1, 1)
        else:
            kernels.sarsa_lambda(q, e, delta, *given, int(kind == ACCUMULATING))
        ideal = np.zeros_like(q)
        kernels.online_lambda_return(ideal, *given)
        for name, right in {"q": q, "e": e, "delta": delta, "ideal": ideal}.items():
            np.testing.assert_array_equal(each["found"][name], right)


def test_the_titles_of_lesson_08_have_the_numbers_of_the_lesson():
    bump = asked(
        traces_and_ideal(),
        {"kind": REPLACING},
        {"kind": TRUE_ONLINE},
        {"kind": ACCUMULATING, "step": 1},
    )
    assert [told["finding"] for told in bump] == [
        "Accumulating traces: Q of A, left 9 times, is 104.8 below the ideal",
        "Replacing traces: Q of A, left 9 times, is 5.63 above the ideal",
        "True online is the ideal, in every cell",
        "Accumulating traces: no gap to the ideal after this step",
    ]
    assert "δ = −74.90, e(A) = 4.47, so α · e = 2.24 is above 1" in bump[0]["said"]
    turns = asked(
        with_and_without_q_old(), {"first": False}, {"first": True, "second": False}
    )
    assert [told["finding"] for told in turns] == [
        "True online is the ideal, in every cell",
        "Without q_sa − Q_old in the first line: Q of A, left twice, is 2.69 below the ideal",
        "Without the second line: Q of A, left twice, is 2.03 above the ideal",
    ]
    assert "Q_old = 0.00; now q_sa = 4.05; δ + q_sa − Q_old = 4.50" in turns[0]["said"]
    assert turns[0]["found"]["q"][3][:2] == pytest.approx([5.0131, 6.8225], abs=1e-4)


def test_the_titles_of_lesson_07_say_whom_a_step_teaches():
    path = numbered("LLKJFBA")
    told = asked(
        traces_on_a_path(),
        {"step": 4},
        {"step": 5, "lam": 0},
        {"path": path, "step": 6, "kind": ACCUMULATING, "lam": 0.9},
        {"path": [11], "step": 0},
        {"path": []},
    )
    assert [each["finding"] for each in told] == [
        "Step 5 teaches 5 cells: B most, +1.00, and L least, +0.43",
        "Step 4 teaches nothing, for δ = 0; 4 cells have a trace",
        "Step 5 teaches B alone: +1.00",
        "Step 6 teaches 5 cells: B most, +1.00, and K least, +0.53",
        "The path begins in L: press a cell beside it",
        "Press a cell: the path begins there",
    ]


def test_paths_are_drawn_cell_by_cell():
    shown = traces_on_a_path()
    presses = [*"LKJA", "undo", "clear", *"AAE", "path a loop", *["K"] * 5]
    told = run(
        f"{shown.script}\nconst feed = {json.dumps(shown.feed)}, told = [];\n"
        "let values = { ...handle.begins(feed), step: 5, path: [] };\n"
        f"for (const name of {json.dumps(presses)}) {{\n"
        "  values = { ...values, ...handle.picked(feed, values, name) };\n"
        "  told.push([values.path.map((c) => feed.cells[c]).join(''), values.step, values.note]);\n"
        "}\nconsole.log(JSON.stringify(told));"
    )
    ways = [way for way, *_ in told]
    assert ways[:9] == ["L", "LK", "LKJ", "LKJ", "LK", "", "A", "AA", "AAE"]
    assert told[3][2] == "A does not touch J, where the path ends. "
    assert ways[9] == PATHS["a loop"] and told[9][1] == len(PATHS["a loop"]) - 1
    assert told[-1][2] == "K does not touch A, where the path ends. "


@pytest.mark.parametrize("lab", [traces_and_ideal, with_and_without_q_old])
def test_even_values_without_bounds_fit_on_a_phone(lab):
    wild = {"alpha": 1, "gamma": 1, "lam": 1, "first": False}
    ways = [random_path(seed, steps=30) for seed in range(4)] + [[0] * 31]
    kinds = range(len(lab().feed["kinds"]))
    changes = [
        {**wild, "path": way, "step": 30, "kind": kind}
        for way in ways
        for kind in kinds
    ]
    for told in asked(lab(), *changes, width=PHONE):
        assert "NaN" not in told["picture"] + told["finding"] + told["said"]
        found = re.findall(r'<text x="([\d.]+)"[^>]*>([^<]*)<', told["picture"])
        assert found and max(len(text) for _, text in found) * LETTER < PHONE / 2


def test_every_path_that_it_offers_goes_from_cell_to_cell():
    for way in PATHS.values():
        for a, b in zip(numbered(way), numbered(way)[1:], strict=False):
            rows, columns = zip(divmod(a, COLUMNS), divmod(b, COLUMNS), strict=True)
            assert abs(rows[0] - rows[1]) + abs(columns[0] - columns[1]) <= 1


def test_the_still_says_what_the_handle_says_at_its_opening():
    for lab in (traces_on_a_path, traces_and_ideal, with_and_without_q_old):
        shown = lab()
        finding = asked(shown)[0]["finding"]
        assert shown.picture.finding == finding
        assert finding in shown.still().alt


def test_true_online_says_that_it_is_the_ideal_wherever_it_is():
    ways = [
        {"path": random_path(seed), "step": step, "alpha": alpha, "lam": lam}
        for seed, step, alpha, lam in [
            (1, 25, 1, 1),
            (2, 9, 0.05, 0.3),
            (3, 20, 0.6, 0),
        ]
    ]
    for told in asked(with_and_without_q_old(), *ways):
        assert told["finding"] == "True online is the ideal, in every cell"
        assert abs(told["found"]["gap"]["by"]) < 1e-9
