"""All calls but readers: short programs, each line one call with good and bad values; `things` are their names."""

from __future__ import annotations

import re

from fuzz import things
from fuzz.contract import attempt
from fuzz.targets import Case, Target, lay, snapshot, unchanged
from fuzz.values import Text, lines

NAME = "program.py"
OWN = (
    "./again",
    "./out",
    "./pipe",
    "./transitions.csv",
    "./datapackage.json",
    "./folder/transitions.csv",
    "./folder/datapackage.json",
)  # what a program may write
STORE = re.compile(r"store='([^']+)'")  # a call's own store, whatever it is called
GIVEN = "  # given"  # ends a line that only prepares others: its errors are not the library's


def attack(case: Case) -> str:
    """Run a program line by line. It ends where something that was to get a name is refused."""
    names, answers = things.names(), {"accepted"}
    lay({"folder/file": b"x", "empty.npz": b"", "empty.py": b"", "empty.npy": b""})
    for line in case[NAME].decode().splitlines():
        code, before, given = (
            compile(line, "<program>", "exec"),
            snapshot(),
            line.endswith(GIVEN),
        )
        answer = attempt(lambda code=code: exec(code, names), given)
        stores = [f"./{name}" for name in STORE.findall(line)]
        unchanged(before, (*OWN, *stores))
        if answer == "accepted":
            continue
        if not given:
            answers.add(answer)
        if re.match(r"\w+ = ", line):
            break
    return max(answers, key=["accepted", "refused", "borrowed"].index)


def program(name: str, share: int, *strategies: Text | str) -> Target:
    """The target of such programs, of lines as these draw them."""
    return Target(
        name, lines(*strategies).map(lambda text: {NAME: text.encode()}), share, attack
    )


def given(text: Text) -> Text:
    """The same line, marked as one that only prepares others."""
    return text.map(lambda line: line and line + GIVEN)
