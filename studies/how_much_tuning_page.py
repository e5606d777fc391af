"""The page docs/studies/how_much_tuning.md: its tables and its text; how_much_tuning.py calls this module."""

from __future__ import annotations

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
from how_much_tuning_text import PAGE
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
    """What tuning gains for each task, with the bias and without; and the scale in reward a step."""
    study = draws.study
    rows = []
    for task in study.worlds:
        low, high = study.ends(task)
        cells = [task, f"{low:.2f}", f"{high:.2f}".replace("-", "−")]
        for kind in ("paper's", "winner"):
            for method in (SR, OURS):
                cells.append(f"{draws.judged(task, method, kind).estimate:.2f}")
        ours, sr = (draws.judged(task, method, "winner") for method in (OURS, SR))
        cells.append(said(less(task, ours, sr)))
        rows.append([cell.replace("-", "−") for cell in cells])
    head = ["world", "score 0 is", "score 1 is", "SR, paper's", "QBIASSR, paper's"]
    head += ["SR, tuned", "QBIASSR, tuned", "tuned: QBIASSR less SR"]
    return table(head, rows)


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
        "tuning_friction": plot_friction(draws, by_name["H5"]),
    }


def numbers(draws: Draws, found: list[Finding]) -> dict[str, str]:
    """The numbers of the prose, by name."""
    study = draws.study
    by_name = {its.name: its for its in found}
    effects = {world: draws.effects(world) for world in ("friction", "wander_1k")}
    its_price = price(study, OURS)
    paper = draws.over_tasks(OURS, "paper's")
    tuned = less(
        "tuned", draws.over_tasks(OURS, "winner"), draws.over_tasks(SR, "winner")
    )
    ours, sr = (draws.regret(method, "paper's") for method in (OURS, SR))
    of_all = {name: len(array.ravel()) for name, array in study.parts.items()}
    return {
        "runs": f"{sum(of_all.values()):,}",
        "tries": str(its_price.worth(paper.estimate)),
        "paper": plainly(paper),
        "beaten": f"{100 * beaten_by_the_papers(study, OURS):.0f}",
        "luck": f"{luck(study, OURS):.2f}",
        "tuned": said(tuned),
        "regret_ours": plainly(ours),
        "regret_sr": plainly(sr),
        "best_of_two": f"{its_price.estimate[1]:.2f}",
        "rank_ours": plainly(draws.rank_correlation(OURS)),
        "rank_sr": plainly(draws.rank_correlation(SR)),
        "bias_alone": said(effects["friction"]["bias alone"]),
        "traces_alone": said(effects["friction"]["traces alone"]),
        "both": said(effects["friction"]["both"]),
        "traces_ideal": said(effects["wander_1k"]["traces alone"]),
        "hold": str(sum(its.verdict == "holds" for its in found)),
        **{name: said(its.parts[0]) for name, its in by_name.items()},
        "H5_more": said(by_name["H5"].parts[1]),
    }


def page(study: Study) -> tuple[str, Mapping[str, Picture]]:
    """The page in Markdown, and its pictures."""
    draws = Draws(study)
    found = findings(draws)
    drawn = pictures(draws, found)
    shown = {
        name: f"![{picture.alt}](../pictures/{name}.png)"
        for name, picture in drawn.items()
    }
    text = PAGE.format(
        **numbers(draws, found),
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
