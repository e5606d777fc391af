"""What the exercises of assignment 1 share."""

from __future__ import annotations

PAST_THE_END = "this looks past the end. After a terminated step nothing follows, so the target is the reward alone."

NO_GAMMA = "γ is missing: what comes a step later counts γ times."

TARGET = "r if terminated else r + gamma * max(q[s_next])"
