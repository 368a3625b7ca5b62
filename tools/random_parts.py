#!/usr/bin/python3
"""Runs random parts on meshes of Gmsh, and judges them by what must hold.

    tools/random_parts.py SEED COUNT [--programs build/release/bin] [--keep DIR] [--jobs 2] [--only PATTERN]

A part is a plate, an angle, a tee, a dog bone, a lug, a ring, a notched plate or a polygon, with fillets, holes, an insert
or a chord of another metal, turned by any angle (part_shapes.py). Its cracks begin at sides, fillets, roots and holes, or
lie inside. It is held and loaded at sides, in holes and at points (part_cases.py), so much that K is that of metals.

It is run in all modes (random_scenes.py), as `stria check` sees it, and a fifth of these, or those that --only names:

    moved, turned, mirrored, scaled, reversed, louder, renumbered, from Abaqus: the same numbers (random_twins.py)
    split      triangles split by hand, as the program splits them; the same from Gmsh's format 4.1
    resumed    stopped and resumed, with the digits of the undisturbed run
    reaction   the forces on its support and on its other boundaries, which balance
    smaller    elements half as large: K changes as `stria check` says, and by less than a tenth where nothing warns
    energies   K, J and the released energy of the same part without flow and contact, growing (random_energies.py)

Gmsh is no package of this project; without it nothing is run. Exit code 1 where anything does not hold.
"""

import copy
import math
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import other_bodies  # noqa: E402
import other_words  # noqa: E402
import part_cases  # noqa: E402
import part_outlines  # noqa: E402
import part_shapes  # noqa: E402
import random_energies  # noqa: E402
import random_lives as lives  # noqa: E402
import random_scenes as scenes  # noqa: E402
import random_trials  # noqa: E402
import random_twins  # noqa: E402
from twins import Twin  # noqa: E402

MOST_SECONDS = 1.5  # by the estimate of `stria check`
LEAST_K = 20.0  # MPa sqrt(mm). Of less, J misses as much at a slight bend: stress along the faces counts there, and K is nothing
OFF_OF_CHECK = 2e-3  # of K: the program's half elements and those made here round otherwise
K_LINE = re.compile(r"# tip (\d+): K_I = (\S+), K_II = (\S+) MPa sqrt\(mm\) at the load factor (\S+)")
HALF_LINE = re.compile(r"#   on elements half as large K_I = (\S+), K_II = ([^:\s]+)")


UNRESOLVED = set(" ".join(other_words.COLUMNS[kind][0] for kind in ("K", "trials", "J")).split())  # of tips just behind a bend


def has_unresolved_tips(folder):
    summary = folder / "summary.json"
    return summary.exists() and re.search(r"turns sharply|crack bends", summary.read_text(encoding="utf-8")) is not None


class Trial:
    """A part on its mesh, and its case with loads that are large enough."""

    def __init__(self, seed, folder, programs):
        rng = random.Random(seed)
        self.seed, self.folder, self.programs, self.said = seed, folder, programs, ""
        self.part = part_shapes.part_of(rng)
        self.cracks = part_shapes.cracks_of(self.part, rng)
        size = rng.uniform(0.45, 1.0)
        self.element = size * rng.choice([0.5, 0.7, 1.0])
        wishes = {"size": size, "at_crack": self.element, "cracks": self.cracks, "recombination": rng.choice([0, 1, 2, 3, 3])}
        self.mesh = part_outlines.meshed(self.part, folder, **wishes) if self.cracks else None
        if self.mesh is None:
            return
        self.case = part_cases.case_of(self.part, self.mesh, self.cracks, self.element, rng)
        stress = self.case["material"].get("yield_stress", 400.0)
        target = rng.uniform(0.2, 0.7) * stress  # MPa sqrt(mm): a plastic zone of parts of a millimetre
        self.check = self.checked(self.case, self.mesh)
        most = self.largest_K()
        if most > 0.0:
            part_cases.sized(self.case, min(target / most, 0.2 * stress))  # loads of the factor 1 make about 1 MPa
            self.check = self.checked(self.case, self.mesh)

    def largest_K(self):
        return max((math.hypot(*K) for K in self.check["K"]), default=0.0)

    def checked(self, case, mesh, name="checked"):
        """What `stria check` says: K of each tip, that on elements half as large, warnings, and how it ends."""
        random_twins.write_mesh(self.folder / "body.msh", mesh)
        path = self.folder / f"{name}.toml"
        path.write_text(random_twins.case_text(case), encoding="utf-8")
        command = [str(self.programs / "stria"), "check", str(path)]
        result = subprocess.run(command, capture_output=True, text=True, env=scenes.ENVIRONMENT, timeout=600)
        of = lambda pattern, first: [tuple(map(float, found.groups()[first:first + 2])) for found in pattern.finditer(result.stdout)]
        factors = [float(found[4]) for found in K_LINE.finditer(result.stdout)]
        said = (result.stderr.strip().splitlines() or [""])[-1]
        warnings = re.findall(r"^# warning: (.*)$", result.stdout, re.M)
        seconds = re.search(r"estimate of the run: .*about (\S+) s of a processor", result.stdout)
        return {"seconds": float(seconds[1]) if seconds else 0.0, "K": of(K_LINE, 1), "half": of(HALF_LINE, 0), "factors": factors,
                "code": result.returncode, "said": said, "warnings": warnings}

    def run(self, name, case=None, mesh=None):
        return random_twins.run(self.programs, self.folder, name, case or self.case, mesh or self.mesh)


