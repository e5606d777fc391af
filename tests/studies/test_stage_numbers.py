"""The study behind the stage: it runs, it counts what it says, and the page has its table."""

import json

import numpy as np
import pytest
import similarity_page
import stage_numbers
import stage_table

import rlrobot_edu as rl
from rlrobot_edu.widgets.stage.honest import read_numbers

STEPS = 100
GROUPS = {"0": (0, 0), "1 or more": (1, 15)}  # in so few steps no robot knows seven
NUMBERS = read_numbers()


@pytest.fixture(scope="module")
def small():
    """The whole study with two robots of each kind, and few steps."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(stage_numbers, "STEPS", STEPS)
        patch.setattr(stage_numbers, "GROUPS", GROUPS)
        yield stage_numbers.measure(range(2))


def test_two_robots_and_few_steps_give_numbers_of_the_same_form(small):
    def form(its):
        if isinstance(its, list):
            return len(its)
        if not isinstance(its, dict):
            return "number"
        if "all" in its:  # groups by advisers
            return form(its["all"])
        return {name: form(each) for name, each in its.items()}

    assert form(small) == form(NUMBERS)
    assert json.loads(json.dumps(small)) == small
    assert small["shown"] in (0, 1)


def test_metres_bumps_and_reward_are_those_of_the_librarys_robots(small):
    rewards = []
    for seed in range(2):
        agent = rl.Agent("wander_1k", "TOSL+QBIASSR", seed=seed)
        env = rl.make_env("wander_1k", seed=seed, engine="kinematic")
        rewards.append(rl.learn(agent, env, STEPS, progress=False).rewards)
    its = small["TOSL, ideal"]
    mean = np.mean(rewards)
    assert its["reward"]["asking"]["mean"] == pytest.approx(mean, abs=1e-4)
    bumps = np.mean([np.sum(r <= -2) for r in rewards])
    assert its["bumps"]["asking"]["mean"] == pytest.approx(bumps)
    assert 0 < its["metres"]["asking"]["mean"] < 0.4 * 1.2 * STEPS


def test_the_groups_hold_all_moments_once(small):
    for its in (small["TOSL, ideal"], NUMBERS["TOSL, ideal"], NUMBERS["Q, ideal"]):
        *groups, everywhere = its["advice"].values()
        assert sum(each["moments"] for each in groups) == everywhere["moments"]
        assert groups[0]["pays"]["lot"] == groups[0]["pays"]["asked"], "nobody to ask"


def test_the_page_has_the_table_of_the_studys_numbers():
    page = similarity_page.PAGE_OF.read_text(encoding="utf-8")
    rows = stage_table.asked_table(NUMBERS)
    assert len(rows) == 5
    for row in rows:
        assert f"| {' | '.join(row)} |" in page
    everywhere = NUMBERS["TOSL, ideal"]["advice"]["all"]
    assert f"{everywhere['moments']:,}" in rows[-1]


def test_a_rise_is_told_only_where_it_shows():
    its = {"lot": 0.1, "asked": 0.2, "more": {"mean": 0.1, "half": 0.02}}
    assert stage_table.risen(its, 1) == "10.0 → 20.0 % (+10.0 ± 2.0)"
    its["more"] = {"mean": 0.1, "half": 0.2}
    assert stage_table.risen(its, 1) == "10.0 → 20.0 %"


def test_the_page_says_that_more_advisers_pay_more_and_no_bump_becomes_rarer():
    *groups, everywhere = NUMBERS["TOSL, ideal"]["advice"].values()
    rises = [its["pays"]["more"]["mean"] for its in groups]
    assert rises == sorted(rises)
    for its in (*groups, everywhere):
        assert its["bumps"]["more"]["mean"] >= 0
