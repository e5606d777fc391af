"""The stepper: what it records, what it shows, and how it plays."""

import asyncio
import re
import statistics
import time
from itertools import product

import gymnasium
import numpy as np
import pytest
from own_thread import in_a_thread
from worlds import RandomWorld

import rlrobot_edu as rl
from rlrobot_edu.course.stepper.code_view import code_html
from rlrobot_edu.course.stepper.colours import STRONGEST, css, largest, tint
from rlrobot_edu.course.stepper.environment_view import view_of
from rlrobot_edu.course.stepper.equations import explain_update
from rlrobot_edu.course.stepper.names import Names
from rlrobot_edu.course.stepper.numerals import given, number, short
from rlrobot_edu.course.stepper.script import KEYS
from rlrobot_edu.course.stepper.state_view import StateView
from rlrobot_edu.course.stepper.style import STYLE
from rlrobot_edu.course.stepper.tables import Window, q_html, traces_of
from rlrobot_edu.course.stepper.tape import Tape
from rlrobot_edu.learning.methods import ALGORITHMS


def tape_of(method: str, length: int = 500, p_end: float = 0.1, **settings) -> Tape:
    env = RandomWorld(p_end=p_end)
    agent = rl.Agent(env, method, seed=1, **settings)
    return Tape(agent, env, StateView(Names(agent, env, None)), length)


def stepper_of(task: str = "worked_example", method: str = "TOSL+QBIASSR", **options) -> rl.Stepper:
    return rl.Stepper(rl.Agent(task, method, seed=0), rl.make_env(task, seed=0), **options)


def exact(view: str) -> list[list[str]]:
    """The numbers row of each equation in a view: exact values where there are some, else the text."""
    update = re.search(r'<section class="update">(.*?)</section>', view, re.S)[1]
    term = r'<span(?: class="[^"]*")?(?: title="([^"]*)")?(?: style="[^"]*")?><i>.*?</i><b>(.*?)</b></span>'
    return [[value or text for value, text in re.findall(term, line)] for line in update.split('class="line"')[1:]]


def evaluate(row: list[str]) -> tuple[float, float]:
    """Both sides of ``… ← formula = result``; without a result, the formula twice."""
    formula = "".join(row).replace("−", "-").replace("·", "*").split("←")[-1]
    formula, _, result = formula.removeprefix("δ=").rpartition("=") if "=" in formula else (formula, "", formula)
    return eval(formula), eval(result)


@pytest.mark.parametrize("method", [f"{a}+{s}" for a, s in product(ALGORITHMS, ("SR", "QBIASSR", "EG"))])
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


@pytest.mark.parametrize("method", [f"{a}+{s}" for a, s in product(ALGORITHMS, ("SR", "QBIASSR", "EG"))])
def test_watching_changes_nothing_about_learning(method):
    tape = tape_of(method)
    for _ in range(150):
        tape.forward()
    env = RandomWorld(p_end=0.1)
    agent = rl.Agent(env, method, seed=1)
    alone = list(rl.steps(agent, env, steps=150))
    assert [tape._at(t).step[:9] for t in range(1, 151)] == [step[:9] for step in alone]
    assert np.array_equal(agent.q, tape.agent.q)


@pytest.mark.parametrize("settings", [*({"method": f"{a}+SR"} for a in ALGORITHMS),
                                      {"method": "SL+SR", "accumulating": True},
                                      {"method": "TOSL+SR", "traces": "full"}])  # fmt: skip
def test_the_numbers_in_the_equation_are_the_librarys(settings):
    tape = tape_of(**settings)
    for _ in range(200):
        tape.forward()
        step, lines = tape.frame.step, explain_update(tape.agent, tape.frame).lines
        rows = [[term.text if term.value is None else repr(term.value) for term in line] for line in lines]
        for row in rows:
            computed, stated = evaluate(row)
            assert np.isclose(computed, stated, rtol=1e-12, atol=1e-12)
        assert evaluate(rows[-1])[1] == tape.q[step.s, step.a] == tape.frame.q_sa_new
        if len(rows) == 3:
            fade = tape.agent.parameters.gamma * tape.agent.parameters.lam
            assert evaluate(rows[0])[1] == step.delta
            assert np.isclose(evaluate(rows[1])[1] * fade, tape.e[step.s, step.a], rtol=1e-12)


