"""Record the toolkit's datasets anew: ``python datasets/make_datasets.py [name …]``. The same bytes every time.

Each is 18,000 steps (five hours of the robot's time) of an agent that learns with TOSL+SR, the paper's defaults and
seed 0, and so explores as it goes.
"""

import sys
from pathlib import Path

import rlrobot_edu as rl

DATASETS = {
    "wander_simple": {"method": "TOSL+SR", "steps": 18_000, "seed": 0},
    "wander_1k": {"method": "TOSL+SR", "steps": 18_000, "seed": 0},
}


def make_dataset(name: str, folder: Path) -> None:
    """Record one dataset into `folder`/`name`."""
    how = DATASETS[name]
    env = rl.make_env(name, seed=how["seed"])
    agent = rl.Agent(name, how["method"], seed=how["seed"])
    rl.record(env, agent, steps=how["steps"]).save(folder / name)


if __name__ == "__main__":
    for name in sys.argv[1:] or DATASETS:
        make_dataset(name, Path(__file__).parent)
        print(name)
