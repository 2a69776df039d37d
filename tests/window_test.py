#!/usr/bin/env python3
"""Drives the studio window with mouse and keys, as the paper's Figure 2 begins, and checks what it recorded.

usage: window_test.py LUMINIST OUTPUT_FOLDER

Needs Xvfb, xdotool and ImageMagick's import; without one of them it says so and ends with status 77 (skipped).
Screenshots of every step are left in the output folder.
"""
import subprocess
import sys
import time

from window_cameras import cameras
from window_driver import RIGHT_PANEL, ROOT, Fault, accept, compare, count, drive, kept_session, labels, place, ready, records, replayed_rig, wait_for

SKIPPED = 77
TAB_LIGHTS = (977, 42)  # of the panels on the right
TAB_PAINT = (1078, 42)
ADD_LAYER = (1171, 69)  # the first button beside the heading "Layers"
# The frames of a scene that moves, below the picture: the first frame on the ruler, and the button of new keys.
RULER = (424, 588)
NEW_KEY = (310, 586)


def edit_strokes(studio, project):
    """The arrow selects the stroke on the bowl, drags it, deletes it; a layer is added, and all of it is undone."""
    studio.key("a")
    studio.do("mousemove", *place(0.535, 0.72))
    time.sleep(0.3)
    studio.do("click", 1)
    studio.do("mousemove", *TAB_PAINT)
    time.sleep(0.5)
    studio.do("click", 1)
    time.sleep(1)
    studio.shot("stroke_selected")
    studio.drag((0.535, 0.72), (0.60, 0.68))
    wait_for("the stroke is moved", lambda: count(project, "Move stroke 2") == 1)
    studio.key("Delete")
    wait_for("the stroke is deleted", lambda: count(project, "Delete stroke 2") == 1)
    studio.do("mousemove", *ADD_LAYER)
    time.sleep(0.5)
    studio.do("click", 1)
    wait_for("a layer is added", lambda: count(project, "Add layer") == 1)
    time.sleep(1)
    studio.shot("layers")
    before = len(records(project))
    studio.key("ctrl+z", "ctrl+z", "ctrl+z")
    wait_for("layer and strokes are as before", lambda: len(records(project)) == before + 3)
    studio.click(*TAB_LIGHTS)
    studio.key("b")


TABS = {"style": 1030, "paint": 1078, "explore": 1134, "history": 1195}
MENUS = {"file": (23, (5, 22, 250, 140)), "view": (95, (76, 22, 272, 306))}
KEYS = (300, 138, 680, 444)


def park(studio):
    """The pointer where no control is: over the canvas, beside the picture."""
    studio.do("mousemove", *place(1.2, 0.02))
    time.sleep(1.5)


def compare_panels(studio):
    """Before anything is painted all panels are as they always are; so are menus and dialogs."""
    for name, x in TABS.items():
        studio.click(x, 42)
        park(studio)
        compare(studio, f"tab_{name}", RIGHT_PANEL)
    studio.click(*TAB_LIGHTS)
    for name, (x, part) in MENUS.items():
        studio.click(x, 12)
        park(studio)
        compare(studio, f"menu_{name}", part)
        studio.do("key", "Escape")
        time.sleep(1)
    studio.key("question")
    park(studio)
    compare(studio, "keys", KEYS)
    studio.do("key", "Escape")
    time.sleep(1)


MATERIALS, CHOOSE = (1004, 194), (965, 222)  # the heading in the tab of styles, and what picks one in the picture
ROUGHNESS_LOCK, ROUGHNESS = (965, 474), (1175, 474)  # of the material that is selected


def turn_a_material(studio, project):
    """A click on the jug chooses its glaze; what a solve may turn is unlocked, a slider turns it, both are undone."""
    studio.click(TABS["style"], 42)
    studio.click(*MATERIALS)
    studio.click(*CHOOSE)
    studio.click(*place(0.45, 0.6))
    park(studio)
    compare(studio, "materials", RIGHT_PANEL)
    studio.click(*ROUGHNESS_LOCK)
    wait_for("a number of the glaze is free", lambda: count(project, "Unlock materials/jug_glaze/roughness") == 1)
    studio.do("mousemove", *ROUGHNESS)
    studio.do("mousedown", 1)
    for x in (1150, 1120):
        studio.do("mousemove", x, ROUGHNESS[1])
        time.sleep(0.3)
    studio.do("mouseup", 1)
    wait_for("it is set once", lambda: count(project, "Set materials/jug_glaze/roughness=") == 1)
    studio.shot("material_set")
    before = len(records(project))
    studio.key("ctrl+z", "ctrl+z")
    wait_for("both are undone", lambda: len(records(project)) == before + 2)
    park(studio)
    compare(studio, "materials", RIGHT_PANEL)
    if count(project, "Set materials/jug_glaze/roughness=") != 1:
        raise Fault("one drag of a slider is recorded more than once")
    studio.click(*MATERIALS)
    studio.click(*TAB_LIGHTS)


HOLDS = (1160, 216)  # the list of what holds of the light that is selected


def compare_light(studio, project):
    """A light that nothing was solved for: its row, what holds of it, its parameters."""
    studio.key("n")
    wait_for("a light is added", lambda: count(project, "Add light") == 1)
    time.sleep(2)
    park(studio)
    compare(studio, "light_added", RIGHT_PANEL)
    studio.click(*HOLDS)
    park(studio)
    compare(studio, "light_holds", RIGHT_PANEL)
    studio.do("key", "Escape")


