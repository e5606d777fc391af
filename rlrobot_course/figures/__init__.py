"""What the figures of several lessons share: `plots`, `paths` of robots, `runs` as curves, `rows` of robots."""
