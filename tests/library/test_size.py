"""What a reader feels: no tricks, files of one sitting, folders that say what is in them, and a page that is true."""

import ast
import textwrap
from pathlib import Path

import pytest
import size
import tricks

ROOT = Path(__file__).parents[2]
SOURCES = size.sources(*size.PACKAGES)
MOST_LINES_OF_A_FILE = 260
# How often each kind still occurs. Lower a number when you have rewritten a place; a new place is written without.
LEFT = {
    "walrus": 39,
    "writing through vars()": 19,
    "text or list times a truth value": 13,
    "conditional within a conditional": 19,
    "unpacked generator or map": 50,
    "call of a conditional": 1,
}


@pytest.mark.parametrize("kind", tricks.FORBIDDEN)
def test_no_new_trick_comes(kind):
    places = tricks.places_of(kind, SOURCES)
    if len(places) > LEFT[kind]:
        listed = "\n".join(places)
        pytest.fail(
            f"{kind}: {len(places)} places, {LEFT[kind]} before. Write the new one as a plain statement:\n{listed}"
        )


@pytest.mark.parametrize(
    ("kind", "code"),
    [
        ("walrus", "if (n := len(x)) > 3: pass"),
        ("writing through vars()", "vars(self)['n'] = 3"),
        ("writing through vars()", "vars(self).update(n=3)"),
        ("text or list times a truth value", "name + ', all' * (n > 3)"),
        ("text or list times a truth value", "[x] * bool(x)"),
        ("conditional within a conditional", "1 if a else 2 if b else 3"),
        ("unpacked generator or map", "[*map(int, x)]"),
        ("unpacked generator or map", "f(*(a for a in x))"),
        ("call of a conditional", "(f if x else g)(3)"),
        ("nested comprehension, or with two for", "[a for b in x for a in b]"),
        ("nested comprehension, or with two for", "[[a for a in b] for b in x]"),
    ],
)
def test_a_trick_is_seen(tmp_path, kind, code):
    file = tmp_path / "code.py"
    file.write_text(code)
    assert tricks.tricks_in([file])[kind] == 1
    assert tricks.places_of(kind, [file]) == [f"{file}:1"]


def test_plain_code_has_no_trick(tmp_path):
    file = tmp_path / "code.py"
    plain = """
        n = len(x)
        name = "all" if n > 3 else "some"
        rows = [3 * "ab", 2 * [0.0], *x, *sorted(x)]
        vars(self)
    """
    file.write_text(textwrap.dedent(plain))
    assert not tricks.tricks_in([file])


def test_comments_docstrings_and_blanks_are_no_code():
    code = '"""Say something."""\n\n# why\nx = f(1,\n      2)\n'
    assert [token.string for token in size.tokens_of_code(code)] == list("x=f(1,2)")
    assert size.lines_of_code(code) == 2
    assert size.statements(code) == 1
    assert size.statements("a, b = 1, 2\n") == 2


def test_a_file_is_read_in_one_sitting():
    lines = {
        str(path.relative_to(ROOT)): size.lines_of_code(
            path.read_text(encoding="utf-8")
        )
        for path in SOURCES
    }
    long = {name: n for name, n in lines.items() if n > MOST_LINES_OF_A_FILE}
    assert not long, "split it by what it does"


def test_the_page_of_sizes_is_up_to_date():
    written = (ROOT / "docs/howto/size.md").read_text(encoding="utf-8")
    assert written == size.page(), "run `make size`"


def test_every_folder_says_what_is_in_it():
    silent = []
    for path in SOURCES:
        if path.name == "__init__.py":
            text = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""
            if len(text.split()) < 3 or "TODO" in text:
                silent.append(str(path.relative_to(ROOT)))
    assert not silent
