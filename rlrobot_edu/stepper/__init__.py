"""The stepper: a learning process, one step at a time, forward and backward."""
