"""What a person looks at: curves, pictures of a robot's scenes and films. Views in 3D are in in3d/,
the room that pages draw in room/.

Data types first:

Still      a picture as a file, with a sentence for readers who cannot see it (display.py)
Displayed  an object that a notebook shows as a widget and keeps as a still picture (display.py)
Picture    a matplotlib figure with a description in words (picture.py)
Film       the scenes of some steps and their rewards, a moving picture (film.py)

What they draw are scenes, see `rlrobot_edu.robots.scene`. Begin with top_down.py, the shortest way from a scene to a
picture; then, in this order:

palette.py   colours by what they stand for, which colour-blind readers can tell apart
style.py     how a figure looks: letters, lines, the finding above it
images.py    images as small files
display.py   what a notebook asks an object for
picture.py   figures, and the axes to draw on
ends.py      the names of curves at their ends
describe.py  what all views of scenes share: the path, a description in words
top_down.py  `plot_scene`, a scene from above; `Camera`, pictures of one room, one after another
film.py      `film`, a scene from above for each step, as a GIF
curves.py    `plot_learning`, learning curves
map_of_settings.py  what a method earns, over two of its parameters
"""
