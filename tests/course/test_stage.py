"""The stage lives the library's lives, tells the library's chances, and says of robots what was counted."""

import copy
import json
from pathlib import Path

import numpy as np
import pytest
from in_node import run
from PIL import Image

import rlrobot_edu as rl
from rlrobot_edu.widgets.kernels import bias_of, probabilities
from rlrobot_edu.widgets.page_file import read_text
from rlrobot_edu.widgets.playground.script import luck_of
from rlrobot_edu.widgets.stage.honest import (
    compared,
    honest,
    read_numbers,
    rule,
    shows,
    verdict,
)
from rlrobot_edu.widgets.stage.page import METHODS, SECOND_ROOM, TASK, lives_script
from rlrobot_edu.widgets.stage.second_room import NEW_IN, grown

HOUR = 3600
SEEDS = range(10)
PICTURES = Path(__file__).parents[2] / "docs/pictures"
NUMBERS = read_numbers()


def lived(program: str, seeds=SEEDS):
    """What a program in JavaScript gives that lives with the luck of these seeds; it uses life.js."""
    lucks = json.dumps([luck_of(seed) for seed in seeds])
    return run(
        f"{lives_script()}\n{read_text('stage/life.js')}\nconst lucks = {lucks};\n"
        "const live = (i, method) => { about.lucks[0] = lucks[i]; return lifeOf(method, null); };\n"
        f"console.log(JSON.stringify((() => {{ {program} }})()));"
    )


def test_both_lives_are_the_librarys_reward_by_reward():
    found = lived(
        "const rewards = (i) => [NOBODY, NEIGHBOURS].map((method) => Array.from(live(i, method).r.slice(1)));\n"
        "return lucks.map((_, i) => rewards(i));"
    )
    for seed in SEEDS:
        for method, rewards in zip(METHODS, found[seed], strict=True):
            agent = rl.Agent(TASK, method, seed=seed)
            env = rl.make_env(TASK, seed=seed, engine="kinematic")
            expected = rl.learn(agent, env, HOUR, progress=False).rewards
            np.testing.assert_array_equal(rewards, expected, f"{method}, seed {seed}")


MOMENTS = """
const life = live(0, NEIGHBOURS), motions = motionsOf(life.world);
return momentsOf(life).map((moment) => {
  const bad = { [moment.similar[0].state]: moment.similar[0].q.map(() => -100) };
  const says = moment.similar.map((one) => motions.map((motion) => sayOf(moment, one, motion)));
  const actions = motions.map((motion) => motion.actions);
  return { ...moment, again: chancesOf(moment), what: chancesOf(moment, bad), says, actions };
});
"""


@pytest.fixture(scope="module")
def moments():
    return lived(MOMENTS, seeds=[6])


def test_chances_are_those_by_which_the_robot_chose_and_the_librarys(moments):
    task = rl.load_task(TASK)
    agent = rl.Agent(task, "TOSL+QBIASSR", seed=6)
    env = rl.make_env(task, seed=6, engine="kinematic")
    chosen = [step.probabilities.copy() for step in rl.steps(agent, env, HOUR)]
    scale = 100 / (10 / (1 - 0.9))
    assert len(moments) > 100
    for moment in moments:
        np.testing.assert_allclose(moment["chances"], chosen[moment["t"]], rtol=1e-12)
        np.testing.assert_array_equal(moment["again"]["chances"], moment["chances"])
        q = np.zeros((task.states.n, task.actions.n))
        for one in moment["similar"]:
            q[one["state"]] = one["q"]
        bias = bias_of(q, task.states.shape, moment["s"])
        np.testing.assert_array_equal(moment["again"]["bias"], bias)
        p = probabilities(bias * scale, moment["temperature"])
        np.testing.assert_allclose(moment["chances"], p, rtol=1e-12)
        q[moment["similar"][0]["state"]] = -100
        p = probabilities(
            bias_of(q, task.states.shape, moment["s"]) * scale, moment["temperature"]
        )
        np.testing.assert_allclose(moment["what"]["chances"], p, rtol=1e-12)


