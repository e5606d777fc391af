"""A step in words: for a beginner, and with the symbols of its update. panes.js says the same on the page."""

from __future__ import annotations

from rlrobot_edu.widgets.stepper.names import Names
from rlrobot_edu.widgets.stepper.numerals import given, told_apart
from rlrobot_edu.widgets.stepper.symbols import in_symbols
from rlrobot_edu.widgets.stepper.tape import Frame, Tape


def simply(tape: Tape, names: Names) -> str:
    """What the robot did, what that paid, and whether it now thinks better of it."""
    frame = tape.frame
    if frame is None:
        return "Before the first step"
    step = frame.step
    paid = "brought nothing"
    if step.r:
        paid = f"earned {given(step.r)}" if step.r > 0 else f"cost {given(-step.r)}"
    bump = " and bumped" if _has_bumped(tape, frame) else ""
    did = f"{names.told(step.a)}{bump}. That {paid}"
    what = f"{names.quoted(step.a)} here"
    change = frame.q_sa_new - frame.q_sa
    if not change:
        return f"{did}. It thinks of {what} as before."
    joined = "yet" if step.r * change < 0 else "and"
    thinks = "better" if change > 0 else "worse"
    was, now = told_apart(frame.q_sa, frame.q_sa_new)
    return f"{did}, {joined} it now thinks {thinks} of {what}: {was} → {now}."


def _has_bumped(tape: Tape, frame: Frame) -> bool:
    """Whether a robot that drives has lost much in this step."""
    seen = tape.view.look_data(frame.look)
    if seen is None or seen["place"] is None:
        return False
    loss = tape.view.constant_data()["loss"]
    return loss is not None and frame.step.r <= loss


def sentence(tape: Tape, names: Names) -> str:
    """The step in one sentence, with a′ if the update of this algorithm learns from it."""
    frame = tape.frame
    if frame is None:
        return "Before the first step."
    step = frame.step
    text = (
        f"Step {step.t + 1} (episode {frame.episode}, its step {frame.number}): in state s = {step.s} the agent took "
        f"action a = {_named(step.a, names)} and got r = {given(step.r)}; now it is in s′ = {step.s_next}"
    )
    if step.terminated:
        return f"{text}, where the episode ends."
    if step.truncated:
        return f"{text}; the time of this episode is up."
    agent = tape.agent
    symbols = in_symbols(agent.method.algorithm.name, agent.parameters)
    if "{Q(s′, a′)}" in "".join(symbols.equation):
        text += f", where it will take a′ = {_named(step.a_next, names)}"
    return f"{text}."


def _named(a: int, names: Names) -> str:
    name = names.action(a)
    return name if name == str(a) else f"{a} ({name})"
