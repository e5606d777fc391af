"""What helps to make a task and to understand an agent, and a look at the installation.

new_task.py      `new_task` writes a task file to begin with, from its robot's part of templates/
check_task.py    `check_task` lets the robot act, and reports what is worth a look: begin here
task_tables.py   the tables that it shows
trial.py         what it has seen: the robot at random, with one action for ever, and with an agent that learns
blind.py         a method that sees nothing: what it earns needs no looking
doctor.py        what is installed, what is missing, and what that disables
drawing.py       `draw_room` makes a room of characters: the scene of a task
commands.py      the commands of ``rlrobot-edu``
"""
