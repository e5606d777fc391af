"""What belongs to the learner: copies of the notebooks, the right answers kept so far, and the progress."""
