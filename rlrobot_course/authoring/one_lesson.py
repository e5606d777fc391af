"""A plugin of pytest: ``-p rlrobot_course.authoring.one_lesson --lesson 04`` keeps the tests of one lesson.

A test belongs to a lesson if it has the lesson's number, room or notebook among its parameters, or stands in its
notebook or in a file named after its room. The names of tests are sentences, so a failure is one, too.
"""

import re
from itertools import takewhile
from pathlib import Path
from typing import Any

LONGEST = 300  # characters of what a test has found
COMPARED = "assert reference_output == test_output failed:"  # by nbval, the two outputs on the next line
COLOURS = re.compile(r"\x1b\[[\d;]*m")


def pytest_addoption(parser: Any) -> None:
    """The number of the lesson."""
    parser.addoption("--lesson", required=True, help="only the tests of this lesson, as in 04")


def pytest_collection_modifyitems(config: Any, items: list[Any]) -> None:
    """Leave out the tests of other lessons, or of none."""
    number = config.getoption("--lesson")
    kept = [item for item in items if belongs(item.path, parameters_of(item), number)]
    config.hook.pytest_deselected(items=[item for item in items if item not in kept])
    items[:] = kept


def parameters_of(item: Any) -> list[Any]:
    """What a test is given."""
    return list(item.callspec.params.values()) if hasattr(item, "callspec") else []


def belongs(file: Path, parameters: list[Any], number: str) -> bool:
    """Whether a test in this file, with these parameters, is one of a lesson."""
    if file.name.startswith((f"test_lesson_{number}_", f"{number}_")):
        return True
    words = [thing for thing in parameters if isinstance(thing, str)]
    return any(word in (number, f"lesson_{number}") or word.startswith(f"notebooks/{number}_") for word in words)


def sentence(report: Any) -> str:
    """A failed test in words: where it failed, which sentence does not hold, and what was found instead."""
    found = getattr(getattr(report.longrepr, "reprcrash", None), "message", "") or str(report.longrepr)
    lines = [line.strip() for line in COLOURS.sub("", found).splitlines() if line.strip()] or [""]
    if COMPARED in lines:
        saved_and_now = lines[lines.index(COMPARED) + 1]
        return f"{report.nodeid.replace('::', ', ')}: its output is not the saved one. {saved_and_now}"[:LONGEST]
    if "::Cell " in report.nodeid:
        return f"{report.nodeid.replace('::', ', ')}: {lines[-1]}"[:LONGEST]
    told = " ".join([lines[0], *takewhile(lambda line: not line.startswith("assert "), lines[1:])])[:LONGEST]
    if "::" not in report.nodeid:
        return f"the tests cannot be loaded: {told}"
    name, _, parameters = report.nodeid.rpartition("::")[2].partition("[")
    test = name.removeprefix("test_").replace("_", " ")
    return f"{parameters.rstrip(']') or report.nodeid.partition('::')[0]}: “{test}” does not hold. {told}"


def pytest_terminal_summary(terminalreporter: Any, exitstatus: int, config: Any) -> None:
    """A sentence for each fault, and one at the end."""
    number = config.getoption("--lesson")
    reports = [*terminalreporter.stats.get("error", []), *terminalreporter.stats.get("failed", [])]
    faults = list(dict.fromkeys(sentence(report) for report in reports))
    end = f"Lesson {number} is not right yet; faults: {len(faults)}."
    if exitstatus == 0:
        end = f"✓ Lesson {number}: its exercises, wrong answers, figures and notebook are right."
    elif not faults:
        end = f"The check of lesson {number} has not come to its end."
    terminalreporter.write_line("\n".join([*(f"✗ {fault}" for fault in faults), end]))
