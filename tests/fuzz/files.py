"""The readers: each gets a damaged file. What it does not refuse must be as good as a whole one."""

from __future__ import annotations

import hashlib
import io
import json
from typing import Any

import numpy as np
from hypothesis import strategies as st

import rlrobot_edu as rl
from fuzz import seeds, things
from fuzz.contract import attempt
from fuzz.strategies import (
    Draw,
    bomb,
    damaged_archive,
    damaged_array,
    damaged_bytes,
    damaged_json,
    damaged_rows,
)
from fuzz.targets import Case, Target, lay, snapshot, unchanged
from rlrobot_edu.learning.history import History


def reader(
    name: str, cases: st.SearchStrategy[Case], share: int, read: Any, use: Any
) -> Target:
    """The target of a reader: `read()` reads what is in the present folder, `use` what came of it."""

    def attack(case: Case) -> str:
        lay({**seeds.files()[name], **case})
        before = snapshot()
        answers: list[Any] = []
        answer = attempt(lambda: answers.append(read()))
        unchanged(before)
        if answers:
            attempt(lambda: use(*answers), given=False)
        return answer

    return Target(name, cases, share, attack)


def in_file(name: str, damaged: st.SearchStrategy[bytes]) -> st.SearchStrategy[Case]:
    """Cases of one file."""
    return damaged.map(lambda data: {name: data})


RECORDING, PACKAGE, ABOUT = "transitions.csv", "datapackage.json", "experiment.json"


@st.composite
def recordings(draw: Draw) -> Case:
    """Damaged rows or package; mostly with the right fingerprint, which else would tell."""
    whole = seeds.files()["recording"]
    csv, package = whole[RECORDING], whole[PACKAGE]
    kind = draw(st.integers(0, 5))
    if kind <= 2:
        csv = draw(damaged_rows(csv) if kind < 2 else damaged_bytes(csv))
        described = json.loads(package)
        if draw(st.integers(0, 3)):
            digest = hashlib.sha256(csv.decode(errors="replace").encode()).hexdigest()
            described["resources"][0] |= {"hash": f"sha256:{digest}", "bytes": len(csv)}
            described["rlrobot"]["rows"] = csv.count(b"\n") - 1
        package = json.dumps(described).encode()
    else:
        package = (
            draw(damaged_bytes(package))
            if kind == 3
            else draw(damaged_json(package)).encode()
        )
    return {RECORDING: csv, PACKAGE: package}


@st.composite
def stores(draw: Draw) -> Case:
    """Damaged ``experiment.json``, or a damaged or renamed history."""
    whole = seeds.files()["store"]
    kind = draw(st.integers(0, 5))
    if kind <= 1:
        return {
            ABOUT: draw(
                damaged_bytes(whole[ABOUT]) | damaged_json(whole[ABOUT]).map(str.encode)
            )
        }
    name = draw(st.sampled_from([name for name in whole if "/" in name]))
    if kind > 2:
        return {name: draw(damaged_archive(whole[name]))}
    label = draw(st.sampled_from(["Q+SR", "TOSL+QBIASSR", "x", "Q+SR "]))
    number = draw(
        st.sampled_from(["0000", "0001", "0009", "-1", "9" * 30, "x", "0000-x", "00"])
    )
    return {f"{label}/{number}.npz": whole[name]}


def read_store() -> rl.Comparison:
    """The comparison that goes on from the store in this folder, and opens all of it."""
    result = rl.compare(seeds.model(), store=".", **seeds.STORE)
    rl.Comparison.load(".")
    return result


def attack_store(case: Case) -> str:
    """Whatever the store holds: the same numbers as without one, or a sentence.

    Where the numbers in an archive were changed, nobody can know better; then they need only be usable.
    """
    whole = seeds.files()["store"]
    lay({**whole, **case})
    before = snapshot()
    results: list[rl.Comparison] = []
    answer = attempt(lambda: results.append(read_store()))
    unchanged(before, new=("./Q+SR/0", "./TOSL+QBIASSR/0", "./."))
    forged = any(
        name != ABOUT and data not in whole.values() for name, data in case.items()
    )
    if results:
        attempt(lambda: things.usable_comparison(results[0], forged))
    return answer


def archives(kind: str, share: int, read: Any, use: Any) -> Target:
    """The target of a reader of one ``.npz`` file."""
    name = f"{kind}.npz"
    whole = st.deferred(lambda: damaged_archive(seeds.files()[kind][name]))
    rare = st.integers(0, 499).flatmap(
        lambda i: (
            whole if i else st.builds(bomb, st.sampled_from(["about.npy", "r.npy"]))
        )
    )
    return reader(kind, in_file(name, rare), share, read, use)


legacy = st.deferred(
    lambda: damaged_array(np.load(io.BytesIO(seeds.files()["legacy"]["legacy.npy"])))
)
legacy_bytes = st.deferred(lambda: damaged_bytes(seeds.files()["legacy"]["legacy.npy"]))


@st.composite
def sheets(draw: Draw) -> Case:
    """A damaged CSV file, also with semicolons and decimal commas, and with some of the columns only."""
    whole = seeds.files()["sheet"]["mine.csv"].decode().splitlines()
    columns = draw(st.sets(st.integers(0, 6), max_size=2))
    rows = [line.split(",") for line in whole]
    kept = [[cell for i, cell in enumerate(row) if i not in columns] for row in rows]
    csv = "\n".join(",".join(row) for row in kept)
    if draw(st.booleans()):
        csv = csv.replace(",", ";").replace(".", ",")
    data = csv.encode()
    return {"mine.csv": draw(damaged_rows(data) | damaged_bytes(data) | st.just(data))}


TARGETS = [
    reader("sheet", sheets(), 8, lambda: rl.read_recording("mine.csv", task=seeds.TASK), things.usable_recording),
    reader("recording", recordings(), 12, lambda: rl.read_recording("."), things.usable_recording),
    reader("legacy", in_file("legacy.npy", legacy | legacy | legacy_bytes), 8,
           lambda: rl.read_recording("legacy.npy", legacy=True, task=seeds.TASK), things.usable_recording),
    archives("model", 14, lambda: rl.SampleModel.load("model.npz"), things.usable_model),
    archives("agent", 14, lambda: rl.Agent.load("agent.npz"), things.usable_agent),
    archives("history", 8, lambda: History.load("history.npz"), things.usable_history),
    Target("store", stores(), 8, attack_store),
]  # fmt: skip