def test_a_moments_state_is_new_and_the_similar_ones_are_the_tasks(moments):
    task = rl.load_task(TASK)
    assert len({moment["s"] for moment in moments}) == len(moments)
    for moment in moments:
        sets = task.states.siblings(moment["s"]).values()
        others = [int(k) for states in sets for k in states if k != moment["s"]]
        assert [one["state"] for one in moment["similar"]] == others
        for one in moment["similar"]:
            assert -1 <= one["seen"] < moment["t"]
            if one["seen"] < 0:
                assert not any(one["q"]), "what was never met says nothing"


def test_what_all_say_of_a_motion_is_its_bias(moments):
    for moment in moments:
        total = np.sum(moment["says"], axis=0)
        bias = np.array(moment["again"]["bias"])
        expected = [bias[actions].mean() for actions in moment["actions"]]
        np.testing.assert_allclose(total, expected, atol=1e-9)


def test_ghosts_that_stood_at_one_place_step_aside():
    script = read_text("stage/asking.js")
    told = lived(
        script
        + """
        const life = live(0, NEIGHBOURS), far = ([a, b], [c, d]) => Math.hypot(a - c, b - d);
        return momentsOf(life).map(({ t, known }) => {
          const places = known.map(({ seen }) => life.places[seen]), spots = fanned(places, life.places[t], life.world);
          const all = [life.places[t], ...spots];
          const gaps = all.flatMap((spot, i) => all.slice(i + 1).map((other) => far(spot, other)));
          return { gap: Math.min(9, ...gaps), moved: Math.max(0, ...spots.map((spot, i) => far(spot, places[i]))) };
        });
        """,
        seeds=[6],
    )
    assert min(one["gap"] for one in told) > 0.45, "a robot is half a metre wide"
    assert max(one["moved"] for one in told) < 2
    assert min(one["moved"] for one in told) == 0, "who is in nobody's way stays"


def test_each_action_belongs_to_one_motion_and_those_that_move_alike_are_one(moments):
    actions = moments[0]["actions"]
    assert sorted(a for group in actions for a in group) == list(range(9))
    assert [1, 3, 4] in actions, "three commands leave the robot where it is"


def test_the_moment_shown_has_the_most_advisers_and_the_wrong_one_the_most_bumps():
    told = lived(
        """
        const life = live(0, NEIGHBOURS), motions = motionsOf(life.world), moments = momentsOf(life);
        const first = moments.indexOf(firstShown(life, moments, motions));
        const wrong = moments.indexOf(mostWrong(moments));
        const rows = moments.map((moment) => {
          const { t, pays, chances, similar } = moment, favourite = favouriteOf(chances, motions);
          const says = similar.map((one) => Math.abs(sayOf(moment, one, favourite)));
          const advisers = says.filter((say) => say >= 0.1).length, did = favourite.actions.includes(life.a[t]);
          const rise = sum(chances.filter((_, a) => pays[a] <= -2), (p) => p - 1 / 9);
          const next = Array.from(life.r.slice(t + 1, t + 11)), grown = chances[favourite.actions[0]] * 9;
          return { advisers, did, rise, next, grown, tried: pays[life.a[t]], paid: life.r[t + 1] };
        });
        const least = moments.indexOf(leastEarned(life, moments, motions));
        return { rows, first, wrong, least, usual: usuallyEarned(life), rewards: Array.from(life.r).slice(1) };
        """,
        seeds=[6],
    )
    rows = told["rows"]
    shown, wrong = rows[told["first"]], rows[told["wrong"]]
    followed = [row for row in rows if row["did"]]
    assert shown["did"]
    assert shown["advisers"] == max(row["advisers"] for row in followed)
    later = [row for row in rows[told["first"] + 1 :] if row["did"]]
    assert all(row["advisers"] < shown["advisers"] for row in later)
    assert wrong["rise"] == pytest.approx(max(row["rise"] for row in rows))
    doubled = [row for row in followed if row["grown"] >= 2]
    advised = [row for row in doubled if len(row["next"]) == 10]
    assert 10 < len(advised) < len(followed)
    least = min(sum(row["next"]) for row in advised)
    assert sum(rows[told["least"]]["next"]) == pytest.approx(least)
    assert rows[told["least"]] in advised
    assert told["usual"] == pytest.approx(10 * np.mean(told["rewards"]))
    for row in rows:
        assert row["tried"] == row["paid"], "what was tried is what the step paid"


