"""The bias explorer: which states have a say in a choice of QBIASSR, and how much.

Data
    bias.BiasNumbers      every number of QBIASSR in one state: sets, means, bias, and the choice without and with it
    marks.Mark            the sign and the colours of one input
    states.Place          where a state stands among the others
    explorer.BiasExplorer the widget: all states as buttons, and what follows from the one that was clicked

Begin with `bias`, which says what is shown. `marks` and `states` say how states are marked, written and placed, on the
page and in pictures alike. Three parts make the page: `state_buttons`, `member_table` (to edit Q) and the formulas of
`panes`. `still` draws the same as a picture, `saved_page` writes all states to a page that needs no kernel,
and `explorer` puts all of it together.
"""