def paint_and_accept(studio):
    project = kept_session(studio)
    ready(studio)
    compare(studio, "open")
    compare_panels(studio)
    turn_a_material(studio, project)
    strokes = [[(0.38, 0.33), (0.40, 0.50), (0.47, 0.40), (0.45, 0.22), (0.45, 0.60)], [(0.51, 0.70), (0.56, 0.74)],
               [(0.77, 0.73), (0.82, 0.77)]]
    for number, stroke in enumerate(strokes, 1):
        studio.drag(*stroke)
        wait_for(f"stroke {number} is recorded", lambda n=number: count(project, "Paint 1 stroke") == n)
    if count(project, "Add light") != 1:
        raise Fault(f"one light is added for the paint: {labels(project)}")
    time.sleep(3)
    studio.shot("painted")
    edit_strokes(studio, project)
    studio.key("s")
    studio.drag((0.66, 0.36), (0.66, 0.44), (0.64, 0.56))
    wait_for("the shadow is recorded", lambda: count(project, "Paint 1 stroke") == 4)
    studio.key("ctrl+Return")
    time.sleep(5)
    studio.shot("solving")
    accept(studio, project)
    time.sleep(1)
    studio.shot("accepted")
    return project


LIGHT_MENU = (1247, 97)  # of the first light in the list
RENAME, DUPLICATE = (1150, 114), (1150, 134)  # in that menu


def keep_the_list(studio, project):
    """The menu of a light: a copy and another name, each one command, both undone again."""
    for choice, start in ((DUPLICATE, "Duplicate light as light-2"), (RENAME, "Rename light to key")):
        studio.click(*LIGHT_MENU)
        studio.shot("light_menu")
        studio.click(*choice)
        if choice == RENAME:
            studio.do("key", "ctrl+a")
            studio.do("type", "--delay", "60", "key")
            studio.do("key", "Return")
        wait_for(f"\"{start}\" is recorded", lambda label=start: count(project, label) == 1)
        time.sleep(1)
        studio.shot("light_list")
        before = len(records(project))
        studio.key("ctrl+z")
        wait_for("it is undone", lambda n=before: len(records(project)) == n + 1)
        time.sleep(1)
        studio.click(1000, 97)  # the copy, or the new name, was selected and is gone


def differing_in(one, other):
    words = ["compare", "-metric", "AE", "-fuzz", "4%", one, other, "null:"]
    return int(float(subprocess.run(words, check=False, capture_output=True, text=True).stderr.split()[0]))


def stand_still(studio, name):
    """A screenshot of a window in which nothing changes any more, not even what says that it works."""
    def stands():
        before = studio.shot(name)
        time.sleep(2)
        return differing_in(before, studio.shot(name)) < 10

    wait_for("the window stands still", stands)
    return studio.shot(name)


def close_menus_by_escape(studio):
    studio.do("mousemove", 640, 707)
    before = stand_still(studio, "no_menu")
    studio.click(23, 12)
    opened = stand_still(studio, "file_menu")
    studio.do("mousemove", 640, 707)
    studio.do("key", "Escape")
    closed = stand_still(studio, "menu_closed")
    differing = [differing_in(before, shot) for shot in (opened, closed)]
    if not differing[0] > 5000 or differing[1] > 1500:
        raise Fault(f"a menu differs in {differing[0]} pixels, and after Esc in {differing[1]}")


def look_from_anywhere(studio):
    """The scene stands there plainly, then lit; it is turned, and the canvas comes back."""
    studio.key("v")
    ready(studio)
    studio.shot("orbit")
    studio.drag((0.5, 0.9), (0.8, 0.8))
    studio.shot("orbit_turned")
    time.sleep(6)
    studio.shot("orbit_lit")
    studio.key("v")
    ready(studio)


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
    lines = len(records(named))
    studio.key("ctrl+z")
    wait_for("the last stroke can be undone after the crash", lambda: len(records(named)) == lines + 1)
    studio.kill()


def recover_unsaved(studio):
    studio.start()
    project = kept_session(studio)
    ready(studio)
    studio.drag((0.42, 0.4), (0.45, 0.5))
    wait_for("a stroke is recorded", lambda: count(project, "Paint 1 stroke") == 1)
    killed = studio.process
    studio.kill(heard=False)  # a zombie holds no lock
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
             lambda: f'"pid":{studio.process.pid}' in (project / "lock").read_text())
    killed.wait()
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
    compare_light(studio, project)
    studio.kill()


def play(studio, output):
    studio.start()
    project = paint_and_accept(studio)
    keep_the_list(studio, project)
    close_menus_by_escape(studio)
    look_from_anywhere(studio)
    named = undo_redo_save(studio, project)
    crash_and_reopen(studio, named)
    recover_unsaved(studio)
    frames(studio)
    cameras(studio)
    lights = replayed_rig(studio, named).count("[[light]]")
    if lights != 1:
        raise Fault(f"the replayed project has {lights} lights, 1 was painted")
    print(f"window: every step is recorded; screenshots in {output}")


if __name__ == "__main__":
    sys.exit(drive(play))
