"""Widgets of a notebook; most of them are also pages of their own, which need no kernel.

stepper/        `rl.Stepper`: an agent's steps, forward and back
bias_explorer/  `BiasExplorer`: which states influence a choice of QBIASSR
playground/     `rl.playground`: a page in which a robot learns, with sliders
stage/          `rl.stage`: a page that shows whom a robot asks in a state that is new to it
driving/        `teleoperate`: a person drives the robot
watching.py     `rl.watch`: a robot that learns, in 3D
sliders.py      `ParameterSliders`: a learning curve for parameters that the reader sets

They share javascript/ (the kernels' source, translated for a page), kernels.py (the kernels as functions that return
their result), page_file.py (a page's program as one file), page_script.py (names of sliders for screen readers),
room_picture.py (a room in a notebook) and motions.py (the names and signs of motions). Begin with sliders.py, the
shortest.
"""
