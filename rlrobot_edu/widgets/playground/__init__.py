"""The playground: a page of its own in which a robot learns, with sliders; it needs neither Python nor a network.

Read in this order:

- `playground`: ``rl.playground()``, which puts the page together;
- `worlds`: the worlds as data, one of them the `cliff`;
- `kernels`: the library's kernels, as JavaScript (see `rlrobot_edu.widgets.javascript`);
- `start.js`: a life of given settings; `rlrobot_edu/widgets/javascript/life.js`: how it goes on;
- `run.js`: a life with its score and its floor; `walls.js`: walls inside a room;
- `page.html`, `style.css`: the looks; `room.js`, `cells.js` and `curve.js` draw it;
- `page.js`: time, and words; `settings.js`: sliders and the link; `hands.js`: what is dragged; `begin.js`: buttons;
- `look.js`: colours and height within another page; `around.js`: the part of that other page; `framed`: a notebook's.
"""
