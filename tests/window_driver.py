"""What the window's test drives it with: a screen, the program on it, mouse and keys, screenshots and the log."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import tomllib

SKIPPED = 77
PATIENCE = 240  # seconds: a machine without a GPU that does other work, too
# The window is 1280 x 720; its canvas lies between the panels, and the 640 x 480 picture fills it but for a margin.
CANVAS = (278, 60, 944, 692)
MARGIN = 12
PICTURE = (640, 480)
ROOT = pathlib.Path(__file__).resolve().parent.parent
REFERENCES = ROOT / "tests" / "app" / "golden"
LARGEST_DIFFERENCE = 0.002  # of the pixels: hinting and antialiasing of another version of the font rasterizer
WHOLE = (0, 0, 1280, 720)
RIGHT_PANEL = (946, 55, 334, 460)


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

    def kill(self, heard=True):
        """Ends the program at once. Unless that is heard of, it stays a zombie until the next start."""
        self.process.send_signal(signal.SIGKILL)
        if heard:
            self.process.wait()

    def click(self, x, y):
        """A click on a control: the pointer rests there for a moment, as a hand does."""
        self.do("mousemove", x, y)
        time.sleep(0.5)
        self.do("click", 1)
        time.sleep(0.8)

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
        return self.retake(self.output / f"{self.shots:02}_{name}.png")

    def retake(self, file):
        subprocess.run(["import", "-window", "root", "-crop", "1280x720+0+0", "+repage", file], env=self.env, check=True)
        colors = int(subprocess.run(["identify", "-format", "%k", file], check=True, capture_output=True).stdout)
        if colors < 200:
            raise Fault(f"{file.name} has {colors} colours only: blank")
        return file


def differing_pixels(shot, part, reference):
    """How many pixels of a part of a screenshot (left, top, width, height) differ visibly from a reference picture."""
    left, top, width, height = part
    cut = shot.with_name(f"{shot.stem}.part.png")
    subprocess.run(["convert", shot, "-crop", f"{width}x{height}+{left}+{top}", "+repage", cut], check=True)
    if os.environ.get("LUMINIST_NEW_REFERENCES"):
        subprocess.run(["convert", cut, "+dither", "-colors", "255", "-strip", f"PNG8:{reference}"], check=True)
    if not reference.exists():
        raise Fault(f"no reference {reference}; {cut} is the candidate")
    words = ["compare", "-metric", "AE", "-fuzz", "4%", reference, cut, "null:"]
    return float(subprocess.run(words, check=False, capture_output=True, text=True).stderr.split()[0])


def compare(studio, name, part=WHOLE):
    """Waits until a part of the window is as its reference picture is: glyphs and lines are the same everywhere, so few
    pixels may differ visibly. references.toml says why it is as it is. Where LUMINIST_NEW_REFERENCES is set the part
    becomes the reference, in few colours; look at it before it is committed."""
    reference = REFERENCES / f"{name}.png"
    reason = tomllib.loads((REFERENCES / "references.toml").read_text())[name]
    if os.environ.get("LUMINIST_NEW_REFERENCES"):
        time.sleep(4)
    end = time.monotonic() + PATIENCE / 4
    shot = studio.shot(name)
    while (differing := differing_pixels(shot, part, reference)) > LARGEST_DIFFERENCE * part[2] * part[3]:
        if time.monotonic() > end:
            raise Fault(f"{shot} differs from {reference} in {differing:.0f} of {part[2] * part[3]} pixels ({reason})")
        time.sleep(1)
        studio.retake(shot)


def records(project):
    """The whole records of a project's log."""
    lines = (project / "log.jsonl").read_text().splitlines()
    return [json.loads(line)["record"] for line in lines if line.endswith("}")]


def labels(project):
    return [record["command"] for record in records(project) if "command" in record]


def count(project, start):
    return sum(label.startswith(start) for label in labels(project))


def accept(studio, project):
    """What is proposed; on a slow machine there may be nothing yet, so that the key is pressed again."""
    def accepted():
        if count(project, "Accept") == 0:
            studio.key("Return")
            time.sleep(2)
        return count(project, "Accept") == 1

    wait_for("the lights are accepted", accepted)


def kept_session(studio):
    """The log of the unsaved session that is open, once there is one."""
    folder = wait_for("the demo scene opens", lambda: next(iter(studio.unsaved.glob(f"untitled-{studio.process.pid}-*.lum")), None))
    wait_for("its log begins", lambda: (folder / "log.jsonl").exists() and records(folder))
    return folder


def count_colors(studio, part):
    """How many colours a part of the screen (WxH+X+Y) has."""
    probe = studio.output / "probe.png"
    subprocess.run(["import", "-window", "root", "-crop", part, "+repage", probe], env=studio.env, check=True)
    colors = int(subprocess.run(["identify", "-format", "%k", probe], check=True, capture_output=True).stdout)
    probe.unlink()
    return colors


def ready(studio):
    """Until the window shows the picture: its tool strip and a bright hint are there long before, so look at the middle."""
    wait_for("the picture shows", lambda: count_colors(studio, "600x400+310+150") > 500)


def drive(play):
    """play(studio, output) at a window of its own. Words: LUMINIST OUTPUT_FOLDER ... returns the exit status."""
    missing = [tool for tool in ("Xvfb", "xdotool", "import", "identify", "compare") if not shutil.which(tool)]
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (tools/packages test)")
        return SKIPPED
    luminist, output = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(output, ignore_errors=True)
    output.mkdir(parents=True)
    with Display() as display:
        studio = Studio(luminist, display.name, output / "state", output)
        try:
            play(studio, output)
        except Fault as fault:
            print(fault)
            subprocess.run(["import", "-window", "root", output / "fault.png"], env=studio.env, check=False)
            return 1
        finally:
            if studio.process and studio.process.poll() is None:
                studio.kill()
    return 0


def replayed_rig(studio, project):
    """The rig that a project's log comes to."""
    subprocess.run([studio.luminist, "replay", project, "-o", studio.output / "replayed"], check=True)
    return (studio.output / "replayed" / "rig.toml").read_text()
