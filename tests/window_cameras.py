"""A step of the window's test: paint through two cameras, one rig for both."""
import json
import math
import struct
import time

from window_driver import ROOT, Fault, count, count_colors, kept_session, ready, records, wait_for

VIEW = (93, 12)
LOOK_THROUGH = (122, 158)
SECOND_CAMERA = (380, 180)
SOLVE_TOGETHER = (338, 668)
TOGETHER = "170x20+530+660"  # where the error of both is told, once there is one


def with_second_camera(glb):
    """A glTF binary whose first camera is there once more, 40 degrees to its left around the middle."""
    size, = struct.unpack_from("<I", glb, 12)
    scene = json.loads(glb[20:20 + size])
    node = dict(next(node for node in scene["nodes"] if "camera" in node), name="left side")
    c, s = math.cos(math.radians(-40)), math.sin(math.radians(-40))
    middle = (0.25, 0.0, 0.0)

    def turned(x, y, z):
        return [c * x + s * z, y, c * z - s * x]

    m = node["matrix"]
    place = turned(*(a - b for a, b in zip(m[12:15], middle)))
    node["matrix"] = [v for i in (0, 4, 8) for v in [*turned(*m[i:i + 3]), 0.0]] + [a + b for a, b in zip(place, middle)] + [1.0]
    scene["nodes"].append(node)
    scene["scenes"][0]["nodes"].append(len(scene["nodes"]) - 1)
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    rest = glb[20 + size:]
    return struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A) + text + rest


def cameras(studio):
    """A stroke through each of two cameras, and one rig that is found for both, accepted and undone."""
    scene = studio.output / "two_cameras.glb"
    scene.write_bytes(with_second_camera((ROOT / "meshes" / "still_life" / "still_life.glb").read_bytes()))
    studio.start(scene)
    project = kept_session(studio)
    ready(studio)
    time.sleep(2)
    studio.drag((0.38, 0.33), (0.40, 0.50), (0.47, 0.40))
    wait_for("the first stroke is recorded", lambda: count(project, "Paint 1 stroke") == 1)
    studio.do("mousemove", *VIEW)
    time.sleep(0.5)
    studio.do("click", 1)
    time.sleep(1)
    for place in (LOOK_THROUGH, (LOOK_THROUGH[0] + 40, LOOK_THROUGH[1]), (SECOND_CAMERA[0], LOOK_THROUGH[1])):
        studio.do("mousemove", *place)
        time.sleep(0.7)
    studio.click(*SECOND_CAMERA)
    wait_for("the other camera is looked through", lambda: count(project, "Look through left side") == 1)
    time.sleep(3)
    studio.drag((0.45, 0.45), (0.52, 0.52), (0.60, 0.50))
    wait_for("the second stroke is recorded", lambda: count(project, "Paint 1 stroke") == 2)
    time.sleep(6)
    studio.shot("painted_through_two_cameras")
    if count_colors(studio, TOGETHER) > 1:
        raise Fault("something is told about both before they are solved together")
    studio.click(*SOLVE_TOGETHER)
    wait_for("both are solved", lambda: count_colors(studio, TOGETHER) > 3)
    time.sleep(2)
    studio.shot("solved_for_two_cameras")
    studio.key("Return")
    wait_for("one rig is accepted for both", lambda: count(project, "Accept a solve of 2 pictures") == 1)
    time.sleep(2)
    studio.shot("accepted_for_two_cameras")
    before = len(records(project))
    studio.key("ctrl+z")
    wait_for("it can be undone", lambda: len(records(project)) == before + 1)
    studio.kill()
