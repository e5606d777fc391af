"""What the figures of several lessons begin with: plots, rooms, words, paths through a room, curves of runs."""
