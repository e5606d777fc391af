"""The stepper: what it records, what it tells its page, and what the page makes of it."""

import json
import re
import shutil
import statistics
import subprocess
import time
from itertools import product

import gymnasium
import numpy as np
import pytest
from in_node import on_its_page, view
from worlds import RandomWorld

import rlrobot_edu as rl
from rlrobot_course.lesson_22.vbiassr import VBIASSR
from rlrobot_edu.show.describe import path_of
from rlrobot_edu.widgets.playground.worlds import cells_world
from rlrobot_edu.widgets.stepper.code_view import code_html
from rlrobot_edu.widgets.stepper.colours import STRONGEST, scale_limit, tint
from rlrobot_edu.widgets.stepper.environment_view import view_of
from rlrobot_edu.widgets.stepper.equations import as_text, explain_update
from rlrobot_edu.widgets.stepper.names import Names
from rlrobot_edu.widgets.stepper.numerals import before_it, given, number, short
from rlrobot_edu.widgets.stepper.page_data import frame_data
from rlrobot_edu.widgets.stepper.sentences import simply
from rlrobot_edu.widgets.stepper.state_view import StateView
from rlrobot_edu.widgets.stepper.still_tables import rows_of_step
from rlrobot_edu.widgets.stepper.symbols import SYMBOLS
from rlrobot_edu.widgets.stepper.tables import Window, traces_of
from rlrobot_edu.widgets.stepper.tape import Tape


def tape_of(method: str, length: int = 500, p_end: float = 0.1, **settings) -> Tape:
    env = RandomWorld(p_end=p_end)
    agent = rl.Agent(env, method, seed=1, **settings)
    return Tape(agent, env, StateView(Names(agent, env)), length)


def stepper_of(
    task: str = "worked_example", method: str = "TOSL+QBIASSR", **options
) -> rl.Stepper:
    return rl.Stepper(
        rl.Agent(task, method, seed=0), rl.make_env(task, seed=0), **options
    )


def exact(view: str) -> list[list[str]]:
    """The numbers row of each equation in a view: exact values where there are some, else the text."""
    update = re.search(r'<section class="update">(.*?)</section>', view, re.S)[1]
    term = r'<span(?: class="[^"]*")?(?: title="([^"]*)")?(?: style="[^"]*")?><i>.*?</i><b>(.*?)</b></span>'
    return [
        [value or text for value, text in re.findall(term, line)]
        for line in update.split('class="line"')[1:]
    ]


def evaluate(row: list[str]) -> tuple[float, float]:
    """Both sides of ``… ← formula = result``; without a result, the formula twice."""
    formula = "".join(row).replace("−", "-").replace("·", "*").split("←")[-1]
    formula, _, result = (
        formula.removeprefix("δ=").rpartition("=")
        if "=" in formula
        else (formula, "", formula)
    )
    return eval(formula), eval(result)


@pytest.mark.parametrize(
    "method", [f"{a}+{s}" for a, s in product(SYMBOLS, ("SR", "QBIASSR", "EG"))]
)
def test_back_and_forth_shows_the_tables_to_the_last_bit(method):
    tape = tape_of(method)
    recorded = [(tape.q.copy(), tape.e.copy())]
    for _ in range(200):
        tape.forward()
        recorded.append((tape.q.copy(), tape.e.copy()))
    assert np.array_equal(tape.q, tape.agent.q) and np.array_equal(tape.e, tape.agent.e)
    rng = np.random.default_rng(0)
    for target in rng.integers(201, size=30):
        while tape.t != target:
            tape.forward() if tape.t < target else tape.back()
        q, e = recorded[target]
        assert np.array_equal(tape.q, q) and np.array_equal(tape.e, e)
    assert tape.end == 200


@pytest.mark.parametrize(
    "method", [f"{a}+{s}" for a, s in product(SYMBOLS, ("SR", "QBIASSR", "EG"))]
)
def test_watching_changes_nothing_about_learning(method):
    tape = tape_of(method)
    for _ in range(150):
        tape.forward()
    env = RandomWorld(p_end=0.1)
    agent = rl.Agent(env, method, seed=1)
    alone = list(rl.steps(agent, env, steps=150))
    assert [tape._at(t).step[:9] for t in range(1, 151)] == [step[:9] for step in alone]
    assert np.array_equal(agent.q, tape.agent.q)


