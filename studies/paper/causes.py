"""Why ours differs from the paper's: each cause with the experiment that shows it, or does not.

Every sentence here is chosen by the outcomes. A cause is *shown* only where the experiment shows it.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Mapping

from paper import paper, verdicts
from paper.cause import (
    DECIDES,
    NO_MATTER,
    NOT_RUN,
    NOT_SHOWN,
    NOTHING,
    SHOWN,
    Cause,
    Outcomes,
    cured,
    mean_words,
    of_pairs,
    opposites,
    p_words,
    paired,
    signed,
)
from paper.causes_in_models import fault, gamma, lucky_rows, model_only
from paper.experiments import ARMS, CUT, EVADED, HELD, LENGTHS, Length
from paper.outcome import NEAR, Outcome, shuttles, significant_with
from paper.verdicts import AGREES, DIRECTION, UNDECIDED
from rlrobot_edu.experiments.tables import Table


def causes(outcomes: Outcomes, figures: Mapping[str, str]) -> list[Cause]:
    """All causes, in the order of the report. A cause whose experiments were not run says so."""
    made = []
    for title, needs, make in (
        ("Wander-simple: the length", ("robot_wander_simple",), _wander_simple),
        *((f"{task}: walls that hold the robot", (f"robot_{task}", f"cause_walls_{task}"), _walls) for task in HELD),
        (
            "The algorithms: walls that hold the robot",
            ("preliminary_algorithms_robot", "cause_walls_algorithms"),
            _walls,
        ),
        ("Navigation: the number of episodes", ("robot_navigation_1k",), _navigation),
        ("Few repetitions in the paper", ("robot_wander_1k",), _few),
        ("Q-learning on the model: a fault of the paper's program", ("cause_fault",), fault),
        (
            "Q-learning on the model: lucky rows",
            ("preliminary_algorithms", *(f"cause_loops_{unseen}" for unseen in CUT)),
            lucky_rows,
        ),
        ("γ: it sets the temperature, too", ("preliminary_gamma", "preliminary_gamma_alone"), gamma),
        ("T: the model, not the robot", ("preliminary_temperature", "preliminary_temperature_robot"), model_only),
        ("α: the model, not the robot", ("preliminary_alpha", "preliminary_alpha_robot"), model_only),
        ("The arms: to and fro pays", _by_kind(ARMS, "robot", "cause_contact"), _to_and_fro),
        ("The arms: long traces", _by_kind(ARMS, "robot", "cause_traces"), _long_traces),
        ("A choice of ours: loop evasion in SR, too", _by_kind(EVADED, "robot", "cause_evasion"), _evasion),
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
    said = of_pairs(outcome, length)
    return {name: word for name, word in said.items() if word.name not in (AGREES, UNDECIDED)}


def _told(said: Mapping[str, verdicts.Verdict]) -> str:
    return "; ".join(f"{name}: {word}" for name, word in said.items())


def _walls(outcomes: Outcomes, figures, key: str, held_key: str):
    """Whether the methods come into the paper's order when walls hold the robot, as they do in V-REP."""
    ideal, held = outcomes[key], outcomes[held_key]
    length = ideal.longest
    status, explains = cured((key, ideal, held))
    body = f"{mean_words(ideal.means())} With `Realism.vrep()`: {mean_words(held.means())}"
    before, after = _told(of_pairs(ideal, length)), _told(of_pairs(held, length))
    said = f"On the ideal robot: {before}. With V-REP's wall friction and lag, `Realism.vrep()`: {after}."
    alone = [f"cause_{name}_{ideal.experiment.task}" for name in ("friction", "lag")]
    if key.startswith("robot_") and all(name in outcomes for name in alone):
        (friction, p), (lag, p_lag) = (outcomes[name].pair("TOSL+SR", "Q+SR") for name in alone)
        said += (
            f" With the friction alone TOSL+SR less Q+SR is {signed(friction)} ({p_words(p)}), "
            f"with the lag alone {signed(lag)} ({p_words(p_lag)})."
        )
    return status, said, body, explains


def _navigation(outcomes: Outcomes, figures, key: str):
    """Whether the methods come into the paper's order with more episodes; its test of three agents finds nothing."""
    outcome, (one, _, five, _) = outcomes[key], LENGTHS["navigation_1k"]
    gains = {n: {its.name: verdicts.gain(pair, its) for pair, its in paired(outcome, n)} for n in (one, five)}
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
            for pair, its in paired(outcome, length):
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


