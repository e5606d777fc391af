"""What JupyterLab does when it saves a notebook: a widget that is not saved with it gives way to its picture."""

from typing import Any

VIEW = "application/vnd.jupyter.widget-view+json"
STATE = "application/vnd.jupyter.widget-state+json"
# For the command line of JupyterLab: its server calls the function below before it writes a file.
ASKED_FOR = f"--ContentsManager.pre_save_hook={__name__}.drop_dead_views"


def drop_dead_views(model: dict[str, Any], **_: object) -> None:
    """Take out of a notebook's outputs the views of widgets whose state is not saved with it.

    A restart of the kernel ends all widgets. JupyterLab would show an error in place of each when the notebook is
    opened again, although a picture stands in the same output.

    model: what is saved, as Jupyter's servers describe it to a `pre_save_hook`
    """
    _drop(model, everywhere=True)


def drop_where_a_picture_is(model: dict[str, Any], **_: object) -> None:
    """As `drop_dead_views`, but only where a page stands beside the view: so for the notebooks of everybody.

    model: as for `drop_dead_views`
    """
    _drop(model, everywhere=False)


def _drop(model: dict[str, Any], *, everywhere: bool) -> None:
    if model["type"] != "notebook":
        return
    for output in dead_views(model["content"]):
        if everywhere or "text/html" in output["data"]:
            del output["data"][VIEW]


def _jupyter_server_extension_points() -> list[dict[str, str]]:
    """Where a Jupyter server finds the function below; the wheel asks it to, in jupyter.json."""
    return [{"module": __name__}]


def _load_jupyter_server_extension(server: Any) -> None:
    """Let the server call the function above before it writes a notebook."""
    server.contents_manager.register_pre_save_hook(drop_where_a_picture_is)


def dead_views(notebook: dict[str, Any]) -> list[dict[str, Any]]:
    """The outputs of a notebook that show a widget whose state is not in the notebook."""
    saved = notebook["metadata"].get("widgets", {}).get(STATE, {}).get("state", {})
    found = []
    for cell in notebook["cells"]:
        for output in cell.get("outputs", []):
            view = output.get("data", {}).get(VIEW)
            if view is not None and view["model_id"] not in saved:
                found.append(output)
    return found
