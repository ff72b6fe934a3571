#!/usr/bin/env python3
"""Computes two machines with CalculiX on the mesh of deadpoint, and holds the two results against each other.

  stack    a transient with contact conductances (benchmarks/calculix/stack.toml): the same cells, the same time steps
  starter  the frame of the starter press, bonded from ten parts: deformation under the temperatures that deadpoint found

Prints docs/validation/calculix.md, or writes it with --write. Installs Debian's calculix-ccx where ccx is missing.
"""

import argparse
import datetime
import os
import platform
import re
import resource
import struct
import subprocess
import sys
import tempfile
import time
import tomllib
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "validation" / "calculix.md"
STACK = ROOT / "benchmarks" / "calculix" / "stack.toml"
STARTER = ROOT / "cases" / "starter" / "case.toml"
DURATION = 3600  # [s], of the stack
LAYER = 1e-3  # [m], thickness of the elements that stand for a contact
SOLVERS = ["ITERATIVE SCALING", "ITERATIVE CHOLESKY", "SPOOLES"]
# By number of nodes: those of the faces S1, S2, ... of CalculiX, counter-clockwise as seen from within.
FACES = {8: [(0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)],
         4: [(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)]}


def fail(text, remedy):
    sys.exit(f"error: {text}\n  help: {remedy}")


def quantity(text, unit):
    """The number of a quantity that must be stated in SI units; degC stays degC."""
    number, given = text.split(" ", 1)
    if given != unit:
        fail(f"'{text}' is not in {unit}", "state the case's quantities in the units that this script expects")
    return float(number)


# ---------------------------------------------------------------- programs

def run_timed(command, folder, log):
    """Runs a command on one thread; wall and processor seconds."""
    environment = os.environ | {"OMP_NUM_THREADS": "1", "CCX_NPROC_EQUATION_SOLVER": "1"}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    with open(folder / log, "w") as out:
        done = subprocess.run([str(c) for c in command], cwd=folder, env=environment, stdout=out, stderr=subprocess.STDOUT)
    wall = time.monotonic() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        print((folder / log).read_text()[-2000:], file=sys.stderr)
        fail(f"{command[0]} ended with code {done.returncode}", f"see {folder / log}")
    return {"wall": wall, "cpu": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime}


def need_calculix():
    if not subprocess.run(["which", "ccx"], capture_output=True).returncode == 0:
        subprocess.run(["apt-get", "install", "-y", "--no-install-recommends", "calculix-ccx"], check=True)
    text = subprocess.run(["ccx", "-v"], capture_output=True, text=True).stdout
    return re.search(r"Version ([\d.]+)", text).group(1)


def run_ccx(deck, folder, name):
    (folder / f"{name}.inp").write_text(deck)
    taken = run_timed(["ccx", name], folder, f"{name}.log")
    if "Job finished" not in (folder / f"{name}.log").read_text():
        fail(f"CalculiX did not finish {name}", f"see {folder / (name + '.log')}")
    return taken


# ---------------------------------------------------------------- files of deadpoint

class Mesh:
    """mesh.inp of `deadpoint mesh --calculix`."""

    def __init__(self, path):
        self.nodes, self.elements, self.parts, self.surfaces = {}, {}, {}, {}
        rows = None
        for line in path.read_text().splitlines():
            if line.startswith("**"):
                continue
            if line.startswith("*"):
                keys = dict(k.strip().split("=") for k in line.split(",")[1:])
                if line.startswith("*NODE"):
                    rows = lambda v: self.nodes.__setitem__(int(v[0]), tuple(map(float, v[1:])))
                elif line.startswith("*ELEMENT"):
                    cells = self.parts.setdefault(keys["ELSET"], [])

                    def rows(v, cells=cells):
                        cells.append(int(v[0]))
                        self.elements[int(v[0])] = tuple(map(int, v[1:]))
                else:
                    faces = self.surfaces.setdefault(keys["NAME"], [])
                    rows = lambda v, faces=faces: faces.append((int(v[0]), int(v[1].strip()[1:])))
                continue
            rows(line.split(","))

    def face_nodes(self, face):
        element = self.elements[face[0]]
        return [element[i] for i in FACES[len(element)][face[1] - 1]]

    def part_of_element(self):
        return {e: part for part, elements in self.parts.items() for e in elements}

    def nodes_of(self, part):
        return sorted({n for e in self.parts[part] for n in self.elements[e]})


