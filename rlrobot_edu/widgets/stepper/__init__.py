"""The stepper: any agent in any environment, one step at a time, forwards and backwards.

Data
    tape.Frame            one step, and all that is needed to show it and to undo it
    tape.Change           the entries of a table that a step changed, their old and new values
    tape.Tape             the latest frames, and Q, e and visits at the position shown
    tape.EnvironmentView  a view of an environment: it looks now, gives the page its data, and is drawn later
    names.Names           the meaning of states and actions, in the words of the task
    tables.Window         the states and actions that fit into a picture
    cell_values.Mark      the value of a place in a robot's world
    widget.Stepper        what a notebook shows

Begin with `tape`, which records `rl.steps` and does not depend on the page. Two views of an environment follow
(`robot_view` with `cell_values`, `state_view`); `environment_view` chooses the better one. `still` draws a position as
a picture, with `still_tables`, `sentences` and `equations`; `code_view` shows the lines of the update rule;
`symbols` has the equations of each algorithm, `colours` are those of values.

The page is a program of its own, in `page/`: tape.js goes forwards and back, panes.js draws the view (with tables.js,
worlds.js and numerals.js), stepper.js reacts to the reader. `page_data` gives it the steps. If a page can compute the
world, `replay` gives it the kernels, and replay.js learns again from any step on; comparison.js shows both runs.
credit.js finds the rewards behind a value, with the updates of `credit_kernels`, and advice.js the states behind a
bias. The same program is a widget in a notebook (`widget`) and a file that needs no kernel; `saved_page` lists its
parts.
"""
