"""The notebooks as files: complete, tidy, readable on a page that is not running, and solvable."""

import ast
import importlib
import json
import re
from pathlib import Path

import nbformat
import numpy as np
import pytest
from cell_names import names_in
from jupyter_client.manager import AsyncKernelManager
from jupyter_core.utils import run_sync
from nbclient import NotebookClient

from rlrobot_course.authoring.lists import lessons
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.question import Question

ROOT = Path(__file__).parents[2]
ASSIGNMENTS = sorted(
    path.relative_to(ROOT).as_posix()
    for path in ROOT.glob("notebooks/homework/*.ipynb")
)
NOTEBOOKS = [
    path.relative_to(ROOT).as_posix() for path in lessons(ROOT).values()
] + ASSIGNMENTS
COURSE = ROOT / "rlrobot_course"


def number(name: str) -> str:
    """Of notebooks/07_eligibility_traces.ipynb it is 07."""
    return Path(name).name.partition("_")[0]


def room(name: str) -> str:
    """The room of a notebook: of 07_eligibility_traces.ipynb lesson_07, of homework/1_….ipynb assignment_1."""
    return f"{'assignment' if name in ASSIGNMENTS else 'lesson'}_{number(name)}"


LESSONS = [
    name for name in NOTEBOOKS if (COURSE / room(name) / "exercises.py").exists()
]
ABSOLUTE_PATH = re.compile(
    r"(?<![\w.:/])/(home|root|tmp|usr|opt|var|Users|work|private|mnt)/|\b[A-Z]:\\\\"
)
LARGEST_FILE, LARGEST_OUTPUT = 1_000_000, 500_000  # bytes
WIDEST, HEAP = 960, 80  # of a picture [pixels], of words without a tag between them
LONGEST_CELL, LONGEST_FILE = (
    16,
    40,
)  # lines that are not blank, of a cell and of a file that a cell writes
WRITES = "%%writefile "
# why an output may be another one elsewhere, so that it is not compared
REASONS = ("a clock", "the reader's own folder")
SECONDS = {
    "half a minute": 30,
    "a minute": 60,
    "one to two minutes": 60,
    "ten seconds": 10,
    "twenty seconds": 20,
}
WAIT = re.compile(rf"(?i)(?:takes|\()\s?(?:about|some)?\s?({'|'.join(SECONDS)})\b")


def read(name: str) -> nbformat.NotebookNode:
    return nbformat.read(ROOT / name, as_version=4)


def code_cells(name: str) -> list[nbformat.NotebookNode]:
    return [cell for cell in read(name).cells if cell.cell_type == "code"]


def outputs(name: str) -> list[nbformat.NotebookNode]:
    return [output for cell in code_cells(name) for output in cell.outputs]


def exercises(name: str) -> dict[str, Exercise | Question]:
    """The exercises of a lesson by name."""
    return vars(importlib.import_module(f"rlrobot_course.{room(name)}.exercises").check)


def exercise_cells(cells: list[nbformat.NotebookNode]) -> list[nbformat.NotebookNode]:
    return [cell for cell in cells if "exercise" in cell.metadata.get("tags", [])]


