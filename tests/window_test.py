#!/usr/bin/env python3
"""Drives the studio window with mouse and keys, as the paper's Figure 2 begins, and checks what it recorded.

usage: window_test.py LUMINIST OUTPUT_FOLDER

Needs Xvfb, xdotool and ImageMagick's import; without one of them it says so and ends with status 77 (skipped).
Screenshots of every step are left in the output folder.
"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

SKIPPED = 77
PATIENCE = 240  # seconds: a machine without a GPU that does other work, too
# The window is 1280 x 720; its canvas lies between the panels, and the 640 x 480 picture fills it but for a margin.
CANVAS = (278, 60, 944, 692)
MARGIN = 12
PICTURE = (640, 480)
# The frames of a scene that moves, below the picture: the first frame on the ruler, and the button of new keys.
RULER = (424, 588)
NEW_KEY = (310, 586)
ROOT = pathlib.Path(__file__).resolve().parent.parent
LARGEST_DIFFERENCE = 0.002  # of the pixels: hinting and antialiasing of another version of the font rasterizer


class Fault(Exception):
    pass


def place(x, y):
    """Where a point of the picture, in picture heights, lies on the screen."""
    left, top, right, bottom = CANVAS
    zoom = min((right - left - 2 * MARGIN) / PICTURE[0], (bottom - top - 2 * MARGIN) / PICTURE[1])
    return (round((left + right) / 2 + zoom * (x * PICTURE[1] - PICTURE[0] / 2)),
            round((top + bottom) / 2 + zoom * PICTURE[1] * (y - 0.5)))


def wait_for(what, holds):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        found = holds()
        if found:
            return found
        time.sleep(0.1)
    raise Fault(f"waited {PATIENCE} s in vain: {what}")


class Display:
    """A screen of its own, so that nothing else is touched."""

    def __enter__(self):
        out, into = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(into), "-screen", "0", "1280x800x24", "+extension", "GLX"],
            pass_fds=[into], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(into)
        with os.fdopen(out) as answer:
            number = answer.readline().strip()
        if not number:
            raise Fault("Xvfb did not start")
        self.name = f":{number}"
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


class Studio:
    """The program, and the hand at it."""

    def __init__(self, luminist, display, state, output):
        self.luminist, self.output, self.shots = luminist, output, 0
        self.env = dict(os.environ, DISPLAY=display, XDG_STATE_HOME=str(state), LC_ALL="C.UTF-8")
        self.env.pop("WAYLAND_DISPLAY", None)
        self.unsaved = state / "luminist" / "unsaved"
        self.process = None

    def start(self, *words):
        self.process = subprocess.Popen([self.luminist, *map(str, words)], env=self.env, cwd=self.output)

    def kill(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()

    def do(self, *words):
        if self.process.poll() is not None:
            raise Fault(f"the studio ended with status {self.process.returncode}")
        subprocess.run(["xdotool", *map(str, words)], env=self.env, check=True, stdout=subprocess.DEVNULL)

    def key(self, *keys):
        self.do("mousemove", *place(1.2, 0.05))  # without a window manager keys go where the pointer is
        self.do("key", "--delay", "60", *keys)

    def drag(self, *points):
        self.do("mousemove", *place(*points[0]))
        time.sleep(0.3)
        self.do("mousedown", 1)
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            for step in range(1, 7):
                t = step / 6
                self.do("mousemove", *place(x0 + t * (x1 - x0), y0 + t * (y1 - y0)))
                time.sleep(0.02)
        self.do("mouseup", 1)

    def shot(self, name):
        """A screenshot that is not blank."""
        self.shots += 1
        file = self.output / f"{self.shots:02}_{name}.png"
        subprocess.run(["import", "-window", "root", "-crop", "1280x720+0+0", "+repage", file], env=self.env, check=True)
        colors = int(subprocess.run(["identify", "-format", "%k", file], check=True, capture_output=True).stdout)
        if colors < 200:
            raise Fault(f"{file.name} has {colors} colours only: blank")
        return file


def compare(shot, name):
    """Against a reference picture: glyphs and lines are the same everywhere, so few pixels may differ visibly."""
    reference = ROOT / "tests" / "app" / "golden" / f"{name}.png"
    if not reference.exists():
        raise Fault(f"no reference {reference}; {shot} is the candidate")
    words = ["compare", "-metric", "AE", "-fuzz", "4%", reference, shot, "null:"]
    answer = subprocess.run(words, check=False, capture_output=True, text=True)
    differing = float(answer.stderr.split()[0])
    if not differing <= LARGEST_DIFFERENCE * 1280 * 720:
        raise Fault(f"{shot} differs from {reference} in {differing:.0f} pixels")


def records(project):
    """The whole records of a project's log."""
    lines = (project / "log.jsonl").read_text().splitlines()
    return [json.loads(line)["record"] for line in lines if line.endswith("}")]


