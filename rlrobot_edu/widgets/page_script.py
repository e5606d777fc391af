"""The page's own part beside the sliders of a widget."""

from __future__ import annotations

from rlrobot_edu.jupyter import anywidget


class NamedHandles(anywidget.AnyWidget):
    """Gives the handle of each slider in the box around it the slider's name, for screen readers.

    ipywidgets writes the name beside the slider, but leaves the handle without one.
    """

    _esm = """
    export default {
      render({ el }) {
        const name = () => {
          const sliders = el.closest(".widget-vbox")?.querySelectorAll(".widget-slider .noUi-handle") ?? [];
          if (!sliders.length) return setTimeout(name, 50); // they are not on the page yet
          for (const handle of sliders) {
            handle.setAttribute("aria-label", handle.closest(".widget-slider").querySelector("label").textContent);
          }
        };
        name();
      },
    };
    """
