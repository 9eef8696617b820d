#!/usr/bin/env python3
"""An external planner for oxturn that plans nothing: it answers with paths that were recorded or planned elsewhere.

    oxturn plan --exec 'python3 docs/planners/recording.py recordings' kitchen.yaml --svg kitchen.svg
    oxturn run mine.toml -o out --exec 'python3 docs/planners/recording.py recordings'

The folder has a file for each map, named as the map is ("kitchen", "rooms-7"), poses in metres in the map's frame:

  NAME.csv    x,y[,yaw][,tool]: one pose a line; tool 0 or 1, 1 if left out. A first line may name the columns; other
              columns are then ignored
  NAME.yaml   what `ros2 topic echo` prints of a topic with nav_msgs/Path (the last message counts), or with
              geometry_msgs/PoseStamped or nav_msgs/Odometry (each message is a pose)

From the problem's start the robot drives straight to the first pose with the tool off. A recording is judged as any
path is: if it leaves free space by more than rounding, it is invalid. `oxturn score --tolerance` is for noisy ones.
"""
import csv
import hashlib
import json
import os
import re
import sys

COLUMNS = ("x", "y", "yaw", "tool")


def say(**message):
    print(json.dumps(message), flush=True)


def describe(folder):
    """Other recordings are another version."""
    content = hashlib.sha256()
    for name in sorted(os.listdir(folder)):
        with open(os.path.join(folder, name), "rb") as file:
            content.update(name.encode() + b"\0" + file.read())
    return {"oxturn": 1, "name": "recording", "title": "paths that were recorded elsewhere",
            "capabilities": ["holes", "tether", "curvature", "footprint"], "version": content.hexdigest()[:16]}


def read_csv(text):
    """[(x, y, tool is on), ...]"""
    names, poses = COLUMNS, []
    for number, row in enumerate(csv.reader(text.splitlines()), 1):
        row = [cell.strip() for cell in row]
        if not any(row) or row[0].startswith("#"):
            continue
        if not poses and "x" in row and "y" in row:
            names = row
            continue
        try:
            pose = {name: float(cell) for name, cell in zip(names, row) if name in COLUMNS}
            poses.append((pose["x"], pose["y"], pose.get("tool", 1) != 0))
        except (ValueError, KeyError):
            raise ValueError(f"line {number} is {','.join(row)!r}, expected {','.join(names)}") from None
    return poses


def read_ros(text):
    """The positions: those of the last list of poses, or one of each message."""
    messages = [message for message in re.split(r"^---\s*$", text, flags=re.MULTILINE) if message.strip()]
    if any(re.search(r"^poses:", message, re.MULTILINE) for message in messages):
        messages = messages[-1:]
    number = r"([-+.0-9eE]+)"
    return [(float(x), float(y), True) for message in messages
            for x, y in re.findall(rf"position:\s*x:\s*{number}\s*y:\s*{number}", message)]


def read(folder, name):
    for suffix, reader in ((".csv", read_csv), (".yaml", read_ros)):
        path = os.path.join(folder, name + suffix)
        if os.path.exists(path):
            with open(path) as file:
                try:
                    return reader(file.read())
                except ValueError as error:
                    raise ValueError(f"{path}: {error}") from None
    raise ValueError(f"there is no recording for '{name}': {os.path.join(folder, name)}.csv or .yaml")


def legs_of(start, poses):
    """Legs in driving order; a pose's `tool` is about the segment that ends there."""
    legs, at = [], start
    for k, (x, y, tool) in enumerate(poses):
        if (x, y) == at:
            continue
        tool = tool and k > 0
        if not legs or legs[-1][0] != tool:
            legs.append((tool, [at]))
        at = (x, y)
        legs[-1][1].append(at)
    return legs


def main():
    words = [word for word in sys.argv[1:] if word != "--describe"]
    if len(words) != 1 or not os.path.isdir(words[0]):
        sys.exit("usage: recording.py FOLDER, a folder with recordings")
    if "--describe" in sys.argv:
        print(json.dumps(describe(words[0])))
        return
    say(ready=True)
    properties = json.loads(sys.stdin.readline())["problem"]["properties"]
    try:
        legs = legs_of(tuple(properties["start"]), read(words[0], properties["name"]))
    except ValueError as error:
        say(error="failed", reason=str(error))
        return
    if not legs:
        say(error="failed", reason=f"the recording for '{properties['name']}' has no poses")
        return
    say(path={"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"tool": tool}, "geometry": {"type": "LineString", "coordinates": points}}
        for tool, points in legs]})


main()
