"""The galleries of tasks and of datasets, from the tasks, their pictures and the datasets' own cards."""

import json
from pathlib import Path

import rlrobot_edu as rl
from rlrobot_edu.task.task_file import available_tasks

DATASETS = Path(__file__).parents[2] / "datasets"


def task_card(name: str) -> str:
    task = rl.load_task(name)
    first, _, _ = task.description.partition("\n")
    sizes = f"{task.states.n} states × {task.actions.n} actions; robot `{task.robot}` in `{task.scene}`"
    curve = "learning curve of TOSL+QBIASSR above that of a robot that acts at random"
    pictures = (
        f'<img src="pictures/{name}.png" width="260" alt="{name}: the robot in its room with the path of 100 steps">\n'
        f'<img src="pictures/{name}_learning.png" width="380" alt="{name}: {curve}">'
    )
    files = f"[Its file](../tasks/{name}.py) · [its recording](../datasets/{name}/README.md)"
    return f"## {name}\n\n{first}\n\n{sizes}.\n\n{pictures}\n\n{files}\n"


def dataset_row(folder: Path) -> str:
    package = json.loads((folder / "datapackage.json").read_text(encoding="utf-8"))
    rows = len(rl.read_recording(folder.name))
    size = sum(resource["bytes"] for resource in package["resources"]) / 1e6
    link = f"[{folder.name}](../datasets/{folder.name}/README.md)"
    return f"| {link} | {package['title']} | {rows:,} | {size:.1f} MB | {package['licenses'][0]['name']} |"


def write_galleries(folder: Path) -> None:
    """tasks.md and datasets.md."""
    about = (
        "`rl.load_task(name)` reads a task, `rl.make_env(name)` makes its robot. Each is one file to read. "
        "Pictures: the robot after one hour of learning, and means of 10 repetitions with 95 % intervals."
    )
    cards = "\n".join(task_card(name) for name in available_tasks())
    (folder / "tasks.md").write_text(
        f"# Gallery of tasks\n\n{about}\n\n{cards}", encoding="utf-8"
    )

    folders = sorted(path.parent for path in DATASETS.glob("*/datapackage.json"))
    about = "`rl.read_recording(name)` reads a recording: rows (s, a, r, s') of the toolkit's own robots."
    table = [
        "| dataset | what it is | rows | size | licence |",
        "|---|---|---:|---:|---|",
        *map(dataset_row, folders),
    ]
    toc = "\n".join(f"../datasets/{path.name}/README" for path in folders)
    text = [
        f"# Gallery of datasets\n\n{about}\n",
        *table,
        "",
        f"```{{toctree}}\n:hidden:\n\n{toc}\n```",
        "",
    ]
    (folder / "datasets.md").write_text("\n".join(text), encoding="utf-8")