def key_of(position):
    return tuple(round(1e7 * x) for x in position)


def read_vtu(path):
    """Points and point arrays of one of deadpoint's .vtu files."""
    raw = path.read_bytes()
    marker = raw.index(b'<AppendedData encoding="raw">\n_') + 31
    types = {"Float32": "f", "Float64": "d", "Int32": "i", "UInt32": "I", "UInt8": "B", "Int64": "q"}
    arrays = {}
    for kind, name, offset in re.findall(rb'<DataArray type="(\w+)" Name="([^"]*)"[^>]*offset="(\d+)"', raw[:marker]):
        at = marker + int(offset)
        count, _, _ = struct.unpack_from("<3Q", raw, at)
        sizes = struct.unpack_from(f"<{count}Q", raw, at + 24)
        at += 24 + 8 * count
        data = b""
        for size in sizes:
            data += zlib.decompress(raw[at:at + size])
            at += size
        code = types[kind.decode()]
        arrays[name.decode()] = struct.unpack(f"<{len(data) // struct.calcsize(code)}{code}", data)
    return arrays


def triples(values):
    return list(zip(values[0::3], values[1::3], values[2::3]))


def field_files(folder):
    """(time, path) of the fields of a run."""
    text = (folder / "fields.pvd").read_text()
    return [(float(t), folder / f) for t, f in re.findall(r'timestep="([^"]+)"[^>]*file="([^"]+)"', text)]


# ---------------------------------------------------------------- decks

def node_lines(nodes):
    return "*NODE, NSET=ALL\n" + "".join(f"{n}, {x:.12e}, {y:.12e}, {z:.12e}\n" for n, (x, y, z) in nodes.items())


def element_lines(mesh, part):
    kind = "C3D8" if len(mesh.elements[mesh.parts[part][0]]) == 8 else "C3D4"
    return f"*ELEMENT, TYPE={kind}, ELSET={part}\n" + "".join(
        f"{e}, " + ", ".join(map(str, mesh.elements[e])) + "\n" for e in mesh.parts[part])


def layer_elements(mesh, side_a, side_b, first):
    """Elements between the matching faces of two sides, numbered on from `first`."""
    at = {}
    for face in side_b:
        for n in mesh.face_nodes(face):
            at[key_of(mesh.nodes[n])] = n
    result = []
    for face in side_a:
        a = mesh.face_nodes(face)[::-1]  # counter-clockwise as seen from the layer, since FACES looks into the element
        try:
            b = [at[key_of(mesh.nodes[n])] for n in a]
        except KeyError:
            fail("the meshes of an interface do not match", "choose cell sizes that divide the edges of both parts")
        result.append((first + len(result), *a, *b))
    return result


