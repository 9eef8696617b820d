#!/usr/bin/env python3
"""A planner that works for ever, in two processes."""
import os
import sys
import time

if sys.argv[-1] == "--describe":
    print('{"oxturn": 1, "name": "waits"}')
    sys.exit()
print('{"ready": true}', flush=True)
os.fork()
while True:
    time.sleep(1)
