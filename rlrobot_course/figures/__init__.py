"""What the figures of several lessons begin with: plots, words, paths through a room, curves of runs."""
