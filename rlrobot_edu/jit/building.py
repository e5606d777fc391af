"""Put kernels together: the text of a template, and after it the parts that take the place of its own.

A template is an ordinary module whose kernels call a few parts by name. Its text is written to a small module in a
cache folder, followed by a line for each part, such as ``from rlrobot_edu.learning.algorithms.sarsa import update``.
From then on it is a module like any other, and numba keeps on disk what it compiles there. numba looks for a change
in that one file alone, so its name holds a hash of the sources of all packages that it imports from.

A function of somebody's own is imported, too, and compiled as own.py says. One that no module can import, such as that
of a notebook's cell, is put in its place in memory. Then nothing is kept, and the next process compiles again.
"""

import importlib.util
import linecache
import sys
import tempfile
import threading
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import cache
from itertools import count
from pathlib import Path
from types import ModuleType
from typing import Any, cast

from rlrobot_edu.files import remove_old, sha256, write_whole
from rlrobot_edu.jit import call
from rlrobot_edu.jit.dispatcher import FOLDER, PACKAGE, is_ours
from rlrobot_edu.jit.fingerprint import code_of
from rlrobot_edu.jit.own import in_numba, in_python

Build = Callable[..., ModuleType]  # (template, **parts) -> its kernels, as `build`
ROOM = 2**22  # for what numba keeps of one module [bytes]
UNUSED = 30 * 24 * 3600  # age at which built modules go [s]
_one_thread = threading.RLock()  # a module that another one is making is not whole
_numbers = count()  # of the modules that are in memory alone


def build(template: ModuleType, **parts: Any) -> ModuleType:
    """The kernels of a template with other parts.

    template: the module
    parts: by their names in the template: kernels, somebody's own functions, or values such as True
    """
    # to somebody's own function a name may mean something else by now
    own = [part for part in parts.values() if callable(part) and not is_ours(part)]
    return _build(template, tuple(map(code_of, own)), **parts)


@cache
def _build(template: ModuleType, codes: tuple[str, ...], **parts: Any) -> ModuleType:
    """See `build`; `codes`: what somebody's own parts are made of now."""
    text = Path(str(template.__file__)).read_text(encoding="utf-8")
    if not all(map(can_be_imported, parts.values())):
        made = {
            name: in_numba(part) if callable(part) else part
            for name, part in parts.items()
        }
        return in_memory(template.__name__, text, made)
    lines = [line for name, part in parts.items() for line in lines_of(name, part)]
    packages = {
        part.__module__.partition(".")[0]
        for part in parts.values()
        if callable(part) and is_ours(part)
    }
    return module_of(template.__name__, "\n".join([text, *lines, ""]), packages)


def module_of(name: str, text: str, packages: Iterable[str] = ()) -> ModuleType:
    """The module of this text, in the cache folder if that can be.

    name: how its name begins; packages: what it imports from besides this one
    """
    if FOLDER is not None:
        with suppress(OSError):  # no room, say: the next process compiles it again
            return _on_disk(name, text, packages)
    return in_memory(name, text, {})


@cache
def for_python(kernel: Callable[..., Any]) -> Callable[..., Any]:
    """The kernel as Python calls it: kept on disk. What is not compiled stays as it is."""
    if not hasattr(kernel, "py_func"):
        return kernel
    return cast(Callable[..., Any], build(call, kernel=kernel).call)


def can_be_imported(part: Any) -> bool:
    """Whether lines of Python stand for this part: a value, or a function by its module and name."""
    if not callable(part):
        return True
    module = sys.modules.get(part.__module__)
    is_there = getattr(module, part.__name__, None) is part
    return is_there and part.__module__ != "__main__"


def lines_of(name: str, part: Any) -> list[str]:
    """The lines of Python after which `name` stands for this part."""
    if not callable(part):
        return [f"{name} = {part!r}"]
    imported = f"from {part.__module__} import {part.__name__} as {name}"
    if is_ours(part):
        return [imported]
    # its code, and all that it refers to, as a name: after an edit this is another module
    return [
        f"{imported}  # {code_of(part)}",
        "from rlrobot_edu.jit.own import in_numba",
        f"{name} = in_numba({name})",
    ]


def _on_disk(name: str, text: str, packages: Iterable[str]) -> ModuleType:
    assert FOLDER is not None
    versions = [sources_of(each) for each in sorted({PACKAGE.name, *packages})]
    digest = sha256("\n".join([text, *versions]).encode())[:16]
    # its package's name comes first, so it counts as the toolkit's
    name = f"{name}_{digest}"
    path = FOLDER / f"{name}.py"
    with _one_thread:
        if name not in sys.modules:
            if not path.exists():
                _write(path, text)
            _load(name, path)
        return sys.modules[name]


def _write(path: Path, text: str) -> None:
    """Write a built module. Raises OSError if there is no room for it and for what numba will keep of it."""
    remove_old(path.parent.rglob("*.*"), UNUSED)
    with tempfile.TemporaryFile(dir=path.parent) as file:
        file.write(bytes(ROOM))
    write_whole(path, text)


def _load(name: str, path: Path) -> None:
    """Import a built module."""
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None and spec.loader is not None
    sys.modules[name] = importlib.util.module_from_spec(spec)  # numba looks there
    try:
        spec.loader.exec_module(sys.modules[name])
    except BaseException:
        del sys.modules[name]
        raise


@cache
def sources_of(package: str) -> str:
    """Hash of the sources of a package, as they are now."""
    folder = Path(str(sys.modules[package].__file__)).parent
    texts = [
        path.read_bytes()
        for path in sorted(folder.rglob("*.py"))
        if "__pycache__" not in path.parts
    ]
    return sha256(b"\0".join(texts))


def in_memory(name: str, text: str, parts: dict[str, Any]) -> ModuleType:
    """The module of this text, with these parts in their places; `name`: how its name begins."""
    module = ModuleType(f"{name} {next(_numbers)}")
    file = f"<{module.__name__}>"
    # where Python, and those who read a function's source, look for its lines
    linecache.cache[file] = len(text), None, text.splitlines(keepends=True), file
    exec(compile(text, file, "exec"), vars(module))
    for part_name, part in parts.items():
        setattr(module, part_name, part)
    return module


def build_in_python(template: ModuleType, **parts: Any) -> ModuleType:
    """As `build`, but nothing is compiled: slow, and Python says in which line an error arose."""
    text = Path(str(template.__file__)).read_text(encoding="utf-8")
    module = in_memory(template.__name__, text, parts)
    for name, thing in [*vars(module).items()]:
        is_function = callable(thing) and hasattr(thing, "__code__")
        is_kernel = hasattr(thing, "py_func")
        if is_function or is_kernel:
            setattr(module, name, in_python(thing))
    return module
