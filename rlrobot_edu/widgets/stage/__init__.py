"""The stage: two robots learn in one room; one asks the states that are similar to its own, and the page shows whom.

Read in this order:

- `page`: ``rl.stage()``, which builds the page;
- `second_room`: the paper's four cells and a box, which the bias explorer shows;
- `honest`: what the page says of a hundred robots, from numbers.json, which studies/stage_numbers.py writes;
- `life.js`: two lives of an hour, by the library's kernels, and the moments at which a state was new;
- `view.js`: the room in 3D; `asking.js`: ghosts, ribbons and the arrow; `badge.js`: words in it;
- `page.html`, `style.css`: the looks; `page.js`: time, and the picture; `panel.js`: words, buttons and the link;
- `hands.js`: dragging, keys, and the beginning; `opening.png`: what a saved notebook keeps.

Kernels, walls and worlds are the playground's, and so is `theme.js`; colours and buttons are those of
`rlrobot_edu.show.room`; the chances come from the bias explorer's bias.js.
"""