def heat_deck(mesh, case, solver, step, duration, every):
    """The transient: contacts as layers that conduct h t across and nothing along, which is the film exactly."""
    part_of = mesh.part_of_element()
    level = {part: sum(mesh.nodes[n][1] for n in mesh.nodes_of(part)) for part in mesh.parts}
    lift = {part: LAYER * i for i, part in enumerate(sorted(mesh.parts, key=level.get))}
    nodes = {}
    for part in mesh.parts:
        for n in mesh.nodes_of(part):
            x, y, z = mesh.nodes[n]
            nodes[n] = (x, y + lift[part], z)
    text = node_lines(nodes)
    for part in mesh.parts:
        text += element_lines(mesh, part)
    next_element = max(mesh.elements) + 1
    for joint, data in case["joints"].items():
        for interface in data["interfaces"]:
            name = f"{joint}_{interface['name']}"
            layer = layer_elements(mesh, mesh.surfaces[f"INTERFACE_{name}_A"], mesh.surfaces[f"INTERFACE_{name}_B"],
                                   next_element)
            next_element += len(layer)
            text += f"*ELEMENT, TYPE=C3D8, ELSET=LAYER_{name}\n" + "".join(", ".join(map(str, e)) + "\n" for e in layer)
            conductance = 1 / quantity(interface["conductance"]["resistance"], "m^2 K/W")
            text += (f"*MATERIAL, NAME=LAYER_{name}\n*CONDUCTIVITY, TYPE=ORTHO\n1e-12, {conductance * LAYER:.12g}, 1e-12\n"
                     f"*SPECIFIC HEAT\n1e-12\n*DENSITY\n1e-12\n*SOLID SECTION, ELSET=LAYER_{name}, MATERIAL=LAYER_{name}\n")
    for name, part in case["parts"].items():
        m = case["materials"][part["material"]]
        text += (f"*MATERIAL, NAME=M_{name}\n*CONDUCTIVITY\n{quantity(m['conductivity'], 'W/m/K')}\n"
                 f"*SPECIFIC HEAT\n{quantity(m['specific_heat'], 'J/kg/K')}\n*DENSITY\n{quantity(m['density'], 'kg/m^3')}\n"
                 f"*SOLID SECTION, ELSET=PART_{name}, MATERIAL=M_{name}\n")
    start = quantity(case["machine"]["initial_temperature"], "degC")
    ambient = quantity(case["machine"]["ambient"], "degC")
    steps = round(duration / step)
    text += (f"*INITIAL CONDITIONS, TYPE=TEMPERATURE\nALL, {start}\n*STEP, INC={steps + 1}\n"
             f"*HEAT TRANSFER, DIRECT, SOLVER={solver}\n{step:.12g}, {duration:.12g}\n")
    for name, surface in case["surfaces"].items():
        faces = mesh.surfaces.get(f"SURFACE_{name}", [])
        if "film" in surface:
            h = quantity(surface["film"]["coefficient"], "W/m^2/K")
            text += "*FILM\n" + "".join(f"{e}, F{f}, {ambient}, {h}\n" for e, f in faces)
        if "heat_flux" in surface:
            q = quantity(surface["heat_flux"], "W/m^2")
            text += "*DFLUX\n" + "".join(f"{e}, S{f}, {q}\n" for e, f in faces)
    assert len(part_of) == len(mesh.elements)
    return text + f"*NODE PRINT, NSET=ALL, FREQUENCY={every}\nNT\n*END STEP\n"


def read_dat(path):
    """Values printed at nodes: {time: {node: values}}."""
    result, rows = {}, None
    for line in path.read_text().splitlines():
        if "time" in line:
            rows = result.setdefault(float(line.split()[-1]), {})
        elif line.strip() and rows is not None:
            values = line.split()
            rows[int(values[0])] = tuple(map(float, values[1:]))
    return result


# ---------------------------------------------------------------- the transient

def compare_stack(deadpoint, folder, scale):
    case = tomllib.loads(STACK.read_text())
    smaller = ["--size", scale, "--set", f"operation.0.duration={DURATION / scale:g} s"]
    run_timed([deadpoint, "mesh", STACK, "--calculix", *smaller, "-o", folder / "mesh"], folder, "mesh.log")
    mesh = Mesh(folder / "mesh" / "mesh.inp")
    step = quantity(case["numerics"]["max_step"], "s")
    duration = DURATION / scale
    trials = {s: run_ccx(heat_deck(mesh, case, s, step, 5 * step, 5), folder, "trial") for s in SOLVERS}
    solver = min(trials, key=lambda s: trials[s]["cpu"])
    every = round(duration / step / 6)
    theirs_time = run_ccx(heat_deck(mesh, case, solver, step, duration, every), folder, "stack")
    theirs = read_dat(folder / "stack.dat")
    load = os.getloadavg()[1]
    ours_time = run_timed([deadpoint, "run", "--quiet", "--ranks", "1", STACK, *smaller, "--set",
                           f"output.field_times={[f'{k * duration / 6:g} s' for k in range(1, 6)]}".replace("'", '"'),
                           "-o", folder / "stack"], folder, "deadpoint.log")

    at = {}
    for part in mesh.parts:
        for n in mesh.nodes_of(part):
            at.setdefault(key_of(mesh.nodes[n]), []).append(n)
    files = field_files(folder / "stack")
    start = quantity(case["machine"]["initial_temperature"], "degC")
    rows, largest_rise = [], max(v[0] - start for v in theirs[max(theirs)].values())
    for when, path in files:
        printed = min(theirs, key=lambda t: abs(t - when))
        if abs(printed - when) > 1e-3 * step:
            fail(f"CalculiX printed no temperatures at {when} s", "let the field times be multiples of its interval")
        arrays = read_vtu(path)
        ours = {}
        for x, value in zip(triples(arrays["points"] if "points" in arrays else arrays["Points"]),
                            arrays["temperature [degC]"]):
            ours.setdefault(key_of(x), []).append(value)
        worst = square = count = 0
        for key, numbers in at.items():
            # Two nodes at one place are the two sides of a contact: pair them by size.
            for a, b in zip(sorted(ours[key]), sorted(theirs[printed][n][0] for n in numbers)):
                worst, square, count = max(worst, abs(a - b)), square + (a - b) ** 2, count + 1
        assert count == len(mesh.nodes)
        rows.append((when, max(v[0] - start for v in theirs[printed].values()), worst, (square / count) ** 0.5))
    return {"cells": len(mesh.elements), "nodes": len(mesh.nodes), "steps": round(duration / step), "step": step,
            "trials": trials, "solver": solver, "theirs": theirs_time, "ours": ours_time, "rows": rows,
            "rise": largest_rise, "load": load}


