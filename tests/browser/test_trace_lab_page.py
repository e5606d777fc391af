"""The trace lab in a browser: a path is drawn by the mouse and by the keyboard."""

import pytest

from rlrobot_course.lesson_07.handles import traces_on_a_path


@pytest.fixture
def page(browser, tmp_path):
    traces_on_a_path().save(tmp_path / "lab.html")
    page = browser.new_page(reduced_motion="reduce")
    page.goto((tmp_path / "lab.html").as_uri())
    yield page
    page.close()


def finding(page) -> str:
    return page.locator(".rl-finding").inner_text()


def test_a_path_is_drawn_by_the_mouse(page):
    page.get_by_role("button", name="clear").click()
    for cell in "CBA":
        page.locator(f'[data-pick="{cell}"]').click()
    assert finding(page) == "Step 2 teaches 2 cells: B most, +1.00, and C least, +0.81"
    page.get_by_role("button", name="undo").click()
    assert finding(page) == "Step 1 teaches nothing, for δ = 0; one cell has a trace"


def test_a_path_is_drawn_by_the_keyboard(page):
    page.get_by_role("button", name="clear").press("Enter")
    for cell in "CBA":
        page.locator(f'[data-pick="{cell}"]').focus()
        page.keyboard.press("Enter")
        assert page.evaluate("document.activeElement.dataset.pick") == cell
    assert finding(page).startswith("Step 2 teaches 2 cells")
