"""The playground lives the library's life: node, with the page's own script, beside `rl.learn`."""

import json
import shutil
import subprocess
from importlib.resources import files

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.widgets.playground.cliff import cliff_model
from rlrobot_edu.widgets.playground.page import (
    AGES,
    DAY,
    LUCKS,
    METHODS,
    SCORES,
    SHOWS,
    TASKS,
    simulation_script,
)
from rlrobot_edu.widgets.playground.worlds import cells_world

STEPS = 10_000
needs_node = pytest.mark.skipif(
    shutil.which("node") is None, reason="node is missing: it runs JavaScript"
)
LIVE = """
const told = {};
for (const [name, settings, steps] of JOBS) {
  const simulation = newSimulation({ ...about.parameters, luck: 0, ...settings }, settings.walls);
  let sum = 0;
  for (let i = 0; i < steps; i++) sum += simulation.step().r;
  told[name] = { q: simulation.m.q.map((row) => Array.from(row)), sum };
}
console.log(JSON.stringify(told));
"""


def lived(*jobs):
    """What came of lives in JavaScript, each a name, settings and a number of steps."""
    script = f"{simulation_script()}\nconst JOBS = {json.dumps(jobs)};\n{LIVE}"
    done = subprocess.run(
        ["node", "-"], input=script, capture_output=True, text=True, check=True
    )
    return json.loads(done.stdout)


def learned(task, method, seed=0, steps=STEPS, **parameters):
    """The Q that the library learns."""
    if task == "cliff":
        agent = rl.Agent(cliff_model(), method, seed=seed, r_max=1.0, **parameters)
        env = rl.make_env(cliff_model(), seed=seed)
    else:
        agent = rl.Agent(task, method, seed=seed, **parameters)
        env = rl.make_env(
            task, seed=seed, engine="kinematic" if task in TASKS else None
        )
    rl.learn(agent, env, steps=steps, progress=False)
    return agent.q


SOME = (("wander_1k", "TOSL+QBIASSR"), ("navigation_1k", "SL+SR"), ("cliff", "Q+EG"))
ALL = (
    *((task, "Q+EG") for task in (*TASKS, "cliff")),
    *(("navigation_1k", method) for method in METHODS),
)


@pytest.mark.long
@needs_node
@pytest.mark.parametrize("pairs", [SOME, pytest.param(ALL, marks=pytest.mark.nightly)])
def test_each_method_learns_to_the_last_bit_what_the_library_learns(pairs):
    told = lived(*((f"{t} {m}", {"task": t, "method": m}, STEPS) for t, m in pairs))
    for task, method in pairs:
        np.testing.assert_array_equal(
            told[f"{task} {method}"]["q"],
            learned(task, method),
            err_msg=f"{task} {method}",
        )


@needs_node
def test_sliders_and_luck_are_the_librarys_parameters_and_seed():
    given = {"alpha": 0.5, "gamma": 0.8, "lam": 0.3, "temperature": 5}
    told = lived(
        ("one", {"task": "navigation_1k", "method": "SL+SR", "luck": 7, **given}, 4000)
    )
    np.testing.assert_array_equal(
        told["one"]["q"], learned("navigation_1k", "SL+SR", seed=7, steps=4000, **given)
    )


@needs_node
def test_a_wall_that_was_moved_changes_what_comes():
    wall = [0.5, 0.0, 0.5, 90]  # across its way
    settings = {"task": "wander_1k", "method": "Q+RANDOM"}
    told = lived(
        ("as it was", settings, 500), ("moved", {**settings, "walls": [wall]}, 500)
    )
    assert told["as it was"]["sum"] != told["moved"]["sum"]


SCORED = """
const told = {};
for (const [name, task, luck, steps] of JOBS) {
  const run = new Run({ ...about.parameters, luck, task, method: "TOSL+QBIASSR" }, null);
  const { atMost } = run.world.score, counts = [], rewards = [];
  for (let t = 0; t < steps; t++) {
    run.step();
    const { r, terminated } = run.simulation.last;
    counts.push(atMost === null ? terminated : r <= atMost);
    rewards.push(r);
  }
  const { score, curve } = run, points = curve.of("counts"), means = curve.of("rewards");
  told[name] = { first: score.first, last: score.last, points, means, counts: counts.map(Number), rewards };
}
console.log(JSON.stringify(told));
"""


