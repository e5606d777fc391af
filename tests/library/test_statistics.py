"""Statistics: against SciPy, and against the arithmetic of the paper's own tables."""

import warnings

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from in_markdown import in_markdown
from scipy import integrate, stats

from rlrobot_edu.experiments.rounding import ROUNDING, without_rounding
from rlrobot_edu.experiments.statistics import (
    Anova,
    Interval,
    Pair,
    Tukey,
    hedges_g,
    mean_band,
)
from rlrobot_edu.experiments.tables import Table

# The paper's ANOVA tables: sums of squares and degrees of freedom, between and within; F; p
PAPER_ANOVA = {
    "wander-simple": (125.41, 2, 476.37, 297, 39.09, 8.88e-16),
    "wander-1K": (
        27.47,
        2,
        6.58,
        15,
        31.31,
        4.44e-6,
    ),  # prints 31.29, within the rounding of 6.58
    "wander-4K": (14.96, 2, 3.50, 15, 32.05, 3.84e-6),
    "3D-arm-1K": (136.21, 2, 456.23, 69, 10.30, 0.0001),
    "3D-arm-4K": (278.65, 2, 414.97, 69, 23.17, 2.01e-8),
    "2D-navigation-1K": (7.62, 2, 5.51, 6, 4.15, 0.0739),  # prints 0.070
    "Giraff wander-1K": (31.73, 2, 55.26, 57, 16.36, 2e-6),
}
# Its Tukey tables: Q statistic, df, p; 0.001 is its way to print "smaller"
PAPER_TUKEY = [
    (0.80, 297, 0.838), (10.41, 297, 0.0), (11.21, 297, 0.0),  # prints 0.820
    (6.17, 15, 0.0015), (11.17, 15, 0.0), (5.00, 15, 0.0079),
    (7.92, 15, 0.0), (10.97, 15, 0.0), (3.05, 15, 0.111),
    (1.68, 69, 0.465), (6.20, 69, 0.0), (4.52, 69, 0.006),
    (2.60, 69, 0.165), (9.33, 69, 0.0), (6.73, 69, 0.0),
    (1.95, 6, 0.410), (4.07, 6, 0.063), (2.13, 6, 0.354),
    (4.3491, 57, 0.00892), (8.0827, 57, 0.0), (3.7336, 57, 0.02835),
]  # fmt: skip


def inference(p: float) -> str:
    return Pair("A", "B", 0.0, 0.0, p, p, Interval(0.0, 0.0, 0.0)).inference


@pytest.fixture
def groups():
    rng = np.random.default_rng(0)
    return {
        "A": rng.normal(0, 1, 20),
        "B": rng.normal(1, 1, 15),
        "C": rng.normal(1.2, 1, 30),
    }


@pytest.mark.parametrize("task", PAPER_ANOVA)
def test_the_papers_sums_of_squares_give_its_f_and_p(task):
    between, df_between, within, df_within, f, p = PAPER_ANOVA[task]
    anova = Anova(between, df_between, within, df_within)

    # the sums are rounded to a hundredth, and so is F
    error = anova.f * (0.005 / between + 0.005 / within) + 0.005
    assert anova.f == pytest.approx(f, abs=error)
    digits = (
        0.5 if p in (0.0001, 2e-6) else 0.1 if p < 1e-3 else 0.01
    )  # some p have one digit, and F is rounded
    assert anova.p == pytest.approx(p, rel=digits)
    assert anova.ms_between == between / df_between


@pytest.mark.parametrize("q, df, p", PAPER_TUKEY)
def test_the_papers_q_statistics_give_its_p(q, df, p):
    assert stats.studentized_range.sf(q, 3, df) == pytest.approx(
        p, abs=0.002 if p > 0.05 else 0.0012 if p == 0 else 5e-4 if p == 0.006 else 1e-4
    )


def test_anova_agrees_with_scipy(groups):
    anova, expected = Anova.of(list(groups.values())), stats.f_oneway(*groups.values())
    assert (anova.f, anova.p) == pytest.approx((expected.statistic, expected.pvalue))
    everything = np.concatenate(list(groups.values()))
    assert anova.ss_between + anova.ss_within == pytest.approx(
        np.sum((everything - everything.mean()) ** 2)
    )
    assert (anova.df_between, anova.df_within) == (2, 62)


