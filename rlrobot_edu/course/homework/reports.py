"""Grades as a text, as a sheet for each student, as JUnit's XML, and as Gradescope's ``results.json``."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Mapping, Sequence
from pathlib import Path
from xml.etree import ElementTree as ET

from rlrobot_edu.course.homework.marks import Marked
from rlrobot_edu.course.homework.rooms import room_of


def as_text(one: Marked) -> str:
    """What a terminal shows of one notebook: points, and of each exercise what there is to say."""
    lines = [
        f"{one.name}: {one.score:g} of {one.max_score:g} points"
        + f" ({room_of(one.lesson).replace('_', ' ')})" * bool(one.lesson)
    ]
    for score in one.scores:
        lines.append(f"  {score.exercise:<20} {score.score:g}/{score.max_score:g}")
        if score.score < score.max_score or score.lent:
            lines.append(textwrap.indent(score.output, "      "))
    if one.off:
        lines.append(f"  {one.student.late:g} days late: {one.off:g} points off")
    lines += [f"  Note: {note}" for note in one.notes]
    return "\n".join(lines)


def as_sheet(one: Marked, sections: Mapping[str, str]) -> str:
    """What a student gets back, in Markdown: the points, and for each that is missing why, and where to look again.

    sections: the heading under which each exercise stands in the notebook, by its name
    """
    lines = [f"# {Path(one.name).stem}: {one.score:g} of {one.max_score:g} points", ""]
    if one.off:
        lines += [f"{one.student.late:g} days late: {one.off:g} points off.", ""]
    for score in one.scores:
        if score.score == score.max_score:
            lent = f", with the right `{score.lent}` in place of yours" * bool(score.lent)
            lines += [f"- `{score.exercise}`: right{lent}", ""]
            continue
        lines += [
            f"## `{score.exercise}`: {score.score:g} of {score.max_score:g}",
            "",
            "```text",
            score.output,
            "```",
            "",
        ]
        if score.exercise in sections:
            lines += [f"To look at again: *{sections[score.exercise]}*, in your notebook.", ""]
    return "\n".join(lines)


def as_junit(marked: Sequence[Marked]) -> str:
    """A test suite for each notebook, in it a test case for each exercise, which fails where points are missing."""
    suites = ET.Element("testsuites", name="rlrobot_edu grade")
    for one in marked:
        lost = [score for score in one.scores if score.score < score.max_score]
        suite = ET.SubElement(
            suites, "testsuite", name=_xml(one.name), tests=str(len(one.scores)), failures=str(len(lost)), errors="0"
        )
        for score in one.scores:
            case = ET.SubElement(suite, "testcase", name=score.exercise, classname=room_of(one.lesson))
            if score in lost:
                failure = ET.SubElement(case, "failure", message=f"{score.score:g} of {score.max_score:g} points")
                failure.text = _xml(score.output)
    ET.indent(suites)
    return ET.tostring(suites, encoding="unicode", xml_declaration=True) + "\n"


def as_gradescope(one: Marked) -> str:
    """Gradescope's ``results.json``: a visible test for each exercise, and what only the instructor should see."""
    tests = [
        {"name": score.exercise, "score": score.score, "max_score": score.max_score, "output": score.output,
         "status": "passed" if score.score == score.max_score else "failed", "visibility": "visible"}
        for score in one.scores
    ]  # fmt: skip
    if one.notes:
        tests.append(
            {"name": "notes for the instructor", "score": 0.0, "max_score": 0.0, "output": "\n".join(one.notes),
             "visibility": "hidden"}
        )  # fmt: skip
    return json.dumps({"score": one.score, "tests": tests}, indent=1, ensure_ascii=False) + "\n"


def _xml(text: str) -> str:
    """`text` without what XML cannot hold."""
    return "".join(sign if sign.isprintable() or sign in "\n\t" else "?" for sign in text)
