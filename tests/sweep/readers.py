"""Reads the rows of a sweep with DuckDB and pandas: the folder of the sweep is the argument."""

import sys

import duckdb
import pandas

folder = sys.argv[1]
chunks, summary = f"{folder}/chunks/*.parquet", f"{folder}/summary.parquet"
query = "SELECT state, count(*), min(id), max(id) FROM '{}' GROUP BY state ORDER BY state"
one, all_ = (duckdb.sql(query.format(path)).fetchall() for path in (chunks, summary))
assert one == all_, (one, all_)
frame = pandas.read_parquet(summary)
assert list(frame["id"]) == list(range(len(frame))), "rows stand in the order of the plan"
done = frame[frame["state"] == "done"]
assert done["gap_true"].notna().all() and done["reason"].isna().all()
assert frame[frame["state"] == "refused"]["reason"].notna().all()
best = duckdb.sql(f"SELECT max(gap_true) FROM '{summary}' WHERE feasible").fetchall()[0][0]
assert best == done["gap_true"].max() and bool(frame[frame["gap_true"] == best]["front"].any())
units = dict(duckdb.sql(f"SELECT decode(key), decode(value) FROM parquet_kv_metadata('{summary}')").fetchall())
assert units["unit.gap_true"] == "mm" and units["unit.in_R"] == "mm", units
print(len(frame), "rows")
