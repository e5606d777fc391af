"""The tables of docs/when_similarity_helps.md, and the page; similarity.py calls this module."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from similarity_figures import factors_picture, gain_picture, spectra_picture
from similarity_numbers import (
    LENGTHS,
    LONG_WORKED_EXAMPLE,
    METHOD,
    TRIED,
    Found,
    estimate,
    gain_of_robots,
    gains,
    low,
    mean_factors,
    rank_correlation,
    slope,
)
from similarity_split import spectrum_of_noise
from similarity_text import PAGE
from stage_table import HEAD, asked_table

from rlrobot_edu.files import write_whole
from rlrobot_edu.widgets.stage.honest import IDEAL, read_numbers, verdict

DOCS = Path(__file__).parents[1] / "docs"
PAGE_OF = DOCS / "when_similarity_helps.md"


def gain_table(found: Found, rival: str) -> str:
    """A line for each order, a column for each temperature and length."""
    temperatures = list(found["orders"])
    head = ["k"]
    for temperature in temperatures:
        head += [f"T = {temperature}: {steps:,} steps" for steps in LENGTHS]
    by_temperature = [gains(found, temperature, rival) for temperature in temperatures]
    n = len(by_temperature[0]) - 1
    rows = []
    for k in range(n + 1):
        row = [str(k)]
        for its in by_temperature:
            if k == n and rival != "SR":
                row += ["same T"] * len(LENGTHS)
            else:
                row += [str(estimate(its[k, :, i])) for i in range(len(LENGTHS))]
        rows.append(row)
    return table(head, rows)


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table in Markdown, numbers at the right."""
    marks = [":---", *["---:"] * (len(head) - 1)]
    return "\n".join(f"| {' | '.join(row)} |" for row in (head, marks, *rows))


def spectra_table(found: Found) -> str:
    """A line for each task: what the low orders have, and the mean factor, of Q and of random numbers."""
    rows = []
    for task, its in found["spectra"].items():
        noise = spectrum_of_noise(its["shape"])
        shares = np.array(its[METHOD])
        mean, half = estimate(mean_factors(shares))
        rows.append(
            [
                f"`{task}`",
                f"{low(shares):.0f} %",
                f"{low(noise):.0f} %",
                f"{mean:.2f} ± {half:.2f}",
                f"{mean_factors(noise):.2f}",
            ]
        )
    head = [
        "task",
        "orders 0 and 1",
        "of random numbers",
        "mean factor",
        "of random numbers",
    ]
    return table(head, rows)


def advice_table(found: Found) -> str:
    """A line for each task, the best advice first."""
    tasks = sorted(found["advice"].items(), key=lambda its: -np.mean(its[1]["skill"]))
    rows = []
    for task, its in tasks:
        skills = f"{np.mean(its['skill']):.2f} ± {estimate(its['skill']).half:.2f}"
        states = f"{np.mean(its['states']):.0f}"
        rows.append([f"`{task}`", states, skills, str(gain_of_robots(its))])
    return table(["task", "states", "advice skill", "gain"], rows)


def numbers(found: Found) -> dict[str, str]:
    """Gains for the prose, by names such as ``sr_02_0_3600`` (rival, T = 0.2, order 0, steps)."""
    its = {}
    for temperature in found["orders"]:
        label = temperature.replace(".", "")
        for name, rival in (("sr", "SR"), ("fair", "SR, fair T")):
            for k, by_length in enumerate(gains(found, temperature, rival)):
                for i, steps in enumerate(LENGTHS):
                    its[f"{name}_{label}_{k}_{steps}"] = str(estimate(by_length[:, i]))
        its[f"slope_{label}"] = str(slope(found, temperature, 1))
    return its


def page(found: Found) -> str:
    """The page in Markdown."""
    rank = rank_correlation(found)
    new_states = read_numbers()
    first_seed, last_seed = new_states["seeds"]
    return PAGE.format(
        factors_alt=factors_picture().alt,
        spectra_alt=spectra_picture(found).alt,
        gain_alt=gain_picture(found).alt,
        spectra=spectra_table(found),
        worlds=gains(found, "1", "SR").shape[1],
        gain_over_sr=gain_table(found, "SR"),
        gain_over_fair=gain_table(found, "SR, fair T"),
        advice=advice_table(found),
        first_seed=first_seed,
        last_seed=last_seed,
        asked=table(HEAD, asked_table(new_states)),
        memories=verdict(new_states[IDEAL]["advice"]["all"]),
        teachers=len(found["advice"]["wander_1k"]["skill"]),
        robots=len(found["advice"]["wander_1k"]["SR"]),
        rho=rank.rho,
        rho_p=rank.p,
        critical=rank.critical,
        **numbers(found),
        long_worked=LONG_WORKED_EXAMPLE,
        tried=TRIED,
    )


def write_page(found: Found) -> None:
    """Write the page and its figures."""
    pictures = {
        "factors": factors_picture(),
        "spectra": spectra_picture(found),
        "gain": gain_picture(found),
    }
    for name, picture in pictures.items():
        write_whole(DOCS / "pictures" / f"similarity_{name}.png", picture.png())
    write_whole(PAGE_OF, page(found))
