"""What a class has misunderstood: the mistakes that were recognised, counted over all notebooks; a page and a table."""

from __future__ import annotations

import csv
import io
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from html import escape
from typing import NamedTuple

from rlrobot_edu.course.homework.marks import Marked, Score
from rlrobot_edu.course.homework.rooms import room_of

STYLE = """
:root { color-scheme: light dark; --back: #fff; --ink: #111; --pale: #bbb; --bar: #0072b2 }
@media (prefers-color-scheme: dark) { :root { --back: #000; --ink: #fff; --pale: #666; --bar: #56b4e9 } }
body { font: 16px/1.45 sans-serif; margin: 1em auto; max-width: 60em; padding: 0 1em }
body { color: var(--ink); background: var(--back) }
table { border-collapse: collapse; width: 100% }
th, td { text-align: left; vertical-align: top; padding: .3em .8em .3em 0; border-bottom: 1px solid var(--pale) }
td.n { width: 9em; white-space: nowrap }
td.n i { display: inline-block; height: .8em; background: var(--bar); margin-right: .5em }
code { white-space: nowrap }
""".strip()

HEAD = "".join(f'<th scope="col">{words}</th>' for words in ("how many", "mistake", "what they were told"))


class Misunderstood(NamedTuple):
    """A mistake in an exercise: in a word or two, the hint that was given, and the notebooks that made it."""

    lesson: str
    exercise: str
    mistake: str
    hint: str
    notebooks: list[str]


def misunderstood(marked: Sequence[Marked]) -> list[Misunderstood]:
    """All mistakes, exercise by exercise in the order of the lesson, the most frequent first."""
    made: dict[tuple[str, str], dict[str, list[tuple[str, str]]]] = defaultdict(lambda: defaultdict(list))
    for one in marked:
        for score in one.scores:
            by_mistake = made[one.lesson, score.exercise]
            if not score.is_right:
                by_mistake[score.reason].append((one.name, score.hint))
    return [
        Misunderstood(lesson, exercise, mistake, _most_told(told), [name for name, _ in told])
        for (lesson, exercise), by_mistake in made.items()
        for mistake, told in sorted(by_mistake.items(), key=lambda item: (-len(item[1]), item[0]))
    ]


def _most_told(told: Sequence[tuple[str, str]]) -> str:
    """The hint that most of them got; some name a number of the learner's, and differ."""
    hints = Counter(hint for _, hint in told if hint)
    return hints.most_common(1)[0][0] if hints else ""


def as_table(marked: Sequence[Marked]) -> str:
    """CSV: a line for each mistake, with the notebooks that made it."""
    file = io.StringIO()
    table = csv.writer(file, lineterminator="\n")
    table.writerow(["lesson", "exercise", "mistake", "how many", "hint", "notebooks"])
    for lesson, exercise, mistake, hint, notebooks in misunderstood(marked):
        table.writerow([lesson, exercise, mistake, len(notebooks), hint, " ".join(notebooks)])
    return file.getvalue()


def as_page(marked: Sequence[Marked]) -> str:
    """An HTML page that can be shown to a class: it names no one."""
    title = f"What was misunderstood, in {len(marked)} notebook{'s' * (len(marked) != 1)}"
    head = '<meta charset="utf-8"><meta name="viewport" content="width=device-width">'
    body = f"<main><h1>{title}</h1>\n{''.join(_sections(marked))}</main>"
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head>{head}<title>{title}</title><style>{STYLE}</style></head>\n'
        f"<body>{body}</body></html>\n"
    )


def _sections(marked: Sequence[Marked]) -> Iterator[str]:
    """A section for each exercise."""
    found = misunderstood(marked)
    answers: dict[tuple[str, str], list[Score]] = defaultdict(list)
    for one in marked:
        for score in one.scores:
            answers[one.lesson, score.exercise].append(score)
    for (lesson, exercise), scores in answers.items():
        right = sum(score.is_right for score in scores)
        room = room_of(lesson).replace("_", " ") if lesson else "no lesson"
        yield f"<h2>{escape(room)}: <code>{escape(exercise)}</code>, {right} of {len(scores)} right</h2>\n"
        mistakes = [each for each in found if (each.lesson, each.exercise) == (lesson, exercise)]
        if mistakes:
            rows = "".join(_row(each, len(scores)) for each in mistakes)
            yield f"<table><tr>{HEAD}</tr>{rows}</table>\n"


def _row(one: Misunderstood, of: int) -> str:
    n = len(one.notebooks)
    bar = f'<td class="n"><i style="width:{5 * n / of:.2f}em"></i>{n} of {of}</td>'
    return f"<tr>{bar}<td>{escape(one.mistake)}</td><td>{escape(one.hint)}</td></tr>\n"
