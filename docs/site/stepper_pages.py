"""Steppers that live without a kernel: the pages that `Stepper.save` writes, in lessons and on a page of their own."""

import ast
import html
import json
import re
from pathlib import Path

import gymnasium

import rlrobot_edu as rl

METHODS = {
    "Q+EG": "Q-learning, lesson [02](../notebooks/02_q_learning.ipynb)",
    "SL+SR": "SARSA(λ), lesson [05](../notebooks/05_eligibility_traces.ipynb)",
    "TOSL+SR": "true online SARSA(λ), lesson [06](../notebooks/06_true_online_sarsa.ipynb)",
    "TOSL+QBIASSR": "the paper's method, lesson [07](../notebooks/07_qbiassr.ipynb)",
}
STEPS = 40
MORE = 20  # steps after the one that a lesson shows


def write_steppers(source: Path, extra: Path) -> None:
    """stepper.md into the source; the pages it shows to `extra`, which is copied as it is."""
    (extra / "steppers").mkdir(parents=True)
    text = [
        "# Steppers\n",
        f"`rl.Stepper(agent, env)` walks through an agent's learning, forward and back. Here are its first {STEPS} "
        "steps in the worked example, by four methods. Keys ← and →, Home and End work, too.\n",
    ]
    for method, about in METHODS.items():
        name = f"steppers/{method.lower().replace('+', '_')}.html"
        agent, env = rl.Agent("worked_example", method, seed=0), rl.make_env("worked_example", seed=0)
        rl.Stepper(agent, env).save(extra / name, STEPS)
        title = f"A stepper: {method} in the worked example"
        frame = f'<iframe class="stepper" src="{name}" title="{title}" loading="lazy"></iframe>'
        text += [f"## {method}\n", f'{about} · <a href="{name}">on a page of its own</a>\n', frame, ""]
    (source / "stepper.md").write_text("\n".join(text), encoding="utf-8")


def stepper_of(source: str, lesson: str) -> rl.Stepper:
    """What a notebook's cell shows. Its last line is the stepper; it knows the worlds of earlier cells."""
    cells = rl.load_task("worked_example")
    lake = gymnasium.make("FrozenLake-v1", is_slippery=False)
    names = {"rl": rl, "task": cells, "cells": cells, "lake": lake}
    *before, last = ast.parse(source).body
    assert isinstance(last, ast.Expr)
    exec(compile(ast.Module(before, []), lesson, "exec"), names)
    return eval(compile(ast.Expression(last.value), lesson, "eval"), names)


def enliven(notebook: Path, extra: Path) -> None:
    """Where a copy of a lesson shows a stepper's still twin, put the stepper; without scripts the twin stays.

    Raises ValueError if it is not at the step that the notebook has kept.
    """
    content, lesson = json.loads(notebook.read_text(encoding="utf-8")), notebook.stem
    for cell in content["cells"]:
        source = "".join(cell["source"])
        if cell["cell_type"] != "code" or not source.splitlines()[-1:] or "rl.Stepper(" not in source.splitlines()[-1]:
            continue
        data, stepper = cell["outputs"][0]["data"], stepper_of(source, lesson)
        if repr(stepper) != "".join(data["text/plain"]):
            raise ValueError(f"{lesson}: its stepper is kept as {data['text/plain']}, but is {stepper!r}")
        page = f"steppers/{lesson}.html"
        (extra / "steppers").mkdir(parents=True, exist_ok=True)
        stepper.save(extra / page, stepper.t + MORE)
        still = "".join(data["text/html"])
        title = html.escape("A stepper. " + html.unescape(re.search(r'alt="([^"]*)"', still)[1]))
        data["text/html"] = (
            f'<iframe class="stepper" src="{page}" title="{title}" loading="lazy"></iframe>'
            f'<p><a href="{page}">The stepper on a page of its own</a></p><noscript>{still}</noscript>'
        )
        notebook.write_text(json.dumps(content), encoding="utf-8")
