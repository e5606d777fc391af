"""The study of the bias: what is compared, and what is called better."""

import pytest
from bias_page import counts, means
from bias_page import tests as all_tests
from bias_study import BIASED, methods, share_of_s
from bias_verdicts import CONTROLS, PAPERS, outcomes_of

import rlrobot_edu as rl
from rlrobot_edu.reproduction.experiments import Length


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
