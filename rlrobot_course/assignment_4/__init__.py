"""Assignment 4, advice and escape: who advises a state, when a robot goes in circles, and what it does then."""
