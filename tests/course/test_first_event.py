"""Of a run that is wrong, the check shows the first call that differs, and not the numbers at the end."""

import time

import numpy as np
import pytest
from test_checks import exercises, learner

from rlrobot_course.lesson_09.exercises import new_temperature
from rlrobot_course.lesson_10.exercises import choose, true_online_update
from rlrobot_grading.answers.limits import Elsewhere
from rlrobot_grading.hints import first_change, first_event

# the exercises that are judged by whole runs, and how many of the first known mistakes show a call that differs
RUNS = {
    ("lesson_03", "learn"): 10,
    ("lesson_06", "sarsa_learn"): 10,
    ("lesson_10", "learn"): 6,
    ("lesson_10", "learn_and_evade"): 6,
    ("lesson_17", "dyna"): 7,
    ("assignment_1", "train"): 1,
    ("assignment_2", "double_learn"): 6,
    ("assignment_4", "drive"): 6,
}


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(("lesson", "name"), RUNS)
def test_known_mistakes_show_the_first_call_that_differs(lesson, name):
    check = exercises(lesson)[name]
    n = n_others = 0
    for wrong in check.wrong_functions[:10]:
        with np.errstate(all="ignore"):
            verdict = check(wrong)
        assert verdict.status == "wrong" and verdict.rows
        n_others += "The table has the first" not in verdict.text
        if "first call in it that differs" not in verdict.text:
            continue
        n += 1
        names = [row[0] for row in verdict.rows]
        assert names[:2] == ["steps so far", "call"] and len(names) <= 8
        assert any(expected != got for _, expected, got in verdict.rows)
    assert n >= RUNS[lesson, name]
    assert n_others <= 1, "a result of another kind shows itself"


LOOP = """
def answer(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        {}
        s = s_next
        if terminated or truncated:
            s = env.reset()
"""
EVENTS = {
    "an argument": (
        "update(q, s, a, -r, s_next, terminated)",
        (
            ("steps so far", "1", "1"),
            ("call", "update", "update"),
            ("s", "0", "0"),
            ("a", "2", "2"),
            ("r", "-0.0213", "0.0213"),
            ("s_next", "0", "0"),
            ("terminated", "False", "False"),
        ),
    ),
    "a call that is left out": (
        "terminated or update(q, s, a, r, s_next, terminated)",
        (
            ("steps so far", "3", "3"),
            ("call", "update", "env.reset"),
            ("s", "1", ""),
            ("a", "0", ""),
            ("r", "-2", ""),
            ("s_next", "3", ""),
            ("terminated", "True", ""),
        ),
    ),
    "a table, with the entries that differ": (
        "q[0] -= 1; update(q, s, a, r, s_next, terminated)",
        (
            ("steps so far", "1", "1"),
            ("call", "update", "update"),
            ("q[0, 0]", "0", "-1"),
            ("q[0, 1]", "2", "1"),
            ("s", "0", "0"),
            ("a", "2", "2"),
            ("r", "-0.0213", "-0.0213"),
            ("s_next", "0", "0"),
        ),
    ),
    "a loop that ends too early": (
        "update(q, s, a, r, s_next, terminated); return",
        (
            ("steps so far", "1", ""),
            ("call", "choose", "no call"),
            ("s", "0", ""),
        ),
    ),
}


@pytest.mark.parametrize("which", EVENTS)
def test_an_event_is_one_small_table(which):
    line, rows = EVENTS[which]
    verdict = exercises("lesson_03")["learn"](learner(LOOP.format(line)))
    assert verdict.text.startswith("Run 1 of 6 is the first")
    assert verdict.rows == rows


TRAINS = """
def answer(env, q, choose, episodes, alpha, gamma):
    sums = []
    for _ in range(episodes):
        s, total, over = env.reset(), 0.0, False
        while not over:
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            target = r if terminated else r + gamma * max(q[s_next])
            q[s, a] += alpha * (target - q[s, a])
            s, total, over = s_next, total + r, terminated or truncated
        sums.append(total)
    return sums
"""


def trains(old, new):
    """The verdict on the right learner of assignment 1 with one piece written otherwise."""
    assert old in TRAINS
    return exercises("assignment_1")["train"](learner(TRAINS.replace(old, new)))


def test_of_a_loop_that_learns_itself_the_first_step_with_another_table_is_shown():
    verdict = trains("r if terminated else", "r if truncated else")
    assert (
        "The table has the first step after which a table is another." in verdict.text
    )
    assert verdict.rows == (
        ("steps so far", "3", "3"),
        ("s", "1", "1"),
        ("a", "0", "0"),
        ("s_next", "3", "3"),
        ("r", "-2", "-2"),
        ("terminated", "True", "True"),
        ("truncated", "False", "False"),
        ("q[1, 0]", "0.7375", "3.8875"),
    )


def test_of_a_dictionary_that_a_loop_fills_the_first_other_entry_is_shown():
    keeps = "seen.setdefault((s, a), (r, s_next, terminated))"
    answer = learner(DYNA.replace("seen[s, a] = (r, s_next, terminated)", keeps))
    rows = exercises("lesson_17")["dyna"](answer).rows
    assert rows[0] == ("steps so far", "4", "4")
    assert ("seen[1, 2]", "[10, 0, False]", "[10, 2, False]") in rows


