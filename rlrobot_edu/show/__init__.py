"""What a person looks at: curves, pictures of a robot's scenes and films.

painting/ paints what is kept, room/ draws on pages, and in3d/ is the live view, meshcat.

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
numerals.py  how pictures write numbers
ends.py      the names of curves at their ends
describe.py  what all views of scenes share: the path, what is a loss, a description in words
story.py     what a film tells: its title, the steps that tell most, a caption for each
top_down.py  `plot_scene`, a scene from above
film_card.py  films on a page: words, moving pictures, a pause, the key
film.py      `film`, a scene for each step, as a GIF and in 3D
curves.py    `plot_learning`, learning curves
map_of_settings.py  what a method earns, over two of its parameters
"""
