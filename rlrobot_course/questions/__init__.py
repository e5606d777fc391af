"""What the reader is asked: predictions before a run, and old questions from earlier lessons."""