def test_the_page_shows_the_equation_of_the_step_with_symbols_above_the_numbers():
    stepper = stepper_of(method="Q+SR", at=3)
    step = stepper._tape.frame.step
    (row,) = exact(stepper.html)
    assert evaluate(row)[1] == stepper._tape.q[step.s, step.a]
    update = explain_update(stepper._tape.agent, stepper._tape.frame)
    assert "".join(term.symbol for term in update.lines[0]) == "Q(s, a)←Q(s, a)+α·(r+γ·max Q(s′, ·)−Q(s, a))"
    assert update.text()[0].startswith(f"Q({step.s}, {step.a}) ← 0.00 + 0.1·(")


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_after_a_terminal_step_nothing_follows_and_after_a_truncated_one_the_world_goes_on(algorithm):
    tape = tape_of(f"{algorithm}+SR", p_end=0.5)
    while tape.frame is None or not tape.frame.step.terminated:
        tape.forward()
    assert tape.frame.q_next == 0.0
    assert "Terminal: nothing follows" in explain_update(tape.agent, tape.frame).note
    tape.forward()
    assert tape.frame.number == 1 and tape.frame.q_old == tape.frame.e_sa == 0.0

    stepper = stepper_of(method=f"{algorithm}+SR", at=30)  # its episodes are cut off there
    assert "Time is up" in stepper.html and "episode ends" in stepper.html
    stepper.forward()
    assert "episode begins" in stepper.html and "episode 2, its step 1" in stepper.html


def test_memory_stays_bounded_however_long_it_plays(wander_model):
    env = rl.make_env(wander_model, seed=0)
    stepper = rl.Stepper(rl.Agent(wander_model, seed=0), env, keep=50)
    stepper.forward(5000)
    tape = stepper._tape
    assert (stepper.t, len(tape._frames), tape.first) == (5001, 50, 4952)
    stepper.back(1000)
    assert stepper.t == 4952
    with pytest.raises(ValueError, match="no step 7 to show: the earliest that is kept is 4952"):
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


@pytest.mark.parametrize("name, words", [("CliffWalking-v1", "A grid of 4 by 12 cells"),
                                         ("FrozenLake-v1", "A grid of 4 by 4 cells"),
                                         ("Taxi-v4", "the 12 states visited last, of 500")])  # fmt: skip
def test_gymnasiums_own_worlds_are_drawn_as_what_they_are(name, words):
    env = gymnasium.make(name)
    env.reset(seed=0)
    stepper = rl.Stepper(rl.Agent(env, "TOSL+EG", seed=0), env, at=20)
    assert words in stepper.html and stepper.picture().png()


def test_a_sample_model_takes_its_words_from_the_task(wander_model):
    env, task = rl.make_env(wander_model, seed=0), rl.load_task("wander_1k")
    assert "laser_front_left" in rl.Stepper(rl.Agent(wander_model, seed=0), env, task=task).html
    assert "input 4" in rl.Stepper(rl.Agent(wander_model, seed=0), env).html
    with pytest.raises(ValueError, match="'worked_example' has states"):
        rl.Stepper(rl.Agent(wander_model, seed=0), env, task=rl.load_task("worked_example"))


def test_only_what_fits_is_shown_and_the_heading_says_so():
    tape = tape_of("Q+SR")
    assert Window.of(tape).states == list(range(12)) and Window.of(tape).says == "all 12 states"
    stepper = stepper_of("wander_12k", at=3)
    window, step = Window.of(stepper._tape), stepper._tape.frame.step
    assert window.states[0] == step.s_next and step.s in window.states[:2]
    assert len(window.states) == 12 and window.states[-1] is None
    assert step.a in window.actions and len(window.actions) == 9
    assert "9 of 25 actions" in window.says and "all other actions together" in stepper.html


def test_each_part_of_a_step_is_on_the_page_and_marked_by_more_than_colour():
    view = stepper_of(at=12).html
    for pane in ("world", "choice", "update", "q", "traces"):
        assert f'<section class="{pane}"><h4>' in view
    assert '<details class="code"><summary>' in stepper_of().widget.children[-2].value
    assert len(re.findall(r'<td class="[^"]*\bpair\b', view)) == 2 and "▲" in view and "▶ advance</th>" in view
    assert "s keeps no traces" not in view and "Q keeps no traces" in stepper_of(method="Q+SR").html


def test_a_step_is_told_in_three_beats_world_equation_table():
    for task in ("worked_example", "wander_1k"):  # a square world and a wide one
        view = stepper_of(task, at=12).html
        places = [view.index(f'<section class="{pane}">') for pane in ("world", "update", "q")]
        assert places == sorted(places)


