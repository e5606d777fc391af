"""How fast the toolkit is, against plain NumPy, MushroomRL and what was asked for: ``make bench``.

Prints a table and writes it to README.md beside this file. Times are medians of several runs in one go; a ratio
compares two things timed side by side. Numbers of another machine will differ, ratios less so.
"""

from __future__ import annotations

import io
import json
import os
import platform
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
import tracemalloc
from pathlib import Path

import numpy as np

import rlrobot_edu as rl
from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.memory import new_memory
from rlrobot_edu.learning.parameters import Parameters
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.robots.arenas import ARENAS
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.robots.engines.kinematic.base import Body, walls_of
from rlrobot_edu.robots.engines.kinematic.motion import drive, look

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tests")]
from oracles import NumpyModelWorld, learn_in_one_file  # noqa: E402 (the oracle of the tests is the one to beat)

STEPS = 3600
PEERS = (
    "mushroom-rl==1.10.2",
    f"numpy=={np.__version__}",
    "tqdm",
)  # without what its tables do not need, see peers.py
FACTS = (
    "offsets",
    "cumulative",
    "s_next",
    "r",
    "starts",
    "rewards",
    "n_states",
    "n_actions",
    "r_max",
)


def seconds(task, repeat: int = 5) -> float:
    """Median time of a call [s]."""
    times = []
    for _ in range(repeat):
        start = time.perf_counter()
        task()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def peak_megabytes(task) -> float:
    """Largest memory that a call holds at once [MB]."""
    tracemalloc.start()
    task()
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return peak / 1e6


def seconds_a_step(model, method, **parameters) -> float:
    """A step of a method, compiled, in one thread [s]."""
    steps = 100 * STEPS  # the compiled loops are too fast for fewer

    def learn():
        agent = rl.Agent(model, method, seed=7, **parameters)
        rl.learn(agent, rl.make_env(model, seed=11), steps=steps, progress=False)

    return seconds(learn, 1) / steps


def bench_methods(model):
    """A step of each method side by side, and of the plain loop that the tests compare with."""

    def plain():
        world = NumpyModelWorld(model, np.random.default_rng(11))
        learn_in_one_file(world, model, STEPS, np.random.default_rng(7))

    methods = ("TOSL+QBIASSR", "TOSL+SR", "SL+SR", "SARSA+SR", "Q+SR")
    for method in methods:
        seconds_a_step(model, method)
    rounds = [
        {"NumPy": seconds(plain, 1) / STEPS}
        | {method: seconds_a_step(model, method) for method in methods}
        for _ in range(5)
    ]
    names = ", ".join(
        f"{name} {statistics.median(r[name] for r in rounds) * 1e6:.2f}"
        for name in methods
    )
    yield "a step on the wander_1k model, compiled, one thread [µs]", names, "–"
    ratio = statistics.median(r["NumPy"] / r["TOSL+QBIASSR"] for r in rounds)
    slow = statistics.median(r["NumPy"] for r in rounds) * 1e6
    yield (
        "TOSL+QBIASSR in plain NumPy",
        f"{slow:.0f} µs a step: {ratio:.0f} times as long",
        "150 times",
    )
    ratio = statistics.median(r["Q+SR"] / r["TOSL+QBIASSR"] for r in rounds)
    yield "Q+SR against TOSL+QBIASSR", f"{ratio:.2f}", "0.3"


def rounds_with_peers(model):
    """Seconds of a step by others and by us, {method: {who: seconds}} and {method: seconds}, five times.

    Raises CalledProcessError if the others cannot be installed or run.
    """

    def run(*command, **more):
        return subprocess.run(command, check=True, capture_output=True, **more).stdout

    facts = io.BytesIO()
    np.savez(facts, **{name: getattr(model, name) for name in FACTS})
    with tempfile.TemporaryDirectory() as folder:
        run(sys.executable, "-m", "uv", "venv", folder, "--python", sys.executable)
        run(
            sys.executable,
            "-m",
            "uv",
            "pip",
            "install",
            "--python",
            folder,
            "--no-deps",
            *PEERS,
        )
        for _ in range(5):
            theirs = json.loads(
                run(f"{folder}/bin/python", HERE / "peers.py", input=facts.getvalue())
            )
            yield (
                theirs,
                {
                    method: seconds_a_step(model, method, loop_evasion=False)
                    for method in theirs
                },
            )


def bench_peers(rounds):
    """What others need for the same learning."""
    what = "a step of others on the wander_1k model"
    try:
        theirs, ours = zip(*rounds, strict=True)
    except subprocess.CalledProcessError as error:
        print(error.stderr.decode(), file=sys.stderr)
        yield what, f"not measured: {PEERS[0]} could not be installed or run here", "–"
        return
    for method, peers in theirs[0].items():
        cells = [f"here {statistics.median(us[method] for us in ours) * 1e6:.2f} µs"]
        for who in peers:
            times = [them[method][who] for them in theirs]
            ratio = statistics.median(
                time / us[method] for time, us in zip(times, ours, strict=True)
            )
            cells.append(
                f"{who} {statistics.median(times) * 1e6:.0f} µs: {ratio:,.0f} times as long"
            )
        yield f"{what}: {method} without loop evasion", "; ".join(cells), "–"


