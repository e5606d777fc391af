"""What the exercises of assignment 5 share."""

from __future__ import annotations

EARNED = [2.5, 3.25, 1.75, 4.5, 3.0]