@pytest.mark.parametrize("method", ["Q+SR", "SARSA+SR", "TOSL+SR"])
def test_a_term_of_the_equation_has_the_colour_of_its_number_in_the_table(method):
    stepper = stepper_of(method=method, at=12)
    tape, view = stepper._tape, stepper.html
    most = largest(tape.q, tape.agent.parameters.r_max)
    said = dict(re.findall(r'<span class="to-(\w+)" title="[^"]*" style="background:(.*?)">', view))
    assert said["pair"] == css(*tint(tape.frame.q_sa, most))
    assert said["next"] == css(*tint(tape.frame.q_next, most)) and said["reward"] == css(*tint(tape.frame.step.r, most))
    assert f'style="background:{said["reward"]}">{given(tape.frame.step.r)}</b>' in view


@pytest.mark.parametrize("method", ["Q+SR", "TOSL+SR"])
def test_a_changed_cell_says_what_it_was_and_what_it_is_now_and_large_changes_have_stronger_frames(method):
    stepper = stepper_of(method=method, at=12)
    _, old, new = stepper._tape.frame.q_change
    cell = r'<td class="[^"]*\bnew\b[^"]*" title="by (.*?)" style="[^"]*;--strength:(.*?)"><u>(.)</u>'
    told = re.findall(cell + r"<small>(.*?) → </small>(.*?)</td>", stepper.html)
    assert sorted((by, *rest) for by, _, *rest in told) == sorted(
        (number(y - x), "▲" if y > x else "▼", short(x), short(y))
        for x, y in zip(old.tolist(), new.tolist(), strict=True)
    )
    assert old.size and max(float(strength) for _, strength, *_ in told) == 1.0


def test_the_code_on_the_page_is_the_librarys_and_the_lines_that_change_q_are_marked():
    where, code = code_html(rl.Agent("worked_example", "Q+SR"))
    assert re.fullmatch(r"rlrobot_edu/learning/q_learning.py, line \d+", where)
    (hot,) = re.findall(r'<div class="hot">(.*?)</div>', code)
    assert hot.endswith("q[s, a] += alpha * delta") and "Learn from one transition" not in code
    assert code_html(rl.Agent("worked_example", "TOSL+SR"))[1].count("▶") == 2


def test_before_the_first_step_there_is_a_world_and_no_update():
    stepper = stepper_of(at=0)
    assert stepper.t == 0 and "Before the first step" in stepper.html and "<svg" in stepper.html
    assert repr(stepper) == "<Stepper before the first step>" and stepper.picture().png()
    assert not stepper._tape.q.any()


@pytest.mark.parametrize("page, ink", [(np.ones(3), np.full(3, 0.13)), (np.full(3, 0.067), np.full(3, 0.87))])
def test_lettering_stands_out_on_every_value_in_the_light_and_in_the_dark_theme(page, ink):
    def luminance(rgb):
        return np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4) @ (0.2126, 0.7152, 0.0722)

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
    assert [largest(np.array([[-x, x / 2]]), 1.0) for x in (0.1, 1.5, 13, 26, 99)] == [1, 2, 20, 50, 100]


def test_what_was_never_tried_is_a_dot_and_a_learned_zero_is_a_zero():
    stepper = stepper_of(at=1)
    tape = stepper._tape
    assert tape.visits.sum() == 1
    tape.q[0, 0], tape.visits[0, 0] = 0.0, 1
    view = q_html(tape, Window.of(tape), stepper._names)
    assert view.count(">·</td>") == 72 - len(np.argwhere(tape.visits)) and ">0</td>" in view
    tape.visits[0, 0] = tape.agent.visits[0, 0]
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
        share = agent.parameters.alpha * (step.delta + (frame.q_sa - frame.q_old) * (agent.algorithm == "TOSL"))
        changes = (tape.q - before).ravel()
        pair = step.s * tape.q.shape[1] + step.a
        if agent.algorithm == "TOSL":
            changes[pair] += agent.parameters.alpha * (frame.q_sa - frame.q_old)
        expected = np.zeros(tape.q.size)
        expected[list(traces)] = share * np.array(list(traces.values()))
        assert np.allclose(changes, expected, rtol=1e-9, atol=1e-12)


