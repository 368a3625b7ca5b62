#!/usr/bin/python3
"""tools/stria_results.py: tables as they stand, rates and fits whose answers are known."""

import math
import sys
import tempfile
import types
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))

import stria_results as results


class Folder(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.folder = Path(self.place.name)

    def tearDown(self):
        self.place.cleanup()

    def write_cycles(self, name, N, a, K_max, R, opening):
        """A run with two tips; the second is there to be left out."""
        folder = self.folder / name
        folder.mkdir(parents=True)
        lines = ["cycle,tip,a,da,N,K_max,K_min,K_op,U,dK_eff"]
        for k, (n, length, K) in enumerate(zip(N, a, K_max)):
            K_op = opening * K
            da = length - a[k - 1] if k else 0.0
            lines += [f"{k + 1},0,{length!r},{da!r},{n!r},{K!r},{R * K!r},{K_op!r},{(K - K_op) / (K - R * K)!r},{K - K_op!r}", f"{k + 1},1,0,0,0,1,1,1,,1"]
        (folder / "cycles.csv").write_text("\n".join(lines) + "\n")
        return results.Run(folder)


class Tables(Folder):
    def test_columns_are_numpy_arrays_to_the_last_digit(self):
        import numpy

        run = self.write_cycles("run", [0.0, 1e5 / 3], [10.0, 10.1], [300.0, 310.0], 0.1, 0.4)
        self.assertIsInstance(run.cycles["N"], numpy.ndarray)
        self.assertEqual(list(run.cycles.of(tip=0)["N"]), [0.0, 1e5 / 3])
        self.assertTrue(math.isnan(run.cycles["U"][1]))

    def test_a_table_tells_its_columns(self):
        (self.folder / "history.csv").write_text("increment,J\n1,0.5\n")
        history = results.Run(self.folder).history
        self.assertEqual(list(history), ["increment", "J"])
        self.assertTrue("J" in history and "K_I" not in history)

    def test_a_frame_has_the_columns(self):
        run = self.write_cycles("run", [0.0], [10.0], [300.0], 0.1, 0.4)
        before = sys.modules.get("pandas")
        sys.modules["pandas"] = types.SimpleNamespace(DataFrame=dict)
        try:
            self.assertEqual(run.cycles.frame()["a"], [10.0, 0.0])
        finally:
            if before is None:
                del sys.modules["pandas"]
            else:
                sys.modules["pandas"] = before

    def test_a_table_that_is_cut_off_ends_before(self):
        (self.folder / "history.csv").write_text("increment,J\n1,0.5\n2,")
        (self.folder / "faces.csv").write_text("increment,s,opening\n1,2,3\n2,3")
        self.assertEqual(len(results.Run(self.folder).history), 2)
        self.assertEqual(len(results.Run(self.folder).faces), 1)

    def test_the_tables_of_a_shipped_run_are_read(self):
        cycles = results.Run(ROOT / "cases/overload/reference").cycles
        self.assertEqual(len(cycles), 61)
        self.assertAlmostEqual(cycles.columns["K_max"][0], 300.0)

    def test_what_is_written_reads_back(self):
        table = results.Table({"x": [0.1, math.nan], "name": ["a,b", "c"]})
        table.write(self.folder / "table.csv")
        self.assertEqual((self.folder / "table.csv").read_text(), 'x,name\n0.1,"a,b"\n,c\n')


class Rates(Folder):
    def test_secants_of_a_straight_line_are_its_slope(self):
        run = self.write_cycles("run", [0.0, 1000.0, 3000.0], [10.0, 10.5, 11.5], [300.0, 320.0, 340.0], -1.0, 0.25)
        table = results.e647(run).columns
        self.assertEqual(table["dadN_mm_per_cycle"], [0.0005, 0.0005])
        self.assertEqual(table["a_mm"], [10.25, 11.0])
        self.assertEqual(table["N"], [500.0, 2000.0])  # (N, a) is a point of the a-N curve
        # What lies in compression does not count: dK is K_max; in MPa sqrt(m).
        self.assertAlmostEqual(table["dK_MPa_sqrt_m"][0], 310.0 / math.sqrt(1000.0), 12)
        self.assertAlmostEqual(table["dKeff_MPa_sqrt_m"][0], 0.75 * 310.0 / math.sqrt(1000.0), 12)
        self.assertAlmostEqual(table["R"][0], -1.0, 12)

    def test_secants_are_of_all_growth_that_is_counted(self):
        run = self.write_cycles("run", [0.0, 0.0, 0.0, 1000.0, 1000.0], [10.0, 10.0, 10.5, 11.0, 11.0], [300.0, 320.0, 500.0, 340.0, 600.0], 0.1, 0.25)
        table = results.e647(run).columns
        self.assertEqual(table["dadN_mm_per_cycle"], [0.001])
        self.assertAlmostEqual(table["Kmax_MPa_sqrt_m"][0], 330.0 / math.sqrt(1000.0), 12)

    def test_each_tip_has_its_own_rate(self):
        (self.folder / "cycles.csv").write_text(
            "cycle,tip,a,da,N,K_max,K_min,K_op,U,dK_eff\n1,0,4,0,0,300,0,0,1,300\n1,1,4,0,0,200,0,0,1,200\n"
            "2,0,4.25,0.5,1000,310,0,0,1,310\n2,1,4.25,0,1000,210,0,0,1,210\n"
        )
        run = results.Run(self.folder)
        self.assertEqual([results.e647(run, tip=tip).columns["dadN_mm_per_cycle"] for tip in (0, 1)], [[0.0005], [0.0]])
        self.assertEqual(results.e647(run, tip=1).columns["a_mm"], [4.125])

    def test_a_rate_of_cycles_that_differ_has_no_range(self):
        run = self.write_cycles("run", [0.0, 0.0, 1000.0], [10.0, 10.5, 10.5], [300.0, 310.0, 150.0], 0.1, 0.25)
        with self.assertRaises(results.Refusal):
            results.e647(run)
        lines = (self.folder / "run/cycles.csv").read_text().replace("150.0,15.0", "310.0,150.0")  # K_min alone
        (self.folder / "run/cycles.csv").write_text(lines)
        self.assertEqual(results.Run(self.folder / "run").cycles.of(tip=0)["K_max"][2], 310.0)
        with self.assertRaises(results.Refusal):
            results.e647(results.Run(self.folder / "run"))

    def test_cycles_without_growth_belong_to_the_next_growth(self):
        run = self.write_cycles("run", [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0], [10.0, 10.0, 10.0, 10.25, 10.25, 10.25, 10.5], [300.0] * 7, 0.1, 0.25)
        self.assertEqual(results.e647(run).columns["dadN_mm_per_cycle"], [0.25 / 3.0, 0.25 / 3.0])

    def test_a_rate_between_two_loads_has_no_range(self):
        run = self.write_cycles("run", [0.0, 1000.0, 2000.0], [10.0, 10.5, 11.0], [300.0, 310.0, 450.0], 0.1, 0.25)
        with self.assertRaises(results.Refusal):
            results.e647(run)
        # A large growth under one load, and small ones under two.
        (self.folder / "run/case.resolved.toml").write_text('[load]\ncontrol = "load"\n')
        (self.folder / "run/history.csv").write_text("cycle,load_factor\n1,50\n1,5\n2,50\n2,5\n3,50\n3,5\n")
        self.assertEqual(len(results.e647(results.Run(self.folder / "run"))), 2)
        run = self.write_cycles("two", [0.0, 1000.0], [10.0, 10.1], [300.0, 302.0], 0.1, 0.25)
        (self.folder / "two/case.resolved.toml").write_text('[load]\ncontrol = "load"\n')
        (self.folder / "two/history.csv").write_text("cycle,load_factor\n1,50\n1,5\n2,51\n2,5\n")
        with self.assertRaises(results.Refusal):
            results.e647(run)

    def test_what_is_not_there_is_said_in_a_line(self):
        self.assertEqual(results.main(["e647", str(self.folder / "none"), "-o", str(self.folder / "x.csv")]), 2)
        run = self.write_cycles("run", [0.0, 1000.0], [10.0, 10.5], [300.0, 310.0], 0.1, 0.25)
        self.assertEqual(results.main(["e647", str(run.folder), "--tip", "5", "-o", str(self.folder / "x.csv")]), 2)

    def test_polynomials_of_a_parabola_are_its_slope(self):
        # The second run has three rows a growth, which is counted in the last of them.
        for every in (1, 3):
            N = [100.0 * (k // every) ** 2 for k in range(9 * every)]
            ahead = [100.0 * ((k + every - 1) // every) ** 2 for k in range(9 * every)]
            self.check_polynomials(every, N, [10.0 + 1e-3 * n + 1e-7 * n * n for n in ahead])

    def check_polynomials(self, every, N, a):
        run = self.write_cycles(f"run-{every}", N, a, [300.0] * len(N), 0.1, 0.4)
        table = results.e647(run, method="polynomial").columns
        self.assertEqual(len(table["N"]), 3)
        for n, rate in zip(table["N"], table["dadN_mm_per_cycle"]):
            self.assertAlmostEqual(rate / (1e-3 + 2e-7 * n), 1.0, 9)


class Closure(Folder):
    def test_newman_is_that_of_the_references(self):  # docs/references.md 4.1
        for alpha, stress, values in ((1, 0.2, (0.4400, 0.5088, 0.5191, 0.5620, 0.6380, 0.7512)), (3, 0.01, (0.2530, 0.2550, 0.2670, 0.3532, 0.5027, 0.7000))):
            for R, value in zip((-1.0, 0.0, 0.1, 0.3, 0.5, 0.7), values):
                self.assertAlmostEqual(results.newman(R, alpha, stress), value, 4)

    def study(self, alpha, stress):
        lines = ["variant,status,folder"]
        for k, R in enumerate((-1.0, 0.0, 0.3, 0.5)):
            self.write_cycles(f"study/{k}-R", [1.0, 2.0], [10.0, 10.1], [300.0, 300.0], R, results.newman(R, alpha, stress))
            lines.append(f"{k},done,{k}-R")
        (self.folder / "study/study.csv").write_text("\n".join(lines + ["9,failed,nowhere"]) + "\n")
        return self.folder / "study"

    def test_the_fit_finds_the_alpha_that_made_the_data(self):
        table = results.closure_table([self.study(1.73, 0.25)])
        self.assertEqual(table.columns["R"], [-1.0, 0.0, 0.3, 0.5])
        fit = dict(zip(*(results.closure_fit(table, 0.25).columns[name] for name in ("name", "value"))))
        self.assertAlmostEqual(fit["alpha"], 1.73, 3)
        self.assertLess(fit["rms_alpha"], 1e-12)

    def test_runs_of_one_name_are_told_apart(self):
        for name in ("a/out", "b/out", "b/other"):
            self.write_cycles(name, [1.0, 2.0], [10.0, 10.1], [300.0, 300.0], 0.0, 0.4)
        folders = [self.folder / name for name in ("a/out", "b/out", "b/other")]
        self.assertEqual(results.closure_table(folders).columns["run"], ["a/out", "b/out", "other"])
        self.assertEqual(results.closure_table(folders[:1] * 2).columns["run"], ["out", "out"])

    def test_U_of_three_ratios_is_met_by_its_parabola(self):
        table = results.Table({"R": [-1.0, 0.0, 0.5], "Kop_over_Kmax": [1.0 - (0.55 + 0.33 * R + 0.12 * R * R) * (1.0 - R) for R in (-1.0, 0.0, 0.5)]})
        fit = dict(zip(*(results.closure_fit(table, 0.3).columns[name] for name in ("name", "value"))))
        for name, value in (("U0", 0.55), ("U1", 0.33), ("U2", 0.12)):
            self.assertAlmostEqual(fit[name], value, 10)

    def doubts(self, ratios, openings, names="abc"):
        table = results.Table({"run": list(names)[: len(ratios)], "R": ratios, "Kop_over_Kmax": openings})
        return list(results.doubts(table, results.closure_fit(table, 0.3)))

    def test_a_fit_that_says_nothing_is_told(self):
        curve = [results.newman(R, 2.0, 0.3) for R in (0.0, 0.3)]
        self.assertEqual(self.doubts([0.0, 0.3], curve), [])
        self.assertIn("no crack of these closes", self.doubts([0.0, 0.1], [0.0, 0.1])[0])
        self.assertIn("the end of 1 to 3", self.doubts([0.0, 0.3], [0.8, 0.85])[0])
        self.assertIn("off", self.doubts([0.0, 0.3], [curve[0] + 0.1, curve[1] - 0.1])[0])
        self.assertIn("at the end of c", self.doubts([0.0, 0.3, 0.5], curve + [math.nan])[0])

    def test_the_commands_leave_their_files(self):
        results.main(["closure", str(self.study(2.0, 0.3)), "-o", str(self.folder / "out"), "--paris", "1e-12,3"])
        rates = results.Table.read(self.folder / "out-rates.csv").columns
        U = (1.0 - results.newman(0.3, 2.0, 0.3)) / 0.7
        dK = rates["dK_MPa_sqrt_m_R=0.3"][4] * math.sqrt(1000.0)
        self.assertAlmostEqual(1e-12 * (U * dK) ** 3 / (1000.0 * rates["dadN_m_per_cycle"][4]), 1.0, 9)
        self.assertTrue((self.folder / "out-fit.csv").exists() and (self.folder / "out.csv").exists())


if __name__ == "__main__":
    unittest.main()
