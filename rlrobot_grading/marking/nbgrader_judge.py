"""The step of ``nbgrader autograde`` that judges: it has a submission graded as ``grade`` does.

nbgrader itself would run the tests in the kernel of the learner, who could read them there, change them, or end them.
"""

from __future__ import annotations

import tempfile
from copy import deepcopy
from pathlib import Path
from typing import Any

import nbformat
from nbgrader.coursedir import CourseDirectory
from nbgrader.preprocessors import ClearHiddenTests, NbGraderPreprocessor
from nbgrader.utils import is_grade, is_locked
from traitlets import Float, Integer, Unicode

from rlrobot_grading.marking.marking import mark_file
from rlrobot_grading.marking.marks import NO_RULES, Limits, Score, read_rules
from rlrobot_grading.marking.reports import placed
from rlrobot_grading.marking.submission import read_submission


class Judge(NbGraderPreprocessor):
    """It puts a verdict below each test of a notebook, from which nbgrader reads off the points."""

    seed = Integer(None, allow_none=True, help="Of the secret tapes.").tag(config=True)
    seconds = Float(Limits.seconds, help="For one notebook.").tag(config=True)
    memory = Integer(Limits.memory, help="For one notebook [MiB].").tag(config=True)
    rules = Unicode("", help="Path of a file that says what counts how much.").tag(
        config=True
    )

    def preprocess(self, nb: Any, resources: Any) -> tuple[Any, Any]:
        """Judge a submission. Raises ValueError without a seed, or if the instructor's version has no exercises."""
        if self.seed is None:
            raise ValueError(
                "c.Judge.seed is missing in nbgrader_config.py: from it come the hidden tests"
            )
        told, course = resources["nbgrader"], CourseDirectory(parent=self)
        folder = course.format_path(course.source_directory, ".", told["assignment"])
        source = Path(folder, f"{told['notebook']}.ipynb")
        limits, rules = (
            Limits(self.seconds, self.memory),
            read_rules(self.rules) if self.rules else NO_RULES,
        )
        with tempfile.TemporaryDirectory(prefix="rlrobot-judge-") as temporary:
            path = Path(temporary, source.name)
            nbformat.write(nb, path)
            marked = mark_file(
                path, read_submission(source).lesson, self.seed, limits, rules
            )
        marked = placed(
            marked, [cell.source for cell in nb.cells if cell.cell_type == "code"]
        )
        for note in marked.notes:
            self.log.warning("%s: %s", told["student"], note)
        restore(nb, nbformat.read(source, as_version=4))
        nb, resources = ClearHiddenTests(parent=self).preprocess(nb, resources)
        scores = {score.exercise: score for score in marked.scores}
        for cell in nb.cells:
            if is_grade(cell) and _name(cell) in scores:
                cell.outputs = _verdict(scores[_name(cell)])
        return nb, resources


def restore(nb: Any, source: Any) -> None:
    """Give a submission back what belongs to nbgrader: locked cells as they were, and tests that have been deleted."""
    missing = {
        cell.metadata.nbgrader.grade_id: cell
        for cell in source.cells
        if "nbgrader" in cell.metadata
    }
    for cell in nb.cells:
        name = _name(cell)
        cell.metadata.pop("nbgrader", None)
        if name in missing and missing[name].cell_type == cell.cell_type:
            twin = missing.pop(name)
            cell.metadata["nbgrader"] = deepcopy(twin.metadata.nbgrader)
            cell.source = twin.source if is_locked(twin) else cell.source
    nb.cells += [deepcopy(cell) for cell in missing.values() if is_grade(cell)]


def _name(cell: Any) -> str:
    """By which nbgrader knows a cell; empty if it does not."""
    told = cell.metadata.get("nbgrader")
    return str(told.get("grade_id", "")) if isinstance(told, dict) else ""


def _verdict(score: Score) -> list[Any]:
    """Outputs by which nbgrader gives all points of a cell, a part of them, or none."""
    if not score.score:
        return [
            nbformat.v4.new_output(
                "error", ename="wrong", evalue="", traceback=[score.output]
            )
        ]
    told = nbformat.v4.new_output("stream", name="stdout", text=f"{score.output}\n")
    part = nbformat.v4.new_output(
        "execute_result", data={"text/plain": f"{score.score:g}"}, execution_count=1
    )
    return [told] if score.score == score.max_score else [told, part]
