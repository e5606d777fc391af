"""Pages without a kernel: views that Python drew, in one compressed HTML file that any browser opens.

page.py     `save_page`: packs the views and writes the file; begin here
page.html   the controls above the view, and the colours of a light and of a dark page
turning.js  unpacks the views and shows one at a time: buttons, slider, keys, play, links
"""
