"""What the figures of several lessons begin with: plots, paths through a room, curves of runs."""
