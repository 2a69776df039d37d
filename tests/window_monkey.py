#!/usr/bin/env python3
"""A monkey at the studio window: clicks, drags, wheels and keys at random, the same ones for the same seed.

usage: window_monkey.py LUMINIST OUTPUT_FOLDER [ACTIONS [SEED]]

The window lives, shows something and goes on being heard; then it is killed, and its log replays. Needs what
window_test.py needs; ends with status 77 without it. The memory that it took is printed (kilobytes, begin and end).
"""
import pathlib
import random
import subprocess
import sys
import time

from window_driver import drive, kept_session, ready, records, replayed_rig, wait_for

KEYS = ("b a s e i n k v w h x g b p u Tab Escape Return Delete space bracketleft bracketright F1 F2 F3 F4 ctrl+z ctrl+shift+z "
        "ctrl+z ctrl+y shift+g 1 5 0 plus minus").split()  # none that ends the program or opens a dialog of files


def memory(studio):
    status = pathlib.Path(f"/proc/{studio.process.pid}/status").read_text()
    return int(next(line.split()[1] for line in status.splitlines() if line.startswith("VmRSS")))


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
    actions, seed = (int(word) for word in (sys.argv[3:] + ["200", "1"][len(sys.argv) - 3:]))
    chance = random.Random(seed)
    studio.start()
    project = kept_session(studio)
    ready(studio)
    begin = memory(studio)
    for step in range(actions):
        act(studio, chance)
        if step % 50 == 49:
            studio.key("Escape", "Escape")
            studio.shot(f"after_{step + 1}")
    studio.key("Escape", "Escape", "Escape", "F1", "b")
    wait_for("Tab takes the panels away, or brings them back", lambda: heard(studio))
    print(f"monkey: {actions} actions, seed {seed}, {len(records(project))} records, {begin} kB then {memory(studio)} kB")
    studio.kill()
    replayed_rig(studio, project)


if __name__ == "__main__":
    sys.exit(drive(play))
