"""Why ours differs from the paper's: each cause with the experiment that shows it, or does not.

Every sentence here is chosen by the outcomes. A cause is *shown* only where the experiment shows it.
"""

from collections.abc import Mapping

from rlrobot_edu.experiments.statistics import Pair
from rlrobot_edu.experiments.tables import Table
from rlrobot_edu.reproduction import paper, verdicts
from rlrobot_edu.reproduction.cause import (
    NOT_RUN,
    NOT_SHOWN,
    NOTHING,
    SHOWN,
    Cause,
    Outcomes,
    mean_words,
    opposites,
    signed,
)
from rlrobot_edu.reproduction.causes_in_models import fault, gamma, lucky_rows, model_only
from rlrobot_edu.reproduction.experiments import HELD, LENGTHS, Length
from rlrobot_edu.reproduction.outcome import NEAR, Outcome, shuttles, significant_with
from rlrobot_edu.reproduction.verdicts import AGREES, DIRECTION, UNDECIDED


def causes(outcomes: Outcomes, figures: Mapping[str, str]) -> list[Cause]:
    """All causes, in the order of the report. A cause whose experiments were not run says so."""
    made = []
    for title, needs, make in (
        ("Wander-simple: the length", ("robot_wander_simple",), _wander_simple),
        *((f"{task}: walls that hold the robot", (f"robot_{task}", f"cause_walls_{task}"), _walls) for task in HELD),
        ("Navigation: the number of episodes", ("robot_navigation_1k",), _navigation),
        ("Few repetitions in the paper", ("robot_wander_1k",), _few),
        ("Q-learning on the model: a fault of the paper's program", ("cause_fault",), fault),
        ("Q-learning on the model: lucky rows", ("preliminary_algorithms", "cause_loops"), lucky_rows),
        ("γ: it sets the temperature, too", ("preliminary_gamma", "preliminary_gamma_alone"), gamma),
        ("T: the model, not the robot", ("preliminary_temperature", "preliminary_temperature_robot"), model_only),
        ("α: the model, not the robot", ("preliminary_alpha", "preliminary_alpha_robot"), model_only),
        ("The arm: to and fro pays", ("robot_arm_1k", "cause_contact"), _arm),
    ):
        if all(key in outcomes for key in needs):
            made.append(Cause(title, *make(outcomes, figures, *needs)))
        else:
            made.append(Cause(title, NOT_RUN, ""))
    return made


def _wander_simple(outcomes: Outcomes, figures, key: str):
    """Whether what differs from the paper's after a short process does not after a long one."""
    outcome, (short, long) = outcomes[key], LENGTHS["wander_simple"]
    before, after = _unlike(outcome, short), _unlike(outcome, long)
    if not before:
        return NOTHING, f"After {short} every pair agrees with the paper's, or is undecided."
    said = f"After {short}: {_told(before)}."
    if after:
        return NOT_SHOWN, f"{said} After {long} still: {_told(after)}."
    places = frozenset((key, short, name) for name in opposites(outcome, short))
    words = f"{said} After {long} every pair agrees, or is undecided. The paper does not say how long it is."
    return SHOWN, words, "", places


def _unlike(outcome: Outcome, length: Length) -> dict[str, verdicts.Verdict]:
    """The pairs that neither agree with the paper's nor are undecided, and their verdicts."""
    said = _verdicts(outcome, length)
    return {name: word for name, word in said.items() if word.name not in (AGREES, UNDECIDED)}


def _verdicts(outcome: Outcome, length: Length) -> dict[str, verdicts.Verdict]:
    """What is said of each pair that the paper tests."""
    return {its.name: verdicts.of_pair(pair, its) for pair, its in _both(outcome, length)}


def _both(outcome: Outcome, length: Length) -> list[tuple[Pair, paper.PaperPair]]:
    """Our pairs and the paper's."""
    both = ((pair, verdicts.papers(pair, outcome.experiment.pairs)) for pair in outcome.pairs[length])
    return [(pair, its) for pair, its in both if its]


def _told(said: Mapping[str, verdicts.Verdict]) -> str:
    return "; ".join(f"{name}: {word}" for name, word in said.items())


def _walls(outcomes: Outcomes, figures, key: str, held_key: str):
    """Whether the methods come into the paper's order when walls hold the robot, as they do in V-REP."""
    ideal, held = outcomes[key], outcomes[held_key]
    length = ideal.longest
    before, after = _verdicts(ideal, length), _verdicts(held, length)
    body = f"{mean_words(ideal.means())} With `Realism.vrep()`: {mean_words(held.means())}"
    said = f"On the ideal robot: {_told(before)}. With V-REP's wall friction and lag, `Realism.vrep()`: {_told(after)}."
    bad = opposites(ideal, length)
    if not bad:
        return NOTHING, said, body
    cured = {name for name in bad if after[name].name in (AGREES, DIRECTION)}
    return (SHOWN if cured == set(bad) else NOT_SHOWN), said, body, frozenset((key, length, name) for name in cured)


