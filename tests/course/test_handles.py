"""Handles: their numbers are Python's, their pictures fit on a phone, and their pages work by mouse and by keyboard."""

import json
import re
from functools import cache

import gymnasium
import numpy as np
import pytest
from in_node import run

import rlrobot_edu as rl
from rlrobot_course.handles.handle import Handle
from rlrobot_course.lesson_01.exercises import bin_of
from rlrobot_course.lesson_01.handles import cuts_under
from rlrobot_course.lesson_02.exercises import discounted_return
from rlrobot_course.lesson_02.handles import gamma_over, sweeps_over
from rlrobot_course.lesson_03.exercises import update
from rlrobot_course.lesson_03.handles import corridor_values, one_value, run_back
from rlrobot_course.lesson_04.exercises import draw, epsilon_greedy, softmax
from rlrobot_course.lesson_04.handles import TEMPERATURES, draw_on_bar, rules_on_bar
from rlrobot_course.lesson_07.handles import traces_on_a_path
from rlrobot_course.lesson_08.handles import traces_and_ideal, with_and_without_q_old
from rlrobot_course.lesson_09.handles import watch_robots
from rlrobot_course.lesson_09.queues import Walk, plot_watched, watch
from rlrobot_edu.learning.loop import Step

PHONE, SCREEN = 334, 820  # widths of a picture [px]
LETTER = 7.4  # width of a letter, on the average [px]


def rewards_of(policy, steps=200):
    env, rewards = rl.make_env("wander_simple", seed=0), []
    env.reset()
    for _ in range(steps):
        rewards.append(env.step(policy[env.state])[1])
    return rewards


def gamma() -> Handle:
    policies = {"turns away": [2, 2, 1, 3], "always forward": [3, 3, 3, 3]}
    return gamma_over({name: rewards_of(p) for name, p in policies.items()})


def cuts() -> Handle:
    inputs = rl.load_task("wander_1k").inputs
    lasers = zip(inputs, (0.33, 0.51, 2.78, 2.78, 2.17), strict=True)
    return cuts_under(inputs, {laser.name: reading for laser, reading in lasers})


LAKE = gymnasium.make("FrozenLake-v1", map_name="8x8", is_slippery=False).unwrapped


def values_of_sweeps(n=15):
    values = [np.zeros(64)]
    for _ in range(n):
        before, v = values[-1], np.zeros(64)
        for s, actions in LAKE.P.items():
            sums = []
            for outcomes in actions.values():
                _, s_next, r, terminated = outcomes[0]
                sums.append(r + (0 if terminated else 0.9 * before[s_next]))
            v[s] = max(sums)
        values.append(v)
    return values


def sweeps() -> Handle:
    return sweeps_over(values_of_sweeps(), LAKE)


def alpha() -> Handle:
    return one_value(rl.load_task("worked_example"), 0, 0, 29.4)


def draws() -> Handle:
    return draw_on_bar([0.2, 0.5, 0.3], u=0.65)


def rules() -> Handle:
    return rules_on_bar([10.0, 8.0, 3.0, 0.0])


def evading(seed: int, steps: int) -> list[Step]:
    """What a robot does that was cold for so many steps, from when its loop evasion was switched on."""
    env = rl.make_env("wander_1k", seed=seed, realism=rl.Realism.vrep())
    agent = rl.Agent(
        "wander_1k", temperature=0.01, traces="full", loop_evasion=False, seed=seed
    )
    rl.learn(agent, env, steps, progress=False)
    agent.change(loop_evasion=True)
    return list(rl.steps(agent, env, 60, resume=True))


@cache
def robots() -> dict[str, list[Step]]:
    return {"stuck": evading(5, 1500), "healthy": evading(4, 1500)}


def loops() -> Handle:
    return watch_robots(robots(), default=0.01)


HANDLES = {
    "01 cuts": cuts,
    "02 gamma": gamma,
    "02 sweeps": sweeps,
    "03 alpha": alpha,
    "03 corridor": run_back,
    "04 draws": draws,
    "04 rules": rules,
    "07 traces": traces_on_a_path,
    "08 ideal": traces_and_ideal,
    "08 q_old": with_and_without_q_old,
    "09 loops": loops,
}


@pytest.fixture(params=HANDLES)
def handle(request):
    return HANDLES[request.param]()


def asked(handle: Handle, *changes: dict, width: int = SCREEN) -> list[dict]:
    """What its program computes and draws as it opens, and after each of these changes of its values."""
    return run(
        f"const document = {{}};\n{handle.script}\n"
        f"const feed = {json.dumps(handle.feed)}, width = {width};\n"
        "const values = { ...handle.begins?.(feed) };\n"
        "for (const { name, value } of handle.controls(feed)) if (value !== undefined) values[name] = value;\n"
        f"console.log(JSON.stringify([{{}}, ...{json.dumps(changes)}].map((change) => {{\n"
        "  Object.assign(values, change);\n"
        "  const found = handle.compute(feed, values);\n"
        "  return { found, controls: handle.controls(feed), ...handle.draw(found, width, feed, values) };\n"
        "})));"
    )


