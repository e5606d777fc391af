"""What the figures of several lessons share: `plots`, `words`, `runs` as curves, `rows` of robots."""
