"""What grows when it runs for long: ``make soak``, some ten minutes. Not part of ``make test``.

Ten million steps on a model, a million on a robot, 300 times each robot made, run, copied and closed, and 20 live views
that nobody closes. Memory, threads, open files and sockets are counted after a warm-up and at the end; a table shows
how many came, and the script fails if any did.

Memory may grow by 3 MB in each of these: allocators keep a little of what they once had, and up to 1 MB of such noise
has been seen. A leak of 10 kB in each of 300 rounds is found, or of 1 byte in each of 3 million steps. Of threads,
files and sockets, none may be left.
"""

import copy
import gc
import sys
import time
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import psutil
from tqdm import tqdm

import rlrobot_edu as rl
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.task_file import available_tasks

MEMORY = 3e6  # tolerated growth [byte]
PROCESS = psutil.Process()


class Held(NamedTuple):
    """What this process holds: memory [byte], and numbers of threads, open files and sockets."""

    memory: int
    threads: int
    files: int
    sockets: int

    @classmethod
    def now(cls) -> "Held":
        """As it is when all garbage has been collected."""
        gc.collect()
        files = getattr(PROCESS, "num_fds", getattr(PROCESS, "num_handles", None))()
        return cls(
            PROCESS.memory_info().rss,
            PROCESS.num_threads(),
            files,
            len(PROCESS.net_connections()),
        )


def growth(name: str, work: Callable[[], object], rounds: int, warm_up: int) -> Held:
    """What `rounds` of `work` leave behind, after others that fill caches."""
    for _ in range(warm_up):
        work()
    before = Held.now()
    for _ in tqdm(range(rounds), name, leave=False):
        work()
    time.sleep(1.5)  # a live view's last answer may still be on its way
    return Held(*(b - a for a, b in zip(before, Held.now(), strict=True)))


def learn(agent: rl.Agent, env, steps: int) -> None:
    """Let the agent go on learning."""
    rl.learn(agent, env, steps=steps, progress=False)


def one_life(task: str, engine: str) -> None:
    """Make an environment, act in it and in a copy of it, and close both."""
    env = rl.make_env(task, seed=0, engine=engine)
    env.reset()
    for action in range(3):
        env.step(action)
    twin = copy.deepcopy(env)
    twin.step(0)
    twin.close()
    env.close()


def all_works() -> dict[str, tuple[Callable[[], object], int, int]]:
    """By name: what to do, how many times, and how many times before that."""
    model = rl.SampleModel.from_recording(rl.read_recording("wander_1k"))
    on_model = partial(
        learn, rl.Agent(model, seed=0), rl.make_env(model, seed=0), 100_000
    )
    on_robot = partial(
        learn,
        rl.Agent("wander_simple", seed=0),
        rl.make_env("wander_simple", seed=0),
        10_000,
    )
    works = {
        "10 million steps on a model": (on_model, 100, 10),
        "a million steps on a robot": (on_robot, 100, 10),
    }
    tasks = {rl.load_task(name).robot: name for name in available_tasks()}
    for robot, task in tasks.items():
        for engine in ROBOTS[robot].engines:
            works[f"300 lives of {robot}, {engine}"] = (
                partial(one_life, task, engine),
                300,
                60,
            )
    return works


def main() -> None:
    tqdm.monitor_interval = 0  # no thread of its own
    print(
        f"| {'what':42} | minutes | memory (kB) | threads | files | sockets |\n|---|---|---|---|---|---|",
        flush=True,
    )
    grown = []
    for name, work in all_works().items():
        start = time.monotonic()
        memory, *others = growth(name, *work)
        minutes, counts = (
            (time.monotonic() - start) / 60,
            " | ".join(f"{n:+d}" for n in others),
        )
        print(
            f"| {name:42} | {minutes:.1f} | {memory / 1e3:+.0f} | {counts} |",
            flush=True,
        )
        if memory > MEMORY or max(others) > 0:
            grown.append(name)
    if grown:
        sys.exit(
            f"Something grew: {', '.join(grown)}. Memory may by {MEMORY / 1e6:.0f} MB, all else not at all."
        )


if __name__ == "__main__":
    main()
