"""Lessons in a real browser: JupyterLab runs them, and the widgets on the page show the library's numbers."""

from __future__ import annotations

import contextlib
import io
import json
import os
import re
import shutil
import subprocess
import sys
import time
import urllib.request
from pathlib import Path
from urllib.parse import urlsplit

import nbformat
import numpy as np
import psutil
import pytest
from cell_names import names_in
from PIL import Image
from waiting import until

import rlrobot_edu as rl
from rlrobot_course.drives.button import ASKS
from rlrobot_course.learner.my_course import PREFERENCES
from rlrobot_course.learner.saving import ASKED_FOR
from rlrobot_course.questions.old_questions import due
from rlrobot_edu.widgets.bias_explorer.words import amount, vector
from rlrobot_edu.widgets.driving.page import Keyboard
from rlrobot_edu.widgets.stepper.numerals import short

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"
PATIENCE = 300_000  # after so long a page hangs; a busy machine is not a fault [ms]
WIDTHS = (900, 1024, 1440, 1920)
DRIVEN = [
    f"{name}.ipynb"
    for name in (
        "00_start_here",
        "03_q_learning",
        "05_qbiassr",
        "11_wandering_robot",
        "14_sample_models",
    )
]
STOP_KERNELS = """async () => {
    const headers = {'X-XSRFToken': document.cookie.match('_xsrf=([^;]*)')[1]};
    for (const {id} of await (await fetch('/api/kernels')).json()) {
        await fetch('/api/kernels/' + id, {method: 'DELETE', headers});
    }
}"""
ANSWER = """() => [...document.querySelectorAll('.jp-Dialog')].map(dialog => {
    const words = dialog.innerText;
    [...dialog.querySelectorAll('.jp-Dialog-button')].at(-1).click();
    return words;
})"""
SEEN = """() => {
    const all = (what, how) => [...document.querySelectorAll(what)].map(how);
    return {
        kernel: document.querySelector('.jp-Toolbar-kernelName')?.textContent ?? 'No Kernel',
        status: document.querySelector('.jp-Notebook-ExecutionIndicator')?.dataset.status,
        prompts: all('.jp-CodeCell .jp-InputPrompt', prompt => prompt.textContent),
        dialogs: all('.jp-Dialog', dialog => dialog.innerText),
        failed: all('[data-mime-type="application/vnd.jupyter.stderr"]', output => output.innerText.slice(-500)),
    };
}"""
CUT_OFF = """() => [...document.querySelectorAll('.rl-stepper .line, .rl-stepper .line *')]
    .filter(e => e.scrollWidth > e.clientWidth + 1 && getComputedStyle(e).display !== 'inline' ||
        e.getBoundingClientRect().right > e.closest('.rl-stepper').getBoundingClientRect().right + 1)
    .map(e => e.textContent)"""
ALL_CELLS = {
    "@jupyterlab/notebook-extension:tracker": {"windowingMode": "none"}
}  # drawn, not only those in view


SAVED = """
import nbformat
from IPython.display import display

def show(name, i):
    for output in nbformat.read(f"{name}.saved", as_version=4).cells[i].outputs:
        if output.output_type == "stream":
            print(output.text, end="")
        else:
            display(dict(output.data), raw=True)
"""


def with_its_widgets_alone(notebook, name):
    """The notebook, in which cells without a part in a widget or a film show what they have saved: nbval runs them."""
    cells = [
        (i, cell) for i, cell in enumerate(notebook.cells) if cell.cell_type == "code"
    ]
    needed = set()
    for i, cell in reversed(cells):
        taken, given = names_in(cell.source)
        shows = (
            any("rlrobot_edu" in output.get("metadata", {}) for output in cell.outputs)
            or "Film(" in cell.source
        )
        shows = shows or "rl.watch(" in cell.source
        if given & needed or shows:
            needed = (needed - given) | taken
        else:
            cell.source = f"import saved\n\nsaved.show({name!r}, {i})"
        cell.outputs, cell.execution_count = [], None  # what has a number has run here
    return notebook


class Address(str):
    """Where a JupyterLab answers, and the folder that it serves."""

    def __new__(cls, text, folder):
        self = super().__new__(cls, text)
        self.folder = folder
        return self