@pytest.mark.parametrize("settings", [*({"method": f"{a}+SR"} for a in SYMBOLS),
                                      {"method": "SL+SR", "accumulating": True},
                                      {"method": "TOSL+SR", "traces": "full"}])  # fmt: skip
def test_the_numbers_in_the_equation_are_the_librarys(settings):
    tape = tape_of(**settings)
    for _ in range(200):
        tape.forward()
        step, lines = tape.frame.step, explain_update(tape.agent, tape.frame)
        rows = [
            [term.text if term.value is None else repr(term.value) for term in line]
            for line in lines
        ]
        for row in rows:
            computed, stated = evaluate(row)
            assert np.isclose(computed, stated, rtol=1e-12, atol=1e-12)
        assert evaluate(rows[-1])[1] == tape.q[step.s, step.a] == tape.frame.q_sa_new
        if len(rows) == 3:
            fade = tape.agent.parameters.gamma * tape.agent.parameters.lam
            assert evaluate(rows[0])[1] == step.delta
            assert np.isclose(
                evaluate(rows[1])[1] * fade, tape.e[step.s, step.a], rtol=1e-12
            )


def test_the_page_shows_the_equation_of_the_step_with_symbols_above_the_numbers():
    stepper = stepper_of(method="Q+SR", at=3)
    step = stepper._tape.frame.step
    (row,) = exact(view(stepper))
    assert evaluate(row)[1] == stepper._tape.q[step.s, step.a]
    (line,) = explain_update(stepper._tape.agent, stepper._tape.frame)
    assert as_text(line).startswith(f"Q({step.s}, {step.a}) ← 0.00 + 0.1·(")


@pytest.mark.parametrize("algorithm", SYMBOLS)
def test_after_a_terminal_step_nothing_follows_and_after_a_truncated_one_the_world_goes_on(
    algorithm,
):
    env = RandomWorld(p_end=0.5)
    stepper = rl.Stepper(rl.Agent(env, f"{algorithm}+SR", seed=1), env, at=0)
    tape = stepper._tape
    while tape.frame is None or not tape.frame.step.terminated:
        tape.forward()
    assert tape.frame.q_next == 0.0
    assert "Terminal: nothing follows" in view(stepper)
    tape.forward()
    assert tape.frame.number == 1 and tape.frame.q_old == tape.frame.e_sa == 0.0

    stepper = stepper_of(
        method=f"{algorithm}+SR", at=31
    )  # its episodes are cut off after 30
    before, after = on_its_page(
        stepper, "[30, 31].map((t) => (stepper.tape.go(t), views(stepper.tape)))"
    )
    assert "Time is up" in before and "episode ends" in before
    assert "episode begins" in after and "episode 2, its step 1" in after


def test_memory_stays_bounded_however_long_it_plays(wander_model):
    env = rl.make_env(wander_model, seed=0)
    stepper = rl.Stepper(rl.Agent(wander_model, seed=0), env, keep=50)
    stepper.forward(5000)
    tape = stepper._tape
    assert (stepper.t, len(tape._frames), tape.first) == (5001, 50, 4952)
    stepper.back(1000)
    assert stepper.t == 4952
    with pytest.raises(
        ValueError, match="no step 7 to show: the earliest that is kept is 4952"
    ):
        stepper.jump(7)


@pytest.mark.parametrize("world", ["worked_example", "wander_1k", "model"])
def test_a_step_costs_the_kernel_little(world, wander_model):
    # time of the processor, so that whatever else runs on the machine does not count
    env = rl.make_env(wander_model if world == "model" else world, seed=0)
    stepper, times = rl.Stepper(rl.Agent(env, seed=0), env), []
    for _ in range(100):
        start = time.process_time()
        stepper.forward()
        times.append(time.process_time() - start)
    assert statistics.median(times) < 0.015


