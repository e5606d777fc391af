"""The attack, in small: every case that once broke something, and fresh ones of each kind. In full: ``make fuzz``."""

from __future__ import annotations

import pytest

pytest.importorskip("resource", reason="the attack watches time and memory as Unix can")

from fuzz.all_targets import TARGETS
from fuzz.run import HERE, Outcome, once
from fuzz.worker import unpacked

SLOW = sorted(
    target.name for target in TARGETS.values() if target.share == 1
)  # nearly a second an input
QUICK = sorted(TARGETS.keys() - set(SLOW))
GROUPS = [(QUICK[i::3], 100) for i in range(3)] + [(SLOW, 30)]


def told(outcome: Outcome) -> str:
    """What was found, with the programs that show it."""
    return "\n\n".join(
        f"{found['target']}: {found['what']}\n{unpacked(found['case']).get('program.py', b'').decode()}"
        for found in outcome.found.values()
    )


@pytest.mark.long
def test_what_the_attack_once_found_is_mended():
    outcome, _ = once(["--plain", f"--kept={HERE / 'found'}"])
    assert not outcome.found, told(outcome)
    assert outcome.counts["inputs"] == len(list(HERE.glob("found/*/*/")))


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("names", "inputs"), GROUPS, ids=[", ".join(names) for names, _ in GROUPS]
)
def test_the_attack_finds_nothing(names, inputs):
    outcome, _ = once(["--plain", f"--inputs={inputs}", "--seed=0", *names])
    assert not outcome.found, told(outcome)
    assert outcome.counts["inputs"] > 0.9 * inputs * len(names), (
        "hypothesis knows when it has drawn all there is"
    )
    assert min(
        outcome.counts["accepted"], outcome.counts["refused"]
    ) > 0.02 * inputs * len(names)