def scored(*jobs):
    """Score and curve of runs, each a name, a task, a seed and a number of steps, and what happened in each step."""
    folder = files("rlrobot_edu.widgets.playground")
    shown = [
        folder.joinpath(name).read_text("utf-8") for name in ("curve.js", "run.js")
    ]
    script = [simulation_script(), *shown, f"const JOBS = {json.dumps(jobs)};", SCORED]
    done = subprocess.run(
        ["node", "-"],
        input="\n".join(script),
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(done.stdout)


@pytest.mark.long
@needs_node
def test_each_point_of_the_curve_is_the_score_of_that_step():
    """Counted anew from what happened: the first and the last ten minutes, and all in between."""
    told = scored(("hour", "wander_1k", 0, 3600), ("day", "wander_1k", 0, DAY))
    for name, end in (("hour", 3600), ("day", DAY)):
        run = told[name]
        assert run["points"][0] == [600, run["first"]]
        assert run["points"][-1] == [end, run["last"]]
        assert len(run["points"]) <= 241
        for what, points in (("counts", run["points"]), ("rewards", run["means"])):
            happened = np.array(run[what])
            for step, value in points:
                before = happened[step - 600 : step]
                expected = before.sum() if what == "counts" else before.mean()
                assert value == pytest.approx(expected, abs=1e-9)


@pytest.mark.long
@needs_node
def test_a_task_is_there_because_learning_shows_in_most_seeds_and_the_page_opens_with_the_first():
    jobs = []
    for task, ages in AGES.items():
        jobs += [(f"{task} {seed}", task, seed, ages[1][0]) for seed in range(LUCKS)]
    told = scored(*jobs)
    for task in AGES:
        shows = []
        for seed in range(LUCKS):
            first, last = (
                told[f"{task} {seed}"]["first"],
                told[f"{task} {seed}"]["last"],
            )
            is_arrivals = SCORES[task]["atMost"] is None
            shows.append(
                last >= max(2 * first, 2) if is_arrivals else 2 * last <= first
            )
        assert sum(shows) == SHOWS[task] >= LUCKS / 2
        assert shows[0]


DIGITS = """
console.log(JSON.stringify([
  [0, 1e-9, 0.002, -0.00213, 0.05, 0.53, -12.3, 123.4].map(number),
  apart(1.2804, 1.2801), apart(-0.00001, 0.00002), apart(0.5, 0.5), apart(1, 2),
]));
"""


@needs_node
def test_numbers_have_the_digits_that_show_what_has_changed():
    folder = files("rlrobot_edu.widgets.playground")
    numbers_js = folder.joinpath("numbers.js").read_text("utf-8")
    done = subprocess.run(
        ["node", "-"],
        input=numbers_js + DIGITS,
        capture_output=True,
        text=True,
        check=True,
    )
    numbers, near, signs, same, far = json.loads(done.stdout)
    assert numbers == [
        "0.00", "0.00", "0.0020", "−0.0021", "0.050", "0.53", "−12.30", "123.4",
    ]  # fmt: skip
    assert near == ["1.2804", "1.2801"] and same == ["0.50", "0.50"]
    assert signs == ["−0.00001", "0.00002"] and far == ["1.00", "2.00"]


def test_what_the_worked_example_does_stands_in_its_table():
    """The library's robot acts by chance: each of its steps is in the table, and the box moves as often as it says."""
    world, env = (
        cells_world(rl.load_task("worked_example")),
        rl.make_env("worked_example", seed=0),
    )
    tables = {name: np.array(value) for name, value in world["tables"].items()}
    places = [(tuple(d["cell"]), d["heading"], tuple(d["box"])) for d in world["drawn"]]
    rng, robot, moves, steps = np.random.default_rng(0), env.unwrapped.robot, 0, 4000

    def here():
        return places.index((robot._cell, robot._heading, robot._box))

    env.reset()
    for _ in range(steps):
        place, a = here(), int(rng.integers(3))
        _, r, _, truncated, info = env.step(a)
        first, end = tables["offsets"][3 * place + a : 3 * place + a + 2]
        assert (here(), r) in list(
            zip(tables["s_next"][first:end], tables["r"][first:end], strict=True)
        )
        assert world["seen"][here()] == info["state"]
        moves += places[place][2] != robot._box
        if truncated:
            env.reset()
            assert here() == tables["starts"][0]
    assert moves / steps == pytest.approx(0.1, abs=5 * np.sqrt(0.1 * 0.9 / steps))
    counts = tables["cumulative"].reshape(-1, 3)
    assert (np.diff(counts, axis=1, prepend=0) / 20 == [0.9, 0.05, 0.05]).all()


def test_the_page_is_small_and_asks_for_nothing_from_elsewhere(tmp_path):
    rl.playground(tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert len(page.encode()) < 150_000
    assert (
        'property="og:description" content="Nobody tells this robot how to drive.'
        in page
    )
    assert "http" not in page.replace('http-equiv="Content-Security-Policy"', "")


def test_a_task_or_method_that_the_page_does_not_have_is_refused_with_those_that_it_has():
    with pytest.raises(ValueError, match=r"the playground has no task 'clif'.*cliff"):
        rl.playground(task="clif")
    with pytest.raises(ValueError, match="the playground has no task 'wander_simple'"):
        rl.playground(task="wander_simple")
    with pytest.raises(
        ValueError, match=r"the playground has no method 'SARSA'.*SARSA\+EG"
    ):
        rl.playground(method="SARSA")
    assert '"method": "SARSA+EG"' in rl.playground(task="cliff", method="SARSA+EG").html