def corners(handle: Handle) -> list[dict]:
    """Changes that take each control to its ends."""
    changes = []
    for control in asked(handle)[0]["controls"]:
        ends = {
            "slider": [control.get("min"), control.get("max")],
            "scrubber": [0, control.get("last")],
            "toggle": [True, False],
            "choice": list(range(len(control.get("options", [])))),
        }
        name = control["name"]
        begun = control.get("value")
        changes += [{name: end} for end in ends.get(control["kind"], [])]
        if begun is not None:
            changes.append({name: begun})
    return changes


@pytest.mark.parametrize("width", [PHONE, SCREEN])
def test_a_picture_fits_wherever_its_controls_stand(handle, width):
    for told in asked(handle, *corners(handle), width=width):
        assert told["finding"] and told["said"]
        assert "NaN" not in told["picture"] and "undefined" not in told["picture"]
        assert "NaN" not in told["finding"] + told["said"]
        found = re.findall(
            r'<text x="([-\d.]+)" y="([-\d.]+)" text-anchor="(\w+)"[^>]*>([^<]*)<',
            told["picture"],
        )
        assert found
        for x, y, anchor, text in found:
            size = LETTER * len(text)
            left = float(x) - {"start": 0, "middle": size / 2, "end": size}[anchor]
            assert left > -4 and left + size < width + 8, (text, x, width)
            assert 0 < float(y) <= told["height"], text


def test_a_handle_has_a_name_a_still_and_a_page_of_its_own(handle, tmp_path):
    assert repr(handle) == f"<Handle: {handle.name}>"
    assert handle.still().alt
    assert len(handle.still().data) < 80_000
    handle.save(tmp_path / "handle.html")
    assert (tmp_path / "handle.html").stat().st_size < 100_000


def test_what_gamma_leaves_adds_up_to_the_return():
    shown = gamma()
    for change in ({"gamma": 0.5}, {"gamma": 0.99}, {"gamma": 0.0}):
        found = asked(shown, change)[1]["found"]
        right = [discounted_return(r, change["gamma"]) for r in shown.feed["rewards"]]
        np.testing.assert_allclose(found["returns"], right, rtol=1e-12)
    assert "differ by 0.0" in asked(shown, {"gamma": 0.5})[1]["finding"]


def test_readings_fall_into_the_bins_of_the_lesson():
    shown = cuts()
    for moved in ([0.27, 0.53, 0.8], [0.4, 0.53, 0.51], [0.51, 0.33, 0.51]):
        change = {f"cut{i}": cut for i, cut in enumerate(moved)}
        told = asked(shown, change)[1]
        right = [bin_of(x, sorted(moved)) for x in shown.feed["readings"]]
        assert told["found"]["bins"] == right
        apart = bin_of(0.3, sorted(moved)) != bin_of(0.5, sorted(moved))
        assert ("can tell them apart" in told["finding"]) == apart


def test_two_cuts_at_one_place_waste_a_bin():
    opened, twice, thrice = asked(cuts(), {"cut0": 0.53}, {"cut2": 0.53})
    assert "4⁵ = 1024 states" in opened["said"] and opened["found"]["used"] == 1024
    assert "1 bin has no width" in twice["said"] and "243 states" in twice["said"]
    assert "2 bins" in asked(cuts(), {"cut0": 0, "cut1": 0})[1]["said"]
    assert thrice["found"]["wasted"] == 2


def test_the_sums_of_a_square_make_its_value():
    shown, values = sweeps(), values_of_sweeps()
    for k in (1, 2, 6, 15):
        for square in (62, 55, 0, 19):
            told = asked(shown, {"sweep": k, "square": square})[1]
            assert max(told["found"]["sums"]) == pytest.approx(
                values[k][square], abs=1e-5
            )
    (told,) = asked(shown, {"sweep": 1, "square": 62})[1:]
    assert told["finding"].startswith("After sweep 1, 2 of 64 squares")
    assert "V(62) = max [0, 0, 1, 0] = 1" in told["picture"]
    assert "reached S: 0.25" in asked(shown, {"sweep": 14})[1]["finding"]
    assert "changes nothing" in asked(shown, {"sweep": 15})[1]["finding"]


