#!/usr/bin/env python3
"""Is `shortest` shorter than other planners where it covers as much? Usage: equal_coverage.py RESULTS [OXTURN]

For every valid path of a results folder that covers half of its target or more, `shortest` plans the same problem for
the coverage of that path. The table has, for each map, the path that is hardest to beat: the one for which the ratio of
the lengths for each covered square metre, ours to theirs, is the greatest.
"""
import csv
import json
import os
import subprocess
import sys
import tempfile

LEAST, MOST = 0.5, 0.99999  # coverage of paths that are compared, and that is asked for


def ours(program, results, row, folder):
    """Coverage and length of the path that `shortest` plans for the row's problem and coverage."""
    problem = os.path.join(results, "maps", row["problem_sha256"] + ".geojson")
    coverage = min(float(row["coverage"]), MOST)
    run = subprocess.run([program, "plan", "shortest", problem, "--set", f"coverage={coverage:.6f}", "--json",
                          "-o", os.path.join(folder, "path.geojson")], check=True, stdout=subprocess.PIPE,
                         stderr=subprocess.DEVNULL)
    metrics = json.loads(run.stdout)["metrics"]
    return metrics["coverage"], metrics["path_m"]


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    results, program = sys.argv[1], sys.argv[2] if len(sys.argv) == 3 else "oxturn"
    with open(os.path.join(results, "runs.csv"), newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["outcome"] in ("ok", "partial")]
    hardest = {}
    with tempfile.TemporaryDirectory() as folder:
        for row in rows:
            coverage, length = float(row["coverage"]), float(row["path_m"])
            if coverage < LEAST:
                continue
            share, metres = ours(program, results, row, folder)
            line = (metres / share / (length / coverage), row["variant"], coverage, length, share, metres)
            hardest[row["map"]] = max(line, hardest.get(row["map"], line))
    print("| map | planner | coverage | path_m | `shortest`: coverage | path_m | ratio |")
    print("|---|---|---:|---:|---:|---:|---:|")
    for name, (ratio, variant, coverage, length, share, metres) in hardest.items():
        print(f"| {name} | {variant} | {coverage:.4f} | {length:.1f} | {share:.4f} | {metres:.1f} | {ratio:.3f} |")


main()