def bench_repetitions(model):
    def run(n_jobs):
        return lambda: rl.repeat(model, repetitions=1000, steps=STEPS, n_jobs=n_jobs)

    pairs = [(seconds(run(1), 1), seconds(run(-1), 1)) for _ in range(3)]
    one, both = (statistics.median(times) for times in zip(*pairs, strict=True))
    ratio = statistics.median(a / b for a, b in pairs)
    yield (
        "1000 repetitions × 3600 steps of it in one call",
        f"{one:.2f} s on one core, {both:.2f} s on {os.cpu_count()}: {ratio:.2f} times",
        "1.5 times",
    )


def bench_comparison(model):
    methods = ["TOSL+QBIASSR", "TOSL+SR", "Q+SR"]

    def compare(**more):
        return rl.compare(model, methods, 1000, steps=STEPS, progress=False, **more)

    def alone():
        for method in methods:
            for seed in range(100):
                agent, env = (
                    rl.Agent(model, method, seed=seed),
                    rl.make_env(model, seed),
                )
                rl.learn(agent, env, STEPS, progress=False)

    yield (
        "1000 repetitions × 3600 steps × 3 methods of it in one call of compare",
        f"{seconds(compare, 3):.1f} s",
        "10 s",
    )
    ratio = statistics.median(
        seconds(lambda: compare(n_jobs=1), 1) / (10 * seconds(alone, 1))
        for _ in range(3)
    )
    yield "what compare adds to its repetitions, on one core", f"{ratio - 1:.1%}", "3 %"
    with tempfile.TemporaryDirectory() as folder:
        stored = (
            seconds(lambda i=i: compare(store=Path(folder) / str(i)), 1)
            for i in range(3)
        )
        cost = statistics.median(
            with_store - seconds(compare, 1) for with_store in stored
        ) / (1000 * len(methods))
    yield (
        "what a store adds to each repetition, on all cores: a file on disk",
        f"{cost * 1e3:.1f} ms",
        "10 ms",
    )


def bench_robot():
    """The robot by itself, and with an agent that learns; the actions are the same."""
    env = rl.make_env("wander_1k", seed=0)
    actions = []

    def run():
        agent = rl.Agent("wander_1k", "TOSL+QBIASSR", seed=0)
        history = rl.learn(agent, env, steps=STEPS, keep=True, progress=False)
        actions[:] = history.transitions.a.tolist()

    def replay():
        env.reset()
        for a in actions:
            env.step(a)

    run()
    pairs = [(seconds(run, 1), seconds(replay, 1)) for _ in range(5)]
    learning, alone = (statistics.median(times) for times in zip(*pairs, strict=True))
    ratio = statistics.median(a / b for a, b in pairs)
    yield (
        "robot in the loop: pymunk base, 8 lasers, binning, reward; and with TOSL+QBIASSR",
        f"{STEPS / alone:,.0f} steps a second alone, {STEPS / learning:,.0f} with learning, which adds {ratio - 1:.0%}",
        "8,000 alone, 25 %",
    )


@compiled
def wander(choices, v, omega, place, body, walls, near, touch, lengths):
    """The kinematic base by itself: it moves and looks, again and again."""
    for a in choices:
        drive(
            place,
            v[a],
            omega[a],
            1.0,
            body.hull,
            body.radius,
            body.moment,
            walls,
            near,
            touch,
        )
        look(place, body.rays, 5.02, walls, lengths)


def bench_kinematic():
    """The base without an engine: the compiled loop of learning, and its geometry alone with the same actions."""
    env, steps = rl.make_env("wander_1k", seed=0, engine="kinematic"), 100 * STEPS
    twists = np.array(
        [PIONEER.twist(env.task.command_for(a)) for a in range(env.task.actions.n)]
    )
    v, omega = np.ascontiguousarray(twists.T)
    body, walls = Body.of(PIONEER), walls_of(ARENAS["maze_6x6"])
    room = np.empty(len(walls), np.int64), np.empty(7), np.empty(8)
    actions = np.zeros(steps, np.int64)

    def loop():
        agent = rl.Agent("wander_1k", "TOSL+QBIASSR", seed=0)
        actions[:] = rl.learn(
            agent, env, steps, keep=True, progress=False
        ).transitions.a

    def kernels():
        wander(
            actions, v, omega, np.array([PIONEER.axle, 0.0, 0.0]), body, walls, *room
        )

    loop(), kernels()
    pairs = [(seconds(loop, 1), seconds(kernels, 1)) for _ in range(5)]
    learning, alone = (statistics.median(times) for times in zip(*pairs, strict=True))
    ratio = statistics.median(b / a for a, b in pairs)
    yield (
        "kinematic base, 8 lasers: its geometry alone, compiled; and the loop with binning, reward and TOSL+QBIASSR",
        f"{steps / alone:,.0f} steps a second, {steps / learning:,.0f} with learning: {ratio:.2f} of it",
        "300,000 alone, 0.8",
    )


