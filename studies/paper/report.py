"""The page of the reproduction: people write its prose, and here its tables and figures are put into their blocks."""

import json
from collections.abc import Mapping
from pathlib import Path

from in_markdown import in_markdown
from made_blocks import block, filled

from paper.experiments import EXPERIMENTS
from paper.figures import write_figures
from paper.outcome import read_outcomes
from paper.tables import cost_table, tables
from rlrobot_edu.files import write_whole


def write_page(folder: Path, pictures: Mapping[str, str], *, has_prose: bool) -> Path:
    """Write the figures and the page from averages.csv and environment.json in `folder`.

    pictures: more blocks by name; has_prose: whether the page there is kept, and only its blocks are written
    """
    about = json.loads((folder / "environment.json").read_text(encoding="utf-8"))
    outcomes = read_outcomes(folder / "averages.csv", EXPERIMENTS)
    made = {
        "about": about_words(about, outcomes),
        **pictures,
        **write_figures(folder, outcomes),
        **tables(outcomes),
    }
    if costs := about["seconds a step"]:
        made["costs"] = in_markdown(cost_table(costs))
    path = folder / "README.md"
    bare = (
        "\n\n".join(
            [
                "# The paper's experiments, run again",
                *(block(name, "") for name in made),
            ]
        )
        + "\n"
    )
    write_whole(
        path,
        filled(
            path.read_text(encoding="utf-8") if has_prose and path.is_file() else bare,
            made,
        ),
    )
    return path


def about_words(about: Mapping, outcomes: Mapping) -> str:
    """With what the tables were made, and what is missing in them."""
    lines = [
        f"`{about['command']}` with "
        + ", ".join(map(" ".join, about["versions"].items()))
        + "."
    ]
    lines += [f"Skipped: {key}: {reason}." for key, reason in about["skipped"].items()]
    missing = [
        e.key
        for e in EXPERIMENTS
        if e.key not in outcomes and e.key not in about["skipped"]
    ]
    if missing:
        lines.append(
            f"**{len(missing)} of {len(EXPERIMENTS)} experiments have not been run: {', '.join(missing)}.**"
        )
    return "\n\n".join(lines)
