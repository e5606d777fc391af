"""Assignment 1, a robot's day as numbers: a corridor with a charger, from readings to a policy."""
