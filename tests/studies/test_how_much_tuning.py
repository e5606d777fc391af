"""The registered study of tuning: a tiny one from nothing to its tests, and what it does after an interrupt."""

import how_much_tuning as study
import how_much_tuning_tests as tests
import how_much_tuning_worlds as worlds
import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.experiments.sweep import sweep

REGISTERED = worlds.REGISTERED


def tiny() -> dict:
    """The registered plan in small: few settings, robots and steps; every stage and world is there."""
    plan = dict(REGISTERED)
    few = dict.fromkeys(REGISTERED["sizes"]["judging robots"], 3)
    held = dict.fromkeys(REGISTERED["sizes"]["hold-out robots"], 2)
    plan["sizes"] = {
        "settings": 4, "robots": 2, "candidates": 2, "choosing robots": 2, "judging robots": few,
        "friction settings": 2, "friction robots": 2, "hold-out robots": held, "draws": 50, "price draws": 5,
    }  # fmt: skip
    plan["methods"] = study.FRICTION_METHODS
    lengths = {name: [60, None] for name in REGISTERED["lengths"]}
    plan["lengths"] = lengths | {
        "navigation_1k": [3600, 1], "mobile_arm_2k": [120, 1],
        **{name: [120, 1] for name in REGISTERED["lengths"] if name.startswith("arm")},
    }  # fmt: skip
    return plan


def test_tiny(tmp_path):
    study.run(tiny(), tmp_path / "store", tmp_path / "data.npz", 1)
    print(tests.findings(tests.Draws(study.read(tiny(), tmp_path / "data.npz"))))
