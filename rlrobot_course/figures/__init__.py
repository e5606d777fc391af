"""What the figures of several lessons begin with: `plots`, `paths` through a room, `runs` as curves, `rows` of robots."""
