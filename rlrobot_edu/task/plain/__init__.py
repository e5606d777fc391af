"""Plain functions: rewards and goals that numba and JavaScript compute as Python does, to the last bit.

A task's ``reward(before, after)`` and ``goal(readings)`` are Python functions and may do anything. Those that are plain
are compiled for fast learning with ``engine="kinematic"``, and run in the pages of the playground and the stepper. All
others work too, in the plain loop; a message then names the line that is why. Plain is:

| what | how it is written |
|---|---|
| a reading | `after["laser_front"]`, or `after[name]` where `name` stands for a text |
| a number | `0.5`, `10`, `True` |
| a name for a number | `LIMIT`, `math.pi`, a default as in `def near(readings, limit=0.3)` |
| arithmetic | `a + b`, `a - b`, `a * b`, `a / b`, `-a`; whole numbers are floats, so all is below 2⁵³ |
| a comparison | `<`, `<=`, `>`, `>=`, `==`, `!=`, `low <= a < high`; as a number, true is 1 and false is 0 |
| a choice | `and`, `or`, `not`, `a if condition else b` |
| a limit | `abs(a)`, `min(a, b)`, `max(a, b)`, of more than two numbers, too |
| a root | `sqrt(a)` or `math.sqrt(a)` |
| rounding | `round(a)`, to a whole number; of two equally near ones it is the even one |
| a variable | `name = a`, `name += a` (also `-=`, `*=`, `/=`), `a, b = x, y` |
| other statements | `if`, `elif`, `else`, `return`, `pass`, a docstring |
| a helper | a plain function of your own; it takes readings, numbers and texts, by place or by name |

A division by 0 and a root of a number below 0 stop with Python's own error in each of the three. Nothing else is plain:
no power, shift or remainder, no other function, no list or array, no loop, no name that may have no value yet, no way
to the end without a return, nothing that is remembered from call to call. Instead of `hypot`, whose last bit differs
from one library to the next, tasks use `length` of `rlrobot_edu.task.rewards`.

`task_text` writes a task's functions, and `plain_text` any, as the text of a module (writer.py, statements.py,
expressions.py, names.py) with the arithmetic of arithmetic.py; source.py finds the text of a function, and makes sure
that it is what runs. `functions_of` makes Python's functions of the text.
"""

from rlrobot_edu.task.plain.source import NotPlainError
from rlrobot_edu.task.plain.writer import functions_of, plain_text, task_text

__all__ = ["NotPlainError", "functions_of", "plain_text", "task_text"]