def test_a_next_is_covered_on_request_and_not_spoken_of_by_methods_that_do_not_learn_from_it():
    def view(method, **options):
        return stepper_of(method=method, at=3, **options)

    said = re.compile(r'<div class="said"><span>(.*?)</span>')
    assert "a′ = " in said.search(view("SARSA+SR").html)[1] and "a′" not in said.search(view("Q+SR").html)[1]
    hidden = view("SARSA+SR", hide="a_next")
    assert "a′" not in said.search(hidden.html)[1] and "<details><summary>Show a′</summary> = " in hidden.html
    assert "a′ = " not in hidden.picture().alt and 'class="next' not in hidden.html
    with pytest.raises(ValueError, match="can hide a_next, got hide="):
        view("SARSA+SR", hide=("b",))


@pytest.mark.parametrize("method", ["Q+SR", "SARSA+SR", "TOSL+SR", "ESARSA+SR"])
def test_the_terms_of_the_equation_point_at_their_cells(method):
    stepper = stepper_of(method=method, at=12)
    view, step = stepper.html, stepper._tape.frame.step
    for name in ("pair", "next", "reward"):
        assert f'<span class="to-{name}"' in view
    q = view[view.index('<section class="q">') : view.index("</section>", view.index('<section class="q">'))]
    assert len(re.findall(r'<td class="[^"]*next', q)) == (3 if method == "ESARSA+SR" else 1)
    assert step.s_next is not None and not re.search(r"<th[^>]*>\s*(&nbsp;)?\s*</th>", view)


def test_worlds_of_cells_show_the_value_and_the_best_action_of_what_was_visited():
    lake = gymnasium.make("FrozenLake-v1", is_slippery=False)
    stepper = rl.Stepper(rl.Agent(lake, "SL+SR", seed=25), lake, at=24)
    best = stepper._tape.q.max(axis=1)
    values = [float(text) for text in re.findall(r'class="v">(.*?)</text>', stepper.html)]
    assert values == [float(short(best[s])) for s in np.flatnonzero(stepper._tape.visits.any(axis=1))]
    assert "best →</title>" in stepper.html and "<polygon points=" in stepper.html
    cells = stepper_of(at=107)
    assert cells.html.count('class="chip"') == 4 and "<title>state 3: ↑ 1.72</title>" in cells.html


def test_wheels_have_icons_and_the_latest_rewards_are_a_line():
    stepper = stepper_of("wander_1k", at=40)
    names = stepper._names
    # what the task makes of it: both wheels back is twice ahead, and one wheel back is nothing
    assert "".join(names.column(a)[0] for a in range(9)) == "↑■↺■■↖↻↗↑" and names.column(8) == "↑ 8"
    assert names.row(0) == "0: ↑ −1, −1"
    simple = stepper_of("wander_simple", at=2)._names
    assert [simple.column(a) for a in range(4)] == list("■↺↻↑") and simple.row(3) == "↑ 1, 1"
    line = re.search(r'<p class="rewards".*?</p>', stepper.html)[0]
    assert line.count("<b") == 10 and stepper_of(at=31).html.count("<i>|</i>") == 1


def test_numbers_are_short_and_never_rounded_to_nothing():
    assert [number(x) for x in (0, 1, -0.002, 0.905, 12.345)] == ["0.00", "1.00", "−0.002", "0.905", "12.35"]
    assert [short(x) for x in (0, 1, -0.0021, 0.905, 4e-5)] == ["0", "1.00", "−0.002", "0.91", "4e−5"]
    for x in np.geomspace(1e-9, 1e9, 200):
        assert len(short(-x)) <= 6 and float(short(x).replace("−", "-")) > 0 < float(number(x).replace("−", "-"))


def test_the_saved_output_is_a_picture_with_words_and_always_the_same():
    data, again = (stepper_of(at=12)._repr_mimebundle_() for _ in range(2))
    assert "data:image/png;base64," in data["text/html"] and data["text/html"] == again["text/html"]
    assert data["text/plain"] == again["text/plain"] and data["text/plain"].startswith("<Stepper at step 12: state ")
    assert "application/vnd.jupyter.widget-view+json" in data
    assert "Step 12 (episode 1" in data["text/html"] and "δ = " in data["text/html"]


async def until(holds) -> None:
    """Let the stepper play until `holds()`, however slow the machine is."""
    async with asyncio.timeout(60):
        while not holds():
            await asyncio.sleep(0.005)


