"""Handles in a browser: whatever can be moved moves by mouse and by keyboard, and nothing moves by itself."""

from __future__ import annotations

import pytest
from test_handles import HANDLES, PHONE


@pytest.fixture(scope="module")
def opened(browser, tmp_path_factory):
    """Opens a handle's page; it must ask for nothing but itself, and say nothing on the console."""
    folder = tmp_path_factory.mktemp("handles")
    pages, faults = [], []

    def opened(name, width=1280):
        file = folder / f"{name.replace(' ', '_')}.html"
        HANDLES[name]().save(file)
        page = browser.new_page(
            viewport={"width": width, "height": 900}, reduced_motion="reduce"
        )
        pages.append(page)
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.on("console", lambda said: faults.append(said.text))
        page.goto(file.as_uri())
        page.locator(".rl-finding").wait_for()
        return page

    yield opened
    for page in pages:
        page.close()
    assert faults == []


def seen(page) -> str:
    return page.locator(".rl-seen svg").inner_html()


@pytest.mark.parametrize("name", HANDLES)
def test_all_that_can_be_moved_moves_by_keyboard(opened, name):
    page = opened(name)
    for slider in page.locator(".rl-moved input[type=range]:visible").all():
        before = seen(page)
        slider.focus()
        for key in ("ArrowLeft", "ArrowRight", "ArrowRight"):
            page.keyboard.press(key)
        after = set()
        for key in ("Home", "End"):
            page.keyboard.press(key)
            after.add(seen(page))
        assert after != {before}
    for button in page.locator(".rl-moved button:visible").all():
        button.focus()
        page.keyboard.press("Enter")
        assert page.locator(".rl-finding").inner_text()
    assert not page.locator("[data-play]:visible").count()  # motion is reduced


@pytest.mark.parametrize("name", HANDLES)
def test_nothing_is_wider_than_a_phone(opened, name):
    page = opened(name, PHONE + 56)
    assert page.evaluate("document.documentElement.scrollWidth") <= PHONE + 56
    for part in page.locator(".rl-moved :is(button, input, select):visible").all():
        assert part.bounding_box()["height"] >= 27
