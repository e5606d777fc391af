"""One experiment on many computers, such as a class's (docs/howto/class_experiment.md).

plan.py    `plan`: what is compared, written down once, with a digest
shares.py  `shard` runs one computer's share of it, `merge` makes the one comparison
"""
