"""The bias explorer: which states influence a choice of QBIASSR, and how much.

Data
    bias.BiasNumbers       every number of QBIASSR in one state: sets, means, bias, and the choice without and with it
    marks.Mark             the sign and the colour of one input
    widget.ExplorerWidget  what a reader has chosen and edited
    explorer.BiasExplorer  what a notebook shows: one state in four columns, and the states to choose from

Begin with `bias`, which computes what is shown. `marks` and `words` define how states are marked and written, on the
page as in pictures. `still` draws the four columns as a picture, all or the first of them.

The page is a program of its own, in `page/`: bias.js computes a state's numbers with the kernels and puts them into
sentences; states.js draws the states, as a room where they are places of a robot; explorer.js draws the columns,
whose values the reader drags and edits. `widget` gives it the task and the tables. The same program is a widget in a
notebook and a file that needs no kernel.
"""
