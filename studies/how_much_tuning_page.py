"""The page docs/studies/how_much_tuning.md: its tables and its text; how_much_tuning.py calls this module."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from pathlib import Path

from how_much_tuning import METHODS, OURS, Study
from how_much_tuning_figures import (
    plot_friction,
    plot_maps,
    plot_price,
    plot_regret,
)
from how_much_tuning_numbers import (
    beaten_by_the_papers,
    luck,
    plainly,
    price,
    said,
)
from how_much_tuning_tests import SR, Draws, Finding, findings, less
from how_much_tuning_text import PAGE, VERDICT
from how_much_tuning_worlds import settings_of

from rlrobot_edu.files import write_whole
from rlrobot_edu.show.picture import Picture

DOCS = Path(__file__).parent.parent / "docs"
KINDS = ("paper's", "others'", "common", "winner")


def table(head: list[str], rows: list[list[str]]) -> str:
    """A table in Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def told_p(p: float) -> str:
    """A p-value with the digits that matter."""
    return "< 0.01" if p < 0.01 else f"{p:.2f}"


def of_hypotheses(found: list[Finding], draws: Draws) -> str:
    """What was expected, what was found, and the verdict."""
    texts = draws.study.plan["hypotheses"]
    rows = []
    for its in found:
        numbers = []
        for part in its.parts:
            name = f"{part.name}: " if len(its.parts) > 1 else ""
            numbers.append(f"{name}{said(part)}")
        text = f"**{its.name}.** {texts[its.name]}"
        verdict = f"**{its.verdict}**" if its.verdict != "not shown" else its.verdict
        rows.append([text, "; ".join(numbers), told_p(its.corrected), verdict])
    return table(["hypothesis", "found", "p, corrected", "verdict"], rows)


def of_methods(draws: Draws) -> str:
    """Score of each method at each kind of setting."""
    rows = []
    for method in METHODS:
        parts = [draws.over_tasks(method, kind) for kind in KINDS]
        rows.append([method, *map(plainly, parts)])
    head = ["method", "the paper's", "tuned on the other five", "tuned on all six", "tuned for the task"]  # fmt: skip
    return table(head, rows)


def of_tasks(draws: Draws) -> str:
    """Score of TOSL+SR and TOSL+QBIASSR by task, and what the scale means in reward a step."""
    study = draws.study
    rows = []
    for task in study.worlds:
        cells = [task, " / ".join(f"{end:.2f}" for end in study.ends(task))]
        for kind in ("paper's", "others'", "winner"):
            if kind in study.kinds(task, OURS):
                both = [draws.judged(task, method, kind).estimate for method in (SR, OURS)]  # fmt: skip
                cells.append(" / ".join(f"{score:.2f}" for score in both))
            else:
                cells.append("–")
        ours, sr = (draws.judged(task, method, "winner") for method in (OURS, SR))
        rows.append([*cells, said(less(task, ours, sr))])
    head = ["world", "reward a step at 0 / 1", "the paper's", "tuned on the other five", "tuned"]  # fmt: skip
    return table([*head, "tuned: QBIASSR less SR"], rows)


def of_settings(study: Study) -> str:
    """The common setting of each method."""
    rows = []
    for method in METHODS:
        its = settings_of(study.plan)[int(study.common(method))]
        values = [f"{its[name]:.2f}" for name in ("alpha", "gamma", "lam", "temperature")]  # fmt: skip
        if method.startswith("Q+"):
            values[2] = "–"
        rows.append([method, *values])
    return table(["method", "α", "γ", "λ", "T"], rows)


def pictures(draws: Draws, found: list[Finding]) -> dict[str, Picture]:
    """The four pictures by the names of their files."""
    by_name = {its.name: its for its in found}
    return {
        "tuning_maps": plot_maps(draws, by_name["H6"]),
        "tuning_price": plot_price(draws),
        "tuning_regret": plot_regret(draws, by_name["H3"]),
        "tuning_friction": plot_friction(draws),
    }


