"""Handles: pictures of an idea that the reader moves, by sliders, a scrubber, switches and clicks.

handle.py   `Handle`: what a notebook shows; a page of its own by `save`
kit.js      the part that all handles share: controls, keys, the picture's frame
marks.js    bars, lines and letters of a picture
style.css   their look

Each lesson's handle is one program beside the lesson's figures, such as `lesson_02/gamma.js`, and a function that gives
it its numbers. A program is an object ``handle``; what it must have stands at the top of kit.js. Begin with gamma.js.
"""
