"""The trace lab of lessons 07 and 08: a path over a small grid that the reader draws, and what each cell learns.

kernels.py  the updates, step by step over a whole path; a page runs them as JavaScript
lab.py      `trace_lab`: the grid, the paths that it offers, and the handle
still.py    the picture that a saved notebook keeps
lab.js      what can be moved, what it computes, and what it says
grid.js     how the cells are drawn

One pair a cell: as in lesson 07's corridor, the only action is "go on". Two places pay: A pays 10 to a step that leads
into it, E takes 2. A step may also lead back into its own cell.
"""