@pytest.fixture(scope="module")
def lab(tmp_path_factory):
    """Address of a JupyterLab of its own, with copies of the notebooks; nothing of the user's is read or written."""
    home = tmp_path_factory.mktemp("lab")
    shutil.copytree(NOTEBOOKS.parent / "docs/pictures", home / "docs/pictures")
    lessons = home / "notebooks"
    lessons.mkdir()
    (lessons / "saved.py").write_text(SAVED, encoding="utf-8")
    for name in DRIVEN:
        shutil.copy(NOTEBOOKS / name, lessons / f"{name}.saved")
        nbformat.write(
            with_its_widgets_alone(nbformat.read(NOTEBOOKS / name, as_version=4), name),
            lessons / name,
        )
    folders = (
        "JUPYTER_CONFIG_DIR",
        "JUPYTER_RUNTIME_DIR",
        "JUPYTERLAB_SETTINGS_DIR",
        "JUPYTERLAB_WORKSPACES_DIR",
    )
    command = [
        sys.executable, "-m", "jupyterlab", "--no-browser", "--ip=127.0.0.1", "--port=0", "--allow-root",
        "--IdentityProvider.token=", f"--ServerApp.root_dir={home}", f"--LabApp.app_settings_dir={home}", ASKED_FOR,
    ]  # fmt: skip
    (home / "overrides.json").write_text(json.dumps(PREFERENCES | ALL_CELLS))
    with open(home / "log", "w") as log:
        server = subprocess.Popen(
            command, cwd=home, stdout=log, stderr=log,
            env=os.environ | {folder: str(home / folder.lower()) for folder in folders},
        )  # fmt: skip
    try:
        address = soon(
            lambda: (
                address_in(home)
                if server.poll() is None
                else pytest.fail((home / "log").read_text())
            )
        )
        yield Address(address, home)
    finally:
        server.terminate()
        try:
            server.wait(timeout=60)
        except subprocess.TimeoutExpired:
            server.kill()


def address_in(home):
    """The address that the server has written down, once it answers there: it looked for a free port itself."""
    with contextlib.suppress(OSError, ValueError, StopIteration):
        told = next((home / "jupyter_runtime_dir").glob("jpserver-*.json"))
        address = f"http://127.0.0.1:{json.loads(told.read_text())['port']}"
        urllib.request.urlopen(f"{address}/api", timeout=5).close()
        return address


def soon(look, rest=lambda: time.sleep(0.2)):
    """What `look` finds, once it finds anything."""
    end = time.monotonic() + PATIENCE / 1000
    while not (found := look()):
        assert time.monotonic() < end, "waited in vain"
        rest()
    return found


def is_error(said):
    """Whether a line of the browser's console is an error. JupyterLite's extension wants a service of its own site."""
    return (
        said.type == "error" and "jupyterlite" not in said.text + said.location["url"]
    )


@contextlib.contextmanager
def lesson(browser, lab, name, before=lambda page: None):
    """The page of a notebook all of whose cells have run, and a list that takes the errors of its programs.

    Any dialog of JupyterLab that lies over the page is answered (the kernel did not start; which one should it be?).
    A failure says which there were, and what was on the page. before: takes the page before it opens the notebook.
    """
    page, errors, dialogs = (
        browser.new_page(viewport={"width": 1400, "height": 1000}),
        [],
        [],
    )
    page.set_default_timeout(PATIENCE)
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on(
        "console", lambda said: errors.append(said.text) if is_error(said) else None
    )
    page.add_locator_handler(
        page.locator(".jp-Dialog").first,
        lambda: dialogs.extend(page.evaluate(ANSWER)),
        no_wait_after=True,
    )
    before(page)
    try:
        page.goto(f"{lab}/lab/tree/notebooks/{name}?reset")
        n_cells = sum(
            cell.cell_type == "code"
            for cell in nbformat.read(
                Path(lab.folder, "notebooks", name), as_version=4
            ).cells
        )
        soon(
            lambda: has_run_all(page, n_cells, dialogs, errors),
            rest=lambda: page.wait_for_timeout(1000),
        )
        yield page, errors
    except Exception as failure:
        seen = page.evaluate(SEEN) | {"answered dialogs": dialogs, "errors": errors}
        failure.add_note("\n".join(f"{what}: {found}" for what, found in seen.items()))
        raise
    finally:
        page.evaluate(STOP_KERNELS)
        page.close()


