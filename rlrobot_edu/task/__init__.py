"""What a robot senses, does and is rewarded for: all that defines a learning problem, in words and units.

The data, each in the words of those before it:

InputVariable, OutputVariable   a sensor and its bins, an actuator and its values (variables.py)
Bin                             one interval of an input variable (variables.py)
StateSpace, ActionSpace         all combinations of bins, of values, each with its number (spaces.py)
Quantity, RobotCard             a sensor's or a command's unit and range; what a robot can sense and do (robot_cards.py)
Task                            inputs, outputs, reward and the robot: the learning problem (task.py)

`Room` is a room of one's own, for a robot on wheels (room.py); `tools/drawing.py` draws one with characters.

The functions: `load_task` reads a task from its file, `available_tasks` names those that come along (task_file.py).
Task files share rewards.py and wheel_commands.py. Rewards and goals that are plain functions (plain/) are compiled for
fast learning, and run in pages.

Begin with ``tasks/wander_simple.py``, which is a whole task on one page; then variables.py, spaces.py, task.py.
"""
