"""Recordings by name, and from and to other people's formats.

reading.py         `read_recording`: by name, from a folder, or from an array of the paper's own program
minari_dataset.py  Minari, the Gymnasium world's datasets of recorded steps: what `Recording.to_minari` and
                   `Recording.from_minari` do, of the extra "all"
"""
