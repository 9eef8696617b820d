#!/usr/bin/env python3
"""`oxturn draw` on the drawings of docs/drawings: every stroke drawn, every fill covered as far as the tool reaches it.
With a least turning radius no bend is sharper.

usage: drawn_by_beachbot.py OXTURN DRAWINGS
"""
import glob
import json
import subprocess
import sys

LEAST = {"stroke_share": 0.999, "fill_share": 0.98, "fill_share_reachable": 0.999}


TURNING = ["horse.svg", "warning.svg"]  # the others take longer


def failures_with_radius(oxturn, drawing):
    run = subprocess.run([oxturn, "draw", drawing, "--json", "--robot", "min_turn_radius=0.5"],
                         capture_output=True, text=True, check=False)
    violations = json.loads(run.stdout)["metrics"]["curvature_violations"] if run.stdout else run.stderr
    return [] if violations == 0 else [f"{drawing} with a least turning radius: {violations} bends are sharper"]


def main():
    oxturn, folder = sys.argv[1:3]
    drawings = sorted(glob.glob(f"{folder}/*.svg"))
    failures = [] if drawings else [f"no drawings in '{folder}'"]
    for drawing in drawings:
        run = subprocess.run([oxturn, "draw", drawing, "--json"], capture_output=True, text=True, check=False)
        if run.returncode != 0:
            failures.append(f"{drawing}: exit code {run.returncode}: {run.stderr}")
            continue
        result = json.loads(run.stdout)
        if result["outcome"] != "ok":
            failures.append(f"{drawing}: {result['outcome']}: {result['reason']}")
        for metric, least in LEAST.items():
            if (share := result["metrics"][metric]) is not None and share < least:
                failures.append(f"{drawing}: {metric} is {share}, expected at least {least}")
    for name in TURNING:
        failures += failures_with_radius(oxturn, f"{folder}/{name}")
    print("\n".join(failures) or f"{len(drawings)} drawings, all drawn")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