def has_run_all(page, n_cells, dialogs, errors):
    """Whether all cells have run. If nothing goes on, it runs them: what comes before the kernel may be lost.

    The indicator says idle before there is a kernel, too; cells that are run then may start another, and be lost.
    """
    new, seen = page.evaluate(ANSWER), page.evaluate(SEEN)
    dialogs.extend(new)
    # a folded cell has no number; one that is not folded comes after it
    have_run = [
        not prompt or bool(re.search("[0-9]", prompt)) for prompt in seen["prompts"]
    ]
    has_begun = any(re.search("[0-9]", prompt) for prompt in seen["prompts"])
    if (
        new and not has_begun
    ):  # one dialog may follow another, and widgets miss a kernel that comes after them
        page.reload()
        errors.clear()  # JupyterLab's own, about what it has just said in words
        return False
    assert "appears to have died" not in "".join(new), "the kernel died while cells ran"
    if sum(have_run) == n_cells:
        return True
    if len(have_run) < n_cells:
        return False
    if (
        seen["status"] == "idle"
        and seen["kernel"] != "No Kernel"
        and not any("*" in each for each in seen["prompts"])
    ):
        page.click("text=Run >> nth=0")
        page.click("text=Run All Cells")
    return False


def shown_q(page):
    """The numbers in the stepper's table of Q, as they are after the step; a dot, of what was never tried, is a 0."""
    cells = page.locator(".rl-stepper section.q td").all_text_contents()
    return [re.sub("[▲▼]|.* → ", "", cell).replace("·", "0") for cell in cells]


def press(page, button, expected):
    """Click a button of the stepper and wait for the step that it should show."""
    page.click(f".rl-stepper .rl-{button}")
    page.wait_for_function(
        f"document.querySelector('.rl-stepper .said span').textContent.startsWith('Step {expected} (')"
    )


def steps_forward_and_back(page, agent, at, folder):
    """Ten steps forward from step `at` and two back: the table on the page is that of `agent` at that step."""
    page.locator(".rl-stepper").scroll_into_view_if_needed()
    page.screenshot(path=folder / "before.png")
    for i in range(10):
        press(page, "step", at + 1 + i)
    for i in range(2):
        press(page, "back", at + 9 - i)
    task = rl.load_task("worked_example")
    rl.learn(agent, rl.make_env(task, seed=0), steps=at + 8, progress=False)
    assert shown_q(page) == [short(value) for value in agent.q.ravel()]
    page.screenshot(path=folder / "after.png")
    assert (folder / "after.png").read_bytes() != (folder / "before.png").read_bytes()


def looks_right(page, widget=".rl-stepper"):
    """At four widths: no equation is cut off, each picture says what it shows, and axe-core finds nothing serious."""
    axe = pytest.importorskip(
        "axe_playwright_python.sync_playwright", reason="needs axe-playwright-python"
    ).Axe()
    for width in WIDTHS:
        page.set_viewport_size({"width": width, "height": 900})
        page.wait_for_timeout(
            500
        )  # the page lays itself out anew, which may take longer
        page.locator(widget).first.scroll_into_view_if_needed()
        for _ in range(100):
            if not (cut := page.evaluate(CUT_OFF)):
                break
            page.wait_for_timeout(200)
        assert not cut, f"cut off at {width} pixels: {cut}"
    shown = "[...document.querySelectorAll('.jp-OutputArea-output img')]"
    mute = f"{shown}.filter(i => !i.alt && i.naturalWidth > 1).map(i => i.outerHTML.slice(0, 200))"
    assert page.evaluate(mute) == []
    found = axe.run(
        page, context=".jp-OutputArea-output", options={"resultTypes": ["violations"]}
    )
    serious = [
        each
        for each in found.response["violations"]
        if each["impact"] in ("serious", "critical")
    ]
    assert not serious, [
        (each["id"], [node["html"][:200] for node in each["nodes"]][:3])
        for each in serious
    ]