# ---------------------------------------------------------------- the deformation

UNITS = {"Pa": 1, "GPa": 1e9, "1/K": 1, "1": 1}


def frame_deck(mesh, case, parts, temperature):
    """The bonded parts under given temperatures: ties of the finer side's nodes to the coarser side's faces."""
    elements = {part: mesh.parts[f"PART_{part}"] for part in parts}
    fineness = {part: len(mesh.nodes_of(f"PART_{part}")) / sum(size_of(mesh, e) for e in elements[part]) for part in parts}
    nodes = {n: mesh.nodes[n] for part in parts for n in mesh.nodes_of(f"PART_{part}")}
    text = node_lines(nodes)
    for part in parts:
        text += element_lines(mesh, f"PART_{part}")
    part_of = mesh.part_of_element()
    ties = 0
    for name in [s[:-2] for s in mesh.surfaces if s.startswith("BOND_") and s.endswith("_A")]:
        sides = {}
        for side in ("_A", "_B"):
            faces = mesh.surfaces[name + side]
            sides[part_of[faces[0][0]][5:]] = (name + side, faces)
        if not set(sides) <= set(parts):
            continue
        ties += 1
        slave, master = sorted(sides, key=fineness.get, reverse=True)
        for part in (slave, master):
            surface, faces = sides[part]
            text += f"*SURFACE, NAME={surface}, TYPE=ELEMENT\n" + "".join(f"{e}, S{f}\n" for e, f in faces)
        text += (f"*TIE, NAME=T{ties}, POSITION TOLERANCE=2e-3, ADJUST=NO\n{sides[slave][0]}, {sides[master][0]}\n")
    for part in parts:
        m = case["materials"][case["parts"][part]["material"]]
        value = lambda key: float(m[key].split()[0]) * UNITS[m[key].split()[1]] if isinstance(m[key], str) else m[key]
        text += (f"*MATERIAL, NAME=M_{part}\n*ELASTIC\n{value('youngs_modulus'):.12g}, {value('poissons_ratio'):.12g}\n"
                 f"*EXPANSION, ZERO=20\n{value('expansion'):.12g}\n*SOLID SECTION, ELSET=PART_{part}, MATERIAL=M_{part}\n")
    feet = sorted({n for f in mesh.surfaces["SURFACE_feet"] for n in mesh.face_nodes(f)})
    first = min(feet, key=lambda n: mesh.nodes[n][0] + mesh.nodes[n][2])
    second = max(feet, key=lambda n: mesh.nodes[n][0] - mesh.nodes[n][2])
    text += "*BOUNDARY\n" + "".join(f"{n}, 2, 2\n" for n in feet)
    text += f"{first}, 1, 1\n{first}, 3, 3\n{second}, 3, 3\n"
    text += "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nALL, 20\n*STEP\n*STATIC, SOLVER=SPOOLES\n*TEMPERATURE\n"
    text += "".join(f"{n}, {temperature[n]:.7g}\n" for n in nodes)
    return text + "*NODE PRINT, NSET=ALL\nU\n*END STEP\n", ties


def size_of(mesh, element):
    """About the volume of an element: that of its bounding box."""
    corners = [mesh.nodes[n] for n in mesh.elements[element]]
    result = 1.0
    for axis in range(3):
        result *= max(c[axis] for c in corners) - min(c[axis] for c in corners)
    return result


