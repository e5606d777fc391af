"""What widgets are made of: the packages of the extra ``notebook``. Whoever makes a widget takes them from here."""

from rlrobot_edu.installing import to_install

try:
    import anywidget as anywidget
    import ipywidgets as ipywidgets
    import traitlets as traitlets
    from IPython.display import display as display
except ImportError as missing:
    raise ImportError(
        f"widgets need {missing.name}: run {to_install('notebook')}; everything else works without it"
    ) from None