def test_lesson_03_steps_forward_and_back_and_shows_the_librarys_numbers(
    browser, lab, tmp_path
):
    with lesson(browser, lab, "03_q_learning.ipynb") as (page, errors):
        steps_forward_and_back(
            page, rl.Agent("worked_example", "Q+RANDOM", seed=0), 31, tmp_path
        )
        looks_right(page)
        assert errors == []


def test_lesson_05_explores_the_bias_of_any_state_and_any_table(browser, lab, tmp_path):
    with lesson(browser, lab, "05_qbiassr.ipynb") as (page, errors):
        cells = rl.load_task("worked_example")
        agent = rl.Agent(cells, "Q+SR", alpha=0.3, seed=131, loop_evasion=False)
        rl.learn(agent, rl.make_env(cells, seed=131), steps=158, progress=False)
        q = agent.q.copy()
        page.get_by_role("button", name=re.compile(r"^13\b")).click()
        expect_bias(page, q, 13)
        page.screenshot(path=tmp_path / "explorer.png")
        page.locator(".rl-fold", has_text="spin right").click()
        page.get_by_role("spinbutton", name="Q of state 19, spin right").fill("-20")
        page.keyboard.press("Enter")
        q[19, 2] = -20
        expect_bias(page, q, 13)
        page.get_by_role("button", name="Reset Q").click()
        expect_bias(page, agent.q, 13)
        looks_right(page, ".rl-bias")
        assert errors == []


def test_lesson_00_shows_a_robot_that_learns_in_the_cell_that_runs_it(browser, lab):
    asked = set()

    def listen(page):
        page.on("request", lambda request: asked.add(urlsplit(request.url)[:2]))

    with lesson(browser, lab, "00_start_here.ipynb", listen) as (page, errors):
        cell = page.locator(".jp-CodeCell", has_text="rl.watch(novice")
        cell.scroll_into_view_if_needed()
        until(view_in(cell), f"{LEARNED} && caption.textContent.startsWith('step 600')")
        assert errors == []
        addresses = {address for address in asked if address[0] in ("http", "ws")}
        assert addresses == {urlsplit(lab)[:2]}, (
            "a page from elsewhere, behind a proxy, could not see it"
        )

        saved = Path(lab.folder, "notebooks/00_start_here.ipynb")
        is_saved(page, saved)
        is_seen_again(page)  # its kernel tells
        is_saved(page, saved)
        page.evaluate(STOP_KERNELS)
        is_seen_again(page)  # the notebook has kept it


def test_lesson_11_shows_robots_that_move_to_this_computer_alone(browser, lab):
    with lesson(browser, lab, "11_wandering_robot.ipynb") as (page, errors):
        cell = page.locator(".jp-CodeCell", has_text="rl.watch(held")
        cell.scroll_into_view_if_needed()
        view = view_in(cell)
        until(view, "typeof viewer === 'object' && count >= 200")
        assert view.evaluate("body().position.length() > 0.5"), "the robot stands still"
        drawn = view.locator("#view canvas:not([id])").first
        picture = Image.open(io.BytesIO(drawn.screenshot()))
        assert len(picture.convert("RGB").getcolors(1_000_000)) > 20, (
            "the frame is empty"
        )

        assert errors == []
        ends_without_a_trace(page)


def is_saved(page, notebook):
    """Save the notebook, with the robot that is seen.

    JupyterLab saves by itself, too, perhaps before the robot is there.
    """
    earlier = notebook.stat().st_mtime_ns
    page.keyboard.press("Control+s")
    soon(
        lambda: (
            notebook.stat().st_mtime_ns > earlier
            and keeps_view(notebook, "rl.watch(novice")
        ),
        rest=lambda: page.wait_for_timeout(500),
    )


def keeps_view(notebook, code):
    """Whether a notebook holds the widget that the cell with this code shows; not while it is being written."""
    with contextlib.suppress(ValueError):
        kept = json.loads(notebook.read_text(encoding="utf-8"))
        (cell,) = [cell for cell in kept["cells"] if code in "".join(cell["source"])]
        views = [output.get("data", {}).get(VIEW) for output in cell["outputs"]]
        models = {view["model_id"] for view in views if view}
        widgets = kept["metadata"].get("widgets", {}).values()
        return bool(models) and any(models <= each["state"].keys() for each in widgets)
    return False


