"""Record the toolkit's datasets anew: ``python datasets/make_datasets.py [name …]``. The same bytes every time.

Each agent learns while it is recorded, with the paper's defaults and seed 0, and so explores as it goes. 18,000 steps
are five hours of the robot's time.
"""

import sys
from pathlib import Path

import gymnasium
import numpy as np

import rlrobot_edu as rl
from rlrobot_edu.files import write_whole

FIVE_HOURS = {"method": "TOSL+SR", "steps": 18_000, "seed": 0}
DATASETS = {
    "worked_example": FIVE_HOURS,
    "wander_simple": FIVE_HOURS,
    "wander_1k": FIVE_HOURS,
    "wander_4k": FIVE_HOURS,
    "wander_12k": FIVE_HOURS,
    # TOSL drives the same way again after 30 episodes; Q-learning takes its time and sees more of the room.
    "navigation_1k": {"method": "Q+SR", "episodes": 50, "seed": 0},
    "giraff_wander_simple": FIVE_HOURS,
    "giraff_wander_1k": FIVE_HOURS,
    "giraff_wander_4k": FIVE_HOURS,
    "arm_1k": {"method": "TOSL+SR", "episodes": 150, "seed": 0},
    "arm_4k": {"method": "TOSL+SR", "episodes": 150, "seed": 0},
    "mobile_arm_2k": {"method": "TOSL+SR", "steps": 18_000, "seed": 0},
}

CARD = """# Dataset {name}

{title}

| | |
|---|---|
| What | {rows:,} transitions (s, a, r, s') in {episodes}; the task is [tasks/{name}.py](../../tasks/{name}.py) |
| How | `python datasets/make_datasets.py {name}` records the same bytes again (on {platform}) |
| Robot and scene | `{robot}` in `{scene}`, one step is {step_time:g} s |
| Method | {method}, the paper's default parameters, seed {seed}; it learned while it was recorded |
| Files | `transitions.csv`; `datapackage.json` says what the numbers mean (Frictionless data package) |
| Licence | [CC0 1.0](https://creativecommons.org/publicdomain/zero/1.0/): public domain |

Read it with `rl.read_recording("{name}")`.

## Columns

| column | meaning |
|---|---|
| `episode`, `step` | number of the episode and of the step in it, from 0 |
| `s`, `s_next` | state before and after the step, 0 to {last_state}: {inputs}; the first varies slowest |
| `a` | action, 0 to {last_action}: {outputs}; the first varies slowest |
| `r` | reward: {rewards} |
| `terminated` | 1 if the episode reached its end with this step |

Rewards seen: {seen}.

## Coverage and known weaknesses

What `rl.SampleModel.from_recording(recording).diagnose()` finds:

```
{diagnosis}
```

A model made from these rows knows nothing of the pairs that were not seen, takes what was seen once for certain, and
may go round for ever in a loop that was lucky once. An agent that learned chose the actions: the states it liked are
seen often, those it avoided seldom.{unmet}
"""


def learner(name: str, method: str, seed: int) -> tuple[rl.Agent, gymnasium.Env]:
    """An agent and its environment.

    The datasets are older than the environments' own random numbers. So that their rows stay as they were, both draw
    the agent's here, each for itself. It matters in worked_example alone, whose box moves by chance.
    """
    return rl.Agent(name, method, seed=seed), rl.make_env(
        name, seed=np.random.SeedSequence(seed)
    )


def make_dataset(name: str, folder: Path) -> None:
    """Record one dataset into `folder`/`name`."""
    how = dict(DATASETS[name])
    agent, env = learner(name, how.pop("method"), how.pop("seed"))
    recording = rl.record(agent, env, **how)
    recording.save(folder / name)
    write_whole(folder / name / "README.md", card(name, recording))


def card(name: str, recording: rl.Recording) -> str:
    """The dataset in words."""
    task, source = recording.task, recording.source
    seen = {r: int((recording.r == r).sum()) for r in source.rewards}
    unmet = [f"{r:g}" for r, times in seen.items() if not times]
    return CARD.format(
        name=name,
        title=task.description.partition("\n")[0],
        rows=len(recording),
        episodes="one episode"
        if recording.episode[-1] == 0
        else f"{recording.episode[-1] + 1:,} episodes",
        platform=source.platform,
        robot=source.robot,
        scene=source.scene,
        step_time=source.step_time,
        method=source.method,
        seed=source.seed,
        last_state=source.states.n - 1,
        last_action=source.actions.n - 1,
        inputs=", ".join(f"`{v.name}` ({v.n_bins} bins)" for v in task.inputs),
        outputs=", ".join(f"`{v.name}` ({len(v.values)} values)" for v in task.outputs),
        rewards=", ".join(f"{r:g}" for r in source.rewards),
        seen=", ".join(f"{r:g} {times:,} times" for r, times in seen.items()),
        diagnosis=rl.SampleModel.from_recording(recording).diagnose(),
        unmet=f" The reward {' and '.join(unmet)} never came." if unmet else "",
    )


if __name__ == "__main__":
    for name in sys.argv[1:] or DATASETS:
        make_dataset(name, Path(__file__).parent)
        print(name)
