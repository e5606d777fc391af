"""What the figures of several lessons begin with: plots, rooms, paths through a room, curves of runs."""
