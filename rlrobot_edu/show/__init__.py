"""What a person looks at: curves, pictures of a robot's scenes and films. Views in 3D are in in3d/.

Data types first:

Still      a picture as a file, with a sentence for readers who cannot see it (display.py)
Displayed  what a notebook shows as its widget, and keeps as its still twin (display.py)
Picture    a matplotlib figure that says in words what it shows (picture.py)
Film       the scenes of some steps and their rewards, a moving picture (film.py)

What they draw are scenes, see `rlrobot_edu.robots.scene`. Begin with top_down.py, the shortest way from a scene to a
picture; then, in this order:

palette.py   colours by what they stand for, told apart by colour-blind readers
display.py   what a notebook asks an object for
picture.py   figures, and the axes to draw on
describe.py    what every view of scenes needs: the path, a description in words
top_down.py  `plot_scene`, a scene from above; `Camera`, pictures of one room, one after another
film.py      `film`, a scene from above for each step, as a GIF
curves.py    `plot_learning`, learning curves
"""