def _to_and_fro(outcomes: Outcomes, figures, *needs: str):
    """Whether the paper's order comes back where to and fro before the object pays nothing."""
    body = [
        "The reward for the way to the object has a local optimum: away and nearer again pays (−1 + 5) / 2 = 2 a step, "
        "away from contact and back (−1 + 10) / 2 = 4.5. Loop evasion does not help, for the mean reward is positive. "
        f"Share of agents whose final average lies within {NEAR} of 2.0 or 4.5: {_at_shuttles(outcomes, needs[::2])}.",
        *(figures[name] for name in ("shuttle", "stuck") if name in figures),
        f"With a reward for contact alone: {_means(outcomes, needs[1::2])} "
        "The paper's text names the reward for the way, so this is an ablation and not our reward.",
    ]
    return _changed_arms(outcomes, needs, "With a reward for contact alone", "\n\n".join(body))


def _long_traces(outcomes: Outcomes, figures, *needs: str):
    """Whether the paper's order comes back where its methods have no traces, as Q-learning has none."""
    changed = needs[1::2]
    body = (
        "With long traces each reward is passed back to the same few actions as often as the loop comes round. Without "
        f"them (λ = 0), share of agents at a shuttle: {_at_shuttles(outcomes, changed)}. {_means(outcomes, changed)} "
        "The queue of loop evasion is as long as a trace, so it is shorter here, too, and Q+SR's arms are other ones."
    )
    return _changed_arms(outcomes, needs, "Without traces", body)


def _changed_arms(outcomes: Outcomes, needs: tuple[str, ...], change: str, body: str):
    """What a change does to the pairs that are opposite to the paper's, by arm and length."""
    arms = [(key, outcomes[key], outcomes[changed]) for key, changed in zip(needs[::2], needs[1::2], strict=True)]
    status, explains = cured(*arms)
    after = []
    for _, arm, changed in arms:
        for length in arm.final:
            if bad := opposites(arm, length):
                said = of_pairs(changed, length)
                words = _told({name: said[name] for name in bad})
                after.append(f"{arm.experiment.task} after {length}: {words}")
    if not after:
        return NOTHING, "No pair of an arm is opposite to the paper's.", body
    bad = [(changed, n, name) for _, arm, changed in arms for n in arm.final for name in opposites(arm, n)]
    signs = [name for changed, n, name in bad if not of_pairs(changed, n)[name].is_opposite]
    said = f"{change}, of the {len(bad)} pairs that are opposite to the paper's, {len(signs)} turn round"
    return status, f"{said}, {len(explains)} of them significantly: {'. '.join(after)}.", body, explains


def _by_kind(tasks: Iterable[str], *kinds: str) -> tuple[str, ...]:
    return tuple(f"{kind}_{task}" for task in tasks for kind in kinds)


def _evasion(outcomes: Outcomes, figures, *needs: str):
    """Which verdicts are others when SR has no loop evasion, as in the paper's program."""
    other, same, rows = [], Counter(), []
    for key, changed in zip(needs[::2], needs[1::2], strict=True):
        ours, its = outcomes[key], outcomes[changed]
        for length in ours.final:
            where, after = f"{ours.experiment.task} after {length}", of_pairs(its, length)
            for name, word in of_pairs(ours, length).items():
                if after[name].name == word.name:
                    same[ours.experiment.task] += 1
                else:
                    other.append(f"{where}: {name}: {after[name]}, with ours {word}")
            rows += [[where, rule, *o.means(length).values()] for rule, o in (("ours", ours), ("its", its))]
    said = (
        "The paper's algorithm 3 sets the temperature before every softmax selection; so does ours, in SR as in "
        "QBIASSR. Its program does so in QBIASSR alone. "
    )
    kept = ", ".join(f"{n} in {task}" for task, n in same.items())
    said += f"By that rule these verdicts are others: {'; '.join(other)}. " if other else ""
    table = Table("Mean final average rewards by either rule", ["task", "rule", *paper.THREE], rows).markdown
    return (DECIDES if other else NO_MATTER), f"{said}The same are: {kept or 'none'}.", table


def _at_shuttles(outcomes: Outcomes, keys: Iterable[str]) -> str:
    return _by_task(outcomes, keys, lambda o: {x: f"{shuttles(final):.0%}" for x, final in o.final[o.longest].items()})


def _means(outcomes: Outcomes, keys: Iterable[str]) -> str:
    means = _by_task(outcomes, keys, lambda o: {x: f"{mean:.2f}" for x, mean in o.means().items()})
    return f"Mean final average rewards: {means}."


def _by_task(outcomes: Outcomes, keys: Iterable[str], values: Callable[[Outcome], dict[str, str]]) -> str:
    found = ((outcomes[key].experiment.task, values(outcomes[key])) for key in keys)
    return "; ".join(f"{task}: " + ", ".join(map(" ".join, by.items())) for task, by in found)
