#!/usr/bin/env python3
"""A monkey at the studio window: clicks, drags, wheels and keys at random, the same ones for the same seed.

usage: window_monkey.py LUMINIST OUTPUT_FOLDER [ACTIONS [SEED [MEGABYTES]]]

The window lives, shows something and goes on being heard; then it is killed, and its log replays. Its memory grows by
no more than so many megabytes (50; 0: not asked, as where a sanitizer keeps what is freed). Measured are the pages
that are the program's alone, at rest, from the end of a warm-up on: a few strokes with the lights that follow them, a
solve that is accepted, the view from anywhere and every panel, so that what is only loaded at its first use does not
count. Needs what window_test.py needs; ends with status 77 without it.
"""
import pathlib
import random
import subprocess
import sys
import time

from window_driver import Fault, accept, count, drive, kept_session, ready, records, replayed_rig, wait_for

KEYS = ("b a s e i n k v w h x g b p u Tab Escape Return Delete space bracketleft bracketright F1 F2 F3 F4 ctrl+z ctrl+shift+z "
        "ctrl+z ctrl+y shift+g 1 5 0 plus minus").split()  # none that ends the program or opens a dialog of files
TABS = (977, 1030, 1078, 1134, 1195)  # of the panels on the right, at y 42
REST = 14  # seconds after which memory that is free was given back


def works(studio):
    """Whether one of its threads runs, or would run if there were a processor for it, more than now and then."""
    running = 0
    for _ in range(20):
        states = [file.read_text().rpartition(")")[2].split()[0] for file in
                  pathlib.Path(f"/proc/{studio.process.pid}/task").glob("*/stat")]
        running += "R" in states
        time.sleep(0.2)
    return running > 3


def memory(studio):
    """Kilobytes that are the program's alone, once it rests."""
    studio.key("Escape", "Escape")
    wait_for("the studio rests", lambda: not works(studio))
    time.sleep(REST)
    status = pathlib.Path(f"/proc/{studio.process.pid}/status").read_text()
    return int(next(line.split()[1] for line in status.splitlines() if line.startswith("RssAnon")))


def memory_of_the_shot(studio):
    """As memory(), with the view from anywhere closed: it gives back what it needs, so the smaller one of two looks."""
    first = memory(studio)
    studio.key("v")
    return min(first, memory(studio))


def warm_up(studio, project):
    for number, stroke in enumerate([((0.38, 0.33), (0.45, 0.60)), ((0.51, 0.70), (0.56, 0.74)), ((0.7, 0.5), (0.8, 0.7))], 1):
        studio.drag(*stroke)
        wait_for(f"stroke {number} is recorded", lambda n=number: count(project, "Paint 1 stroke") == n)
    studio.key("ctrl+Return")
    time.sleep(6)
    accept(studio, project)
    for key in ("F2", "F3", "F4", "w", "w", "F1", "v"):
        studio.key(key)
        time.sleep(1)
    time.sleep(8)  # the view from anywhere is lit
    studio.drag((0.5, 0.9), (0.8, 0.8))
    time.sleep(4)
    studio.key("v")
    for tab in (*TABS, TABS[0]):
        studio.click(tab, 42)


def act(studio, chance):
    """The pointer stays off the menu bar: what is behind it leaves the program or the folder."""
    def somewhere():
        return chance.randrange(2, 1278), chance.randrange(32, 718)

    kind = chance.choice(("click", "click", "drag", "drag", "stroke", "wheel", "key", "key"))
    if kind == "key":
        studio.key(chance.choice(KEYS))
        return
    if kind == "stroke":
        studio.drag(*[(chance.uniform(0.1, 1.2), chance.uniform(0.1, 0.9)) for _ in range(3)])
        return
    studio.do("mousemove", *somewhere())
    if kind == "click":
        studio.do("click", 1)
    elif kind == "wheel":
        studio.do("click", chance.choice((4, 5)))
    else:
        studio.do("mousedown", 1)
        for _ in range(3):
            studio.do("mousemove", *somewhere())
        studio.do("mouseup", 1)


def heard(studio):
    """Whether Tab changes much of what is shown."""
    before = studio.shot("before_tab")
    studio.key("Tab")
    time.sleep(2)
    words = ["compare", "-metric", "AE", "-fuzz", "4%", before, studio.shot("after_tab"), "null:"]
    return float(subprocess.run(words, check=False, capture_output=True, text=True).stderr.split()[0]) > 10000


def play(studio, _):
    actions, seed, most = (int(word) for word in (sys.argv[3:] + ["200", "1", "50"][len(sys.argv) - 3:]))
    chance = random.Random(seed)
    studio.start()
    project = kept_session(studio)
    ready(studio)
    warm_up(studio, project)
    begin = memory(studio)
    for step in range(actions):
        act(studio, chance)
        if step % 50 == 49:
            studio.key("Escape", "Escape")
            studio.shot(f"after_{step + 1}")
        if step % 1000 == 999:
            print(f"monkey: {step + 1} actions, {len(records(project))} records, {memory_of_the_shot(studio) - begin:+} kB", flush=True)
    studio.key("Escape", "Escape", "Escape", "F1", "b")
    wait_for("Tab takes the panels away, or brings them back", lambda: heard(studio))
    end = memory_of_the_shot(studio)
    print(f"monkey: {actions} actions, seed {seed}, {len(records(project))} records, {begin} kB then {end} kB")
    studio.kill()
    replayed_rig(studio, project)
    if most > 0 and end - begin > 1000 * most:
        raise Fault(f"the studio's memory grew by {(end - begin) / 1000:.0f} MB, more than {most}")


if __name__ == "__main__":
    sys.exit(drive(play))
