"""What the exercises of assignment 1 share."""

from __future__ import annotations

TARGET = "r if terminated else r + gamma * max(q[s_next])"