@in_a_thread
def test_it_plays_no_faster_than_asked_and_a_pause_stops_it_at_once():
    async def play() -> None:
        stepper = stepper_of()
        stepper.controls.speed.value = 20
        start = time.monotonic()
        stepper.play()
        stepper.play()  # a second call changes nothing
        await until(lambda: stepper.t >= 6)
        assert time.monotonic() - start >= 4 / 20  # five steps, the first of them at once
        stepper.pause()
        paused = stepper.t
        await asyncio.sleep(0.2)
        assert stepper.t == paused
        button = stepper.controls.buttons["play"]
        button.click()
        assert "Pause" in button.description
        await until(lambda: stepper.t > paused)
        button.click()
        assert "Play" in button.description

    asyncio.run(play())
    with pytest.raises(RuntimeError, match="running event loop"):
        stepper_of().play()


@in_a_thread
def test_it_does_not_run_ahead_of_a_page_that_is_slow():
    async def play() -> int:
        stepper = stepper_of()
        stepper.controls.speed.value = 30
        stepper.play()
        await asyncio.sleep(0.02)
        stepper._player.page_has_shown()  # the page has shown one step, and then no more
        await asyncio.sleep(0.5)
        stepper.pause()
        return stepper.t

    assert asyncio.run(play()) <= 5


@in_a_thread
def test_a_jump_far_ahead_can_be_stopped_and_says_how_far_it_went():
    async def go() -> rl.Stepper:
        stepper = stepper_of()
        stepper.controls.field.value = 10**9
        await until(lambda: "on the way to step 1000000000. Pause stops it." in stepper._answer.value)
        assert "Pause" in stepper.controls.buttons["play"].description
        stepper.controls.buttons["play"].click()
        await until(lambda: "Stopped at step" in stepper._answer.value)
        return stepper

    stepper = asyncio.run(go())
    assert f"Stopped at step {stepper.t}, on the way to step 1000000000." in stepper._answer.value
    assert stepper.controls.field.value == stepper.controls.slider.value == stepper.t < 10**6
    assert f"Step {stepper.t} (" in stepper.html

    async def arrive() -> None:
        stepper = stepper_of()
        stepper.controls.field.value = 700
        await until(lambda: not stepper._player.runs)
        assert stepper.t == 700 and "rl-error" not in stepper._answer.value

    asyncio.run(arrive())


def test_a_step_that_is_no_longer_kept_is_told_and_every_click_is_answered():
    stepper = stepper_of(at=30, keep=5)
    answer = stepper._answer.value
    stepper.controls.buttons["last"].click()
    assert stepper._answer.value != answer
    stepper.controls.field.value = 3
    assert "the earliest that is kept is 26" in stepper._answer.value and stepper.controls.field.value == 30


class Breaking(RandomWorld):
    def step(self, a):
        if self.np_random.random() < 0.2:
            raise OSError("the robot's battery <is> empty")
        return super().step(a)


@in_a_thread
def test_an_error_stops_playing_and_is_told_on_the_page():
    async def play() -> rl.Stepper:
        env = Breaking()
        stepper = rl.Stepper(rl.Agent(env, seed=0), env)
        stepper.controls.speed.value = 30
        stepper.play()
        await until(lambda: not stepper._player.runs)
        return stepper

    stepper = asyncio.run(play())
    assert not stepper._player.runs and "battery &lt;is&gt; empty" in stepper._answer.value
    with pytest.raises(RuntimeError, match="stopped with an error before"):
        stepper.forward(3)


def test_the_controls_move_the_view():
    stepper = stepper_of(at=10)
    stepper.controls.slider.value = 4
    assert stepper.t == 4 == stepper.controls.field.value
    stepper.controls.field.value = 25
    assert stepper.t == 25 == stepper.controls.slider.value == stepper.controls.slider.max
    stepper.back(5)
    assert (stepper.t, stepper.controls.slider.value, stepper.controls.slider.max) == (20, 20, 25)
    names = {c: b for b in stepper.widget.children[0].children for c in b._dom_classes}
    for name, t in (("first", 0), ("step", 1), ("last", 25), ("back", 24)):
        names[f"rl-{name}"].click()
        assert stepper.t == t
    for control in (*names.values(), stepper.controls.slider, stepper.controls.field, stepper.controls.speed):
        assert control.description and control.tooltip


def test_an_agent_that_learned_elsewhere_is_noticed():
    agent, env = rl.Agent("worked_example", seed=0), rl.make_env("worked_example", seed=0)
    stepper = rl.Stepper(agent, env, at=5)
    rl.learn(agent, env, steps=10, progress=False)
    stepper.back()
    with pytest.raises(RuntimeError, match="used elsewhere"):
        stepper.forward(2)
    with pytest.raises(ValueError, match="in this order; got RobotEnv and Agent"):
        rl.Stepper(env, agent)


