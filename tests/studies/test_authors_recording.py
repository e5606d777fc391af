"""The study of the authors' recording: its page follows from its numbers, its intervals are right; its runs repeat."""

import authors_recording as study
import authors_recording_page as pages
import numpy as np
import pytest
from scipy import stats

import rlrobot_edu as rl


@pytest.fixture(scope="module")
def found():
    return pages.read(study.FILE)


def test_the_page_is_what_its_numbers_say():
    assert study.PAGE.read_text(encoding="utf-8") == pages.page(study.FILE)


def test_the_interval_over_hours_is_the_jackknifes(found):
    pair = ("TOSL+SR", "Q+SR")
    its = pages.without_hours(found, pair)
    each = [
        found[f"authors without hour {hour}"][pair[0]].mean
        - found[f"authors without hour {hour}"][pair[1]].mean
        for hour in range(1, 6)
    ]
    whole = np.mean(each)
    pseudo = [5 * whole - 4 * x for x in each]  # Tukey's pseudo-values
    half = stats.t.ppf(0.975, 4) * stats.sem(pseudo)
    assert its.each == each and its.half == pytest.approx(half)


def test_the_interval_over_recordings_is_students(found):
    its = pages.over_recordings(found, "ideal", ("TOSL+SR", "Q+SR"))
    low, high = stats.ttest_1samp(its.each, 0).confidence_interval()
    assert len(its.each) == 6
    assert (its.mean - its.half, its.mean + its.half) == pytest.approx((low, high))


def test_what_the_report_says_of_the_recordings_is_so(found):
    """The paper's order without the fault in the authors' recording; Q+SR ahead in all six of the ideal robot."""
    authors = found["authors"]
    first, second, third = (
        authors[x].mean for x in ("TOSL+QBIASSR", "TOSL+SR", "Q+SR")
    )
    assert first > second > third
    assert not pages.excludes_zero(pages.without_hours(found, ("TOSL+SR", "Q+SR")))
    assert max(pages.over_recordings(found, "ideal", ("TOSL+SR", "Q+SR")).each) < 0


def test_an_hour_is_left_out_whole(vrep):
    rest = study.without_hour(vrep, 2)
    assert len(rest) == len(vrep) - 3600
    assert rest.s.tolist() == [*vrep.s[:3600], *vrep.s[7200:]]


@pytest.mark.long
def test_a_part_of_the_agents_earns_what_the_file_says(vrep, found):
    """Within four standard errors; the recording is not part of the project."""
    model = rl.SampleModel.from_recording(vrep)
    methods = {label: {"method": label} for label in study.THREE}
    runs = rl.compare(
        model, methods, 60, steps=study.LIFE, seed=study.SEED, progress=False
    )
    for label, x in runs.final.items():
        group = found["authors"][label]
        assert x.mean() == pytest.approx(group.mean, abs=4 * group.sd / 60**0.5)
