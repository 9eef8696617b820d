#!/usr/bin/python3
"""Runs the quick suite as a user would, twice, and holds the results against what the README promises.

usage: quick_suite.py OXTURN SOURCE_DIR WORK_DIR

- one row for every planner x map x robot x seed, none of them a defect of ours
- -j1 and -j2 give the same bytes but for timing columns
- length_ratio never below 1; boustrophedon and zigzag cover at least 0.99, certified
- the independent scorer (Shapely) agrees on every path
- the paths' hash is the committed one, in every preset: tests/data/quick_paths.sha256. It proves determinism only;
  after a deliberate change of a planner or generator write the new one with --accept as the fourth argument.
"""
import csv
import hashlib
import os
import shutil
import subprocess
import sys

TIMING = {"plan_wall_s", "plan_cpu_s", "peak_rss_bytes", "score_s", "load"}


def run(oxturn, suite, folder, jobs):
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([oxturn, "run", suite, "-o", folder, f"-j{jobs}"], check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, "runs.csv"), newline="") as file:
        return list(csv.DictReader(file))


def main():
    oxturn, source, work = sys.argv[1:4]
    suite = os.path.join(source, "bench/suites/quick.toml")
    one = run(oxturn, suite, os.path.join(work, "j1"), 1)
    two = run(oxturn, suite, os.path.join(work, "j2"), 2)
    failures = []

    def check(good, what):
        if not good:
            failures.append(what)

    strip = lambda rows: [{k: v for k, v in row.items() if k not in TIMING} for row in rows]
    check(strip(one) == strip(two), "-j1 and -j2 differ")
    problems = {(row["map"], row["robot"]) for row in one}
    planners = {row["variant"] for row in one}
    check(len(one) == len(problems) * len(planners) > 0,
          f"{len(one)} rows for {len(planners)} planners on {len(problems)} problems")
    for row in one:
        name = f"{row['variant']} on {row['map']}"
        check(row["outcome"] in ("ok", "partial"), f"{name}: {row['outcome']}: {row['reason']}")
        if not row["length_ratio"]:
            continue
        check(float(row["length_ratio"]) >= 1, f"{name}: length_ratio {row['length_ratio']}")
        check(float(row["coverage_upper"]) - float(row["coverage_lower"]) <= 0.001, f"{name}: interval too wide")
        if row["planner"] in ("boustrophedon", "zigzag"):
            check(float(row["coverage_lower"]) >= 0.99, f"{name}: coverage_lower {row['coverage_lower']}")

    scorer = os.path.join(source, "tests/metrics/independent_scorer.py")
    told = subprocess.run([sys.executable, scorer, os.path.join(work, "j1")], capture_output=True, text=True)
    check(told.returncode == 0, "the independent scorer disagrees:\n" + told.stdout[-2000:] + told.stderr[-2000:])

    digest = hashlib.sha256("".join(row["path_sha256"] for row in one).encode()).hexdigest()
    golden = os.path.join(source, "tests/data/quick_paths.sha256")
    if sys.argv[4:] == ["--accept"]:
        with open(golden, "w") as file:
            file.write(digest + "\n")
    with open(golden) as file:
        check(file.read().strip() == digest, f"paths' hash is {digest}, committed is another")

    for failure in failures:
        print(failure)
    print(f"{len(one)} rows, {len(failures)} failures")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