def labels(project):
    return [record["command"] for record in records(project) if "command" in record]


def count(project, start):
    return sum(label.startswith(start) for label in labels(project))


def kept_session(studio):
    """The log of the unsaved session that is open, once there is one."""
    folder = wait_for("the demo scene opens", lambda: next(iter(studio.unsaved.glob(f"untitled-{studio.process.pid}-*.lum")), None))
    wait_for("its log begins", lambda: (folder / "log.jsonl").exists() and records(folder))
    return folder


def ready(studio):
    """Until the window shows the picture: its tool strip and a bright hint are there long before, so look at the middle."""
    probe = studio.output / "probe.png"

    def shows():
        subprocess.run(["import", "-window", "root", "-crop", "600x400+310+150", "+repage", probe], env=studio.env, check=True)
        return int(subprocess.run(["identify", "-format", "%k", probe], check=True, capture_output=True).stdout) > 500

    wait_for("the picture shows", shows)
    probe.unlink()


def paint_and_accept(studio):
    project = kept_session(studio)
    ready(studio)
    compare(studio.shot("open"), "open")
    strokes = [[(0.38, 0.33), (0.40, 0.50), (0.47, 0.40), (0.45, 0.22), (0.45, 0.60)], [(0.51, 0.70), (0.56, 0.74)],
               [(0.77, 0.73), (0.82, 0.77)]]
    for number, stroke in enumerate(strokes, 1):
        studio.drag(*stroke)
        wait_for(f"stroke {number} is recorded", lambda n=number: count(project, "Paint 1 stroke") == n)
    if count(project, "Add light") != 1:
        raise Fault(f"one light is added for the paint: {labels(project)}")
    time.sleep(3)
    studio.shot("painted")
    studio.key("s")
    studio.drag((0.66, 0.36), (0.66, 0.44), (0.64, 0.56))
    wait_for("the shadow is recorded", lambda: count(project, "Paint 1 stroke") == 4)
    studio.key("ctrl+Return")
    time.sleep(5)
    studio.shot("solving")
    studio.key("Return")
    wait_for("the lights are accepted", lambda: count(project, "Accept") == 1)
    time.sleep(1)
    studio.shot("accepted")
    return project


def undo_redo_save(studio, project):
    before = len(records(project))
    studio.key("ctrl+z")
    wait_for("undo is recorded", lambda: len(records(project)) == before + 1)
    studio.key("ctrl+shift+z")
    wait_for("redo is recorded", lambda: len(records(project)) == before + 2)
    time.sleep(1)
    studio.key("ctrl+s")
    time.sleep(2)
    studio.shot("save_as")
    named = studio.output / "painted.lum"
    studio.do("key", "ctrl+a")
    studio.do("type", "--delay", "40", str(named))
    studio.do("key", "Return")
    wait_for("the project is saved", lambda: (named / "log.jsonl").exists() and not project.exists())
    return named