def in_all_modes(trial):
    """What is wrong, how the case ends, and its folder."""
    case = trial.folder / "case.toml"
    text = random_twins.case_text(trial.case)
    case.write_text(text, encoding="utf-8")
    begin = time.monotonic()
    ends = {mode: scenes.run(trial.programs, case, trial.folder / mode, mode) for mode in scenes.MODES}
    trial.seconds = (time.monotonic() - begin) / len(ends)
    code, said, warnings = ends["inprocess"]
    if {end[0] for end in ends.values()} - {code} or code not in (0, 2, 3):
        return [f"modes: {[end[:2] for end in ends.values()]}"], said, code
    wrong = [f"modes warn otherwise: {[end[2] for end in ends.values()]}"] if any(end[2] != warnings for end in ends.values()) else []
    sentence = lambda words: re.sub(r"^stria: [^:]*\.toml:\d*:? ?", "", words)
    if (2 in (trial.check["code"], code)) and (trial.check["code"], sentence(trial.check["said"])) != (code, sentence(said)):
        wrong.append(f"check ends with {trial.check['code']}: {trial.check['said']}; run with {code}: {said}")
    if code == 0:
        one, folder = scenes.numbers(trial.folder / "inprocess"), trial.folder / "inprocess"
        worst, where = max(scenes.difference(one, scenes.numbers(trial.folder / mode)) for mode in scenes.MODES[1:])
        wrong += [f"modes: {worst:.1e} of {where}"] if worst >= scenes.SAME else []
        broken = scenes.unlawful(folder, text, trial.element) or scenes.broken_balance(trial.programs, folder, text)
        wrong += [broken] if broken else []
        wrong += against_check(trial)
    return wrong, said, code


def against_check(trial):
    """K of the first cycle, which is nominal, and of `stria check`."""
    rows = lives.table(trial.folder / "inprocess/cycles.csv")
    firsts = [row for row in rows if row["cycle"] == rows[0]["cycle"]]
    if not firsts or "load_case" in trial.case or len(firsts) != len(trial.check["K"]):
        return []
    has_stress = any("initial_stress" in region for region in trial.case.get("region", []))
    for row, (K, _), factor in zip(firsts, trial.check["K"], trial.check["factors"]):
        largest = max(abs(k) for pair in trial.check["K"] for k in pair)
        if row.get("K_max") and K > 0.0 and not has_stress and "growth" not in trial.case and abs(float(row["K_max"]) - K) > 1e-4 * largest:
            return [f"K_max is {row['K_max']}, check says {K:g} at {factor:g}"]
    return []


def applied(trial):
    """Forces of loads of the factor 1, by boundary; None where a load is not one of [load] or no sum tells it."""
    nodes, _, edges, _ = trial.mesh
    polygon = {}
    for cell in trial.mesh[1]:
        for k, b in enumerate(cell):
            polygon[cell[k - 1], b] = True
    total = [0.0, 0.0]
    for boundary in trial.case["boundary"]:
        if "case" in boundary or "cosine" in boundary:
            return None
        if "force" in boundary:
            total = [x + f for x, f in zip(total, boundary["force"])]
        for name, a, b in edges:
            if name != boundary["on"]:
                continue
            a, b = (a, b) if (a, b) in polygon else (b, a)  # the metal to the left
            (x0, y0), (x1, y1) = nodes[a], nodes[b]
            length, inward = math.dist(nodes[a], nodes[b]), [y0 - y1, x1 - x0]
            middle = [(x0 + x1) / 2.0 - boundary.get("origin", [0.0, 0.0])[0], (y0 + y1) / 2.0 - boundary.get("origin", [0.0, 0.0])[1]]
            slope = boundary.get("traction_gradient", [[0.0, 0.0], [0.0, 0.0]])
            more = [row[0] * middle[0] + row[1] * middle[1] for row in slope]
            for axis in (0, 1):
                total[axis] += boundary.get("pressure", 0.0) * inward[axis]
                total[axis] += length * (boundary["traction"][axis] + more[axis]) if "traction" in boundary else 0.0
    return total