def test_a_robot_leaves_a_path_that_begins_where_its_episode_began():
    stepper = stepper_of("wander_1k", at=20)
    looks = stepper._tape.looks()
    assert len(looks) == 21 and 'aria-label="A room of' in stepper.html
    assert all(solid.role != "wall" for solid in looks[0].solids)
    agent, env = stepper._tape.agent, rl.make_env("wander_1k", seed=0)
    assert view_of(env, Names(agent, env, None)).heading == "The world from above"


@pytest.mark.long
def test_in_a_browser_held_keys_wait_for_the_kernel_which_is_missed_and_nothing_is_cut_off(browser):
    names = ("first", "back", "step", "play", "last", "shown")
    buttons = "".join(f"<button class='rl-{name}' onclick='pressed.push(`{name}`)'></button>" for name in names)
    handle = (
        "<div class='widget-slider'><label>step</label><div class='noUi-handle' role='slider' tabindex='0'></div></div>"
    )
    view = stepper_of(at=12).html
    page = browser.new_page(viewport={"width": 1000, "height": 1000})
    page.set_default_timeout(120_000)
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.set_content(
        f"<script>pressed = []</script><div class='rl-stepper'>{buttons}{handle}{STYLE}{KEYS}<main></main></div>"
    )
    page.wait_for_function("document.querySelector('.rl-stepper').rl")

    def show(html):
        page.evaluate("view => { document.querySelector('main').innerHTML = view }", html)
        page.wait_for_function("pressed.at(-1) === 'shown'")
        page.evaluate("pressed.pop()")

    show(view)
    assert page.get_by_role("slider", name="step").count() == 1
    page.wait_for_function("document.querySelector('[aria-live]').textContent.startsWith('Step 12 (')")
    page.click(".rl-view .q h4")
    for key in ("ArrowRight", "ArrowLeft", "Space", "Home", "End", "x", "Control+ArrowRight"):
        page.keyboard.press(key)
    assert page.evaluate("pressed.splice(0)") == ["step", "back", "play", "first", "last"]
    page.focus("button.rl-step")  # as after a click on it
    for key in ("ArrowRight", "ArrowLeft", "Home"):
        page.keyboard.press(key)
    assert page.evaluate("pressed.splice(0)") == ["step", "back", "first"]
    assert page.evaluate("!!document.activeElement.closest('[data-lm-suppress-shortcuts]')")
    page.focus(".noUi-handle")
    page.keyboard.press("ArrowRight")
    assert page.evaluate("pressed.splice(0)") == [], "an arrow on a slider moves the slider"
    page.focus(".rl-keys")
    show(view)
    for _ in range(10):
        page.keyboard.down("ArrowRight")  # held: the first one, and no more before the kernel has answered
    assert page.evaluate("pressed.splice(0)") == ["step"]
    assert page.locator(".rl-silent").is_hidden()
    page.locator(".rl-silent").wait_for()
    assert "restarted" in page.locator(".rl-silent").inner_text()
    show(view)
    page.keyboard.down("ArrowRight")
    assert page.evaluate("pressed.splice(0)") == ["step"] and page.locator(".rl-silent").is_hidden()
    show(view)
    assert page.evaluate("document.activeElement.className") == "rl-keys"
    page.hover(".line .to-pair")
    assert page.evaluate("getComputedStyle(document.querySelector('.q td.pair')).outlineWidth") == "4px"
    for width in range(460, 1900, 120):
        page.set_viewport_size({"width": width, "height": 900})
        cut = page.evaluate(
            "[...document.querySelectorAll('.rl-view *')].filter(e => e.clientWidth && e.scrollWidth > "
            "e.clientWidth + 1 || e.getBoundingClientRect().right > innerWidth).map(e => e.outerHTML)"
        )
        assert cut == [], width
    page.close()
    assert errors == []


def test_the_trail_is_called_start_only_where_it_reaches_the_start_of_the_episode():
    def words(t):
        axes = rl.Stepper(rl.Agent("wander_1k", seed=0), rl.make_env("wander_1k", seed=0), at=t).picture().axes
        return [text.get_text().strip() for ax in axes for text in ax.texts]

    assert "start" in words(40)
    assert "start" not in words(173)
