"""Assignment 2, on or off policy: what a target promises, and a maximum that is too hopeful."""
