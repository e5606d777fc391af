"""Assignment 3, credit where it is due: returns of n steps, three kinds of traces, Watkins's Q(λ)."""
