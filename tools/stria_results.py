#!/usr/bin/python3
"""A run as NumPy arrays or a pandas data frame, and in the forms that other programs take.

    from stria_results import Run
    run = Run("runs/overload")
    a, K_op = run.cycles["a"], run.cycles["K_op"]       # run.cycles.frame() is a pandas.DataFrame

    tools/stria_results.py e647 runs/paris-life -o rates.csv
    tools/stria_results.py closure runs/sent-closure-study -o closure

`run.history`, `run.cycles`, `run.faces` and `run.closure` are the tables of docs/notation.md, `run.summary` is summary.json;
`run.cycles.of(tip=0)` keeps the rows of one tip. Columns are NumPy arrays where python3-numpy is installed and lists where it
is not; an empty cell is NaN. docs/report.md says what the two commands write, and in which units.
"""

import argparse
import csv
import itertools
import json
import math
import sys
import tomllib
from pathlib import Path

SQRT_M = math.sqrt(1000.0)  # sqrt(mm) in a sqrt(m): K of Stria is in MPa sqrt(mm)
KSI_SQRT_IN = 6.894757293168361 * math.sqrt(0.0254)  # MPa sqrt(m) in a ksi sqrt(in)
INCH = 25.4  # mm


class Refusal(Exception):
    """What is asked for cannot be told; its text says why."""


def number(cell):
    """The value of a cell; NaN where it is empty, the text itself where it is none."""
    try:
        return float(cell) if cell else math.nan
    except ValueError:
        return cell


class Table:
    """Columns by their names: list(table) names them, and len(table) counts rows."""

    def __init__(self, columns):
        self.columns = columns

    @classmethod
    def read(cls, path):
        with open(path, newline="", encoding="utf-8") as file:
            head, *rows = csv.reader(file)
        whole = [row for row in rows if len(row) == len(head)]  # a run that goes on may be writing the last one
        return cls({name: [number(row[k]) for row in whole] for k, name in enumerate(head)})

    def __getitem__(self, name):
        try:
            import numpy
        except ImportError:
            return self.columns[name]
        return numpy.array(self.columns[name])

    def __iter__(self):
        return iter(self.columns)

    def __contains__(self, name):
        return name in self.columns

    def __len__(self):
        return len(next(iter(self.columns.values()), []))

    def of(self, **values):
        """The rows in which these columns have these values: of(tip=0, cycle=3)."""
        kept = [k for k in range(len(self)) if all(self.columns[name][k] == value for name, value in values.items())]
        return Table({name: [cells[k] for k in kept] for name, cells in self.columns.items()})

    def frame(self):
        """The table as pandas.DataFrame (Debian: python3-pandas)."""
        import pandas

        return pandas.DataFrame(self.columns)

    def write(self, path):
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(self.columns)
            for row in zip(*self.columns.values()):
                writer.writerow("" if isinstance(cell, float) and math.isnan(cell) else cell for cell in row)


class Run:
    """The folder of a run; each table is read when it is first asked for."""

    def __init__(self, folder):
        self.folder = Path(folder)

    def __getattr__(self, name):
        if name in ("history", "cycles", "faces", "closure"):
            table = Table.read(self.folder / f"{name}.csv")
        elif name == "summary":
            table = json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))
        else:
            raise AttributeError(name)
        setattr(self, name, table)
        return table


def tension_range(K_max, K_min):
    """dK of ASTM E647: what lies in compression does not count."""
    return max(K_max, 0.0) - max(K_min, 0.0)


def counted(N, grown):
    """Rows between which growth of any tip is counted, by twos: it may be so some rows behind it, and the first of two is the last
    in front of what is counted at the second. Cycles that pass without growth belong to the next growth."""
    first = 0
    for last in range(1, len(N)):
        if N[last] > N[first] and grown[last] > grown[first]:
            yield first, last
            first = last
        elif N[last] == N[first] and grown[last] == grown[first]:
            first = last


def secant_rates(N, grown, pairs):
    """ASTM E647 X1.1: two rows and the rate between them, which is that of the point midway on the straight line."""
    for first, last in pairs:
        yield (first, last), (grown[last] - grown[first]) / (N[last] - N[first])