def test_a_world_without_a_robot_is_shown_by_its_state():
    env = gymnasium.make("Taxi-v4")
    env.reset(seed=0)
    stepper = rl.Stepper(rl.Agent(env, "TOSL+EG", seed=0), env, at=20)
    panes = view(stepper)
    assert "the 12 states visited last, of 500" in panes and "of 500</td>" in panes
    assert stepper.picture().png()


def test_a_sample_model_without_words_shows_numbers(wander_model):
    env = rl.make_env(wander_model, seed=0)
    assert "input 4" in view(rl.Stepper(rl.Agent(wander_model, seed=0), env))


def test_only_what_fits_is_shown_and_the_heading_says_so():
    tape = tape_of("Q+SR")
    assert (
        Window.of(tape).states == list(range(12))
        and Window.of(tape).says == "all 12 states"
    )
    stepper = stepper_of("wander_12k", at=3)
    window, step = Window.of(stepper._tape), stepper._tape.frame.step
    assert window.states[0] == step.s_next and step.s in window.states[:2]
    assert len(window.states) == 12 and window.states[-1] is None
    assert step.a in window.actions and len(window.actions) == 9
    assert "9 of 25 actions" in window.says and "all other actions together" in view(
        stepper
    )


@pytest.mark.parametrize("method", ["Q+SR", "SARSA+SR", "TOSL+SR"])
def test_a_term_of_the_equation_has_the_colour_of_its_number_in_the_table(method):
    stepper = stepper_of(method=method, at=12)
    tape, panes = stepper._tape, view(stepper)
    most, said = scale_limit(tape.q, tape.agent.parameters.r_max), {}
    for place, background in re.findall(
        r'<span class="to-(\w+)" title="[^"]*" style="background:(.*?)">', panes
    ):
        said.setdefault(place, background)

    def css(x):
        colour, opacity = tint(x, most)
        return colour, pytest.approx(opacity, abs=0.01)  # the page has 256 of them

    found = {
        place: (text[:7], int(text[7:], 16) / 255)
        for place, text in said.items()
        if place != "trace"
    }
    assert found == {
        "pair": css(tape.frame.q_sa),
        "next": css(tape.frame.q_next),
        "reward": css(tape.frame.step.r),
    }
    assert (
        f'style="background:{said["reward"]}">{given(tape.frame.step.r)}</b>' in panes
    )


@pytest.mark.parametrize("method", ["Q+SR", "TOSL+SR"])
def test_a_changed_cell_says_what_it_was_and_what_it_is_now_and_large_changes_have_stronger_frames(
    method,
):
    stepper = stepper_of(method=method, at=12)
    _, old, new = stepper._tape.frame.q_change
    cell = r'<td class="[^"]*\bnew\b[^"]*" data-at="\d+" title="by (.*?)" style="[^"]*;--strength:(.*?)"><u>(.)</u>'
    table = view(stepper).split('<section class="q">')[1]
    told = re.findall(cell + r"<small>(.*?) → </small>(.*?)</td>", table)
    assert sorted((by, *rest) for by, _, *rest in told) == sorted(
        (number(y - x), "▲" if y > x else "▼", short(x), short(y))
        for x, y in zip(old.tolist(), new.tolist(), strict=True)
    )
    assert old.size and max(float(strength) for _, strength, *_ in told) == 1.0


def test_the_code_on_the_page_is_the_librarys_and_the_lines_that_change_q_are_marked():
    where, code = code_html(rl.Agent("worked_example", "Q+SR"))
    assert re.fullmatch(
        r"rlrobot_edu/learning/algorithms/q_learning.py, line \d+", where
    )
    (hot,) = re.findall(r'<div class="hot">(.*?)</div>', code)
    assert (
        hot.endswith("q[s, a] += alpha * delta")
        and "Learn from one transition" not in code
    )
    assert code_html(rl.Agent("worked_example", "TOSL+SR"))[1].count("▶") == 2


def test_before_the_first_step_there_is_a_world_and_no_update():
    stepper = stepper_of(at=0)
    panes = view(stepper)
    assert stepper.t == 0 and "Before the first step" in panes and "<svg" in panes
    assert (
        repr(stepper) == "<Stepper before the first step>" and stepper.picture().png()
    )
    assert not stepper._tape.q.any()


