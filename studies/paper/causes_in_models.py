"""Causes that lie in sample models and in parameters: why the preliminary tests differ from the paper's."""

import numpy as np

from paper import paper, verdicts
from paper.cause import (
    NOT_SHOWN,
    NOTHING,
    SHOWN,
    Outcomes,
    mean_words,
    of_value,
    p_words,
    signed,
    value_words,
)
from paper.experiments import CUT, FAULTY, RECORDINGS
from paper.outcome import Outcome, interval
from paper.verdicts import BEATEN
from rlrobot_edu.experiments.tables import Table

TOSL_OVER_Q = paper.PaperPair("TOSL+SR", "Q+SR").name


def fault(outcomes: Outcomes, figures, key: str):
    outcome = outcomes[key]
    means, (before, p), (after, p_after) = (
        outcome.means(), outcome.pair("TOSL+SR", "Q+SR"), outcome.pair("TOSL+SR", FAULTY)
    )  # fmt: skip
    body = (
        "The program drew s′ with the action of the step before, and looked its reward up in its table R(s, a, s′) "
        "with the new one. Here Q-learning is run in a world that answers like that (worlds.py, `PreviousAction`).\n\n"
        f"{mean_words(means)}"
    )
    said = (
        f"On the model TOSL+SR less Q+SR is {signed(before)} ({p_words(p)}); with the fault of the paper's program in "
        f"Q-learning it is {signed(after)} ({p_words(p_after)})"
    )
    if before > 0:
        return NOTHING, f"{said}: the order is the paper's without the fault.", body
    if after > 0 and p_after < verdicts.LEVEL:
        places = frozenset([("preliminary_algorithms", outcomes[key].longest, TOSL_OVER_Q)])
        return SHOWN, f"{said}, the paper's order.", body, places
    return NOT_SHOWN, f"{said}: the fault alone does not bring the paper's order back.", body


def lucky_rows(outcomes: Outcomes, figures, full_key: str, *cut_keys: str):
    """Whether the order is another without the lucky rows, whatever unknown pairs do.

    One such model does not suffice: where hardly anything is left to be earned, no method can be seen to earn more.
    """
    full, cuts = outcomes[full_key], dict(zip(CUT, (outcomes[key] for key in cut_keys), strict=True))
    before, p = full.pair("TOSL+SR", "Q+SR")
    about = full.diagnosis
    loops, dozen = (
        ", ".join(f"{label} {np.sort(full.lucky[label])[::-1][:most].sum():.0%}" for label in ("TOSL+SR", "Q+SR"))
        for most in (None, 12)
    )
    body = (
        f"In the model, {about.pairs_seen_once / about.pairs_seen:.0%} of the pairs that were seen were seen only once "
        f"({paper.SEEN_ONCE_IN_VREP:.0%} in the authors' recording), and `diagnose()` finds {len(about.loops)} "
        f"well-rewarded loops that rest on at most three samples. Share of all steps that are spent in them: {loops}; "
        f"in the dozen that are visited most: {dozen}. "
        "With these pairs taken out they do what every unknown pair does, which is one of three things (`unseen`)."
    )
    rows = [["with them", *_order(full)], *([f"without, unknown: {unseen}", *_order(o)] for unseen, o in cuts.items())]
    columns = ["TOSL+SR", "Q+SR", "TOSL+SR less Q+SR", "p"]
    body += "\n\n" + Table("The model with its lucky rows and without", ["model", *columns], rows).markdown
    again = [outcomes[key] for seed in RECORDINGS if (key := f"cause_recording_{seed}") in outcomes]
    if again:
        rows = [["the toolkit's", *_order(full)], *([str(o.experiment.seed), *_order(o)] for o in again)]
        ahead = sum(before < 0 for before, _ in (o.pair("TOSL+SR", "Q+SR") for o in again))
        body += (
            f"\n\nOn the models of {len(again)} further recordings Q+SR is ahead of TOSL+SR in {ahead}.\n\n"
            + Table("Models of other recordings", ["seed of the recording", *columns], rows).markdown
        )
    after = {unseen: o.pair("TOSL+SR", "Q+SR") for unseen, o in cuts.items()}
    words = ", ".join(f"{signed(x)} ({unseen}: {p_words(p_after)})" for unseen, (x, p_after) in after.items())
    said = (
        f"TOSL+SR less Q+SR is {signed(before)} ({p_words(p)}) on the model. Once its well-rewarded loops on few "
        f"samples are taken out, it is, by what unknown pairs do, {words}"
    )
    if before > 0:
        return NOTHING, f"{said}.", body
    if all(x > 0 or p_after >= verdicts.LEVEL for x, p_after in after.values()):
        return SHOWN, f"{said}.", body, frozenset([(full_key, full.longest, TOSL_OVER_Q)])
    less = all(o.means()[label] < full.means()[label] for o in cuts.values() for label in ("TOSL+SR", "Q+SR"))
    decide = "these rows decide how much is earned, not who earns most" if less else "these rows do not decide"
    lowest = min(cuts.values(), key=lambda o: abs(o.pair("TOSL+SR", "Q+SR")[0])).means()
    level = " and ".join(f"{lowest[x]:.2f} of {full.means()[x]:.2f}" for x in ("TOSL+SR", "Q+SR"))
    return NOT_SHOWN, f"{said}: {decide}. Where the two differ least, they earn {level}.", body


def _order(outcome: Outcome) -> list[object]:
    difference, p = outcome.pair("TOSL+SR", "Q+SR")
    return [outcome.means()["TOSL+SR"], outcome.means()["Q+SR"], difference, p_words(p).removeprefix("p = ")]


def gamma(outcomes: Outcomes, figures, plain: str, alone: str):
    chosen = outcomes[plain].experiment.best
    both = [of_value(outcomes[key]) for key in (plain, alone)]
    said = (
        f"Softmax divides Q by Rmax / (1 − γ), so a sweep over γ changes the temperature. On the model, {chosen} "
        f"{value_words(both[0])}; with the temperature held fixed it {value_words(both[1])}."
    )
    robot = [f"preliminary_gamma{end}_robot" for end in ("", "_alone")]
    if all(key in outcomes for key in robot):
        words = [value_words(of_value(outcomes[key])) for key in robot]
        said += f" On the robot it {words[0]}; with the temperature held fixed it {words[1]}."
    status = NOTHING if both[0].name != BEATEN else SHOWN if both[1].name != BEATEN else NOT_SHOWN
    return status, said


def model_only(outcomes: Outcomes, figures, model: str, robot: str):
    """Whether a loss of the paper's value is the model's alone: on the robot it must be smaller beyond doubt."""
    chosen = outcomes[model].experiment.best
    there, here = of_value(outcomes[model]), of_value(outcomes[robot])
    widest = here.loss + interval(outcomes[robot].final[outcomes[robot].longest])
    said = f"On the model, {chosen} {value_words(there)}. On the robot it {value_words(here)}"
    if there.name != BEATEN:
        return NOTHING, f"{said}."
    if here.name != BEATEN and widest < there.loss:
        return SHOWN, f"{said}, and there it loses at most {widest:.2f} (95 %): the model's order is not the robot's."
    return NOT_SHOWN, f"{said}; there it may lose up to {widest:.2f} (95 %), so the two cannot be told apart."