def polynomial_rates(N, grown, pairs):
    """ASTM E647 X1.2: a parabola by least squares through seven points; the row in its middle, twice, and its slope there."""
    rows = [first for first, _ in pairs[:1]] + [last for _, last in pairs]
    for k in range(3, len(rows) - 3):
        window = rows[k - 3 : k + 4]
        centre, half = 0.5 * (N[window[0]] + N[window[-1]]), 0.5 * (N[window[-1]] - N[window[0]])
        x = [(N[j] - centre) / half for j in window]
        _, b1, b2 = least_squares([[1.0, t, t * t] for t in x], [grown[j] for j in window])
        yield (rows[k], rows[k]), (b1 + 2.0 * b2 * (N[rows[k]] - centre) / half) / half


def load_factors(run):
    """Largest and smallest load factor of each cycle where they are what the case gives; else empty."""
    case = run.folder / "case.resolved.toml"
    given = case.exists() and tomllib.loads(case.read_text(encoding="utf-8")).get("load", {}).get("control", "load") == "load"
    if not given or not (run.folder / "history.csv").exists():
        return {}
    extremes = {}
    for cycle, factor in zip(run.history.columns["cycle"], run.history.columns["load_factor"]):
        high, low = extremes.get(cycle, (factor, factor))
        extremes[cycle] = (max(high, factor), min(low, factor))
    return extremes


def require_one_load(cycles, grown, pairs, factors):
    """One dK goes with a rate: refuses a rate that is counted over rows which differ in K before anything has grown, and one
    between rows of different loads. Where K is controlled the load factor follows the crack, and K may change, but not leap."""
    smooth = 0.2  # of K_max, from a row to the next

    def differ(first, last, tolerance):
        size = max(abs(cycles["K_max"][first]), abs(cycles["K_min"][first]))
        return any(abs(cycles[K][last] - cycles[K][first]) > tolerance * size for K in ("K_max", "K_min"))

    def other_load(first, last):
        before, now = (factors.get(cycles["cycle"][row]) for row in (first, last))
        if before and now:
            return any(abs(x - y) > 1e-6 * max(map(abs, before)) for x, y in zip(before, now))
        return differ(first, last, smooth)

    for first, last in pairs:
        waits = any(grown[k] == grown[k - 1] and differ(k - 1, k, 1e-6) for k in range(first + 1, last + 1))
        if waits or other_load(first, last):
            raise Refusal("the load varies between two rates: each is the mean of different cycles, and no dK of one of them goes with it")


def least_squares(rows, values):
    """The coefficients that make rows . coefficients closest to values: normal equations by Gauss's elimination."""
    n = len(rows[0])
    system = [[sum(row[i] * row[j] for row in rows) for j in range(n)] + [sum(row[i] * value for row, value in zip(rows, values))] for i in range(n)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda row: abs(system[row][i]))
        system[i], system[pivot] = system[pivot], system[i]
        for below in range(i + 1, n):
            factor = system[below][i] / system[i][i]
            system[below] = [x - factor * y for x, y in zip(system[below], system[i])]
    solution = [0.0] * n
    for i in reversed(range(n)):
        solution[i] = (system[i][n] - sum(system[i][j] * solution[j] for j in range(i + 1, n))) / system[i][i]
    return solution


def e647(run, tip=0, method="secant"):
    """a-N and da/dN of a tip as ASTM E647 reports them: mm, cycles, mm per cycle, MPa sqrt(m). A crack with two tips is as long as
    the mean of both says, and each tip has its own rate."""
    cycles = run.cycles.of(tip=tip).columns
    if not cycles["cycle"]:
        raise Refusal(f"{run.folder}: cycles.csv has no tip {tip}")
    grown = list(itertools.accumulate(cycles["da"]))
    of_cycle = dict.fromkeys(cycles["cycle"], 0.0)
    for cycle, da in zip(run.cycles.columns["cycle"], run.cycles.columns["da"]):
        of_cycle[cycle] += da
    of_all_tips = list(itertools.accumulate(of_cycle.values()))
    pairs = list(counted(cycles["N"], of_all_tips))
    require_one_load(cycles, of_all_tips, pairs, load_factors(run))
    rates = {"secant": secant_rates, "polynomial": polynomial_rates}[method]
    table = {name: [] for name in ("N", "a_mm", "dadN_mm_per_cycle", "dK_MPa_sqrt_m", "R", "Kmax_MPa_sqrt_m", "dKeff_MPa_sqrt_m", "Kop_MPa_sqrt_m")}
    for (first, last), rate in rates(cycles["N"], grown, pairs):
        middle = lambda values: 0.5 * (values[first] + values[last])
        mean = lambda values: middle(values) / SQRT_M
        K_max, K_min = cycles["K_max"], cycles["K_min"]
        dK = mean([tension_range(high, low) for high, low in zip(K_max, K_min)])
        row = (middle(cycles["N"]), middle(cycles["a"]), rate, dK, mean(K_min) / mean(K_max), mean(K_max), mean(cycles["dK_eff"]), mean(cycles["K_op"]))
        for column, value in zip(table.values(), row):
            column.append(value)
    return Table(table)


