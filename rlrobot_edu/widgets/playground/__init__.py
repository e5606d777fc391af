"""The playground: a page of its own in which a robot learns, with sliders; it needs neither Python nor a network.

Read in this order:

- `playground`: ``rl.playground()``, which puts the page together;
- `worlds`: the worlds as data, one of them the `cliff`;
- `kernels`: the library's kernels, as JavaScript (see `rlrobot_edu.widgets.javascript`);
- `start.js`: a life of given settings; `rlrobot_edu/widgets/javascript/life.js`: how it goes on;
- `page.html`, `style.css`: what there is to see; `pictures.js` draws it; `page.js`: sliders, time, the link.
"""