def numbers(draws: Draws, found: list[Finding]) -> dict[str, str]:
    """The numbers of the prose, by name."""
    study = draws.study
    by_name = {its.name: its for its in found}
    verdicts = [its.verdict for its in found]
    friction, ideal = (draws.effects(world) for world in ("friction", "wander_1k"))
    curve = price(study, OURS)
    paper = draws.over_tasks(OURS, "paper's")
    tries = curve.worth(paper.interval[1])

    def bias(kind: str) -> str:
        return said(less(kind, draws.over_tasks(OURS, kind), draws.over_tasks(SR, kind)))  # fmt: skip

    def best_of(k: int | None) -> str:
        return "–" if k is None else f"{curve.estimate[curve.tries.index(k)]:.2f}"

    settings = settings_of(study.plan)

    def winners(method: str) -> str:
        worlds = [*study.plan["wandering"], *study.plan["arms"]]
        chosen = [settings[int(study.winner(world, method))] for world in worlds]
        *first, last = [f"{its['temperature']:.2f}" for its in chosen]
        return f"{', '.join(first)} and {last}"

    tuned = {}
    for world in study.plan["wandering"]:
        ours, sr = (draws.judged(world, method, "winner") for method in (OURS, SR))
        tuned[f"tuned_{world}"] = said(less(world, ours, sr))
    return {
        "runs": f"{sum(array.size for array in study.parts.values()):,}",
        "tries": counted(tries),
        "winners_ours": winners(OURS),
        "winners_sr": winners(SR),
        "best_of_tries": best_of(tries),
        "best_of_one": best_of(1),
        "best_of_two": best_of(2),
        "best_of_four": best_of(4),
        "paper": plainly(paper),
        "beaten": f"{100 * beaten_by_the_papers(study, OURS):.0f}",
        "luck": f"{luck(study, OURS):.2f}",
        "tuned": bias("winner"),
        **tuned,
        "at_papers": bias("paper's"),
        "regret_ours": plainly(draws.regret(OURS, "paper's")),
        "regret_sr": plainly(draws.regret(SR, "paper's")),
        "others_ours": plainly(draws.regret(OURS, "others'")),
        "others_sr": plainly(draws.regret(SR, "others'")),
        "others_score_ours": plainly(draws.over_tasks(OURS, "others'")),
        "others_score_sr": plainly(draws.over_tasks(SR, "others'")),
        "fewest_judges": str(min(study.plan["sizes"]["judging robots"].values())),
        "most_judges": str(max(study.plan["sizes"]["judging robots"].values())),
        "rank_ours": said(draws.rank_correlation(OURS)),
        "rank_sr": said(draws.rank_correlation(SR)),
        "traces_friction": said(friction["traces alone"]),
        "traces_ideal": said(ideal["traces alone"]),
        "interaction_ideal": said(ideal["interaction"]),
        "H4": said(by_name["H4"].parts[0]),
        "H5": said(by_name["H5"].parts[0]),
        "H5_more": said(by_name["H5"].parts[1]),
        "hold": counted(verdicts.count("holds")),
        "opposite": counted(verdicts.count("the opposite holds")),
        "not_shown": counted(verdicts.count("not shown")),
    }


def counted(n: int | None) -> str:
    """A small number in words."""
    words = ("none", "one", "two", "three", "four", "five", "six", "seven")
    return words[n] if n is not None and n < len(words) else str(n)


def verdict(its: Mapping[str, str]) -> str:
    """The three sentences of the verdict, in one line."""
    return " ".join(VERDICT.format(**its).split())


def wrapped(text: str) -> str:
    """A paragraph in lines of 120 characters."""
    return textwrap.fill(text, 120, break_long_words=False, break_on_hyphens=False)


def page(study: Study) -> tuple[str, Mapping[str, Picture]]:
    """The page in Markdown, and its pictures."""
    draws = Draws(study)
    found = findings(draws)
    drawn = pictures(draws, found)
    shown = {
        name: f"![{picture.alt}](../pictures/{name}.png)"
        for name, picture in drawn.items()
    }
    its = numbers(draws, found)
    text = PAGE.format(
        **its,
        verdict=wrapped(verdict(its)),
        **shown,
        of_hypotheses=of_hypotheses(found, draws),
        of_methods=of_methods(draws),
        of_tasks=of_tasks(draws),
        of_settings=of_settings(study),
        **{f"n_{name.replace(' ', '_')}": n for name, n in study.plan["sizes"].items()},
    )
    return text, drawn


def write_page(study: Study) -> Path:
    """Write the page and its pictures; the text that judges stands in how_much_tuning_text.py."""
    text, drawn = page(study)
    for name, picture in drawn.items():
        write_whole(DOCS / "pictures" / f"{name}.png", picture.png())
    write_whole(DOCS / "studies" / "how_much_tuning.md", text)
    return DOCS / "studies" / "how_much_tuning.md"