def without_free_motion(places, moves):
    """Displacements less the best shift in x and z and turn about y, which nothing holds."""
    rows = []
    for (x, _, z), (u, _, w) in zip(places, moves):
        rows += [((1, 0, z), u), ((0, 1, -x), w)]
    matrix = [[sum(a[i] * a[j] for a, _ in rows) for j in range(3)] + [sum(a[i] * b for a, b in rows)] for i in range(3)]
    for i in range(3):  # Gauss
        for j in range(3):
            if j != i:
                factor = matrix[j][i] / matrix[i][i]
                matrix[j] = [p - factor * q for p, q in zip(matrix[j], matrix[i])]
    a, b, c = (matrix[i][3] / matrix[i][i] for i in range(3))
    return [(u - a - c * z, v, w - b + c * x) for (x, _, z), (u, v, w) in zip(places, moves)]


def compare_frame(deadpoint, folder, scale):
    run_timed([deadpoint, "mesh", STARTER, "--calculix", "--size", scale, "-o", folder / "frame-mesh"], folder, "mesh.log")
    run_timed([deadpoint, "run", "--quiet", "--ranks", "1", STARTER, "--size", scale, "-o", folder / "frame"], folder,
              "frame-run.log")
    mesh = Mesh(folder / "frame-mesh" / "mesh.inp")
    case = tomllib.loads((folder / "frame" / "case.toml").read_text())
    parts = [name for name, part in case["parts"].items() if part["body"] == "frame" and f"PART_{name}" in mesh.parts]
    arrays = read_vtu(field_files(folder / "frame")[-1][1])
    # Several nodes stand at one place, one per part that meets there; they are told apart by their part's number.
    order = [p[5:] for p in mesh.parts]
    at = {}
    for index, (cell_nodes, number) in enumerate(zip(cells_of(arrays), arrays["part"])):
        for n in cell_nodes:
            at[(number, key_of(arrays["Points"][3 * n:3 * n + 3]))] = n
    ours = {}
    for part in parts:
        for n in mesh.nodes_of(f"PART_{part}"):
            ours[n] = at[(order.index(part), key_of(mesh.nodes[n]))]
    temperature = {n: arrays["temperature [degC]"][i] for n, i in ours.items()}
    deck, ties = frame_deck(mesh, case, parts, temperature)
    taken = run_ccx(deck, folder, "frame-ccx")
    theirs = next(iter(read_dat(folder / "frame-ccx.dat").values()))
    numbers = sorted(ours)
    places = [mesh.nodes[n] for n in numbers]
    moved = arrays["displacement [mm]"]
    u_ours = without_free_motion(places, [[1e-3 * c for c in moved[3 * ours[n]:3 * ours[n] + 3]] for n in numbers])
    u_theirs = without_free_motion(places, [theirs[n] for n in numbers])
    apart = [sum((a - b) ** 2 for a, b in zip(u, v)) ** 0.5 for u, v in zip(u_ours, u_theirs)]
    largest = max(sum(c * c for c in u) ** 0.5 for u in u_theirs)

    def mean_height(surface, moves):
        wanted = {n for f in mesh.surfaces[surface] for n in mesh.face_nodes(f)}
        values = [m[1] for n, m in zip(numbers, moves) if n in wanted]
        return sum(values) / len(values)

    gaps = [mean_height("INTERFACE_crank_bearing_front_A", moves) - mean_height("SURFACE_table_top", moves)
            for moves in (u_ours, u_theirs)]
    return {"nodes": len(numbers), "parts": len(parts), "ties": ties, "largest": largest, "worst": max(apart),
            "rms": (sum(a * a for a in apart) / len(apart)) ** 0.5, "gaps": gaps, "theirs": taken,
            "hottest": max(temperature.values())}


def cells_of(arrays):
    start = 0
    for end in arrays["offsets"]:
        yield arrays["connectivity"][start:end]
        start = end


# ---------------------------------------------------------------- the page

def processor():
    match = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())
    return match.group(1) if match else platform.processor()


