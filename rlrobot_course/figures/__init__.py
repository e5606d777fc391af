"""What the figures of several lessons share: `plots`, `paths` through a room, `runs` as curves, `rows` of robots."""
