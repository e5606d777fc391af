"""Attack in a process of its own, which may crash: the last case, and the counts up to it, are on disk."""

from __future__ import annotations

import argparse
import base64
import contextlib
import faulthandler
import importlib
import json
import os
import signal
import sys
import time
import tomllib
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

ROOT = Path(__file__).parents[2]
# Kernels are compiled from their bytecode, which must stay as it is. Which they are, mypy's settings know.
_SETTINGS = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))[
    "tool"
]["mypy"]["overrides"]
_NAMES = [
    name
    for some in _SETTINGS
    if "disallow_untyped_defs" in some
    for name in some["module"]
]
KERNELS = [
    ".".join(path.relative_to(ROOT).with_suffix("").parts)
    for name in _NAMES
    for path in ROOT.glob(name.replace(".", "/") + ".py")
]


class Log:
    """What this worker has done, on disk at all times; `found`: by signature, the first case and what it broke."""

    def __init__(self, folder: Path) -> None:
        self.path, self.counts, self.found = folder / "log.json", Counter(), {}
        self.last = folder / "last.json"

    def begin(self, target: str, case: dict[str, bytes]) -> None:
        """Remember a case before it is tried."""
        self.last.write_text(
            json.dumps({"counts": self.counts, "target": target, "case": packed(case)})
        )

    def write(self) -> None:
        """Keep what was found; done whenever that is something new, and at the end."""
        self.path.write_text(json.dumps({"counts": self.counts, "found": self.found}))


def packed(case: dict[str, bytes]) -> dict[str, str]:
    """A case as JSON can hold it."""
    return {name: base64.b64encode(data).decode() for name, data in case.items()}


def unpacked(case: dict[str, str]) -> dict[str, bytes]:
    """The case again."""
    return {name: base64.b64decode(data) for name, data in case.items()}


def tried(target, case, log: Log) -> None:
    """Try one case and log what came of it."""
    from fuzz.contract import Fault

    log.begin(target.name, case)
    log.counts["inputs"] += 1
    try:
        log.counts[target(case)] += 1
    except Fault as fault:
        log.counts["found"] += 1
        if fault.signature not in log.found:
            log.found[fault.signature] = {
                "what": str(fault),
                "case": packed(case),
                "target": target.name,
            }
            log.write()


def with_hypothesis(target, inputs: int, seed: int, log: Log) -> None:
    """Cases as hypothesis draws them; the same for the same seed."""
    import hypothesis

    @hypothesis.seed(seed)
    @hypothesis.settings(
        max_examples=inputs, deadline=None, database=None, phases=[hypothesis.Phase.generate],
        suppress_health_check=list(hypothesis.HealthCheck),
    )  # fmt: skip
    @hypothesis.given(target.cases)
    def attack(case):
        tried(target, case, log)

    attack()


def with_atheris(target, inputs: int, seed: int, log: Log, folder: Path) -> None:
    """Cases that atheris makes of bytes, with an eye on which lines of the library they reach. Ends the process."""
    import random

    import atheris
    import hypothesis

    @hypothesis.settings(
        database=None, deadline=None, suppress_health_check=list(hypothesis.HealthCheck)
    )
    @hypothesis.given(target.cases)
    def attack(case):
        tried(target, case, log)

    begun = time.time()

    def one(data: bytes) -> None:
        attack.hypothesis.fuzz_one_input(
            data + bytes(8000)
        )  # zeros draw what is simplest
        if log.counts["inputs"] >= inputs or time.time() - begun > 30 + inputs:
            log.write()
            os._exit(0)  # libFuzzer would never return

    corpus = folder / "corpus"
    corpus.mkdir(exist_ok=True)
    for i in range(100):
        (corpus / str(i)).write_bytes(random.Random(f"{seed} {i}").randbytes(1500))
    flags = [
        f"-seed={seed + 1}",
        "-runs=-1",
        "-max_len=3000",
        "-len_control=0",
        "-timeout=0",
        "-rss_limit_mb=0",
        "-verbosity=0",
    ]
    atheris.Setup([sys.argv[0], *flags, str(corpus)], one)
    atheris.Fuzz()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="where the log goes")
    parser.add_argument("targets", nargs="*")
    parser.add_argument("--inputs", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument(
        "--plain", action="store_true", help="without atheris, even if it is there"
    )
    parser.add_argument(
        "--kept", type=Path, help="try the cases in this folder instead"
    )
    arguments = parser.parse_intermixed_args()
    folder = arguments.folder.resolve()
    instrumented = contextlib.nullcontext()
    if not arguments.plain:
        import atheris

        instrumented = atheris.instrument_imports(
            include=["rlrobot_edu"], exclude=KERNELS
        )
    with instrumented:
        import rlrobot_edu as rl

        for name in rl.__all__:
            getattr(rl, name)
        all_targets = importlib.import_module("fuzz.all_targets")
    log = Log(folder)
    here = folder / "here"
    here.mkdir(exist_ok=True)
    os.chdir(here)
    all_targets.warm_up()
    crash = open(folder / "crash.txt", "w")  # noqa: SIM115 - open to the end
    faulthandler.enable(crash, all_threads=False)
    for alarm in (signal.SIGPROF, signal.SIGALRM):
        faulthandler.register(alarm, crash, all_threads=False, chain=True)
    if arguments.kept:
        for path in sorted(arguments.kept.glob("*/*/")):
            files = (file for file in path.rglob("*") if file.is_file())
            case = {
                file.relative_to(path).as_posix(): file.read_bytes() for file in files
            }
            tried(all_targets.TARGETS[path.parent.name], case, log)
    for name in arguments.targets:
        if arguments.plain:
            with_hypothesis(
                all_targets.TARGETS[name], arguments.inputs, arguments.seed, log
            )
        else:
            with_atheris(
                all_targets.TARGETS[name], arguments.inputs, arguments.seed, log, folder
            )
    log.write()


if __name__ == "__main__":
    main()