DYNA = """
def answer(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        seen[s, a] = (r, s_next, terminated)
        for pair in pick(seen):
            update(q, *pair, *seen[pair])
        s = s_next
        if terminated or truncated:
            s = env.reset()
"""


def test_of_a_result_that_alone_is_wrong_the_first_other_entry_is_shown():
    verdict = trains("total + r,", "total + r * gamma,")
    assert "The table has the first entry that differs." in verdict.text
    assert verdict.rows == (("sums[0]", "6", "5.4"),)
    assert trains("return sums", "return sums[:1] + sums").rows[0][0] == "sums"


def test_an_answer_of_which_nothing_can_be_told_so_is_shown_as_before(monkeypatch):
    monkeypatch.setattr(first_change, "_run", lambda *_: 1 / 0)
    assert trains("r if terminated else", "r if truncated else").rows[0][0] == "q[1, 0]"


def test_a_copy_of_the_table_that_learns_is_told_by_what_the_other_lacks():
    source = LOOP.format("update(q, s, a, r, s_next, terminated)")
    source = source.replace(
        "    s = env.reset()\n    for",
        "    kept = q; q = q.copy(); s = env.reset()\n    for",
    )
    verdict = exercises("lesson_03")["learn"](learner(source))
    assert verdict.rows[0] == ("steps so far", "1", "1")
    assert verdict.rows[-1][0].startswith("q[") and "call" not in verdict.text


EVADES = """
def answer(env, shape, n_actions, r_max, steps, rng, alpha, gamma, lam, default):
    q = np.zeros((np.prod(shape), n_actions))
    e, q_old = np.zeros_like(q), 0.0
    length = max(4, min(21, len(q) // 4))
    states, rewards, temperature = [], [], default
    s = env.reset()
    a = choose(q, shape, s, temperature, r_max, gamma, rng.random())
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        states, rewards = [*states, s_next][-length:], [*rewards, r][-length:]
        if len(states) == length:
            temperature = new_temperature(temperature, states, rewards, s_next, default)
        a_next = choose(q, shape, s_next, temperature, r_max, gamma, rng.random())
        q_old = true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)
        s, a = s_next, a_next
        if terminated or truncated:
            e[:], q_old = 0.0, 0.0
            states, rewards, temperature = [], [], default
            s = env.reset()
            a = choose(q, shape, s, temperature, r_max, gamma, rng.random())
    return q
"""
OWN = {"choose": choose, "new_temperature": new_temperature, "true_online_update": true_online_update}  # fmt: skip


def evades(old, new):
    """The verdict on the right learner of lesson 10 with one piece written otherwise, in a learner's cell."""
    assert old in EVADES
    answer = learner(EVADES.replace(old, new))
    answer.__globals__.update(OWN)
    return exercises("lesson_10")["learn_and_evade"](answer)


def test_of_the_learners_own_functions_temperature_and_queue_are_shown():
    rows = evades("[*states, s_next]", "[*states, s]").rows
    assert rows[1] == ("call", "new_temperature", "new_temperature")
    assert any(name.startswith("states[") for name, _, _ in rows)
    rows = evades("len(states) == length", "len(states) >= 4").rows
    assert ("temperature", "0.02", "1.02") in rows
    rows = evades("            temperature = new", "            _ = new").rows
    assert rows == (
        ("steps so far", "7", "7"),
        ("call", "choose", "choose"),
        ("s", "17", "17"),
        ("temperature", "1.75", "1"),
        ("u", "0.055147", "0.055147"),
    )


def test_a_cell_with_helpers_of_its_own_is_shown_what_can_be_seen():
    source = EVADES.replace("choose(", "pick(").replace("-length:]", "-length + 1:]")
    answer = learner(source + "\ndef pick(*given):\n    return choose(*given)\n")
    answer.__globals__.update(OWN)
    verdict = exercises("lesson_10")["learn_and_evade"](answer)
    assert verdict.rows and "choose" not in [got for _, _, got in verdict.rows]


def test_a_right_answer_of_another_make_is_asked_for_no_event(monkeypatch):
    monkeypatch.setattr(first_event, "_first_event", lambda seen: 1 / 0)
    assert evades("for _ in", "for step in")


def test_an_answer_in_another_process_is_shown_as_before():
    check = exercises("lesson_03")["learn"]
    wrong = learner(LOOP.format("update(q, s, a, -r, s_next, terminated)"))
    seen = check.evidence(Elsewhere(lambda *given: (wrong(*given), None, "")), [])
    assert first_event.first_event(seen) == ()


def test_a_check_of_a_run_answers_in_time():
    check = exercises("lesson_03")["learn"]
    wrong = learner(LOOP.format("update(q, s, a, -r, s_next, terminated)"))
    begun = time.process_time()
    check(wrong)
    assert (
        time.process_time() - begun < 5.0
    )  # a median of two is wanted, and none above five