def crash_and_reopen(studio, named):
    strokes = count(named, "Paint 1 stroke")
    studio.key("b")
    studio.drag((1.05, 0.62), (1.14, 0.64))
    wait_for("a stroke is recorded in the named project", lambda: count(named, "Paint 1 stroke") == strokes + 1)
    before = labels(named)
    studio.kill()
    if labels(named) != before:
        raise Fault("a kill changed what was recorded")
    studio.start(named)
    ready(studio)
    studio.shot("reopened")
    studio.key("ctrl+z")
    wait_for("the last stroke can be undone after the crash", lambda: len(records(named)) == len(before) + 4)
    studio.kill()


def recover_unsaved(studio):
    studio.start()
    project = kept_session(studio)
    ready(studio)
    studio.drag((0.42, 0.4), (0.45, 0.5))
    wait_for("a stroke is recorded", lambda: count(project, "Paint 1 stroke") == 1)
    studio.kill()
    studio.start()
    time.sleep(1)
    kept_session(studio)
    ready(studio)
    time.sleep(1)
    studio.shot("recovery")
    studio.do("mousemove", 750, 364)  # "Go on" of the only row
    time.sleep(0.5)
    studio.do("click", 1)
    time.sleep(1)
    wait_for("the session goes on where it was",
             lambda: (project / "lock").exists())
    ready(studio)
    before = len(records(project))
    studio.shot("recovered")
    studio.key("ctrl+z")
    wait_for("its last stroke can be undone", lambda: len(records(project)) == before + 1)
    studio.kill()


def frames(studio):
    """A scene that moves: the ruler is dragged along and let go, and a key is set there."""
    studio.start(ROOT / "meshes" / "creature" / "creature.glb")
    project = kept_session(studio)
    ready(studio)
    time.sleep(2)
    studio.do("mousemove", *RULER)
    time.sleep(0.5)
    studio.do("mousedown", 1)
    for step in range(1, 8):
        studio.do("mousemove", RULER[0] + 30 * step, RULER[1] + 3)
        time.sleep(0.1)
    time.sleep(3)
    studio.shot("dragged_through_time")
    if count(project, "Go to frame"):
        raise Fault("looking through time is recorded before the hand lets go")
    studio.do("mouseup", 1)
    wait_for("going to a frame is recorded once", lambda: count(project, "Go to frame") == 1)
    studio.do("mousemove", *NEW_KEY)
    time.sleep(0.5)
    studio.do("click", 1)
    time.sleep(1)
    studio.do("mousemove", NEW_KEY[0] + 30, NEW_KEY[1] + 16)
    time.sleep(0.5)
    studio.shot("new_key")
    studio.do("click", 1)
    wait_for("a key is recorded", lambda: count(project, "Key ambient") == 1)
    studio.kill()


def main():
    missing = [tool for tool in ("Xvfb", "xdotool", "import", "identify") if not shutil.which(tool)]
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (tools/packages test)")
        return SKIPPED
    luminist, output = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(output, ignore_errors=True)
    output.mkdir(parents=True)
    with Display() as display:
        studio = Studio(luminist, display.name, output / "state", output)
        try:
            studio.start()
            project = paint_and_accept(studio)
            named = undo_redo_save(studio, project)
            crash_and_reopen(studio, named)
            recover_unsaved(studio)
            frames(studio)
        except Fault as fault:
            studio.shots += 100
            print(fault)
            subprocess.run(["import", "-window", "root", output / "fault.png"], env=studio.env, check=False)
            return 1
        finally:
            if studio.process and studio.process.poll() is None:
                studio.kill()
    subprocess.run([luminist, "replay", named, "-o", output / "replayed"], check=True)
    rig = (output / "replayed" / "rig.toml").read_text()
    if rig.count("[[light]]") != 1:
        print(f"the replayed project has {rig.count('[[light]]')} lights, 1 was painted")
        return 1
    print(f"window: every step is recorded; screenshots in {output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
