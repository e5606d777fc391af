"""Two doubts about what we found, tried: ``python docs/doubts.py`` writes docs/doubts.md and doubts.csv (3 minutes).

Does an agent that sees nothing earn less? And does a verdict hang on who has loop evasion?
"""

import csv
from dataclasses import replace
from pathlib import Path

import rlrobot_edu as rl

HERE = Path(__file__).parent
REPETITIONS, SEED = 30, 1  # another seed than the report's and the bias study's

PAGE = """# Two doubts, tried

Written by `python docs/doubts.py`: average rewards of {n} robots each, seed {seed}, with bootstrap 95 % intervals; p is
Tukey's, of all pairs in a table. Each repetition is in [doubts.csv](doubts.csv).

## An agent that sees nothing

`wander_4k` has five speeds for each wheel. Some pairs of them are an arc that fits into the maze, so one action, driven
as a circle, is paid 10 in every step. An agent with one state only, *blind*, can find it; what it earns is what needs
no senses. One hour, 3600 steps, TOSL:

{blind}

So of what a bias gains in this task, a part needs no senses. `wander_1k` has no such arc:

{blind_1k}

## Who has loop evasion

The authors' program calls loop evasion in QBIASSR alone; in algorithm 3 of the paper it comes "before every softmax
selection", and that is what we do: SR has it, too. In the Giraff's task this decides. `giraff_wander_1k`, 1800 steps:

{evasion}
"""


def blind(task: rl.Task) -> rl.Task:
    """The same task for an agent that sees nothing: no reading of its one input is below the cut."""
    return replace(task, inputs=[rl.InputVariable("laser_front", cuts=[1e-9], unit="m")])


def main() -> None:
    """Run all repetitions and write both files."""
    rows, parts = [], {}

    def run(part: str, worlds: dict, steps: int) -> None:
        """Each label's world and settings, compared with Tukey's test."""
        groups = {}
        for label, (task, settings) in worlds.items():
            groups[label] = rl.compare(task, {label: settings}, REPETITIONS, steps=steps, seed=SEED)[label]
        result = rl.Comparison(next(iter(worlds.values()))[0], groups, SEED)
        for label, group in groups.items():
            rows.extend([part, label, i, f"{x:.6g}"] for i, x in enumerate(group.final))
        averages, tests = result.table(), result.tukey().table()
        without_times = replace(averages, columns=averages.columns[:-1], rows=[row[:-1] for row in averages.rows])
        parts[part] = f"{without_times.markdown}\n\n{tests.markdown}"

    for part, name in (("blind", "wander_4k"), ("blind_1k", "wander_1k")):
        task = rl.load_task(name)
        sighted = {s: (task, {"method": f"TOSL+{s}"}) for s in ("QBIASSR", "VBIASSR", "SR")}
        run(part, {**sighted, "SR, blind": (blind(task), {"method": "TOSL+SR"})}, 3600)
    giraff = rl.load_task("giraff_wander_1k")
    run("evasion", {
        "TOSL+QBIASSR": (giraff, {"method": "TOSL+QBIASSR"}),
        **{f"{m}{', no loop evasion' * (not on)}": (giraff, {"method": m, "loop_evasion": on})
           for m in ("TOSL+SR", "Q+SR") for on in (True, False)},
    }, 1800)  # fmt: skip
    with open(HERE / "doubts.csv", "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([("part", "method", "repetition", "final_average_reward"), *rows])
    (HERE / "doubts.md").write_text(PAGE.format(n=REPETITIONS, seed=SEED, **parts), encoding="utf-8")


if __name__ == "__main__":
    main()