def test_tukey_agrees_with_scipy_for_groups_of_different_sizes(groups):
    expected = stats.tukey_hsd(*groups.values()).pvalue
    p_values = [pair.p for pair in Tukey.of(groups).pairs]
    assert p_values == pytest.approx([expected[0, 1], expected[0, 2], expected[1, 2]])


def range_beyond(q: float, groups: int, df: float) -> float:
    """P(studentized range > q), as a double integral: over the normal numbers, then over their estimated SD."""
    z, s = np.linspace(-9, 9, 2001), np.linspace(1e-6, 6, 2001)
    density = 2 * df * s * stats.chi2.pdf(df * s**2, df)
    between = stats.norm.cdf(z) - stats.norm.cdf(z - q * s[:, None])
    below = groups * np.trapezoid(stats.norm.pdf(z) * between ** (groups - 1), z)
    return float(np.trapezoid(density * (1 - below), s))


UNEQUAL = {
    "few that scatter": (5, 3.0),
    "many that hardly do": (40, 0.3),
    "some": (12, 1.0),
}


@pytest.mark.parametrize("shift", [0.0, 1.0, 3.0])
@pytest.mark.parametrize("names", [list(UNEQUAL)[:2], list(UNEQUAL)])
def test_games_howell_is_the_studentized_range_with_each_pairs_own_spread(names, shift):
    """Oracle: Games & Howell (1976), with Welch's and Satterthwaite's degrees of freedom."""
    rng = np.random.default_rng(8)
    groups = {}
    for i, name in enumerate(names):
        n, sd = UNEQUAL[name]
        groups[name] = rng.normal(i * shift, sd, n)
    for pair in Tukey.of(groups).pairs:
        x, y = groups[pair.first], groups[pair.second]
        a, b = x.var(ddof=1) / len(x), y.var(ddof=1) / len(y)
        df = (a + b) ** 2 / (a**2 / (len(x) - 1) + b**2 / (len(y) - 1))
        q = abs(x.mean() - y.mean()) / np.sqrt((a + b) / 2)
        expected = range_beyond(q, len(names), df)
        assert pair.games_howell == pytest.approx(expected, abs=1e-5)
        if len(names) == 2:
            welch = stats.ttest_ind(x, y, equal_var=False).pvalue
            assert pair.games_howell == pytest.approx(welch, abs=1e-6)


def test_a_pair_on_which_the_two_tests_disagree_is_marked_and_explained():
    noise = np.linspace(-1, 1, 10)
    groups = {"narrow": noise, "beside it": noise + 2, "wide": 30 * noise}
    first, *others = Tukey.of(groups).pairs
    assert first.games_howell < 1e-4 and first.p > 0.5 and first.tests_disagree
    assert not any(pair.tests_disagree for pair in others)
    table = Tukey.of(groups).table()
    assert "≠: the tests disagree" in table.caption
    marked = [row for row in table.rows if "≠" in str(row[4])]
    assert [row[0] for row in marked] == ["narrow vs beside it"]
    for text in (str(table), table._repr_html_(), in_markdown(table)):
        assert text.count("≠") == 2
    alike = Tukey.of({"a": noise, "b": noise + 2})
    assert "≠" not in str(alike)


def test_the_table_of_two_tests_is_no_wider_than_a_notebook():
    rng = np.random.default_rng(7)
    names = ("TOSL+QBIASSR", "TOSL+SR", "Q+SR")
    lines = str(Tukey.of({name: rng.normal(0, 1, 10) for name in names})).splitlines()
    assert max(map(len, lines)) <= 110


def test_two_methods_tested_by_anova_tukey_and_t_agree(groups):
    a, b = groups["A"], groups["B"]
    t = stats.ttest_ind(a, b)
    (pair,) = Tukey.of({"A": a, "B": b}).pairs
    assert Anova.of([a, b]).p == pytest.approx(t.pvalue)
    assert pair.p == pytest.approx(t.pvalue, rel=1e-5) and pair.q == pytest.approx(
        abs(t.statistic) * np.sqrt(2)
    )


def test_the_words_of_inference():
    assert [inference(p) for p in (0.0099, 0.01, 0.049, 0.05, float("nan"))] == [
        "p<0.01",
        "p<0.05",
        "p<0.05",
        "",
        "",
    ]


def test_the_band_of_means_agrees_with_scipys_t_test():
    samples = np.random.default_rng(1).normal(3, 2, (40, 2))
    expected = [
        stats.ttest_1samp(column, 0).confidence_interval(0.95) for column in samples.T
    ]
    assert np.allclose(np.transpose(mean_band(samples)), expected)


