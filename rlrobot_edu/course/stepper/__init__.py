"""The stepper: any agent in any environment, one step at a time, forwards and backwards.

Data
    tape.Frame            one step, and all that is needed to show it and to undo it
    tape.Change           the entries of a table that a step changed, their old and new values
    tape.Tape             the latest frames, and Q, e and visits as they were at the position shown
    tape.EnvironmentView  what a view of an environment can do: look now, be drawn later
    names.Names           what the numbers of states and actions mean, in the words of the task
    tables.Window         the states and actions that fit on the page
    cell_values.Mark      what the agent thinks of a place in a robot's world
    equations.Update      the equations of one step, as Terms: a symbol and the number that stands below it
    stepper.Stepper       the widget: controls, and the view of a tape

Begin with `tape`, which records `rl.steps` and knows no page. Three views of an environment follow (`robot_view`
with `cell_values`, `grid_view`, `state_view`; `environment_view` takes the best there is); `colours` are those of all
values. Then the page: `equations`, `tables` and `code_view` fill the panes of `panes`; `style` has their looks, and
`script` is the keyboard and what else the page does by itself. `still` draws the same as a picture, with
`still_tables`. `controls` holds what the reader presses and moves, `player` goes forward by itself, `saved_page` writes
the steps to a page that needs no kernel, and `stepper` puts all of it together.
"""