@pytest.mark.parametrize(
    "page, ink", [(np.ones(3), np.full(3, 0.13)), (np.full(3, 0.067), np.full(3, 0.87))]
)
def test_lettering_stands_out_on_every_value_in_the_light_and_in_the_dark_theme(
    page, ink
):
    def luminance(rgb):
        return np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4) @ (
            0.2126,
            0.7152,
            0.0722,
        )

    for x in np.linspace(-1, 1, 101):
        colour, opacity = tint(x, 1.0)
        rgb = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255
        back = luminance(opacity * rgb + (1 - opacity) * page) + 0.05
        front = luminance(ink) + 0.05
        assert max(back, front) / min(back, front) >= 4.5  # WCAG 2.1, AA


def test_zero_has_no_colour_whatever_else_there_is_and_a_small_loss_is_seen_beside_a_large_gain():
    for most in (1, 25, 1000):
        assert tint(0.0, most)[1] == 0.0 and tint(most, most)[1] == STRONGEST
    (loss, little), (gain, much) = tint(-0.87, 50), tint(25, 50)
    assert loss != gain and 0.15 < little < much
    assert [
        scale_limit(np.array([[-x, x / 2]]), 1.0) for x in (0.1, 1.5, 13, 26, 99)
    ] == [
        1,
        2,
        20,
        50,
        100,
    ]


def test_what_was_never_tried_is_a_dot_and_a_learned_zero_is_a_zero():
    stepper = stepper_of(at=1)
    tape = stepper._tape
    assert tape.visits.sum() == 1
    s, a = tape.frame.step.s, tape.frame.step.a
    panes = on_its_page(stepper, f"(stepper.tape.q[{s}][{a}] = 0, views(stepper.tape))")
    q = panes[
        panes.index('<section class="q">') : panes.index('<section class="traces">')
    ]
    assert q.count(">·</td>") == 71 and "</small>0</td>" in q
    stepper.forward(60)
    assert np.array_equal(tape.visits, tape.agent.visits)
    stepper.back(60)
    assert tape.visits.sum() == 1


@pytest.mark.parametrize("settings", [{"method": "SL+SR"}, {"method": "SL+SR", "accumulating": True},
                                      {"method": "TOSL+SR"}, {"method": "TOSL+SR", "traces": "full"},
                                      {"method": "TOSL+SR", "lam": 0.3}, {"method": "SL+SR", "lam": 0.0}])  # fmt: skip
def test_the_traces_on_the_page_are_those_by_which_the_update_learned(settings):
    tape = tape_of(p_end=0.02, **settings)
    for _ in range(300):
        before = tape.q.copy()
        tape.forward()
        agent, frame = tape.agent, tape.frame
        step, traces = frame.step, traces_of(frame)
        is_online = agent.method.algorithm.name == "TOSL"
        share = agent.parameters.alpha * (
            step.delta + (frame.q_sa - frame.q_old) * is_online
        )
        changes = (tape.q - before).ravel()
        pair = step.s * tape.q.shape[1] + step.a
        if agent.method.algorithm.name == "TOSL":
            changes[pair] += agent.parameters.alpha * (frame.q_sa - frame.q_old)
        expected = np.zeros(tape.q.size)
        expected[list(traces)] = share * np.array(list(traces.values()))
        assert np.allclose(changes, expected, rtol=1e-9, atol=1e-12)


def test_a_next_is_not_spoken_of_by_methods_that_do_not_learn_from_it():
    said = re.compile(r'<div class="said"><span>(.*?)</span>')
    assert "a′ = " in said.search(view(stepper_of(method="SARSA+SR", at=3)))[1]
    assert "a′" not in said.search(view(stepper_of(method="Q+SR", at=3)))[1]


@pytest.mark.parametrize("method", ["Q+SR", "SARSA+SR", "TOSL+SR", "ESARSA+SR"])
def test_the_terms_of_the_equation_point_at_their_cells(method):
    stepper = stepper_of(method=method, at=12)
    panes, step = view(stepper), stepper._tape.frame.step
    for name in ("pair", "next", "reward"):
        assert f'<span class="to-{name}"' in panes
    q = panes[
        panes.index('<section class="q">') : panes.index(
            "</section>", panes.index('<section class="q">')
        )
    ]
    assert len(re.findall(r'<td class="[^"]*next', q)) == (
        3 if method == "ESARSA+SR" else 1
    )
    assert step.s_next is not None and not re.search(
        r"<th[^>]*>\s*(&nbsp;)?\s*</th>", panes
    )