VIEW = "application/vnd.jupyter.widget-view+json"


def is_seen_again(page):
    """After the page is loaded anew the robot is there, with all that it has learned."""
    page.reload()
    cell = page.locator(".jp-CodeCell", has_text="rl.watch(novice")
    cell.scroll_into_view_if_needed()
    cell.locator("iframe").wait_for()
    until(view_in(cell), LEARNED)
    assert not page.get_by_text("model not found").count()


LEARNED = "typeof viewer === 'object' && count >= 600 && !!body()"


def view_in(cell):
    """The page of the view in 3D that a cell shows."""
    return (
        cell.locator('iframe[title="A robot in 3D"]')
        .first.element_handle()
        .content_frame()
    )


def ends_without_a_trace(page):
    """All that runs for the notebooks is for this computer alone; with the kernels ends what they have started."""
    ours = psutil.Process().children(recursive=True)
    listening, theirs = [], []
    for process in ours:
        with contextlib.suppress(psutil.NoSuchProcess):  # it has just ended
            listening += [
                c.laddr
                for c in process.net_connections()
                if c.status == psutil.CONN_LISTEN
            ]
            if "ipykernel_launcher" in " ".join(process.cmdline()):
                theirs += [process, *process.children(recursive=True)]
    assert listening and {address.ip for address in listening} <= {"127.0.0.1", "::1"}
    page.evaluate(STOP_KERNELS)
    assert theirs and not psutil.wait_procs(theirs, timeout=60)[1], (
        "something is left when the kernel has stopped"
    )


def test_lesson_14_takes_predictions_and_old_questions_and_films_a_robot_that_moves(
    browser, lab
):
    with lesson(browser, lab, "14_sample_models.ipynb") as (page, errors):
        cell = page.locator(".jp-CodeCell", has_text="Film(scenes, paid).show3d()")
        cell.scroll_into_view_if_needed()
        until(view_in(cell), "typeof viewer === 'object' && last === 49 && at > 1")
        answer = "nearly 10"
        click_until(page, answer, f"You say “{answer}”. Run on.")
        old = due("14")[0]
        click_until(page, old.right, f"✓ Right. {old.why}")
        assert errors == []
        ends_without_a_trace(page)


def click_until(page, button, told):
    """Click until the page says so: a button that a picture above it moves away under the mouse hears nothing."""

    def click():
        page.get_by_role("button", name=button).click()
        page.wait_for_timeout(3000)

    soon(page.get_by_text(told).is_visible, rest=click)


def expect_bias(page, q, s):
    """Wait until the explorer shows the bias that NumPy finds: for each input a mean along its axis."""
    shape, place = (2, 2, 3, 2), np.unravel_index(s, (2, 2, 3, 2))
    table = q.reshape(*shape, 3)
    means = [table.mean(axis=i)[place[:i] + place[i + 1 :]] for i in range(4)]
    shown = " ".join(amount(x) for x in np.transpose(means).flat)
    actions = "[...document.querySelectorAll('.rl-action')].sort((one, other) => one.dataset.a - other.dataset.a)"
    means_of = (
        "[...action.querySelectorAll('.rl-means data')].map((e) => e.textContent)"
    )
    numbers = f"{actions}.flatMap((action) => {means_of}).join(' ')"
    page.wait_for_function(f"{numbers} === '{shown}'")
    page.wait_for_function(
        f"document.querySelector('.said').textContent.includes('{vector(np.mean(means, axis=0))}')"
    )
    page.wait_for_function(
        f"document.querySelector('.said').textContent.startsWith('State {s} (')"
    )


