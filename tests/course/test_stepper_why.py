"""Why is a number so, and what if? The stepper's page beside lesson 19's `credit`, and beside other agents."""

import numpy as np
import pytest
from in_node import on_its_page

import rlrobot_edu as rl
from rlrobot_course.lesson_19.credit import credit as credit_in
from rlrobot_course.lesson_22.vbiassr import VBIASSR
from rlrobot_edu.learning.algorithm import Algorithm, Selection
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.widgets.stepper.symbols import SYMBOLS

METHODS = [("TOSL+QBIASSR", {}), ("SL+SR", {}), ("SL+SR", {"accumulating": True, "alpha": 0.1}), ("SARSA+SR", {}),
           ("TOSL+SR", {"traces": "full", "alpha": 0.6}), ("ESARSA+EG", {"epsilon": 0.3}), ("Q+SR", {})]  # fmt: skip
SHARES = (
    "(t, s, a) => ((ledger) => ledger.shares(ledger.value(t, s, a)))"
    "(new Ledger(stepper.about, stepper.tape).grow())"
)


def stepper_of(
    method="TOSL+SR", task="worked_example", at=120, keep=2000, **settings
) -> rl.Stepper:
    agent = rl.Agent(task, method, seed=1, **settings)
    return rl.Stepper(agent, rl.make_env(task, seed=1), at=at, keep=keep)


@pytest.mark.parametrize(("method", "settings"), METHODS)
def test_the_page_tells_the_same_shares_as_the_library(method, settings):
    stepper = stepper_of(method, **settings)
    n_states, n_actions = stepper._tape.q.shape
    pairs = f"[...Array({n_states * n_actions}).keys()]"
    every = f"{pairs}.map((at) => shares(120, Math.floor(at / {n_actions}), at % {n_actions}))"
    told = on_its_page(stepper, f"((shares) => {every})({SHARES})")
    agent = rl.Agent("worked_example", method, seed=1, **settings)
    credit = credit_in(agent, rl.make_env("worked_example", seed=1), 120)
    shares = [credit.shares(s, a) for s, a in np.ndindex(n_states, n_actions)]
    np.testing.assert_allclose(told, shares, atol=1e-12)
    paid = on_its_page(
        stepper, "new Ledger(stepper.about, stepper.tape).grow().paidBy(55, 120)"
    )
    paid_by_55 = np.reshape(shares, (n_states, n_actions, -1))[..., 54]
    np.testing.assert_allclose(paid, paid_by_55, atol=1e-12)


def test_at_any_step_also_of_a_tape_that_has_dropped_some_the_shares_are_the_librarys():
    stepper = stepper_of(at=300, keep=100)
    for t in (201, 250, 300):
        stepper.jump(t)
        rows = (
            f"stepper.tape.q.map((row, s) => [...row].map((_, a) => shares({t}, s, a)))"
        )
        told = np.array(on_its_page(stepper, f"((shares) => {rows})({SHARES})"))
        credit = credit_in(
            rl.Agent("worked_example", "TOSL+SR", seed=1),
            rl.make_env("worked_example", seed=1),
            t,
        )
        for s, a in np.ndindex(*credit.q.shape):
            np.testing.assert_allclose(
                told[s, a, : t - 200], credit.shares(s, a)[200:], atol=1e-12
            )
        assert not told[..., t - 200 :].any()


def test_the_answer_names_the_steps_that_made_the_difference():
    agent = rl.Agent("worked_example", "TOSL+SR", seed=0)
    stepper = rl.Stepper(agent, rl.make_env("worked_example", seed=0), at=200)
    told = on_its_page(
        stepper, "paidHtml(stepper.about, stepper.tape, { s: 13, a: 1, rather: 0 })"
    )
    credit = credit_in(
        rl.Agent("worked_example", "TOSL+SR", seed=0),
        rl.make_env("worked_example", seed=0),
        200,
    )
    shares = credit.shares(13, 1) - credit.shares(13, 0)
    first, second, third = np.argsort(-abs(shares))[:3]
    its = credit.steps[first]
    assert f"= {shares.sum():.2f}.</b>" in told
    assert f"in s = {its.s} for r = {its.r:g}: <b>+{shares[first]:.2f}</b>" in told
    most = [
        told.index(f'<button name="{k + 1}"') for k in (first, second, third)
    ]  # entry 0 is step 1
    assert most == sorted(most) and f"What step {first + 1} has paid" in told
    lit = on_its_page(
        stepper,
        "(paidHtml(stepper.about, stepper.tape, { s: 13, a: 1 }), views(stepper.tape))",
    )
    assert 3 <= lit.count('class="lit"') <= 12


def test_settings_that_were_changed_while_it_learned_are_noticed():
    stepper = stepper_of(at=50)
    stepper._tape.agent.change(alpha=0.9)
    stepper.forward(50)
    asked = "return paidHtml(stepper.about, stepper.tape, { s: 0, a: 0 });"
    tried = f"{{ try {{ {asked} }} catch (error) {{ return error.message; }} }}"
    assert "From step 51 on the payments are unknown" in on_its_page(
        stepper, f"(() => {tried})()"
    )