def reaction(trial, rng):
    """The support that is listed first, and moved by next to nothing, tells its force."""
    supports = [b for b in trial.case["boundary"] if b.get("displacement") == [0.0, 0.0]]
    if len([b for b in trial.case["boundary"] if "displacement" in b]) != 1 or len(supports) != 1 or "load_case" in trial.case:
        return None
    force, way = applied(trial), rng.uniform(-3.0, 3.0)
    if force is None:
        return None
    case, direction = copy.deepcopy(trial.case), [math.cos(way), math.sin(way)]
    support = next(b for b in case["boundary"] if "displacement" in b)
    support["displacement"] = [1e-15 * x for x in direction]
    case["boundary"] = [support] + [b for b in case["boundary"] if b is not support]
    (code, said), folder = trial.run("reaction", case)
    if code != 0:
        return f"{code} {said}"
    size = math.hypot(*force)
    for row in lives.table(folder / "history.csv"):
        factor, load = float(row["load_factor"]), float(row["load"])
        expected = -factor * sum(x * d for x, d in zip(force, direction))
        if abs(load - expected) > 1e-6 * size * max(abs(block["max"]) for block in case["load"]["blocks"]):
            return f"the support bears {load:g}, the loads want {expected:g} of up to {size * factor:g} at the factor {factor:g}"
    return None


def resumed(trial, rng):
    case, folder = trial.folder / "case.toml", trial.folder / "parts"
    ended = lives.interrupted(trial.programs, case, folder, rng.uniform(0.1, 0.7) * trial.seconds, rng)
    return f"{ended}" if ended[0] != 0 else lives.first_difference(folder, trial.folder / "inprocess")


def smaller(trial, _rng):
    check = trial.check
    if check["code"] != 0 or len(check["half"]) != len(check["K"]):
        return None
    is_split = any(len(cell) == 3 for cell in trial.mesh[1])
    mesh = part_outlines.halved(part_outlines.halved(trial.mesh) if is_split else trial.mesh)
    other = trial.checked(trial.case, mesh, "smaller")
    largest = max(abs(k) for pair in check["K"] for k in pair)
    for tip, (here, half, its) in enumerate(zip(check["K"], check["half"], other["K"])):
        if max(abs(a - b) for a, b in zip(half, its)) > OFF_OF_CHECK * largest and "refine" not in trial.case.get("fine", {}):
            return f"K of tip {tip} on half elements is {its}, check says {half}"
        if max(abs(a - b) for a, b in zip(here, half)) > 0.1 * largest and not check["warnings"]:
            return f"K of tip {tip} changes from {here} to {half} on half elements, and no warning says so"
    return None


def energies(trial, rng):
    case = other_bodies.elastic(trial.case, contact=False)
    case["growth"] = {"increment": trial.element * rng.uniform(0.5, 1.3), "direction": "straight"}
    case["load"] = {"steps": 4, "blocks": [{"cycles": 3, "max": trial.case["load"]["blocks"][0]["max"], "ratio": 0.0}]}
    for key in ("load_case", "closure"):
        case.pop(key, None)
    case["boundary"] = [b for b in case["boundary"] if "case" not in b]
    case["output"] = {"fields": "none", "faces": "none", "checkpoint_every": 0}
    if "fine" in case:
        case["fine"].pop("enrichment", None)  # without functions a crack grows by whole elements, and so does what it releases
    body, offs = trial, []
    body.has_border = True
    body.modulus = lambda row: part_cases.modulus_at(trial.part, case, (row["x"], row["y"]))
    for finer, mesh in ((1, trial.mesh), (2, None)):
        if finer > 1:
            mesh = part_outlines.halved(part_outlines.halved(trial.mesh))
            case["growth"]["increment"] /= 2.0
            case["load"]["blocks"][0]["cycles"] *= 2
        path = trial.folder / f"energies{finer}.toml"
        random_twins.write_mesh(trial.folder / "body.msh", mesh)
        path.write_text(random_twins.case_text(case), encoding="utf-8")
        code, said, warnings = scenes.run(trial.programs, path, path.with_suffix(""), "inprocess")
        if code != 0 or any("largest ring" in warning or "bends" in warning for warning in warnings):
            return None if code in (0, 2, 3) else f"{code} {said}"
        offs.append(random_energies.worst(body, random_energies.by_increment(path.with_suffix(""))))
        if all(offs[-1][name] <= random_energies.OFF[name] for name in offs[-1]):
            return None
    found = [f"{name} is off by {offs[0][name]:.1%}, finer by {offs[1][name]:.1%}" for name in offs[0]
             if offs[1][name] > max(random_energies.OFF[name], 0.7 * offs[0][name])]
    return ", ".join(found) or None


