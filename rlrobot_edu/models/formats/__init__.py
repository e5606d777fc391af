"""Recordings by name, and to and from other people's formats.

reading.py         `read_recording`: by name, from a folder, or in the paper's own format
legacy.py          the arrays of the paper's own program

Each of these needs a package of the extra "exchange":

minari_dataset.py  Minari, the Gymnasium world's datasets of recorded steps: `to_minari`, `from_minari`
parquet.py         Parquet, a table that pandas, Polars, DuckDB and R read: `to_parquet`, `from_parquet`
described.py       the data package that travels with the rows, and what must hold when they come back
"""
