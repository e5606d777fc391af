"""Six updates of public programs that deviate from the textbook, and what the checks say of them.

``python studies/public_faults.py`` writes the table of docs/howto/mistakes.md. No line is copied: each function says in
our words what a program, or a question about one, was reported to do.
"""

from importlib import import_module
from pathlib import Path
from typing import NamedTuple

from made_blocks import filled

from rlrobot_edu.files import write_whole
from rlrobot_grading.answers.values import Function
from rlrobot_grading.exercises.verdict import Verdict

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs/howto/mistakes.md"
HEAD = "| what the public program does | where it was seen | lesson | what the check says |\n|---|---|---|---|\n"


def no_end(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * (r + gamma * max(q[s_next]) - q[s, a])


def no_end_blended(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] = (1 - alpha) * q[s, a] + alpha * (r + gamma * max(q[s_next]))


def delta_of_each_pair(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    target = r if terminated else r + gamma * q[s_next, a_next]
    e[s, a] = 1
    q += alpha * (target - q) * e
    e *= gamma * lam


def accumulating(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = (r if terminated else r + gamma * q[s_next, a_next]) - q[s, a]
    e[s, a] += 1
    q += alpha * delta * e
    e *= gamma * lam


def clearing(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = (r if terminated else r + gamma * q[s_next, a_next]) - q[s, a]
    e[s] = 0
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam


def dutch_alone(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    later = 0 if terminated else q[s_next, a_next]
    delta = r + gamma * later - q[s, a]
    e[s, a] = (1 - alpha) * e[s, a] + 1
    q += alpha * delta * e
    e *= gamma * lam
    return later


class Fault(NamedTuple):
    """A deviation. where: the program or the question about it, by name; check: lesson and exercise."""

    does: str
    where: str
    check: str
    answer: Function


FAULTS = [
    Fault(
        "Q-learning's target goes on after the end; harmless where the row of an end stays 0",
        "dennybritz/reinforcement-learning, and tutorials of Hugging Face and Gymnasium in one form",
        "03 update",
        no_end,
    ),
    Fault(
        "the same, as (1 − α)Q + α·target",
        "simple_rl, its Q-learning agent",
        "03 update",
        no_end_blended,
    ),
    Fault(
        "each pair with a trace has a TD error of its own",
        "REINFORCEjs, its learner with traces",
        "07 sarsa_lambda_update",
        delta_of_each_pair,
    ),
    Fault(
        "accumulating traces where replacing ones are said",
        "no single program: a frequent mix-up",
        "07 sarsa_lambda_update",
        accumulating,
    ),
    Fault(
        "the traces of the state's other actions are cleared",
        "BURLAP, issue 120",
        "07 sarsa_lambda_update",
        clearing,
    ),
    Fault(
        "a dutch trace in plain SARSA(λ)",
        "ShangtongZhang/reinforcement-learning-an-introduction, issue 94, a question",
        "08 true_online_update",
        dutch_alone,
    ),
]


def verdict(fault: Fault) -> Verdict:
    """What the check of its exercise says of a deviation."""
    lesson, exercise = fault.check.split()
    check = import_module(f"rlrobot_course.lesson_{lesson}.exercises").check
    return getattr(check, exercise).judge(fault.answer)


def table() -> str:
    """The table, in Markdown."""
    text = HEAD
    for fault in FAULTS:
        said = verdict(fault)
        text += f"| {fault.does} | {fault.where} | {fault.check} | {said.hint or 'names no cause'} |\n"
    return text


def written(page: str) -> str:
    """The page with the table in its place."""
    return filled(page, {"table": table().strip()})


if __name__ == "__main__":
    write_whole(PAGE, written(PAGE.read_text(encoding="utf-8")))