def newman(R, alpha, stress):
    """K_op / K_max: J. C. Newman, Int. J. Fracture 24 (1984) R131. alpha is 1 in plane stress and 3 in plane strain; stress is
    the largest stress over the flow stress. The function f of the NASGRO equation."""
    A0 = (0.825 - 0.34 * alpha + 0.05 * alpha**2) * math.cos(math.pi * stress / 2.0) ** (1.0 / alpha)
    A1 = (0.415 - 0.071 * alpha) * stress
    if R < 0.0:
        return A0 + A1 * R
    A3 = 2.0 * A0 + A1 - 1.0
    return max(R, A0 + A1 * R + (1.0 - A0 - A1 - A3) * R**2 + A3 * R**3)


def fitted_alpha(points, stress):
    """The alpha between 1 and 3 whose curve is closest to the points (R, K_op / K_max), and the root of the mean square."""

    def error(alpha):
        return math.sqrt(sum((newman(R, alpha, stress) - opening) ** 2 for R, opening in points) / len(points))

    alpha = min((1.0 + 0.001 * k for k in range(2001)), key=error)
    return alpha, error(alpha)


def opening_point(folder, tip=0, last=6):
    """R, K_max and K_op / K_max, means of the last cycles of a run; K_op may be NaN."""
    rows = Run(folder).cycles.of(tip=tip).columns
    mean = {name: sum(rows[name][-last:]) / len(rows[name][-last:]) for name in ("K_max", "K_min", "K_op")}
    return mean["K_min"] / mean["K_max"], mean["K_max"], mean["K_op"] / mean["K_max"]


def runs_of(folders):
    """The runs themselves, and those of studies that are done."""
    for folder in map(Path, folders):
        if (folder / "study.csv").exists():
            study = Table.read(folder / "study.csv").columns
            yield from (folder / name for name, status in zip(study["folder"], study["status"]) if status == "done")
        else:
            yield folder


def names_of(folders):
    """The last part of each path, with as many before it as tell it from the other folders."""
    paths = [folder.resolve().parts for folder in folders]

    def name(own):
        lengths = range(1, len(own) + 1)
        return "/".join(next((own[-k:] for k in lengths if all(path == own or path[-k:] != own[-k:] for path in paths)), own))

    return [name(path) for path in paths]


def closure_table(folders, last=6):
    """One row per run: R, K_max, K_op / K_max and U at the end."""
    table = {name: [] for name in ("run", "R", "Kmax_MPa_sqrt_m", "Kop_over_Kmax", "U")}
    runs = list(runs_of(folders))
    for folder, name in zip(runs, names_of(runs)):
        R, K_max, opening = opening_point(folder, last=last)
        for column, value in zip(table.values(), (name, R, K_max / SQRT_M, opening, (1.0 - opening) / (1.0 - R))):
            column.append(value)
    return Table(table)


def closure_fit(table, stress):
    """Names, values and what they are: Newman's alpha, and U(R) as a polynomial of as many terms as the load ratios allow."""
    points = [(R, opening) for R, opening in zip(table.columns["R"], table.columns["Kop_over_Kmax"]) if not math.isnan(opening)]
    if not points:
        raise Refusal("no run has an opening load")
    alpha, error = fitted_alpha(points, stress)
    rows = [("alpha", alpha, "Newman's constraint factor"), ("Smax_over_sigma0", stress, "largest stress over flow stress, given"), ("rms_alpha", error, "root of the mean square of K_op / K_max about it")]
    terms = min(3, len({round(R, 6) for R, _ in points}))
    U = [(1.0 - opening) / (1.0 - R) for R, opening in points]
    coefficients = least_squares([[R**power for power in range(terms)] for R, _ in points], U)
    rows += [(f"U{power}", value, f"of R^{power} in U(R)") for power, value in enumerate(coefficients)]
    return Table({"name": [row[0] for row in rows], "value": [row[1] for row in rows], "meaning": [row[2] for row in rows]})