@pytest.mark.parametrize("n", [2, 3, 5, 10, 30])
def test_the_band_covers_the_true_mean_as_often_as_it_says_however_few_there_are(n):
    low, high = mean_band(np.random.default_rng(n).normal(1.0, 1.0, (n, 4000)))
    assert 0.94 < np.mean((low < 1) & (high > 1)) < 0.96


def test_hedges_g_is_an_unbiased_effect_and_its_interval_covers_it():
    rng = np.random.default_rng(3)
    effects = [
        hedges_g(rng.normal(0.8, 1, 10), rng.normal(0, 1, 8)) for _ in range(300)
    ]
    assert np.mean([g.value for g in effects]) == pytest.approx(0.8, abs=0.08)
    assert 0.92 < np.mean([g.low < 0.8 < g.high for g in effects]) < 0.98


def test_the_interval_of_eta_squared_ends_where_the_noncentral_f_says():
    n, f = 60, 16.36
    share = Anova(31.73, 2, 55.26, 57).eta_squared
    assert share.value == pytest.approx(31.73 / 86.99)
    for end, level in ((share.low, 0.975), (share.high, 0.025)):
        assert stats.ncf.cdf(f, 2, 57, end * n / (1 - end)) == pytest.approx(
            level, abs=1e-3
        )
    assert Anova(0.01, 2, 100.0, 57).eta_squared.low == 0


@pytest.mark.parametrize(("n", "shift"), [(2, 0.0), (10, 0.5), (10, -3.0), (60, 20.0)])
def test_the_interval_of_hedges_g_ends_where_the_noncentral_t_says(n, shift):
    rng = np.random.default_rng(5)
    x, y = rng.normal(shift, 1, n), rng.normal(0, 1, n)
    g, df, t = hedges_g(x, y), 2 * n - 2, stats.ttest_ind(x, y).statistic
    for end, level in (
        (g.low, 0.975),
        (g.high, 0.025),
    ):  # as a mixture of normal distributions
        noncentrality = end / g.value * t

        def part(u, noncentrality=noncentrality):
            return stats.norm.cdf(t * np.sqrt(u / df) - noncentrality) * stats.chi2.pdf(
                u, df
            )

        whole = integrate.quad(part, 0, 3 * df + 80, points=[df], limit=200)[0]
        assert whole == pytest.approx(level, abs=1e-5)


@pytest.mark.parametrize("f", [1e3, 1e4, 1e8, 1e12])
def test_the_intervals_of_huge_effects_are_found_at_once_and_hold_the_estimate(f):
    share = Anova(2 * f, 2, 57.0, 57).eta_squared
    assert 0.9 < share.low < share.high < 1 and share.low < share.value
    rng = np.random.default_rng(6)
    g = hedges_g(rng.normal(f, 1, 20), rng.normal(0, 1, 20))
    assert 0.7 * f < g.low < g.value < g.high < 1.6 * f


def test_many_repetitions_and_equal_repetitions_are_no_trouble():
    rng = np.random.default_rng(4)
    g = hedges_g(rng.normal(1, 1, 1000), rng.normal(0, 1, 1000))
    assert g.low < g.value < g.high and g.high - g.low < 0.3
    same = Tukey.of({"A": np.ones(3), "B": np.ones(3)})
    assert np.isnan(same.pairs[0].q) and same.pairs[0].inference == ""
    assert (
        Tukey.of({"A": np.ones(3), "B": np.zeros(3)}).pairs[0].p == 0
        and Anova.of([np.ones(3), np.zeros(3)]).p == 0
    )


def test_too_few_repetitions_are_refused_in_plain_words():
    with pytest.raises(ValueError, match="two repetitions each"):
        Anova.of([np.ones(1), np.ones(5)])


def test_a_table_reads_the_same_as_text_html_and_markdown(groups):
    table = Anova.of(list(groups.values())).table()
    text, page, document = str(table), table._repr_html_(), in_markdown(table)
    for word in (
        "between groups",
        "within groups",
        "total",
        "sum of squares",
        "df",
        "mean square",
        "F",
        "p-value",
    ):
        assert word in text and word in page and word in document
    assert document.count("\n") == 6 and "my\\|task" in in_markdown(
        Table("", ["a"], [["my|task"]])
    )
    assert "&lt;" in Table("", ["a"], [["<b>"]])._repr_html_()