def page(versions, stack, frames):
    table = "\n".join(f"| {t:.0f} | {rise:.3f} | {worst:.5f} | {100 * worst / stack['rise']:.4f} | {rms:.5f} |"
                      for t, rise, worst, rms in stack["rows"])
    trials = ", ".join(f"{s} {t['cpu']:.1f} s" for s, t in stack["trials"].items())
    shares = "\n".join(
        f"| {f['scale']} | {f['nodes']} | {1e6 * f['largest']:.2f} | {1e6 * f['worst']:.3f} | {100 * f['worst'] / f['largest']:.2f} "
        f"| {1e6 * f['rms']:.3f} | {1e6 * f['gaps'][0]:.3f} | {1e6 * f['gaps'][1]:.3f} |" for f in frames)
    return f"""# Beside CalculiX

Written with `scripts/compare-calculix.py` on {datetime.date.today()}: deadpoint {versions[0]}, CalculiX {versions[1]} (Debian),
{processor()}, one thread each.

## A transient with contact conductances

`benchmarks/calculix/stack.toml`: three blocks, two contacts of 2000 and 500 W/m2/K, a flux, and convection. The mesh has {stack['cells']} hexahedra
of first order and {stack['nodes']} nodes; the run has {stack['steps']} steps of {stack['step']:g} s. Both programs use the same cells and the
same steps. In CalculiX a contact is a layer of elements of thickness t = {1e3 * LAYER:g} mm. It has the conductivity h t
across, none along, and no heat capacity, which is exactly deadpoint's contact conductance h.

| time [s] | largest rise [K] | largest difference of any node [K] | of the largest rise [%] | root mean square [K] |
|---|---|---|---|---|
{table}

The time integration differs: CalculiX uses implicit Euler (first order), deadpoint TR-BDF2 (second order). The aim is a largest
difference of 0.1 % of the rise.

| | wall time [s] | processor time [s] |
|---|---|---|
| CalculiX, {stack['solver'].lower()} | {stack['theirs']['wall']:.1f} | {stack['theirs']['cpu']:.1f} |
| deadpoint, the whole command | {stack['ours']['wall']:.1f} | {stack['ours']['cpu']:.1f} |
| ratio | {stack['theirs']['wall'] / stack['ours']['wall']:.1f} | {stack['theirs']['cpu'] / stack['ours']['cpu']:.1f} |

Five steps with each solver of CalculiX took: {trials}; the
fastest solver did the run. deadpoint's time includes meshing and result files. The load average of the machine was
{stack['load']:.0f}. If it exceeds the number of processors, wall times exceed processor times for both programs.

## The deformation of a bonded frame

The case is the frame of the starter press after three hours: ten parts of two materials with meshes that do not match. Both
programs use the temperatures that deadpoint computed. CalculiX joins the parts by `*TIE`: the nodes of the finer side follow
the faces of the coarser side point by point. deadpoint joins them in the mean (mortar ties). The rigid motions that the feet
leave free are subtracted from both results. The gap is the mean height of the front bearing's bore less that of the table.

| `--size` | nodes | largest displacement [um] | largest difference [um] | [%] | root mean square [um] | gap, deadpoint [um] | gap, CalculiX [um] |
|---|---|---|---|---|---|---|---|
{shares}

In an element of first order CalculiX uses one temperature, the mean of its nodes; deadpoint uses the interpolated field.
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true", help="write docs/validation/calculix.md instead of printing it")
    parser.add_argument("--program", type=Path, default=ROOT / "build" / "release" / "app" / "deadpoint")
    parser.add_argument("--keep", type=Path, help="do the work in this folder and leave it")
    parser.add_argument("--sizes", nargs="+", default=["1", "0.7"], help="cell sizes of the frame")
    parser.add_argument("--stack", type=int, default=1, help="divides time and cells along each edge of the stack: a trial")
    options = parser.parse_args()
    if not options.program.exists():
        fail(f"{options.program} does not exist", "run `make build` first, or name the program with --program")
    deadpoint = options.program.resolve()
    theirs = need_calculix()
    ours = subprocess.run([deadpoint, "--version"], capture_output=True, text=True).stdout.split()[-1]
    with tempfile.TemporaryDirectory() as scratch:
        folder = (options.keep or Path(scratch)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        stack = compare_stack(deadpoint, folder, options.stack)
        frames = []
        for size in options.sizes:
            below = folder / f"size-{size}"
            below.mkdir(exist_ok=True)
            frames.append(compare_frame(deadpoint, below, size) | {"scale": size})
        text = page((ours, theirs), stack, frames)
    if options.write:
        PAGE.write_text(text)
    else:
        print(text)
    worst = max(row[2] for row in stack["rows"]) / stack["rise"]
    if worst > 1e-3:
        sys.exit(f"the temperatures differ by {100 * worst:.3f} % of the rise, more than 0.1 %")


if __name__ == "__main__":
    main()
