"""Recordings of what a robot did, and models made from them, in which agents learn in seconds.

The data types:

Recording    transitions (s, a, r, s'), checked, and where they come from
Source       where they come from: states and actions, robot, method, seed
SampleModel  what was seen after each pair (s, a), and how often
Tables       a SampleModel in types that numba knows
Expected     probabilities and mean rewards of a SampleModel
Plan         Q*, V* and the best policy in it
Diagnosis    what it does not know, and the `Loop`s in which it may promise too much

Begin with recording.py (`Recording`, `record`) and sample_model.py. Then, as you need it:

source.py                  what the numbers of a recording mean, and which rows it can have
data_package.py            the one format of its files, written and read
tables.py, own_rows.py     rows of your own: a list, an array, a data frame, a spreadsheet
read_recording.py          recordings by name, from a folder, from a spreadsheet, or in the paper's own format
sampling.py, model_env.py  how an agent acts in a sample model
value_iteration.py         the best that can be done in it
diagnosis.py               what it does not know
held_back.py               what it says of rows that it has not seen
"""