def test_of_what_may_be_no_sum_of_rewards_no_answer_is_given_and_the_reason_is_told():
    def squared(m, s, a, r, s_next, a_next, terminated):
        m.q[s, a] += m.parameters.alpha * (r * r - m.q[s, a])
        return 0.0

    agent = rl.Agent(
        "worked_example", Method(Algorithm("SQUARED", squared), "SR"), seed=0
    )
    stepper = rl.Stepper(agent, rl.make_env("worked_example", seed=0), at=5)
    assert "of SQUARED this is not known" in on_its_page(stepper, "updates.reason")
    planner = rl.Stepper(
        rl.Agent("worked_example", "Q+EG", planner="dyna", seed=0),
        rl.make_env("worked_example"),
    )
    assert "an agent that plans learns from imagined steps" in on_its_page(
        planner, "updates.reason"
    )


def relived(stepper: rl.Stepper, settings="{}", fork="{}") -> list[dict]:
    """The frames of another life of as many steps."""
    frames = "(relived) => stepper.recorded.frames.map(() => relived.step())"
    return on_its_page(
        stepper,
        f"({frames})(new Replay(stepper.about, replayData, {settings}, {fork}))",
    )


@pytest.mark.parametrize("method", ["TOSL+QBIASSR", "SL+SR", "Q+EG", "ESARSA+SR"])
def test_a_fork_that_changes_nothing_is_the_same_life_to_the_last_bit(method):
    stepper = stepper_of(method)
    one = relived(stepper)
    for fork in (
        "{ from: 60 }",
        f"{{ from: 60, reward: {one[59]['r']} }}",
        "{ from: 60, method: 0 }",
    ):
        assert relived(stepper, fork=fork) == one


@pytest.mark.parametrize("method", ["TOSL+SR", "SL+QBIASSR", "Q+SR"])
def test_other_settings_from_a_step_on_are_what_the_library_learns_with_them(method):
    stepper = stepper_of(method)
    agent = rl.Agent("worked_example", method, seed=1)
    for step in rl.steps(agent, rl.make_env("worked_example", seed=1), 120):
        if step.t == 58:
            agent.change(alpha=0.6, temperature=7.0)
    lived = (
        "(relived) => (stepper.recorded.frames.forEach(() => relived.step()), "
        "relived.simulation.m.q.map((row) => [...row]))"
    )
    other = "new Replay(stepper.about, replayData, { alpha: 0.6, temperature: 7 }, { from: 60 })"
    assert np.array_equal(on_its_page(stepper, f"({lived})({other})"), agent.q)


def test_another_reward_is_paid_once_and_changes_nothing_before_it():
    stepper = stepper_of("SARSA+SR")
    was, other = relived(stepper), relived(stepper, fork="{ from: 60, reward: 100 }")
    assert was[:59] == other[:59] and other[59]["r"] == 100 != was[59]["r"]
    assert (other[59]["s"], other[59]["a"]) == (was[59]["s"], was[59]["a"])
    assert other[59]["delta"] - was[59]["delta"] == pytest.approx(100 - was[59]["r"])


@pytest.mark.parametrize("begins", [False, True])
def test_luck_for_an_action_makes_the_agent_choose_it_and_the_update_before_learns_from_it(
    begins,
):
    stepper = stepper_of("SARSA+SR")
    k = 61 if begins else 60  # an episode has 30 steps
    was = relived(stepper)
    action = (was[k - 1]["a"] + 1) % stepper._tape.q.shape[1]
    fork = f"{{ from: {k}, luck: luckFor(stepper.recorded.at({k}).p, {action}), begins: {str(begins).lower()} }}"
    other = relived(stepper, fork=fork)
    assert other[k - 1]["a"] == action and other[k - 1]["s"] == was[k - 1]["s"]
    if begins:
        assert other[: k - 1] == was[: k - 1]
    else:
        assert other[: k - 2] == was[: k - 2] and other[k - 2]["a2"] == action


@pytest.mark.parametrize("name", ["Q", "SARSA", "TOSL"])
def test_another_method_goes_on_from_the_same_table(name):
    stepper = stepper_of("SL+SR")
    names = on_its_page(
        stepper, "stepper.about.methods.map(({ algorithm }) => algorithm)"
    )
    assert names[0] == "SL" and sorted(names) == sorted(SYMBOLS)
    was, other = (
        relived(stepper),
        relived(stepper, fork=f"{{ from: 60, method: {names.index(name)} }}"),
    )
    step, before, after = (
        other[59],
        stepper_of("SL+SR", at=59)._tape,
        rl.Agent("worked_example", f"{name}+SR", seed=1),
    )
    assert other[:59] == was[:59] and step["method"] == names.index(name)
    after.memory.q[:], after.memory.e[:] = before.agent.q, before.agent.e
    after.memory.register[:], after.memory.now.register_size = (
        before.agent.memory.register,
        before.agent.memory.now.register_size,
    )
    after.memory.now.q_old = before.q[step["s"], step["a"]]
    after.update(
        step["s"], step["a"], step["r"], step["s2"], step["a2"], step["terminated"]
    )
    learned = before.q.copy()
    learned.flat[step["q"][0]] = step["q"][1]
    np.testing.assert_array_equal(after.q, learned)
    shown = "(tape, life) => (tape.add(stepper.recorded.frames.map(() => life.step())), tape.go(60), views(tape))"
    life = f"new Replay(stepper.about, replayData, {{}}, {{ from: 60, method: {names.index(name)} }})"
    panes = on_its_page(
        stepper, f"({shown})(stepper.newTape(replayData.start), {life})"
    )
    assert ("(1 − α)" in panes) == (name == "TOSL")


