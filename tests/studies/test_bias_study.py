"""The study of the bias: what is compared, and what is called better."""

import numpy as np
import pytest
from bias_page import counts, means
from bias_page import tests as all_tests
from bias_study import BIASED, methods, seeing_little, share_of_s
from bias_verdicts import CONTROLS, PAPERS, outcomes_of
from coarse import COARSE, near_or_not
from paper.experiments import Length

import rlrobot_edu as rl


def test_the_share_of_a_state_in_its_own_bias_is_what_it_changes_there():
    for name, share in (("wander_1k", 1 / 4), ("worked_example", (3 / 2 + 1 / 3) / 4)):
        task = rl.load_task(name)
        assert share_of_s(task) == pytest.approx(share)
        assert methods(task)["SR, colder"]["temperature"] == pytest.approx(1 / (1 + share))


def test_better_is_what_dunnett_s_test_shows_and_the_tables_say_so():
    task = rl.load_task("wander_simple")
    model = rl.SampleModel.from_recording(rl.read_recording("wander_simple"))
    chosen = {**methods(task), "OBIASSR": {"method": "TOSL+RANDOM"}}  # something that is surely worse
    result = rl.compare(model, chosen, 12, steps=300, n_jobs=1, progress=False)
    early, late = outcomes_of(task, "model", result, (Length(60), Length(300)))
    assert (early.is_late, late.is_late) == (False, True)
    assert late.means["SR"] == pytest.approx(result.final["SR"].mean())
    assert all(late.against["OBIASSR", control].sign == -1 for control in CONTROLS)
    assert late.against["OBIASSR", "SR"].p < 0.001 and late.against["OBIASSR", "SR"].g.high < 0
    pairs = {(biased, control) for biased in BIASED for control in (*CONTROLS, PAPERS) if biased != control}
    assert set(late.against) == pairs
    found = [early, late]
    assert f"{late.means['OBIASSR']:.2f} ▼" in means(found, lambda o: o.is_late)
    assert "| OBIASSR |" in counts(found) and "**" in all_tests(found)


def test_who_sees_little_tells_the_lowest_bin_of_each_input_from_the_rest():
    task = rl.load_task("wander_1k")
    agent = rl.Agent(task, COARSE, seed=0, loop_evasion=False)
    for s in range(0, task.states.n, 7):
        bins = np.minimum(np.unravel_index(s, task.states.shape), 1)
        assert near_or_not(agent.memory, s) == np.ravel_multi_index(bins, task.states.shape)
    rl.learn(agent, rl.make_env(task, seed=0), 300, progress=False)
    used = np.array(np.unravel_index(np.flatnonzero(agent.q.any(axis=1)), task.states.shape))
    assert used.shape[1] > 2 and used.max() == 1


def test_the_coarse_robot_is_there_where_lasers_alone_have_more_than_two_bins():
    there = {name for name in rl.available_tasks() if "coarse" in seeing_little(rl.load_task(name))}
    assert there == {"wander_1k", "wander_4k", "wander_12k", "giraff_wander_1k", "giraff_wander_4k"}