def mirrored(case, mesh):
    twin, told = other_words.mapped(case, mesh, lambda at: [-at[0], at[1]], lambda v: [v[0] if v[0] == "free" else -v[0], v[1]])
    told = (told[0], [cell[::-1] for cell in told[1]], *told[2:])
    return twin, told, lambda column, value: -value if column.startswith("K_II") else value


def gmsh_4_1(trial, rng):
    """Gmsh's own file, in its newer format; numbers of a text file lack a digit."""
    binary = rng.choice([[], ["-bin"]])
    names = [str(trial.folder / "part.geo"), "-o", str(trial.folder / "part41.msh")]
    command = [part_outlines.GMSH, "-2", *names, "-format", "msh41", *binary, "-v", "1"]
    if subprocess.run(command, capture_output=True, timeout=120).returncode != 0:
        return None
    twin = copy.deepcopy(trial.case)
    twin["mesh"] = {"file": "part41.msh"}
    return Twin(twin, trial.mesh)


def twins_of(trial, rng):
    case, mesh = trial.case, trial.mesh
    told = {"scaled": other_words.scaled(case, mesh, 1e3, 1e-6), "scaled by powers of two": other_words.scaled(case, mesh, 4.0**-5, 2.0**20),
            "mirrored": mirrored(case, mesh),
            "turned": other_words.turned(case, mesh, rng.uniform(-3.0, 3.0), [rng.uniform(-50.0, 50.0) for _ in range(2)]),
            "moved": other_words.turned(case, mesh, 0.0, [rng.uniform(-5.0, 5.0) for _ in range(2)]),
            "renumbered": other_words.renumbered(case, mesh, rng), "louder": other_words.louder(case, mesh, 100.0)}
    if all(part_outlines.depth(trial.part, crack["points"][0]) < 1e-9 for crack in case["crack"]):  # none is inside
        told["reversed"] = other_words.reversed_cracks(dict(case, mesh={"specimen": "plate"}), mesh)
        told["reversed"][0]["mesh"] = case["mesh"]
    twins = {name: Twin(*of) for name, of in told.items()}
    twins["from Abaqus"] = other_bodies.from_abaqus(case, mesh)
    twins["from Gmsh 4.1"] = gmsh_4_1(trial, rng)
    if any(len(cell) == 3 for cell in mesh[1]):
        twins["split"] = Twin(case, part_outlines.halved(mesh))
    return {name: twin for name, twin in twins.items() if twin}


RELATIONS = {"reaction": reaction, "resumed": resumed, "smaller": smaller, "energies": energies}


def judge(arguments, seed):
    with tempfile.TemporaryDirectory() as scratch:
        trial = Trial(seed, Path(scratch), arguments.programs)
        if trial.mesh is None:
            return seed, [], "no room for a crack" if not trial.cracks else "Gmsh makes no mesh"
        if trial.check["seconds"] > MOST_SECONDS or trial.check["code"] == 0 and trial.largest_K() < LEAST_K:
            return seed, [], "too large for a trial, or next to nothing at its tips"
        rng = random.Random(f"relations of {seed}")
        wrong, said, code = in_all_modes(trial)
        itself = (code, said), trial.folder / "inprocess"
        unresolved = UNRESOLVED if has_unresolved_tips(itself[1]) else set()
        drawn = lambda name: re.search(arguments.only, name) if arguments.only else rng.random() < 0.2
        for name, twin in twins_of(trial, rng).items():
            twin.base, twin.mesh, twin.without = trial.case, twin.mesh or trial.mesh, twin.without | unresolved
            found = random_twins.fault(arguments.programs, trial.folder, name, twin, itself) if drawn(name) else None
            wrong += [f"{name}: {found}"] if found else []
        random_twins.write_mesh(trial.folder / "body.msh", trial.mesh)
        for name, relation in RELATIONS.items():
            found = relation(trial, rng) if drawn(name) and code == 0 else None
            wrong += [f"{name}: {found}"] if found else []
            random_twins.write_mesh(trial.folder / "body.msh", trial.mesh)
        if wrong and arguments.keep:
            shutil.copytree(scratch, arguments.keep / str(seed), dirs_exist_ok=True)
        return seed, wrong, "good" if code == 0 else f"all end with {code}: {said}"


def main():
    if part_outlines.GMSH is None:
        print(part_outlines.ABSENT, file=sys.stderr)
        return 2
    arguments = random_trials.arguments_of(__doc__, scenes.ROOT / "build/release/bin", "parts that do not hold", only="relations")
    return random_trials.run(judge, arguments)


if __name__ == "__main__":
    sys.exit(main())
