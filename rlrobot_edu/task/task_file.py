"""The file of a task: a small Python file with ``task = Task(...)``, and what it may not do."""

import sys
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from types import ModuleType

from rlrobot_edu.checks import (
    check_name,
    describe_error,
    did_you_mean,
    file_and_line,
)
from rlrobot_edu.files import sha256, shipped
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.task.task import Task


def available_tasks() -> list[str]:
    """The tasks that come with the toolkit.

    Returns
    -------
    list of str
        Their names, in alphabetical order; `load_task` takes each.
    """
    names = (path.stem for path in shipped("tasks").glob("[a-z]*.py"))
    # A "wander copy.py" is no task.
    return sorted(name for name in names if name.isidentifier())


@suggests_keywords
def load_task(task: str | Path | Task) -> Task:
    """The task of this name, or the one in this file.

    Parameters
    ----------
    task : str, Path or Task
        The name of a task that comes with the toolkit, or the path of your own Python file, which must define
        ``task = Task(...)``. It is one file: it cannot import its neighbours, because a task may also run in other
        places. A `Task` is returned unchanged.

    Returns
    -------
    Task
        With the `name`, `path` and `description` that its file gives it. A task that comes with the toolkit is the
        same one each time, unless its file has changed.

    Raises
    ------
    ValueError
        If there is no task of this name, or if something is wrong in the file; the message names file, line and
        mistake.
    FileNotFoundError
        If there is no such file.
    """
    if isinstance(task, Task):
        return task
    if not isinstance(task, str | Path):
        raise ValueError(
            f"a task is a Task, the name of one or the path of its file, not {task!r:.200}"
        )
    path = Path(task)
    is_own = path.suffix == ".py"
    if not is_own and (path.suffix or len(path.parts) > 1):
        if path.exists():
            raise ValueError(f"{path}: the name of a task's file ends in .py")
        raise _no_such_file(path)
    if not is_own:
        name = check_name(str(task), available_tasks(), "task", "the toolkit")
        path = shipped("tasks") / f"{name}.py"
    if not path.is_file():
        raise _no_such_file(path)
    # A file of the user's own is run each time, because its imports may have been edited, too.
    define = _task_of if is_own else _shipped_task
    return define(path, path.read_bytes())


def _no_such_file(path: Path) -> FileNotFoundError:
    """The error that suggests the nearest file of the same folder, or the nearest of the toolkit's tasks."""
    beside = [file.name for file in path.parent.glob("*.py")]
    nearest = did_you_mean(path.name, [*available_tasks(), *beside])
    return FileNotFoundError(f"{path}: there is no such task file{nearest}")


def _task_of(path: Path, text: bytes) -> Task:
    """The task that a file of this text defines."""
    module = ModuleType(f"rlrobot_edu_task_{path.stem}")
    module.__file__ = str(path)
    # only while it runs: there, dataclasses and pickle look for its classes
    sys.modules[module.__name__] = module
    try:
        # Not a regular import: that would keep bytecode next to the file and miss an edit made within the same second.
        exec(compile(text, str(path), "exec"), vars(module))
    except ValueError as error:
        # Most likely it is one of our own sentences, which needs no more words.
        raise ValueError(f"{file_and_line(path, error)}: {error}") from None
    except (Exception, SystemExit) as error:  # a task's file may raise anything
        raise ValueError(
            f"{file_and_line(path, error)}: {describe_error(error)}"
        ) from error
    finally:
        sys.modules.pop(module.__name__, None)
    defined: object = getattr(module, "task", None)
    if not isinstance(defined, Task):
        raise ValueError(
            f"{path}: the file must define task = Task(...), found {defined!r:.200}"
        )
    # Version control may change the ends of lines: they do not count.
    fingerprint = sha256(text.replace(b"\r\n", b"\n"))
    description = str(module.__doc__ or "").strip()
    return replace(
        defined,
        name=path.stem,
        path=str(path),
        description=description,
        fingerprint=fingerprint,
    )


_shipped_task = lru_cache(_task_of)