def bench_building():
    task = rl.load_task("wander_1k")
    source = rl.read_recording("wander_1k").source
    for n, limit in ((180_000, "0.2 s"), (10_000_000, "10 s")):
        rng = np.random.default_rng(0)
        never = np.zeros(n, dtype=bool)
        s, s_next = (
            rng.integers(task.states.n, size=n),
            rng.integers(task.states.n, size=n),
        )
        a, r = rng.integers(task.actions.n, size=n), rng.choice(task.rewards, size=n)
        recording = Recording(Transitions(s, a, r, s_next, never, never), source)

        def build(recording=recording):
            return rl.SampleModel.from_recording(recording)

        time_taken = seconds(build, 5 if n < 1e6 else 1)
        size = (
            sum(v.nbytes for v in vars(build()).values() if isinstance(v, np.ndarray))
            / 1e6
        )
        peak = peak_megabytes(build)
        yield (
            f"sample model from {n:,} random transitions (all outcomes different, the worst case)",
            f"{time_taken:.3f} s; the model has {size:.1f} MB, at the most {peak:.0f} MB while it is built",
            limit,
        )


def bench_set_up():
    shape, n_actions = (5, 5, 5, 5, 5, 4), 25

    def set_up():
        return new_memory(shape, n_actions, Parameters())

    memory = set_up()
    tables = sum(
        np.asarray(v).nbytes
        for k, v in memory._asdict().items()
        if k not in ("q", "e", "visits")
    )
    yield (
        "set-up for 12,500 states × 25 actions, Q and all; memory of QBIASSR and LRLE beside Q, traces and visits",
        f"{seconds(set_up, 20) * 1e3:.2f} ms; {tables / 1e6:.2f} MB",
        "10 ms, 5 MB",
    )


def bench_starts():
    def run(code, folder=ROOT):
        subprocess.run(
            [sys.executable, "-c", code], check=True, capture_output=True, cwd=folder
        )

    bare = seconds(lambda: run("pass"), 7)
    loaded = seconds(lambda: run("import rlrobot_edu"), 7)
    yield (
        "import rlrobot_edu (without the start of Python)",
        f"{loaded - bare:.2f} s",
        "0.5 s",
    )
    with (
        tempfile.TemporaryDirectory() as folder
    ):  # a fresh copy has no compiled kernels yet
        for name in ("rlrobot_edu", "rlrobot_course", "tasks", "datasets"):
            shutil.copytree(
                ROOT / name,
                Path(folder) / name,
                ignore=shutil.ignore_patterns("__pycache__"),
            )
        code = "from rlrobot_course.commands import compile_kernels; compile_kernels()"
        first = seconds(lambda: run(code, folder), 1)
        again = seconds(lambda: run(code, folder), 5)
    imports = seconds(
        lambda: run("import rlrobot_edu, numba, scipy.sparse, pymunk, gymnasium"), 5
    )
    yield (
        "first compilation of all kernels, with the start of Python",
        f"{first:.1f} s",
        "20 s",
    )
    yield (
        "the same from the cache; of it, the kernels alone (less the start of Python and the import of libraries)",
        f"{again:.2f} s; {again - imports:.2f} s",
        "1 s",
    )


def machine() -> str:
    """The processor, as far as the system tells, and what runs on it."""
    model = platform.processor() or platform.machine()
    if Path("/proc/cpuinfo").is_file():
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        model = next(
            (
                line.split(":")[1].strip()
                for line in lines
                if line.startswith("model name")
            ),
            model,
        )
    versions = ", ".join(
        f"{name} {__import__(name).__version__}" for name in ("numpy", "numba")
    )
    python = platform.python_version()
    return f"{model}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}, Python {python}, {versions}"


def main() -> None:
    model = rl.SampleModel.from_recording(rl.read_recording("wander_1k"))
    benches = [
        bench_methods(model), bench_peers(rounds_with_peers(model)), bench_repetitions(model),
        bench_comparison(model), bench_robot(), bench_kinematic(), bench_building(), bench_set_up(),
        bench_starts(),
    ]  # fmt: skip
    lines = [
        "# How fast it is",
        "",
        f"Measured by `make bench` on: {machine()}. Medians of one run; other machines differ, ratios less so.",
        "",
        "| what | measured | wanted |",
        "|---|---|---|",
    ]
    for bench in benches:
        for what, measured, wanted in bench:
            lines.append(f"| {what} | {measured} | {wanted} |")
            print(lines[-1], flush=True)
    (HERE / "README.md").write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
