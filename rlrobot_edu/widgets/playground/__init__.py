"""The playground: a page of its own in which a robot learns, with sliders; it needs neither Python nor a network.

Read in this order:

- `page`: ``rl.playground()``, which builds the page;
- `worlds`: the worlds as data, one of them the `cliff`;
- `kernels`: the library's kernels, as JavaScript (see `rlrobot_edu.widgets.javascript`);
- `script`: kernels, worlds and luck as one program, also for the stage;
- `new_simulation.js`: a simulation of given settings; `rlrobot_edu/widgets/javascript/simulation.js`: its steps;
- `run.js`: a simulation with its score and its floor; `walls.js`: walls inside a room;
- `page.html`, `style.css`: the looks; `picture.js` (with `rlrobot_edu/show/room`), `cells.js` and `curve.js` draw it;
- `page.js`: time, and words; `numbers.js`: numbers with the decimals that they need;
- `settings.js`: sliders and the link; `pointer.js`: dragging; `buttons.js`: buttons;
- `theme.js`: colours and height within another page; `host_page.js`: the part of that page;
  `page_frame`: the frame in a notebook.
"""