def test_worlds_of_cells_show_the_value_and_the_best_action_of_what_was_visited():
    env = rl.make_env("worked_example", seed=0)
    stepper = rl.Stepper(rl.Agent(env.task, "TOSL+QBIASSR", seed=0), env, at=107)
    world, tape, box = cells_world(env.task), stepper._tape, env.unwrapped.robot._box
    here = {
        s
        for s, drawn in zip(world["seen"], world["drawn"], strict=True)
        if tuple(drawn["box"]) == box
    }
    panes = view(stepper)
    marks = re.findall(r"<title>state (\d+): (?:\S) (\S+)</title>", panes)
    assert [int(s) for s, _ in marks] == sorted(
        here & {*np.flatnonzero(tape.visits.any(axis=1))}
    )
    frame = tape.frame
    its = frame.step.s
    assert all(
        value == short(tape.q[int(s)].max()) for s, value in marks if int(s) != its
    )
    (changed,) = re.findall(r'<g class="chip its">.*?</g>', panes)
    told = re.search(r'<tspan class="(?:old|by)">(.*?)<', changed)[1]
    assert told == before_it(frame.q_sa, frame.q_sa_new).removesuffix(" →")
    assert dict(marks)[str(its)] == short(frame.q_sa_new)


def test_wheels_have_icons_and_the_latest_rewards_are_a_line():
    stepper = stepper_of("wander_1k", at=40)
    names = stepper._names
    # what the task makes of it: both wheels back is twice ahead, and one wheel back is nothing
    assert (
        "".join(names.column(a)[0] for a in range(9)) == "↑■↺■■↖↻↗↑"
        and names.column(8) == "↑ 8"
    )
    assert names.row(0) == "↑ 0 ahead, 0.2 m/s"
    assert names.row(3) == "■ 3 stand still"
    assert names.action(3) == "stand still (0, −1)", "two others are stand still, too"
    assert names.told(3) == "The robot stood still"
    simple = stepper_of("wander_simple", at=2)._names
    assert [simple.column(a) for a in range(4)] == list("■↺↻↑") and simple.row(
        3
    ) == "↑ ahead, 0.1 m/s"
    line = re.search(r'<p class="rewards".*?</p>', view(stepper))[0]
    assert line.count("<b") == 10 and view(stepper_of(at=31)).count("<i>|</i>") == 1


def test_numbers_are_short_and_never_rounded_to_nothing():
    assert [number(x) for x in (0, 1, -0.002, 0.905, 12.345)] == [
        "0.00",
        "1.00",
        "−0.002",
        "0.905",
        "12.35",
    ]
    assert [short(x) for x in (0, 1, -0.0021, 0.905, 4e-5)] == [
        "0",
        "1.00",
        "−0.002",
        "0.91",
        "4e−5",
    ]
    for x in np.geomspace(1e-9, 1e9, 200):
        assert len(short(-x)) <= 6 and float(short(x).replace("−", "-")) > 0 < float(
            number(x).replace("−", "-")
        )


def test_the_page_writes_numbers_as_the_library_does():
    xs = [
        0.0,
        0.1,
        -2.0,
        10.0,
        *(sign * x for x in np.geomspace(1e-9, 1e9, 200).tolist() for sign in (1, -1)),
    ]
    for write in (number, short, given):
        told = on_its_page(
            stepper_of(), f"{json.dumps(xs)}.map((x) => {write.__name__}(x))"
        )
        assert told == [write(x) for x in xs]


