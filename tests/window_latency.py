#!/usr/bin/env python3
"""How long a hand waits: for its ink in the window, and for the picture of the lights that follow it.

usage: window_latency.py LUMINIST OUTPUT_FOLDER [LUMINIST_BENCH]

Draws strokes on the demo scene in a window of its own, 60 events a second, and prints one line of JSON: "ink" from the
window system's call to the end of the frame in which the point is drawn, "frames" what such a frame took (median, 95th
percentile, most, in seconds), and, where the bench is given, what `luminist-bench latency --json` says at 1280 x 720. A
measurement and no test: it needs what window_test.py needs, and a machine that does nothing else.
"""
import json
import math
import subprocess
import sys
import time

from window_driver import count, drive, kept_session, place, ready, wait_for

STROKES = 8
POINTS = 60  # of a stroke: one second
PAUSE = 0.25  # seconds between strokes


def stroke_points(number):
    """A wave over the jug and the bowl, elsewhere for every stroke."""
    for step in range(POINTS):
        t = step / (POINTS - 1)
        yield 0.3 + 0.6 * t, 0.35 + 0.04 * number + 0.05 * math.sin(9.0 * t + number)


def draw(studio, number):
    points = list(stroke_points(number))
    words = ["mousemove", *place(*points[0]), "mousedown", "1"]
    for point in points[1:]:
        words += ["mousemove", *place(*point), "sleep", "0.0167"]
    studio.do(*words, "mouseup", "1")


def play(studio, output):
    times = output / "ink.json"
    studio.env["LUMINIST_INK_TIMES"] = str(times)
    studio.start()
    project = kept_session(studio)
    ready(studio)
    time.sleep(8)  # small stages are made ready
    for number in range(STROKES):
        draw(studio, number)
        time.sleep(PAUSE)
    wait_for("the strokes are recorded", lambda: count(project, "Paint 1 stroke") >= STROKES)
    wait_for("the ink was timed", times.exists)
    time.sleep(1)
    line = json.loads(times.read_text())
    studio.kill()
    if len(sys.argv) > 3:
        answer = subprocess.run([sys.argv[3], "latency", "--json"], check=True, capture_output=True, text=True)
        line.update(json.loads(answer.stdout))
    print(json.dumps(line))


if __name__ == "__main__":
    sys.exit(drive(play))
