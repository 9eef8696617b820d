#!/usr/bin/env python3
"""A planner with an error in it."""
import sys

if sys.argv[1:] == ["--describe"]:
    print('{"oxturn": 1, "name": "dies"}')
    sys.exit()
print('{"ready": true}', flush=True)
sys.stdin.readline()
print(1 / 0)
