#!/usr/bin/env python3
"""Fails when a module includes another that its luminist_module(... DEPS ...) does not reach.

The declaration in src/<module>/CMakeLists.txt is the only one; this reads it. Also keeps heavy libraries in their
module: GL in gpu, raster and app, GLFW and ImGui in app, OpenMesh in prep, CGAL in prep, Embree in rays, OpenImageIO in image_io's helper.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIBRARIES = {  # include prefix: modules (or folders below the root) that may use it
    "epoxy/": {"gpu", "raster", "app"},
    "GLFW/": {"app"},
    "imgui": {"app"},
    "backends/imgui": {"app"},
    "EGL/": {"gpu"},
    "OpenMesh/": {"prep"},
    "CGAL/": {"prep"},
    "embree3/": {"rays"},
    "OpenImageIO/": {"image_io/helper"},
    "Eigen/": {"solve", "prep"},
    "tiny_gltf.h": {"scene"},
    "tiny_obj_loader.h": {"scene"},
    "CLI/": {"cli", "tools", "tests"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def declared_modules():
    modules = {}
    for lists in sorted((ROOT / "src").glob("*/CMakeLists.txt")):
        call = re.search(r"luminist_module\(\s*(\w+)([^)]*)\)", lists.read_text())
        if not call:
            continue
        words, deps, reading = call.group(2).split(), [], False
        for word in words:
            if word in ("DEPS", "LIBS", "PRIVATE_LIBS", "TEST_SHARDS", "SANITIZE_O0"):
                reading = word == "DEPS"
            elif reading:
                deps.append(word)
        modules[call.group(1)] = deps
    return modules


def reachable(module, modules):
    seen, stack = {module}, [module]
    while stack:
        for dep in modules.get(stack.pop(), []):
            if dep not in seen:
                seen.add(dep)
                stack.append(dep)
    return seen


def check_file(path, owner, allowed, modules):
    faults = []
    for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        name = match.group(1)
        place = f"{path.relative_to(ROOT)}:{number}"
        top = name.split("/")[0]
        if "/" in name and top in modules and top not in allowed:
            faults.append(f"{place}: {owner} does not depend on {top} (declare it in DEPS, or move the code)")
        for prefix, homes in LIBRARIES.items():
            if name.startswith(prefix) and not any(
                    str(path.relative_to(ROOT)).startswith((f"src/{h}/", f"{h}/")) for h in homes):
                faults.append(f"{place}: {prefix} belongs in {', '.join(sorted(homes))}")
    return faults


def main():
    modules = declared_modules()
    faults = []
    for module, deps in modules.items():
        faults += [f"src/{module}: unknown module {dep} in DEPS" for dep in deps if dep not in modules]
        allowed = reachable(module, modules)
        if any(module in reachable(dep, modules) for dep in deps):
            faults.append(f"src/{module}: its dependencies lead back to it")
        for path in sorted((ROOT / "src" / module).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                faults += check_file(path, module, allowed, modules)
    for folder in ("tools", "tests"):
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                faults += check_file(path, folder, set(modules), modules)
    print("\n".join(faults) if faults else f"layers: {len(modules)} modules, no fault")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