def doubts(table, fit):
    """Sentences on what the fitted alpha does not say: a fit always ends at some number."""
    values = dict(zip(fit.columns["name"], fit.columns["value"]))
    runs = list(zip(table.columns["run"], table.columns["R"], table.columns["Kop_over_Kmax"]))
    unknown = [name for name, _, opening in runs if math.isnan(opening)]
    if unknown:
        yield f"no K_op is known at the end of {', '.join(unknown)}: left out"
    known = [(name, R, opening) for name, R, opening in runs if not math.isnan(opening)]
    if all(opening <= R + 1e-9 for _, R, opening in known):
        yield "no crack of these closes: K_op is K_min, and alpha says nothing (contact = {} in [[crack]], growth that leaves a wake, small elements)"
    elif values["alpha"] in (1.0, 3.0):
        yield f"alpha has run into the end of 1 to 3: no curve fits better, and this one is {values['rms_alpha']:.3f} off (root of the mean square of K_op / K_max)"
    elif values["rms_alpha"] > 0.05:
        yield f"Newman's curve is {values['rms_alpha']:.3f} off (root of the mean square of K_op / K_max)"


def rate_table(ratios, C, m, alpha, stress, rates, english=False):
    """dK at each load ratio for some rates, of da/dN = C (U dK)^m, C in mm per cycle and MPa sqrt(mm): a column per R, as tabular
    data of AFGROW and NASGRO are typed in. m per cycle and MPa sqrt(m), or inches per cycle and ksi sqrt(in)."""
    length, stress_intensity, unit = (INCH, KSI_SQRT_IN, "ksi_sqrt_in") if english else (1000.0, 1.0, "MPa_sqrt_m")
    table = {"dadN_in_per_cycle" if english else "dadN_m_per_cycle": [rate / length for rate in rates]}
    for R in ratios:
        U = (1.0 - newman(R, alpha, stress)) / (1.0 - R)
        table[f"dK_{unit}_R={R:g}"] = [(rate / C) ** (1.0 / m) / U / SQRT_M / stress_intensity for rate in rates]
    return Table(table)


def write_closure(options):
    prefix = options.output
    table = closure_table(options.folders, options.last)
    fit = closure_fit(table, options.stress)
    table.write(f"{prefix}.csv")
    fit.write(f"{prefix}-fit.csv")
    values = dict(zip(fit.columns["name"], fit.columns["value"]))
    print(f"alpha = {values['alpha']:.3f}, Smax/sigma0 = {options.stress:g}: NASGRO equation; K_op / K_max at R = 0: {newman(0.0, values['alpha'], options.stress):.4f}")
    for sentence in doubts(table, fit):
        print(f"warning: {sentence}", file=sys.stderr)
    if options.paris:
        C, m = options.paris
        ratios = sorted({round(R, 2) for R in table.columns["R"]})
        rates = [10.0 ** (-7.0 + 0.25 * k) for k in range(17)]  # mm per cycle
        rate_table(ratios, C, m, values["alpha"], options.stress, rates, options.english).write(f"{prefix}-rates.csv")


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(dest="command", required=True)
    rates = commands.add_parser("e647", help="a-N and da/dN of a run in the columns of ASTM E647")
    rates.add_argument("folder")
    rates.add_argument("-o", "--output", required=True)
    rates.add_argument("--tip", type=int, default=0)
    rates.add_argument("--method", choices=("secant", "polynomial"), default="secant")
    closure = commands.add_parser("closure", help="opening loads over R, Newman's alpha and U(R)")
    closure.add_argument("folders", nargs="+", help="a study, or runs")
    closure.add_argument("-o", "--output", required=True, help="what the names of the files begin with")
    closure.add_argument("--stress", type=float, default=0.3, help="largest stress over flow stress; 0.3")
    closure.add_argument("--last", type=int, default=6, help="cycles over which K_op is averaged; 6")
    closure.add_argument("--paris", type=lambda text: tuple(map(float, text.split(","))), help="C,m of da/dN = C dK_eff^m, mm per cycle and MPa sqrt(mm)")
    closure.add_argument("--english", action="store_true", help="inches per cycle and ksi sqrt(in)")
    options = parser.parse_args(arguments)
    try:
        if options.command == "e647":
            e647(Run(options.folder), options.tip, options.method).write(options.output)
        else:
            write_closure(options)
    except (Refusal, OSError) as refusal:
        print(refusal, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
