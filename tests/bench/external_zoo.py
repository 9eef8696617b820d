#!/usr/bin/env python3
"""External planners that behave as badly as programs do: external_zoo.py MODE. The good path covers small_problem()."""
import json
import os
import signal
import sys
import time

MODE = sys.argv[1]


def say(text):
    sys.stdout.write(text)
    sys.stdout.flush()


def leg(points, tool=True):
    return {"type": "Feature", "properties": {"tool": tool},
            "geometry": {"type": "LineString", "coordinates": points}}


def path(*legs):
    return {"type": "FeatureCollection", "features": list(legs)}


def lanes():
    points = [[0.21, 0.21]]
    for k in range(6):
        row = [[0.2, 0.2 + 0.32 * k], [2.8, 0.2 + 0.32 * k]]
        points += row if k % 2 == 0 else row[::-1]
    return points


GOOD = path(leg(lanes()))
WALL = path(leg([[0.21, 0.21], [4, 0.21]]))


def answer(message):
    say(json.dumps(message) + "\n")


def burn(seconds):
    end = time.process_time() + seconds
    while time.process_time() < end:
        pass


def forever():
    while True:
        time.sleep(1)


def leave_child(daemon):
    if os.fork() == 0:
        if daemon:
            os.setsid()
            if os.fork() != 0:
                os._exit(0)
        forever()


def before_ready():
    if MODE == "silent":
        forever()
    if MODE == "exit_at_once":
        sys.exit(0)
    if MODE == "no_ready":
        answer({"path": GOOD})
    if MODE == "chatty":
        say("Loading the model ...\n")
    if MODE == "slow_start":
        time.sleep(0.5)
        burn(0.5)
        if os.fork() == 0:
            burn(0.5)
            os._exit(0)
        os.wait()
    if MODE == "close_input":
        os.close(0)
    if MODE == "traceback":
        raise KeyError("robot")
    if MODE == "ignore_signals":
        for s in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            signal.signal(s, signal.SIG_IGN)
    say('{"ready": true}\n')


def echo(line):
    """Tells what it was asked, by recorded figures."""
    message = json.loads(line)
    problem = message["problem"]
    figures = {"seed": message["seed"], "wall_s": message["wall_s"], "settings": len(message["settings"]),
               "robot_radius": problem["properties"]["robot"]["radius"], "start_x": problem["properties"]["start"][0]}
    for name in ("configuration_space", "target"):
        xs = [p[0] for p in problem[name]["coordinates"][0]]
        figures[name + "_x"] = max(xs)
    answer({"record": figures})
    answer({"progress": 0.5})
    answer({"trace": {"name": "lanes", "lines": [lanes()]}})
    answer({"promise": problem["target"]})
    say("\n")


LINES = {
    "garbage": "my path is ready\n",
    "nan": '{"path": {"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"tool": true}, '
           '"geometry": {"type": "LineString", "coordinates": [[0.2, 0.2], [NaN, 1]]}}]}}\n',
    "infinite": json.dumps({"path": GOOD}).replace("2.8", "1e999", 1) + "\n",
    "list": "[1, 2]\n",
    "unknown_member": '{"pth": 1}\n',
    "two_members": json.dumps({"progress": 0.1, "path": GOOD}) + "\n",
    "wrong_type": '{"path": {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}}\n',
    "one_point": json.dumps({"path": path(leg([[0.2, 0.2]]))}) + "\n",
    "no_tool": json.dumps({"path": path(leg(lanes()))}).replace('"tool"', '"on"') + "\n",
    "null_path": '{"path": null}\n',
    "empty_path": json.dumps({"path": path()}) + "\n",
    "text_coordinates": json.dumps({"path": path(leg([["a", "b"], [1, 1]]))}) + "\n",
    "deep": "[" * 100000 + "\n",
    "bytes": '{"path": "\udcff\udcfe"}\n',
    "bad_record": '{"record": {"My Figure": 1}}\n',
    "record_text": '{"record": {"rounds": "many"}}\n',
    "progress_over": '{"progress": 50}\n',
    "bad_trace": '{"trace": {"name": "tree", "lines": [[0, 0]]}}\n',
    "bad_publish": '{"publish": []}\n',
    "bad_promise": '{"promise": {"type": "Point", "coordinates": [0, 0]}}\n',
    "infeasible": '{"error": "infeasible", "reason": "the door is too narrow"}\n',
    "unsupported": '{"error": "unsupported", "reason": "no rectangles"}\n',
    "failed": '{"error": "failed", "reason": "no licence"}\n',
    "bad_error": '{"error": "oops"}\n',
    "no_reason": '{"error": "infeasible"}\n',
    "through_wall": json.dumps({"path": WALL}) + "\n",
    "no_end": json.dumps({"path": GOOD}),
    "half_line": json.dumps({"path": GOOD})[:200],
}


def after_problem():
    if MODE in LINES:
        sys.stdout.buffer.write(LINES[MODE].encode("utf-8", "surrogateescape"))
        sys.stdout.flush()
    elif MODE in ("publish_then_wait", "ignore_signals"):
        answer({"publish": GOOD})
        forever()
    elif MODE == "publish_then_die":
        answer({"publish": GOOD})
        os.kill(os.getpid(), signal.SIGSEGV)
    elif MODE == "publish_then_exit":
        answer({"publish": GOOD})
        print("out of ideas", file=sys.stderr)
        sys.exit(3)
    elif MODE == "no_answer":
        forever()
    elif MODE == "spin":
        burn(1e9)
    elif MODE == "endless_line":
        while True:
            say("x" * (1 << 20))
    elif MODE == "endless_lines":
        while True:
            say('{"progress": 0.5}\n' * 1000)
    elif MODE == "endless_errors":
        while True:
            sys.stderr.write("oh no\n" * 10000)
    elif MODE == "allocate":
        big = []
        while True:
            big.append(b"x" * (10 << 20))
    elif MODE == "long_reason":
        answer({"error": "failed", "reason": "x" * 1000000})
    elif MODE == "children":
        leave_child(False)
        leave_child(True)
        answer({"path": GOOD})
    elif MODE == "child_holds_output":
        leave_child(False)
        sys.exit(0)
    elif MODE == "lingers":
        answer({"path": GOOD})
        forever()
    elif MODE == "talks_on":
        answer({"path": GOOD})
        for _ in range(1000):
            say("and another thing\n" * 100)
    elif MODE == "closes_output":
        os.close(1)
        forever()
    elif MODE == "burn":
        burn(0.3)
        answer({"path": GOOD})
    elif MODE == "large":
        big = b"x" * (100 << 20)
        answer({"path": GOOD})
        time.sleep(0.05)
        del big
    else:  # good, echo, no_ready, chatty, slow_start
        answer({"path": GOOD})


def main():
    before_ready()
    if MODE != "close_input":
        line = sys.stdin.readline()
        if MODE == "echo":
            echo(line)
    after_problem()


main()