def exercise_of(cell: nbformat.NotebookNode) -> str:
    """Which exercise is checked in the last line of its cell."""
    return re.search(r"check\.(\w+)\(", cell.source.splitlines()[-1])[1]


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_every_cell_ran_once_from_top_to_bottom_without_error_or_warning(name):
    counts = [cell.execution_count for cell in code_cells(name)]
    assert counts == list(range(1, len(counts) + 1))
    for output in outputs(name):
        assert output.output_type != "error"
        assert not (output.output_type == "stream" and output.name == "stderr"), (
            output.text
        )


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_no_absolute_path_is_left_in_it(name):
    texts = ["".join(cell.source) for cell in read(name).cells]
    for output in outputs(name):
        texts += [output.get("text", "")]
        texts += [
            str(data)
            for kind, data in output.get("data", {}).items()
            if kind.startswith("text/")
        ]
    for text in texts:
        assert not ABSOLUTE_PATH.search(text), text


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_file_and_outputs_are_small(name):
    assert (ROOT / name).stat().st_size <= LARGEST_FILE
    for output in outputs(name):
        assert len(json.dumps(output)) <= LARGEST_OUTPUT


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_reopened_without_a_kernel_no_output_asks_for_a_widget_that_lives_no_more(name):
    assert "widgets" not in read(name).metadata
    for output in outputs(name):
        assert "application/vnd.jupyter.widget-view+json" not in output.get(
            "data", {}
        ), "see notebooks/run_all.py"


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_an_output_that_is_not_compared_says_why(name):
    for cell in code_cells(name):
        ignored = "nbval-ignore-output" in cell.metadata.get("tags", [])
        reason = cell.metadata.get("rlrobot_edu", {}).get("ignored")
        assert ignored == (reason in REASONS), cell.source


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_folded_code_says_in_its_first_line_what_it_does(name):
    for cell in read(name).cells:
        if not cell.metadata.get("jupyter", {}).get("source_hidden"):
            continue
        first, *others = cell.source.splitlines()
        assert first.startswith("# ") and others
        assert not set(cell.metadata.get("tags", [])) & {"exercise", "challenge"}


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_every_widget_has_a_still_twin(name):
    for output in outputs(name):
        data = output.get("data", {})
        if "rlrobot_edu" in output.get("metadata", {}):
            assert "<" in data.get("text/html", ""), data.get("text/plain")


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_every_figure_says_in_words_what_it_shows(name):
    for output in outputs(name):
        data = output.get("data", {})
        assert not [kind for kind in data if kind.startswith("image/")], (
            "no page shows its alt text: see Displayed"
        )
        for picture in re.findall(r"<img[^>]*>", data.get("text/html", "")):
            alt = re.search(r'alt="([^"]*)"', picture)
            assert alt and len(alt[1]) > 20, picture[:300]
    for cell in read(name).cells:
        if cell.cell_type == "markdown":
            assert not re.search(r"!\[\s*\]\(|<img(?![^>]*\balt=)", cell.source), (
                cell.source
            )


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_page_that_strips_styles_scripts_and_frames_shows_all_the_same(name):
    """GitHub and other renderers keep the tags of text, tables and pictures alone; there a film has no pause."""
    for output in outputs(name):
        page = re.sub(
            r"<(style|script)\b.*?</\1>|<label hidden>.*?</label>",
            "",
            output.get("data", {}).get("text/html", ""),
            flags=re.DOTALL,
        )
        lost = re.findall(r"<(iframe|svg|canvas|video|object|form|input)\b", page)
        assert not lost, page[:300]
        assert all(
            int(width) <= WIDEST
            for width in re.findall(r'<img[^>]* width="(\d+)"', page)
        )
        words = [len(text.split()) for text in re.split("<[^>]+>", page)]
        assert max(words) <= HEAP, "without its layout this is a heap of words"


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_links_lead_to_files_that_are_there(name):
    for cell in read(name).cells:
        if cell.cell_type == "markdown":
            for target in re.findall(r"\]\(([^)#\s]+)", cell.source):
                assert (
                    target.startswith("http")
                    or ((ROOT / name).parent / target).exists()
                ), target


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_every_greek_letter_stands_in_the_notation_page(name):
    page = (ROOT / "docs" / "notation.md").read_text(encoding="utf-8")
    letters = r"\\(?:alpha|beta|gamma|delta|varepsilon|epsilon|eta|theta|lambda|mu|pi|rho|sigma|tau|phi|omega)\b"
    for cell in read(name).cells:
        if cell.cell_type == "markdown":
            for letter in set(re.findall(letters, cell.source)):
                assert letter in page, f"{letter} is in {name}, not in docs/notation.md"


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_cells_are_short_and_set_nothing_up_that_a_learner_need_not_see(name):
    for cell in code_cells(name):
        lines = [line for line in cell.source.splitlines() if line.strip()]
        if cell.source.startswith(WRITES):
            lines = lines[1:]
            assert len(lines) <= LONGEST_FILE, cell.source
        else:
            assert len(lines) <= LONGEST_CELL, cell.source
        assert sum(line.startswith(("import ", "from ")) for line in lines) <= 3, (
            cell.source
        )
        assert not re.search(
            r"sys\.path|^\s*[!%]|warnings\.filter", "\n".join(lines), re.MULTILINE
        ), cell.source


@pytest.mark.parametrize("name", LESSONS)
def test_every_exercise_of_a_lesson_is_in_its_notebook_and_waits(name):
    cells = {exercise_of(cell): cell for cell in exercise_cells(code_cells(name))}
    assert cells
    assert cells.keys() == exercises(name).keys()
    for cell in cells.values():
        assert not cell.outputs, (
            "nobody has answered yet, and a check that waits has nothing to say on a page"
        )


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_the_time_a_lesson_takes_is_told_alike_and_fits_into_an_hour_of_class(name):
    minutes = int(re.search(r"In about (\d+) minutes", read(name).cells[0].source)[1])
    page = (
        ROOT / f"docs/{'grading' if name in ASSIGNMENTS else 'lessons'}.md"
    ).read_text("utf-8")
    rows = [line for line in page.splitlines() if f"{name})" in line]
    assert (
        rows or name not in ASSIGNMENTS
    )  # that each lesson has one, test_lessons.py says
    assert all(row.rstrip(" |").endswith(f"| {minutes}") for row in rows)
    assert minutes <= (90 if name in ASSIGNMENTS else 60)


