"""What the figures of several lessons share: `plots`, `words`, `paths` of robots, `runs` as curves, `rows` of dots."""
