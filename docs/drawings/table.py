#!/usr/bin/env python3
"""Prints the table of docs/beachbot.md from the results of `oxturn run beachbot`.

usage: docs/drawings/table.py RESULTS [ROBOT]
"""
import csv
import sys

COLUMNS = ["path_m", "tool_up_m", "stroke_share", "fill_share_reachable", "over_finished_m", "overlap"]


def shown(row, column):
    if not row[column]:
        return ""
    return f"{float(row[column]):.{4 if 'share' in column else 2}f}"


def main():
    folder, robot = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "spot"
    print("| drawing | planner | outcome | " + " | ".join(COLUMNS) + " |")
    print("|---|---|---|" + "---:|" * len(COLUMNS))
    with open(f"{folder}/runs.csv", newline="") as file:
        for row in csv.DictReader(file):
            if row["robot"] == robot:
                cells = [row["map"], f"`{row['variant']}`", row["outcome"]] + [shown(row, c) for c in COLUMNS]
                print("| " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