def more(mean: float, half: float) -> dict[str, float]:
    return {"mean": mean, "half": half}


def test_a_difference_is_told_only_where_its_interval_excludes_zero():
    words = ("more", "fewer", "no difference shows")
    assert [shows(more(*x)) for x in ((5, 4), (-5, 4), (4, 5))] == [1, -1, 0]
    assert compared(more(56.1, 9), words, 0) == "56 ± 9 more"
    assert compared(more(-50, 46), words, 0) == "50 ± 46 fewer"
    assert compared(more(-11, 19), words, 0) == "no difference shows (−11 ± 19)"


def test_the_verdict_follows_the_numbers():
    def advice(pays, bumps):
        return {"pays": {"more": more(*pays)}, "bumps": {"more": more(*bumps)}}

    bold = verdict(advice((0.08, 0.01), (0.001, 0.001)))
    assert bold == "Its memories say “drive on”; they do not say “beware”."
    assert "and “beware”" in verdict(advice((0.08, 0.01), (-0.02, 0.01)))
    assert "nothing" in verdict(advice((0.0, 0.01), (0.0, 0.01)))


def test_the_page_says_what_the_file_says():
    text, why = honest(NUMBERS), rule(NUMBERS)
    metres = NUMBERS["TOSL, ideal"]["metres"]["more"]
    assert f"{abs(metres['mean']):.0f} ± {metres['half']:.0f}" in text
    assert f"({NUMBERS['shown']})" in why
    assert f"{NUMBERS['TOSL, ideal']['advice']['all']['moments']:,}" in why
    other = copy.deepcopy(NUMBERS)
    other["TOSL, ideal"]["metres"]["more"] |= more(-7.0, 2.0)
    assert "7 ± 2 m less far" in honest(other)
    html = rl.stage().html
    assert text in html and why in html


def test_the_page_is_small_and_needs_nothing_else(tmp_path):
    page = rl.stage(tmp_path / "stage.html")
    written = (tmp_path / "stage.html").read_text(encoding="utf-8")
    assert written == page.html
    assert len(written.encode()) <= 200_000
    for word in ("http:", "https:", "import(", "fetch("):
        assert word not in written
    assert page.still().alt


def test_the_second_room_is_the_explorer_in_the_papers_state(tmp_path):
    explorer = rl.stage(tmp_path / "cells.html", room="worked_example")
    assert (tmp_path / "cells.html").stat().st_size <= 200_000
    assert explorer.task.states.decode(21)["theta"].reading == 90
    assert explorer.state == 21 and not explorer.q[21].any()
    terms = sum(len(states) - 1 for states in explorer.numbers.sets.values())
    assert (terms, len(explorer.numbers.means)) == (5, 4)
    with pytest.raises(ValueError, match="wander_1k"):
        rl.stage(room="kitchen")


@pytest.mark.parametrize("name", NEW_IN)
def test_the_robots_of_the_second_room_come_to_their_states_for_the_first_time(name):
    seed, steps = NEW_IN[name]
    s = int("".join(filter(str.isdigit, name.split(",")[0])))
    robot = grown(seed, steps)
    assert robot.visits[s].sum() == 0
    env = rl.make_env(SECOND_ROOM, seed=seed)
    agent = rl.Agent(SECOND_ROOM, "Q+SR", alpha=0.3, seed=seed, loop_evasion=False)
    *_, last = rl.steps(agent, env, steps + 1)
    assert last.s == s


def test_the_robot_in_the_papers_state_knows_four_of_its_five_similar_ones():
    """The fifth, a free way ahead there, cannot occur."""
    robot = grown(*NEW_IN["new in state 21, the paper's"])
    others = [9, 15, 19, 20, 23]
    known = robot.visits[others].any(axis=1)
    assert known.tolist() == [True, True, True, False, True]


@pytest.mark.parametrize("name", ["stage", "stage_dark"])
def test_the_film_of_the_opening_is_short_and_small(name):
    path = PICTURES / f"{name}.gif"
    assert path.stat().st_size < 500_000
    with Image.open(path) as film:
        times = []
        for i in range(film.n_frames):
            film.seek(i)
            times.append(film.info["duration"])
    assert len(times) > 30
    assert sum(times[:-1]) <= 5000, "five seconds, and then it waits"