def test_the_saved_output_is_a_picture_with_words_and_always_the_same():
    data, again = (stepper_of(at=12)._repr_mimebundle_() for _ in range(2))
    assert (
        "data:image/png;base64," in data["text/html"]
        and data["text/html"] == again["text/html"]
    )
    assert data["text/plain"] == again["text/plain"] and data["text/plain"].startswith(
        "<Stepper at step 12: state "
    )
    assert "application/vnd.jupyter.widget-view+json" in data
    assert "Step 12 (episode 1" in data["text/html"] and "δ = " in data["text/html"]


@pytest.mark.parametrize("method", [f"{name}+SR" for name in SYMBOLS])
def test_the_page_says_why_a_value_rose_or_fell_at_every_step(method):
    """What a step paid, with what comes next, is above or below what was expected; and TOSL carries a change on."""
    stepper = stepper_of(method=method, at=200)
    told = on_its_page(
        stepper,
        "[...Array(200).keys()].map((t) => (stepper.tape.go(t + 1), [simply, why].map((say) => "
        "say(stepper.about, stepper.tape.frame))))",
    )
    names = stepper._names
    kinds = set()
    for t, (what, reason) in enumerate(told):
        stepper.jump(t + 1)
        frame = stepper._tape.frame
        change = frame.q_sa_new - frame.q_sa
        word = "rises" if change > 0 else "falls"
        assert what == simply(stepper._tape, names), "the picture says the same"
        action = names.quoted(frame.step.a)
        if change:
            news = "yet" if change * frame.step.r < 0 else "and"
            thinks = "better" if change > 0 else "worse"
            assert f", {news} it now thinks {thinks} of {action} here: " in what
        else:
            assert what.endswith(f". It thinks of {action} here as before.")
        paid = re.match(r"Why: the step paid (\S+) and ", reason)[1]
        assert paid == given(frame.step.r)
        than = "just"
        if frame.step.delta:
            than = "more than" if frame.step.delta > 0 else "less than"
        assert f", {than} the " in reason
        against = bool(change) and change * frame.step.delta <= 0
        assert (f"The value {word} all the same" in reason) == against
        if against:
            assert method == "TOSL+SR" and change * (frame.q_sa - frame.q_old) > 0
        kinds.add(than)
    assert {"more than", "less than"} <= kinds


def test_the_page_says_the_chance_of_what_was_drawn_and_whether_another_had_more():
    stepper = stepper_of(at=100)
    told = on_its_page(
        stepper,
        "[...Array(100).keys()].map((t) => (stepper.tape.go(t + 1), chosen(stepper.about, stepper.tape.frame)))",
    )
    for t, text in enumerate(told):
        stepper.jump(t + 1)
        step = stepper._tape.frame.step
        p = np.round(step.probabilities, 6)
        shares = [float(x) for x in re.findall(r"([\d.e-]+) %", text)]
        assert shares[0] == pytest.approx(100 * p[step.a], rel=0.01)
        assert ("no action had more" in text) == (p[step.a] == p.max())
        assert len(shares) == 1 or shares[1] == pytest.approx(100 * p.max(), rel=0.01)


@pytest.mark.parametrize("method", ["Q+SR", "SL+SR", "TOSL+QBIASSR", "ESARSA+EG"])
def test_the_pages_tables_and_equations_are_the_librarys_at_every_step(method):
    stepper = stepper_of(method=method, at=40)
    every = "[...Array(41).keys()].map((t) => (stepper.tape.go(t), look(stepper.tape)))"
    look = "((tape) => [tape.q.map((row) => [...row]), tape.visits.map((row) => [...row]), tape.frame && " \
        "explained(stepper.about, tape.frame).lines.map(asText)])"  # fmt: skip
    forward = on_its_page(stepper, every.replace("look(", look + "("))
    back = on_its_page(
        stepper,
        every.replace("look(", look + "(").replace("keys()]", "keys()].reverse()"),
    )
    assert forward == back[::-1]
    for t, (q, visits, lines) in enumerate(forward):
        stepper.jump(t)
        tape = stepper._tape
        assert np.array_equal(tape.q, q) and np.array_equal(tape.visits, visits)
        assert not t or lines == [
            as_text(line) for line in explain_update(tape.agent, tape.frame)
        ]