def _navigation(outcomes: Outcomes, figures, key: str):
    """Whether the methods come into the paper's order with more episodes; its test of three agents finds nothing."""
    outcome, (one, _, five, _) = outcomes[key], LENGTHS["navigation_1k"]
    gains = {n: {its.name: verdicts.gain(pair, its) for pair, its in _both(outcome, n)} for n in (one, five)}
    words = [f"after {n} " + ", ".join(f"{name} {signed(x)}" for name, x in gains[n].items()) for n in gains]
    theirs = ", ".join(
        f"{its.name} {signed(paper.difference('navigation_1k', its))}" for its in outcome.experiment.pairs
    )
    said = f"Differences: {words[0]}; {words[1]}; in the paper {theirs}. The paper scores the last of several episodes."
    in_order = [all(x > 0 for x in gains[n].values()) for n in (one, five)]
    if in_order[0]:
        return NOTHING, said
    if not in_order[1]:
        return NOT_SHOWN, said
    return SHOWN, said, "", frozenset((key, one, name) for name in opposites(outcome, one))


def _few(outcomes: Outcomes, figures, *needs: str):
    """How often our own test would miss what only it finds, had it the paper's few repetitions."""
    rows, missed = [], []
    for key, outcome in outcomes.items():
        task = outcome.experiment.task
        if not key.startswith("robot_") or not outcome.experiment.pairs:
            continue
        n = paper.repetitions(task)
        for length, groups in outcome.final.items():
            if n >= min(map(len, groups.values())):
                continue
            shares = significant_with(groups, n)
            for pair, its in _both(outcome, length):
                said = verdicts.of_pair(pair, its)
                if said.name == DIRECTION and pair.p < verdicts.LEVEL:
                    share = shares[frozenset(pair[:2])]
                    missed.append(share < 0.5)
                    rows.append([f"{task}, {length}", its.name, n, f"{share:.0%}"])
    if not rows:
        return NOTHING, "No pair is significant only here in a task which the paper repeated less often."
    table = Table(
        "Pairs that are significant only here: in how many draws of the paper's number of our repetitions they are",
        ["task", "pair", "paper's repetitions", "significant in"], rows,
    ).markdown  # fmt: skip
    words = f"Of {len(rows)} pairs that are significant only here, the test misses {sum(missed)} in most draws"
    return (SHOWN if all(missed) else NOT_SHOWN), f"{words} of as few repetitions as the paper has.", table


def _arm(outcomes: Outcomes, figures, key: str, contact_key: str):
    arm, contact = outcomes[key], outcomes[contact_key]
    shares = {o.experiment.task: {label: shuttles(x) for label, x in o.final[o.longest].items()}
              for name, o in outcomes.items() if name.startswith("robot_arm")}  # fmt: skip
    counted = "; ".join(f"{task}: " + ", ".join(f"{x} {s:.0%}" for x, s in by.items()) for task, by in shares.items())
    body = [
        "The reward for the way to the object has a local optimum: away and nearer again pays (−1 + 5) / 2 = 2 a step, "
        "away from contact and back (−1 + 10) / 2 = 4.5. Loop evasion does not help, for the mean reward is positive. "
        f"Share of agents whose final average lies within {NEAR} of 2.0 or 4.5: {counted}.",
        *(figures[name] for name in ("shuttle", "stuck") if name in figures),
        f"With a reward for contact alone ({contact.experiment.task}, {contact.longest}): "
        f"{mean_words(contact.means())} "
        "The paper's text names the reward for the way, so this is an ablation and not our reward.",
    ]
    there = {length: opposites(arm, length) for length in arm.final}
    if not any(there.values()):
        return NOTHING, "No pair of arm_1k is opposite to the paper's.", "\n\n".join(body)
    cured = frozenset((key, n, name) for n, bad in there.items() for name in bad if name not in opposites(contact, n))
    named = {its: pair for pair, its in _both(contact, contact.longest)}
    words = "; ".join(f"{its.name}: {verdicts.of_pair(pair, its)}" for its, pair in named.items())
    said = f"With a reward for contact alone, after {contact.longest}: {words}."
    back = [verdicts.of_pair(pair, its).name for its, pair in named.items() if its.p < verdicts.LEVEL]
    if all(name == AGREES for name in back):
        return SHOWN, said, "\n\n".join(body), cured
    return NOT_SHOWN, f"{said} So the reward for the way does not explain all of it.", "\n\n".join(body), frozenset()