def weights_of(
    selection: str, task: rl.Task, visits: np.ndarray, s: int, a: int
) -> np.ndarray:
    """By how much Q(k, a) of each state k counts in the bias of action a in state s, from the sets themselves."""
    weights = np.zeros(task.states.n)
    for states in task.states.siblings(s).values():
        weights[list(states)] += (
            visits[list(states), a] if selection == "VBIASSR" else 1.0
        ) / len(states)
    total = weights.sum() if selection == "VBIASSR" else len(task.states.shape)
    return weights / total if total else weights


@pytest.mark.parametrize(
    "method",
    ["TOSL+QBIASSR", "Q+QBIASSR", rl.Method("SARSA", VBIASSR), rl.Method("Q", VBIASSR)],
)
def test_a_bias_is_told_state_by_state(method):
    task, at = rl.load_task("worked_example"), 119
    agent, q, visits = rl.Agent(task, method, seed=1), [], []
    for step in rl.steps(agent, rl.make_env(task, seed=1), at + 1):  # noqa: B007 (the last one is meant)
        q.append(agent.q.copy())
        visits.append(agent.visits.copy())
    name = method if isinstance(method, str) else method.name
    chosen_by = (
        at if name.startswith("Q+") else at - 1
    )  # the others choose a' before they learn
    values, x = (
        q[chosen_by - 1],
        q[chosen_by - 1][step.s] * agent.parameters.q_scale / step.temperature,
    )
    by_q_alone = np.exp(x - x.max()) / np.exp(x - x.max()).sum()
    then = f"q: tape.copyAt({chosen_by}).q, visits: tape.copyAt({at}).visits"
    always = "shape: about.names.shape, parameters: about.parameters"
    advice = f"[0, 1, 2].map((a) => advice({{ ...tape.frame, {then}, {always} }}, {step.s}, a))"
    found = on_its_page(
        stepper_of(method, at=at + 1), f"(({{ tape, about }}) => {advice})(stepper)"
    )
    for a, one in enumerate(found):
        weights = weights_of(name.partition("+")[2], task, visits[at - 1], step.s, a)
        told = np.zeros(task.states.n)
        for k, value, share in one["said"]:
            assert value == values[k, a]
            told[k] = share
        np.testing.assert_allclose(told, weights * values[:, a], atol=1e-12)
        assert one["sum"] == pytest.approx(step.bias[a], abs=1e-9)
        np.testing.assert_allclose(one["alone"], by_q_alone, atol=1e-12)


def test_the_answer_tells_whose_advice_it_was_and_what_it_changed():
    every = (
        "[...Array(121).keys()].map((t) => (tape.go(t), adviceHtml(about, tape, null)))"
    )
    told = on_its_page(
        stepper_of("TOSL+QBIASSR"), f"(({{ tape, about }}) => {every})(stepper)"
    )
    assert "nothing has been chosen" in told[0]
    assert all("by Q alone it would have been" in one for one in told[1:])
    assert any("the state itself" in one for one in told) and any(
        ">Y = 0<" in one for one in told
    )
    assert on_its_page(stepper_of("TOSL+SR"), "choice") is None


@pytest.mark.parametrize("method", ["Q+QBIASSR", rl.Method("TOSL", VBIASSR)])
def test_the_advice_of_every_step_is_told_also_where_steps_were_dropped(method):
    stepper = stepper_of(method, at=300, keep=100)
    every = "[...Array(99).keys()].map((i) => (tape.go(202 + i), adviceHtml(about, tape, null)))"
    told = on_its_page(stepper, f"(({{ tape, about }}) => {every})(stepper)")
    assert all("by Q alone it would have been" in one for one in told)


def untranslatable(m, s):
    """As numba understands it; JavaScript has no sum of an array."""
    m.probabilities[:] = 1.0 / m.q.shape[1] + 0.0 * m.visits[s].sum()


def test_a_selection_that_no_page_can_run_is_shown_and_its_page_says_why_nothing_can_be_tried():
    method = Method("TOSL", Selection("MINE", untranslatable))
    stepper = stepper_of(method, at=20)
    reason, panes = on_its_page(
        stepper, "[replayData.reason, viewHtml(stepper.about, stepper.tape)]"
    )
    line = untranslatable.__code__.co_firstlineno + 2
    assert (
        f"test_stepper_why.py:{line}: “m.visits[s].sum()” has no translation" in reason
    )
    assert "The update with this step’s numbers" in panes
    assert on_its_page(stepper, "Object.keys(updates.kernels).length") == len(SYMBOLS)