LIVES = [("worked_example", "TOSL+QBIASSR", {}), ("worked_example", "SL+SR", {"accumulating": True}),
         ("worked_example", "ESARSA+EG", {"epsilon": 0.3}), ("wander_1k", rl.Method("TOSL", VBIASSR), {}),
         ("worked_example", "TOSL+SR", {"traces": "full"}),
         ("navigation_1k", "TOSL+SR", {"traces": "full", "loop_evasion": True}),
         ("navigation_1k", "Q+SR", {"loop_evasion": True})]  # fmt: skip


@pytest.mark.parametrize(("task", "method", "settings"), LIVES)
def test_a_life_lived_again_on_the_page_is_the_same_to_the_last_bit(
    task, method, settings
):
    engine = None if task == "worked_example" else "kinematic"
    env = rl.make_env(task, seed=3, engine=engine)
    agent = rl.Agent(task, method, seed=4, **settings)
    rl.learn(agent, env, steps=77, progress=False)  # it need not begin with nothing
    stepper = rl.Stepper(agent, env, at=200)
    again = on_its_page(stepper, "((relived) => stepper.recorded.frames.map(() => relived.step()))"
                                 "(new Replay(stepper.about, replayData, {}))")  # fmt: skip
    told = json.loads(
        json.dumps(
            [frame_data(frame, stepper._tape) for frame in stepper._tape.since(0)]
        )
    )
    for mine, its in zip(told, again, strict=True):
        for name in ("t", "s", "a", "r", "s2", "a2", "terminated", "truncated", "episode", "n", "temperature", "q",
                     "delta", "e", "qOld"):  # fmt: skip
            assert its[name] == mine[name], (mine["t"], name)
        assert its["p"] == pytest.approx(mine["p"], abs=1e-6) and its[
            "qNext"
        ] == pytest.approx(mine["qNext"])
        assert dict(zip(*its["traces"], strict=True)) == dict(
            zip(*mine["traces"], strict=True)
        )
        if mine["look"]:
            assert its["look"]["place"][:2] == pytest.approx(
                mine["look"]["place"][:2], abs=1e-3
            )
            assert its["look"]["box"] == mine["look"]["box"]
            for one, other in zip(
                its["look"]["beams"], mine["look"]["beams"], strict=True
            ):
                assert one == pytest.approx(other, abs=2e-3)


def test_what_if_alpha_were_another_is_what_the_library_learns_with_it():
    stepper = stepper_of("worked_example", "TOSL+SR", at=300)
    relived = "new Replay(stepper.about, replayData, { alpha: 0.5, lam: 0.3, temperature: 5 })"
    lived = "((relived) => { for (let i = 0; i < 300; i++) relived.step(); return relived; })"
    q = on_its_page(
        stepper, f"{lived}({relived}).simulation.m.q.map((row) => [...row])"
    )
    agent = rl.Agent(
        "worked_example", "TOSL+SR", alpha=0.5, lam=0.3, temperature=5, seed=0
    )
    rl.learn(agent, rl.make_env("worked_example", seed=0), steps=300, progress=False)
    assert np.array_equal(agent.q, q)


def test_where_no_page_can_live_it_says_why():
    assert "not this world" in on_its_page(stepper_of("wander_1k"), "replayData.reason")
    lake = gymnasium.make("FrozenLake-v1")
    stepper = rl.Stepper(rl.Agent(lake, "Q+SR", seed=0), lake)
    assert "not this world" in on_its_page(stepper, "replayData.reason")
    planner = rl.Stepper(
        rl.Agent("worked_example", "Q+EG", planner="dyna", seed=0),
        rl.make_env("worked_example"),
    )
    assert "no planner" in on_its_page(planner, "replayData.reason")


class Breaking(RandomWorld):
    def step(self, a):
        if self.np_random.random() < 0.2:
            raise OSError("the robot's battery <is> empty")
        return super().step(a)


def asked(stepper: rl.Stepper, **question) -> dict:
    """The answer of the kernel to a question of the page."""
    sent = []
    stepper.widget.send = sent.append
    stepper._hear(question)
    return sent[-1] if sent else {}