@pytest.mark.parametrize(
    "rate",
    [0.1, *(pytest.param(rate, marks=pytest.mark.nightly) for rate in (0.02, 1.0))],
)
def test_one_value_goes_the_lessons_way(rate):
    """Oracle: the lesson's right `update`, over the steps of an agent that does not look at its values."""
    shown, values, q = alpha(), [], np.zeros((24, 3))
    agent = rl.Agent("worked_example", "Q+RANDOM", seed=0)
    for x in rl.steps(agent, rl.make_env("worked_example", seed=0), 6000):
        update(q, x.s, x.a, x.r, x.s_next, x.terminated, rate, 0.9)
        if (x.s, x.a) == (0, 0):
            values.append(q[0, 0])
    told = asked(shown, {"alpha": rate})[1]
    found = told["found"]
    np.testing.assert_allclose([visit["value"] for visit in found["visits"]], values)
    assert ("never rests" in told["finding"]) == (rate == 1.0)
    targets = [visit["target"] for visit in found["visits"]]
    assert max(targets) < shown.feed["most"]


def test_a_value_runs_back_one_cell_a_drive():
    """Oracle: the lesson's right `update`."""
    q = np.zeros((11, 1))
    for k in range(1, 13):
        for s in range(10):
            last = s == 9
            update(q, s, 0, 10.0 if last else 0.0, s + 1, last, 0.3, 0.8)
        told = asked(run_back(), {"drive": k, "alpha": 0.3, "gamma": 0.8})[1]
        np.testing.assert_allclose(told["found"]["values"], q[:10, 0])
        np.testing.assert_allclose(corridor_values(k, 0.3, 0.8), q[:10, 0])
        assert told["found"]["known"] == min(k, 10) and told["found"]["first"] == 10
    assert "4 of 10 cells know" in asked(run_back())[0]["finding"]
    assert "only the last" in asked(run_back(), {"gamma": 0})[1]["finding"]


def test_the_bar_has_the_probabilities_of_the_lessons_rules():
    shown, q = rules(), np.array([10.0, 8.0, 3.0, 0.0])
    heats = [{"rule": 2, "heat": i} for i in range(len(TEMPERATURES))]
    randoms = [{"rule": 1, "epsilon": e} for e in (0.0, 0.2, 1.0)]
    told = asked(shown, *heats, *randoms, {"rule": 0})[1:]
    right = [softmax(q, T) for T in TEMPERATURES]
    right += [epsilon_greedy(q, e) for e in (0.0, 0.2, 1.0, 0.0)]
    found = [each["found"]["chances"] for each in told]
    np.testing.assert_allclose(found, right, rtol=1e-12, atol=1e-300)
    p = right[TEMPERATURES.index(0.5)]
    assert told[TEMPERATURES.index(0.5)]["finding"] == (
        f"At T = 0.5 the best action is drawn {100 * p[0]:.0f} times in 100"
    )


def test_a_hundred_numbers_draw_what_the_lessons_draw_does():
    shown, p = draws(), [0.2, 0.5, 0.3]
    told = asked(shown, *({"presses": n} for n in (1, 2, 9)))[1:]
    for each, numbers in zip(told, shown.feed["numbers"][:2], strict=False):
        drawn = [draw(p, u) for u in numbers]
        assert each["found"]["counts"] == np.bincount(drawn, minlength=3).tolist()
        assert f"as do {drawn.count(1)} of the hundred" in each["finding"]
        assert each["picture"].count("<circle") == 100
    assert told[2]["found"] == told[0]["found"], "they come again"
    ends = asked(shown, *({"u": u} for u in (0.0, 0.2, 0.69, 0.7, 0.99)))[1:]
    assert [each["found"]["drawn"] for each in ends] == [0, 1, 1, 2, 2]


def test_the_rule_of_a_page_heats_when_the_library_does():
    (found,) = (each["found"] for each in asked(loops()))
    for seen, (name, steps) in zip(found, robots().items(), strict=True):
        walk = Walk([step.s_next for step in steps], [step.r for step in steps])
        right = watch(walk, 0.01)
        for column in ("redundancy", "mean", "temperature"):
            told = [each[column] for each in seen]
            np.testing.assert_allclose(
                told, [getattr(each, column) for each in right], atol=1e-12
            )
        chosen_at = [step.temperature for step in steps[1:]]
        assert [each["temperature"] for each in seen[:-1]] == chosen_at, name


def test_the_finding_tells_which_sign_is_missing():
    told = [each["finding"] for each in asked(loops(), *({"t": t} for t in range(60)))]
    assert told[0] == told[21] == loops().picture.finding
    assert "9 of 21 places filled, and the rule waits" in told[9]
    assert "its state is new, so the temperature falls back to 0.01" in told[23]
    assert "it earns 0.46 a step, so the temperature stays at 0.01" in told[25]


def test_the_still_says_if_the_temperature_never_rises():
    walks = {name: Walk([1, 2] * 30, [1.0] * 60) for name in ("a", "b")}
    finding = plot_watched(walks, 1.0).finding
    assert finding == "In 60 steps the temperature of the a robot never rises"
