"""What the robot does by a learner's own function, beside the right one; a red card offers it.

- `by_your_code`: a function is put in the place of the right one, and a robot drives by it for some steps;
- `worlds`: the world in which a loop of the learner's drives, and is filmed;
- `beside`: both drives as films, and what differs in a sentence;
- `button`: the button below the card;
- `mending`: films of a robot that is to be mended.

What a lesson's functions drive stands in the lesson's `drive.py`: its `drives` has a drive for each of them, by name.
"""