def test_the_page_asks_for_steps_and_gets_those_that_it_lacks():
    stepper = stepper_of(at=5)
    answer = asked(stepper, take=3)
    assert [frame["t"] for frame in answer["frames"]] == [5, 6, 7] and stepper.t == 8
    assert [frame["t"] for frame in asked(stepper, have=6)["frames"]] == [6, 7]
    assert asked(stepper, at=2) == {} and stepper.t == 2
    stepper.forward()
    assert (stepper.t, stepper._tape.end) == (3, 8)
    json.dumps(stepper.widget.feed)


def test_the_widgets_program_is_one_module():
    if shutil.which("node") is None:
        pytest.skip("node is missing: it runs JavaScript")
    done = subprocess.run(
        ["node", "--check", "--input-type=module", "-"],
        input=stepper_of().widget._esm,
        text=True,
    )
    assert done.returncode == 0


def test_an_error_of_the_world_is_told_on_the_page():
    env = Breaking()
    stepper = rl.Stepper(rl.Agent(env, seed=0), env, at=0)
    answer = asked(stepper, take=100)
    assert (
        answer["error"] == "the robot's battery <is> empty"
        and answer["frames"][-1]["t"] + 1 == stepper._tape.end
    )
    with pytest.raises(RuntimeError, match="stopped with an error before"):
        stepper.forward(3 + stepper._tape.end)


def test_an_agent_that_learned_elsewhere_is_noticed():
    agent, env = (
        rl.Agent("worked_example", seed=0),
        rl.make_env("worked_example", seed=0),
    )
    stepper = rl.Stepper(agent, env, at=5)
    rl.learn(agent, env, steps=10, progress=False)
    stepper.back()
    with pytest.raises(RuntimeError, match="used elsewhere"):
        stepper.forward(2)
    with pytest.raises(ValueError, match="in this order; got RobotEnv and Agent"):
        rl.Stepper(env, agent)


def test_a_robot_leaves_a_path_that_begins_where_its_episode_began():
    stepper = stepper_of("wander_1k", at=20)
    panes, looks = on_its_page(
        stepper, "[views(stepper.tape), stepper.tape.looks().map((look) => look.place)]"
    )
    seen = stepper._tape.looks()
    assert len(seen) == 21 and 'aria-label="A room of' in panes
    np.testing.assert_allclose(np.array(looks)[:, :2], path_of(seen)[:, :2], atol=1e-3)
    assert all(solid.role != "wall" for solid in seen[0].solids)
    agent, env = stepper._tape.agent, rl.make_env("wander_1k", seed=0)
    assert view_of(env, Names(agent, env)).heading == "The world from above"


def test_the_trail_is_called_start_only_where_it_reaches_the_start_of_the_episode():
    def words(t):
        axes = (
            rl.Stepper(
                rl.Agent("wander_1k", seed=0), rl.make_env("wander_1k", seed=0), at=t
            )
            .picture()
            .axes
        )
        return [text.get_text().strip() for ax in axes for text in ax.texts]

    assert "start" in words(40)
    assert "start" not in words(173)


def test_the_still_shows_the_rows_that_the_step_changed_and_no_others():
    agent = rl.Agent("worked_example", "TOSL+EG", seed=0)
    stepper = rl.Stepper(agent, rl.make_env("worked_example", seed=0), at=12)
    frame = stepper._tape.frame
    shown = rows_of_step(stepper._tape).states
    changed = set((frame.q_change.where // 3).tolist())
    assert set(shown) == changed | {frame.step.s, frame.step.s_next}
    assert shown == sorted(shown)


def test_no_value_in_the_still_lies_on_the_robot():
    agent = rl.Agent("worked_example", "Q+RANDOM", seed=0)
    stepper = rl.Stepper(agent, rl.make_env("worked_example", seed=0), at=31)
    picture = stepper.picture()
    (robot,) = (p for p in picture.axes[0].patches if p.get_label() == "robot/body")
    marks = [p for p in picture.axes[0].patches if p.get_zorder() == 20]
    assert marks
    assert not any(
        mark.get_bbox().contains(*xy) for mark in marks for xy in robot.get_xy()
    )
    assert picture.finding == (
        "The robot spun to the left. That cost 0.02, yet it now thinks better of\n"
        "“spin left” here: −0.002 → 0.167."
    )
