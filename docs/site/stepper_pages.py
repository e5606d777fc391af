"""The page of steppers: four methods in the worked example, without a kernel."""

from pathlib import Path

import rlrobot_edu as rl

METHODS = {
    "Q+EG": "Q-learning, lesson [03](../notebooks/03_q_learning.ipynb)",
    "SL+SR": "SARSA(λ), lesson [07](../notebooks/07_eligibility_traces.ipynb)",
    "TOSL+SR": "true online SARSA(λ), lesson [08](../notebooks/08_true_online_sarsa.ipynb)",
    "TOSL+QBIASSR": "the paper's method, lesson [10](../notebooks/10_tosl_qbiassr.ipynb)",
}
STEPS = 40


def write_steppers(source: Path, extra: Path) -> None:
    """stepper.md into the source; the pages it shows to `extra`, which is copied as it is."""
    (extra / "steppers").mkdir(parents=True)
    text = [
        "# Steppers\n",
        f"`rl.Stepper(agent, env)` walks through an agent's learning, forward and back. Here are its first {STEPS} "
        "steps in the worked example, by four methods. Keys ← and →, Home and End work, too. *What if?* below "
        "learns them anew, in the page, with another α, γ, λ or temperature.\n",
    ]
    for method, about in METHODS.items():
        name = f"steppers/{method.lower().replace('+', '_')}.html"
        agent, env = (
            rl.Agent("worked_example", method, seed=0),
            rl.make_env("worked_example", seed=0),
        )
        rl.Stepper(agent, env).save(extra / name, STEPS)
        title = f"A stepper: {method} in the worked example"
        frame = f'<iframe class="live steppers" src="{name}" title="{title}" loading="lazy"></iframe>'
        text += [
            f"## {method}\n",
            f'{about} · <a href="{name}">on a page of its own</a>\n',
            frame,
            "",
        ]
    (source / "stepper.md").write_text("\n".join(text), encoding="utf-8")