def test_the_keys_of_the_pad_press_its_buttons_wherever_the_focus_is_in_it(browser):
    page = browser.new_page()
    page.set_content(
        '<div class="rl-drive"><button class="rl-action-8" title="ahead" onclick="window.n = (window.n ?? 0) + 1">↑'
        "</button><main></main></div>"
    )
    given = "{ actions: { ArrowUp: 8 }, told: 'the arrows' }"
    model = (
        f"{{ get: (name) => ({given})[name], on: (_, hear) => {{ answer = hear; }} }}"
    )
    page.add_script_tag(
        content=Keyboard._esm.replace(
            "export default", "window.answer = null; window.keyboard ="
        )
    )
    page.evaluate(
        f"keyboard.render({{ model: {model}, el: document.querySelector('main') }})"
    )
    page.wait_for_selector("[aria-label='↑: ahead']")
    page.focus("button")
    for _ in range(3):  # held: the kernel has not answered yet
        page.keyboard.down("ArrowUp")
    assert page.evaluate("n") == 1
    page.evaluate("answer()")
    page.focus(".rl-keys")
    page.keyboard.down("ArrowUp")
    page.keyboard.press("x")
    assert page.evaluate("n") == 2
    page.close()


WIDGETS = [
    """
import rlrobot_edu as rl
from rlrobot_edu.learning.progress import progress_bar
from rlrobot_edu.widgets.sliders import ParameterSliders

with progress_bar(3, shown=True, delay=0, desc="a bar") as bar:
    bar.update(3)
""",
    """
model = rl.SampleModel.from_recording(rl.read_recording("worked_example"))
ParameterSliders(model, steps=300, repetitions=2)
""",
    "rl.Stepper(rl.Agent('worked_example', seed=0), rl.make_env('worked_example'), at=5)",
]


@pytest.mark.parametrize("restarts", [False, True])
def test_a_notebook_that_was_saved_comes_back_whole(browser, lab, tmp_path, restarts):
    name = f"whole_{restarts}.ipynb"
    file = Path(lab.folder, "notebooks", name)
    cells = [nbformat.v4.new_code_cell(source) for source in WIDGETS]
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    metadata = {"kernelspec": kernel}
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata=metadata), file)
    with lesson(browser, lab, name) as (page, _):
        page.locator(".rl-stepper").wait_for()
        if restarts:
            page.click("text=Kernel >> nth=0")
            page.click("text=Restart Kernel…")
            page.locator(".jp-Notebook-ExecutionIndicator[data-status=idle]").wait_for()
        save(page, file)
        page.evaluate(STOP_KERNELS)
        page.reload()
        page.locator(".jp-OutputArea img, .rl-stepper").first.wait_for()
        page.wait_for_timeout(3000)  # widgets come after all else
        page.screenshot(path=tmp_path / "again.png")
        assert "Error displaying widget" not in page.inner_text(".jp-Notebook")
        shown = page.locator(".rl-stepper" if not restarts else ".jp-OutputArea img")
        assert shown.count()


WRONG = """
from rlrobot_course.lesson_03 import check

def target(q, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * min(q[s_next])

check.target(target)
"""


@pytest.mark.nightly
def test_the_button_below_a_red_card_shows_two_robots_that_drive(
    browser, lab, tmp_path
):
    file = Path(lab.folder, "notebooks", "red.ipynb")
    cell = nbformat.v4.new_code_cell(WRONG)
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    metadata = {"kernelspec": kernel}
    nbformat.write(nbformat.v4.new_notebook(cells=[cell], metadata=metadata), file)
    with lesson(browser, lab, file.name) as (page, errors):
        page.get_by_role("button", name=ASKS).click()
        cell = page.locator(".jp-CodeCell")
        cell.locator("iframe").first.wait_for()
        until(view_in(cell), "typeof viewer === 'object' && !!body()")
        page.screenshot(path=tmp_path / "driven.png")
        cell.locator("iframe").nth(1).wait_for()  # yours, and the right one
        assert page.get_by_role("button", name=ASKS).count() == 0, "pressed once"
        assert "By your code the robot earns" in page.inner_text(".jp-Notebook")
        assert not errors


def save(page, notebook):
    """Save the notebook, and wait until its file is new."""
    earlier = notebook.stat().st_mtime_ns
    page.keyboard.press("Control+s")
    soon(
        lambda: notebook.stat().st_mtime_ns > earlier,
        rest=lambda: page.wait_for_timeout(500),
    )
