"""``make fuzz``: attack all targets with so many inputs in all, and say in one line each what came of it.

What breaks the contract is kept in ``found/<target>/<name>/``, and the exit status is 1.
"""

from __future__ import annotations

import argparse
import hashlib
import importlib.util
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE.parent))

from fuzz.worker import unpacked  # noqa: E402 - this is a script

RESTARTS = 30  # of a target whose cases crash the process
LARGEST = 20_000  # bytes of a case that is kept


@dataclass
class Outcome:
    """What came of one target: how often each answer was given, and by signature what broke the contract."""

    counts: Counter = field(default_factory=Counter)
    found: dict[str, dict] = field(default_factory=dict)


def once(arguments: list[str]) -> tuple[Outcome, bool]:
    """What came of one worker, and whether its last case killed it."""
    with tempfile.TemporaryDirectory(prefix="rlrobot-fuzz-") as name:
        folder = Path(name)
        command = [sys.executable, str(HERE / "worker.py"), name, *arguments]
        paths = {
            "MPLBACKEND": "agg",
            "PYTHONPATH": os.pathsep.join([str(HERE.parents[1]), *sys.path]),
        }
        with open(folder / "output", "w") as output:
            streams = {"stdin": subprocess.DEVNULL, "stdout": output, "stderr": output}
            code = subprocess.run(
                command, env={**os.environ, **paths}, **streams
            ).returncode
        log = (
            json.loads((folder / "log.json").read_text())
            if (folder / "log.json").is_file()
            else {}
        )
        outcome = Outcome(Counter(log.get("counts")), log.get("found", {}))
        if code == 0:
            return outcome, False
        if code > 0 or not (folder / "last.json").is_file():  # the attack's own fault
            text = (folder / "output").read_text(errors="replace")
            raise SystemExit(
                f"the worker of {arguments} failed:\n{text[:1000]}\n…\n{text[-3000:]}"
            )
        last, what = json.loads((folder / "last.json").read_text()), death(code, folder)
        outcome.counts = Counter(last["counts"]) + Counter(inputs=1, found=1)
        outcome.found.setdefault(
            what, {"what": what, "case": last["case"], "target": last["target"]}
        )
        return outcome, True


def run(arguments: list[str], inputs: int, seed: int) -> Outcome:
    """Workers one after the other, a new one whenever one was killed by its last case, until all inputs were tried."""
    outcome = Outcome()
    for restart in range(RESTARTS):
        left = inputs - outcome.counts["inputs"]
        mine, killed = once(
            [*arguments, f"--inputs={left}", f"--seed={seed + 1000 * restart}"]
        )
        outcome.counts += mine.counts
        outcome.found = {**mine.found, **outcome.found}
        if not killed or mine.counts["inputs"] >= left:
            break
    return outcome


def death(code: int, folder: Path) -> str:
    """What ended a worker, and where in the library it was."""
    told = {signal.SIGPROF: "computes for ever", signal.SIGALRM: "waits for ever"}
    name = told.get(-code, signal.Signals(-code).name)
    crash = folder / "crash.txt"
    place = re.search(
        r'File ".*(rlrobot_edu/\S+\.py)", line \d+ in (\w+)',
        crash.read_text() if crash.is_file() else "",
    )
    return f"{name} in {place[1]}, {place[2]}" if place else name


def keep(outcome: Outcome, where: Path) -> None:
    """Write what was found, a folder each, and beside it what broke; what is large is only told."""
    for signature, found in outcome.found.items():
        case = unpacked(found["case"])
        if sum(map(len, case.values())) > LARGEST:
            continue
        words, digest = (
            re.sub("[^a-zA-Z]+", "_", signature),
            hashlib.sha256(signature.encode()).hexdigest(),
        )
        folder = where / found["target"] / f"{words[:50].strip('_')}_{digest[:6]}"
        folder.mkdir(parents=True, exist_ok=True)
        for file, data in case.items():
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            (folder / file).write_bytes(data)
        folder.with_suffix(".txt").write_text(
            found["what"] + "\n", encoding="utf-8", errors="replace"
        )


def main() -> None:
    """Share the inputs out among the targets and run as many at a time as there are cores."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--inputs", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("--targets", nargs="*", help="only these")
    parser.add_argument(
        "--plain", action="store_true", help="draw cases with hypothesis alone"
    )
    parser.add_argument(
        "--found",
        type=Path,
        default=HERE / "found",
        help="where to keep what was found",
    )
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    plain = arguments.plain or importlib.util.find_spec("atheris") is None
    if plain and not arguments.plain:
        print(
            "atheris is not installed (pip install --group fuzz): cases are drawn by hypothesis alone."
        )
    from fuzz.all_targets import TARGETS

    targets = [
        target
        for target in TARGETS.values()
        if not arguments.targets or target.name in arguments.targets
    ]
    shares = {
        t.name: max(1, arguments.inputs * t.share // sum(t.share for t in targets))
        for t in targets
    }
    print(f"{sum(shares.values())} inputs, seed {arguments.seed}")
    print(f"{'':<14}  inputs  accepted  refused  borrowed  found  kinds  seconds")

    def attack(name: str) -> Outcome:
        begun = time.time()
        outcome = run([name, *["--plain"] * plain], shares[name], arguments.seed)
        c = outcome.counts
        answers = f"{c['accepted']:>10}{c['refused']:>9}{c['borrowed']:>10}{c['found']:>7}{len(outcome.found):>7}"
        print(
            f"{name:<14}{c['inputs']:>8}{answers}{time.time() - begun:>9.0f}",
            flush=True,
        )
        keep(outcome, arguments.found)
        return outcome

    with ThreadPoolExecutor(arguments.jobs) as pool:
        outcomes = list(
            pool.map(attack, sorted(shares, key=lambda name: -shares[name]))
        )
    found = [
        (f["target"], f["what"]) for outcome in outcomes for f in outcome.found.values()
    ]
    for target, what in found:
        print(f"{target}: {what}")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
