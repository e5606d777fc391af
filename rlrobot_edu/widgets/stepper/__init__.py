"""The stepper: any agent in any environment, one step at a time, forwards and backwards.

Data
    tape.Frame            one step, and all that is needed to show it and to undo it
    tape.Change           the entries of a table that a step changed, their old and new values
    tape.Tape             the latest frames, and Q, e and visits as they were at the position shown
    tape.EnvironmentView  what a view of an environment can do: look now, tell the page, be drawn later
    names.Names           what the numbers of states and actions mean, in the words of the task
    tables.Window         the states and actions that fit into a picture
    cell_values.Mark      what the agent thinks of a place in a robot's world
    widget.Stepper        what a notebook shows

Begin with `tape`, which records `rl.steps` and knows no page. Two views of an environment follow (`robot_view` with
`cell_values`, `state_view`; `environment_view` takes the best there is). `still` draws a position as a
picture, with `still_tables` and `equations`; `code_view` shows the lines of the
update rule; `symbols` has the text of each algorithm, `colours` are those of values.

The page is a program of its own, in `page/`: tape.js goes forwards and back, panes.js draws the view (with
tables.js, worlds.js and numerals.js), stepper.js is what the reader presses. `page_data` gives it the steps. Where a
page can compute the world, `replay` says how, and replay.js learns anew with the library's kernels, from any step on;
comparison.js shows both runs. credit.js says which rewards made a value, with the updates of `credit_kernels`, and
advice.js which states made a bias. The same program is a widget in a notebook (`widget`) and a file that needs no
kernel; `saved_page` lists its parts.
"""
