"""What the toolkit says of installing itself. While it has no public home, it is installed from a checkout alone.

Its home is `Source` in pyproject.toml's `[project.urls]`: without one, nobody may say that a package index has it.
"""

from importlib import metadata

NAME = "rlrobot-edu"


def source() -> str:
    """The address of the repository, or nothing while there is none."""
    try:
        lines: list[str] = metadata.metadata(NAME).get_all("Project-URL") or []
    except metadata.PackageNotFoundError:
        return ""
    for line in lines:
        label, _, address = line.partition(", ")
        if label == "Source":
            return address
    return ""


def to_install(extra: str, pip: str = "pip") -> str:
    """The command that installs an extra, and where it works. pip: how pip is called here"""
    if source():
        return f"{pip} install '{NAME}[{extra}]'"
    return f"{pip} install -e '.[{extra}]' in the toolkit's checkout"
