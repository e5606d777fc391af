"""What widgets are made of: the packages of the extra ``notebook``. Whoever makes a widget takes them from here."""

try:
    import anywidget as anywidget
    import ipywidgets as ipywidgets
    import traitlets as traitlets
    from IPython.display import display as display
except ImportError as missing:
    raise ImportError(
        f"widgets need {missing.name}: run pip install 'rlrobot-edu[notebook]'; everything else works without it"
    ) from None