# Rounding is no variance


def ulps_away(x: float, n: int) -> float:
    """`x`, moved by n of the smallest steps that a float can make."""
    for _ in range(abs(n)):
        x = np.nextafter(x, np.inf if n > 0 else -np.inf)
    return float(x)


CONSTANTS = st.floats(-1e300, 1e300).filter(lambda x: x == 0 or abs(x) > 1e-300)
SIZES = st.lists(st.integers(2, 60), min_size=2, max_size=4)


def verdicts(groups):
    """All that the tests conclude from some groups."""
    arrays, named = list(groups), dict(zip("ABCD", groups, strict=False))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        anova, tukey = Anova.of(arrays), Tukey.of(named)
        repr(anova), repr(tukey)
    return [inference(anova.p), *(pair.inference for pair in tukey.pairs)]


@given(CONSTANTS, SIZES)
def test_equal_numbers_never_differ_whatever_they_are_and_however_many(constant, sizes):
    groups = [np.full(n, constant) for n in sizes]
    assert set(verdicts(groups)) == {""}
    anova, g = Anova.of(groups), hedges_g(groups[0], groups[1])
    assert (
        (anova.ss_between, anova.ss_within) == (0, 0)
        and np.isnan(g).all()
        and np.isnan(anova.eta_squared).all()
    )
    low, high = mean_band(groups[0][:, None])
    assert (low[0], high[0]) == (constant, constant)


@given(CONSTANTS.filter(lambda x: abs(x) > 1e-290), SIZES, st.data())
def test_numbers_that_differ_by_a_few_ulps_never_differ(constant, sizes, data):
    few = st.integers(-4, 4)
    groups = [
        np.array([ulps_away(constant, data.draw(few)) for _ in range(n)]) for n in sizes
    ]
    assert set(verdicts(groups)) == {""}
    shifted = [
        np.full(n, ulps_away(constant, i)) for i, n in enumerate(sizes)
    ]  # each group constant, beside the next
    assert set(verdicts(shifted)) == {""}


@given(st.integers(2, 40), st.integers(1, 1_000_000).map(lambda n: n / 1000))
def test_two_constant_groups_that_do_differ_are_told_apart_and_have_no_effect_in_sds(
    n, difference
):
    x, y = np.full(n, 0.1 + difference), np.full(n, 0.1)
    assert verdicts([x, y]) == ["p<0.01", "p<0.01"] and np.isnan(hedges_g(x, y)).all()


@given(
    st.lists(
        st.lists(st.floats(-1e6, 1e6), min_size=2, max_size=20), min_size=2, max_size=3
    )
)
def test_taking_rounding_out_changes_nothing_by_more_than_rounding_and_twice_is_once(
    lists,
):
    groups = [np.array(group) for group in lists]
    once = without_rounding(groups)
    largest = max(np.abs(group).max() for group in groups)
    for before, after, again in zip(groups, once, without_rounding(once), strict=True):
        assert (
            np.abs(after - before).max() <= sum(map(len, groups)) * ROUNDING * largest
        )
        assert np.array_equal(after, again)


def test_games_howell_of_constant_groups_follows_from_the_other_group_or_from_nothing():
    rng = np.random.default_rng(0)
    groups = {"a": np.full(3, 0.1), "b": np.full(4, 0.1), "c": np.full(3, 0.2)}
    groups["varies"] = rng.normal(0.5, 1, 6)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        pairs = {pair[:2]: pair.games_howell for pair in Tukey.of(groups).pairs}
    assert np.isnan(pairs["a", "b"]) and pairs["a", "c"] == pairs["b", "c"] == 0
    x = groups["varies"]
    q = np.sqrt(2) * abs(x.mean() - 0.1) / stats.sem(x)
    expected = stats.studentized_range.sf(q, 4, 5)
    assert pairs["a", "varies"] == pytest.approx(expected)
    assert pairs["b", "varies"] == pytest.approx(expected)


@pytest.mark.filterwarnings(
    "ignore:Precision loss"
)  # SciPy's word for numbers that are all the same
def test_a_constant_group_beside_one_that_varies_is_tested_as_any_other():
    rng = np.random.default_rng(0)
    x, y = np.full(10, 0.1), rng.normal(0.1, 1, 10)
    assert Anova.of([x, y]).p == pytest.approx(stats.ttest_ind(x, y).pvalue)