def cells_of_the_learner(
    cells: list[nbformat.NotebookNode], answers: set[str]
) -> list[nbformat.NotebookNode]:
    """The cells in which the learner's answers play a part, and those that prepare them; cells that write a file, too.

    All others do the same whether the exercises are solved or not, and are run by nbval.
    """
    names = [names_in(cell.source) for cell in cells]
    used, needed = set(), set()
    for i, (taken, given) in enumerate(names):
        if (
            taken & answers
            or cells[i] in exercise_cells(cells)
            or cells[i].source.startswith(WRITES)
        ):
            used.add(i)
            answers = answers | given
        else:
            answers = answers - given
    for i, (taken, given) in reversed(list(enumerate(names))):
        if i in used or given & needed:
            used.add(i)
            needed = (needed - given) | taken
    return [cells[i] for i in sorted(used)]


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_no_cell_is_said_to_take_longer_than_the_whole_notebook_took(name):
    """What `run_all.py` found stands in the notebook, rounded to ten seconds; another computer may be quicker."""
    notebook = read(name)
    prose = " ".join(
        cell.source for cell in notebook.cells if cell.cell_type == "markdown"
    )
    said = [SECONDS[wait.lower()] for wait in WAIT.findall(prose)]
    assert max(said, default=0) <= notebook.metadata["rlrobot_edu"]["seconds"] + 10


def test_the_cells_of_the_learner_are_those_in_which_an_answer_plays_a_part():
    sources = [
        "import np",
        "%%writefile x.py\nany text",
        "x = np.a",
        "y = np.b",
        "def f(x):\n    return mine(x)",
        "print(f(x))",
        "mine = 3",
        "mine",
    ]
    cells = [nbformat.v4.new_code_cell(source) for source in sources]
    assert [cell.source for cell in cells_of_the_learner(cells, {"mine"})] == [
        *sources[:3],
        *sources[4:6],
    ]


def definition(name: str, exercise: Exercise | Question, folder: Path) -> str:
    """What gives `name` its value: a function, or one line."""
    if isinstance(exercise, Question):
        return f"{name} = {np.asarray(exercise.right).tolist()!r}"
    source = (folder / "exercises.py").read_text(encoding="utf-8")
    for part in ast.parse(source).body:
        if name in (
            getattr(part, "name", ""),
            *(getattr(target, "id", "") for target in getattr(part, "targets", ())),
        ):
            return ast.get_source_segment(source, part)
    raise KeyError(name)


def imports(folder: Path) -> str:
    """What the right answers of a lesson import from elsewhere, for a cell before them."""
    lines = (folder / "exercises.py").read_text(encoding="utf-8").splitlines()
    return "\n".join(
        sorted(
            line
            for line in lines
            if re.match(r"(import|from (?!rlrobot_|__future__)\S+ import) ", line)
        )
    )


@pytest.fixture(scope="module")
def kernel():
    """One kernel for all lessons, so that it loads the library once; nbval gives each a kernel of its own."""
    manager = AsyncKernelManager(kernel_name="python3")
    yield manager
    run_sync(manager.shutdown_kernel)(now=True)


@pytest.mark.long
@pytest.mark.parametrize("name", LESSONS)
def test_a_notebook_runs_with_its_solutions_in_place_and_every_check_is_green(
    name, kernel, tmp_path
):
    notebook = read(name)
    given = f"from rlrobot_course.{room(name)}.exercises import {', '.join(exercises(name))}"
    solutions = f"{given}\n{imports(COURSE / room(name))}"
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    answered = exercise_cells(cells)
    for cell in answered:
        asked = exercise_of(cell)
        answer = definition(asked, exercises(name)[asked], COURSE / room(name))
        cell.source = f"{answer}\n\n{cell.source.splitlines()[-1]}"
    notebook.cells = cells_of_the_learner(cells, set(exercises(name)))

    written = [
        key for key, thing in exercises(name).items() if isinstance(thing, Exercise)
    ]
    kept = written if name not in ASSIGNMENTS else []
    taken = f"from rlrobot_course.learner.my_functions import take\ntake({number(name)!r}, *{kept})"
    extra = [
        nbformat.v4.new_code_cell(source)
        for source in (f"%reset -f\n%cd -q {tmp_path}", solutions, taken)
    ]
    notebook.cells = [*extra[:2], *notebook.cells, *extra[2:] * bool(kept)]
    client = NotebookClient(
        notebook,
        km=kernel,
        timeout=600,
        startup_timeout=600,
        resources={"metadata": {"path": tmp_path}},
    )
    client.execute()
    client.kc.stop_channels()
    for cell in answered:
        assert cell.outputs[-1]["data"]["text/plain"].startswith("✓ "), cell.outputs
    if kept:
        assert extra[2].outputs[0].text == f"yours: {', '.join(kept)}\n"


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_sections_are_numbered_without_a_gap(name):
    cells = [cell.source for cell in read(name).cells if cell.cell_type == "markdown"]
    numbers = re.findall(r"^## (\d+)\. ", "\n".join(cells), re.MULTILINE)
    assert [int(number) for number in numbers] == list(range(1, len(numbers) + 1))
