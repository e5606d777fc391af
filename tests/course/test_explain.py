"""`rlrobot-edu course explain` says which detectors have looked at an answer, and which have spoken."""

from __future__ import annotations

import pytest

from rlrobot_course.authoring.explain import explain

ANSWER = """
def target(q, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * max(q[s_next]) / 2
"""


def test_each_detector_has_a_line_for_a_function(tmp_path):
    (tmp_path / "answer.py").write_text(ANSWER)
    told = explain("03", "target", str(tmp_path / "answer.py"))
    assert "known_mistake: nothing" in told and "wrong in the cases 1, 2, 4" in told
    assert "one_change: it answers as if “gamma * max(q[s_next])” were halved." in told
    (tmp_path / "answer.py").write_text("def target(*_):\n    return 1 / 0")
    assert "no detector looks at an answer that fails" in explain(
        "03", "target", str(tmp_path / "answer.py")
    )


def test_a_value_is_explained_by_its_mistakes_and_by_the_formula():
    told = explain("03", "q_by_hand", "15.4")
    assert (
        "mistake target_itself: this is the target itself" in told
        and "formula: it is as if" in told
    )
    assert "form, formula: nothing" in explain("03", "q_by_hand", "1234.5")
    assert "form: is it spelled" in explain("05", "best_adviser", "flor")


@pytest.mark.parametrize(("words", "told"), [
    (("99", "update", "1"), "lesson '99' has no exercises"), (("03", "updat", "1"), "there are q_by_hand, target"),
    (("03", "update", "none.py"), "none.py is no file"),
])  # fmt: skip
def test_what_cannot_be_explained_is_told_in_a_sentence(words, told):
    with pytest.raises(ValueError, match=told):
        explain(*words)
