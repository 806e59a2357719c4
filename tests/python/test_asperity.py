"""The module asperity against the command, against itself one by one, and with bad input. The
command is $ASPERITY_BIN/asperity.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy
import doctest
import gc
import multiprocessing
import os
import pickle
import subprocess
import tempfile
import threading
import unittest
import unittest.mock
import warnings
from pathlib import Path

import numpy as np

import asperity

COMMAND = str(Path(os.environ["ASPERITY_BIN"]) / "asperity")
PAIR = "materials quartz hastelloy-x"


def ledger(folder, words, *options):
    """The impacts of the command, as a ledger."""
    path = Path(folder) / "impacts.csv"
    subprocess.run([COMMAND, "cor", *words.split(), *options, "--columns", "ledger", "-o", str(path)],
                   check=True, capture_output=True, env={})
    return asperity.read(path)


class Walls(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def refused(self, text, call, *arguments, **keywords):
        with self.assertRaisesRegex(asperity.Error, text):
            call(*arguments, **keywords)

    def test_examples_of_the_docstrings(self):
        result = doctest.testmod(asperity)
        self.assertGreaterEqual(result.attempted, 8)
        self.assertEqual(result.failed, 0)

    def test_a_library_with_other_structs_is_refused(self):
        with unittest.mock.patch.dict(asperity._STRUCTS, key=asperity.BODY):
            self.assertRaisesRegex(ImportError, "another asp_key", asperity._load)

    def test_the_command_has_the_same_impacts(self):
        """Each column of a ledger, to the ten digits that the command prints."""
        for words in (f"surface rq 5um lambda_c 40um {PAIR}",
                      "surface sigma 8 spread weibull plane collisions single rebound constant 0.9 0.8",
                      "surface rq 5um lambda_c 40um 120um lay 1 1 0 rebound walton 0.9 0.3 0 seed 7",
                      f"surface rq 15um lambda_c 120um spread profile deposit off friction 0.5 {PAIR}",
                      "surface sigma 8 rebound walton 0.9 0.3 0 grain lever 0.1",
                      f"surface smooth yield_stress 200MPa scatter 0.3 adhesion 0.5 adhesion_spread 2 {PAIR}"):
            rows = ledger(self.folder, words, "--dp", "2um,20um,50um", "--speed", "30,200", "--angles",
                          "2,20,70,89", "--samples", "50")
            wall = asperity.Wall(words, (2e-6, 50e-6), name="cor")
            self.assertTrue(asperity.heading(rows).endswith("; " + wall.text))
            v1 = asperity.velocities(rows["v1"], np.radians(rows["alpha1_deg"]))
            hits = wall.impacts(v1, rows["d_p"], tag=rows["tag"] - 1)  # which the command draws by
            cor = asperity.coefficients(v1, hits)
            pairs = {"delta_alpha_deg": np.degrees(hits["delta_alpha"]), "hits": hits["hits"],
                     "tilt_out_deg": np.degrees(hits["tilt_out"]), "outcome": hits["outcome"],
                     "v2": np.linalg.norm(hits["v2"], axis=1), "cor_n": cor["cor_n"],
                     "cor_t": cor["cor_t"], "alpha2_deg": np.degrees(cor["alpha2"])}
            self.assertEqual(len(rows), 1200)
            for name, values in pairs.items():
                np.testing.assert_allclose(values, rows[name], rtol=1e-8, atol=1e-9, err_msg=words)
            self.assertGreater(len(set(rows["cor_n"])), 3)

    def test_scatter_of_grains_by_quadrature(self):
        """The mean and sd of CoR_N by sums over the tilt, in and across the plane of incidence, and over the yield
        stress: by the visible slopes, an elastic-plastic normal speed and `bons` friction; of single collisions."""
        v, slope, v_y, friction = 100, np.tan(np.radians(8)), 200e6 / np.sqrt(54.7929e9 * 2650), 0.3
        x, weight = np.polynomial.hermite_e.hermegauss(80)
        p, q, z = np.meshgrid(slope * x, slope * x, x, indexing="ij")
        for degrees, scatter in ((60, 0.3), (85, 0.3), (85, 1e-9)):
            a = np.radians(degrees)
            length = np.sqrt(1 + p ** 2 + q ** 2)
            n1 = v * (np.sin(a) + p * np.cos(a)) / length
            seen = np.einsum("i,j,k->ijk", weight, weight, weight) * np.maximum(n1, 0) * length
            n2 = np.minimum(n1, v_y * np.exp(scatter * z))
            kept = 1 - friction * (n1 + n2) * np.sqrt(v ** 2 - n1 ** 2) / v ** 2  # of the speed along the face
            cor_n = (n2 / length + kept * (n1 / length - v * np.sin(a))) / (v * np.sin(a))
            seen *= cor_n > 0
            mean = (seen * cor_n).sum() / seen.sum()
            sd = np.sqrt((seen * cor_n ** 2).sum() / seen.sum() - mean ** 2)
            wall = asperity.Wall(f"surface sigma 8 spread visible collisions single yield_stress 200MPa "
                                 f"scatter {scatter} deposit off {PAIR}")
            v1 = asperity.velocities(v, np.full(40000, a))
            got = asperity.coefficients(v1, wall.impacts(v1, 2e-5))["cor_n"]
            self.assertAlmostEqual(got.mean(), mean, delta=0.005)
            self.assertAlmostEqual(got.std(), sd, delta=0.01)

    def test_arrays_are_single_impacts(self):
        """Whatever differs from impact to impact is that of the impact."""
        wall = asperity.Wall(f"surface rq 5um lambda_c 40um 80um lay 1 0 0 rebound bons spin on {PAIR}")
        n = 50
        random = np.random.default_rng(1)
        tilted = random.normal(size=(n, 3)) + (0, 0, 4)
        tilted /= np.linalg.norm(tilted, axis=1)[:, None]
        v1 = random.normal(size=(n, 3)) * 20 - 90 * tilted
        each = {"d_p": random.uniform(1e-6, 5e-5, n), "normals": tilted,
                "density": random.uniform(1e3, 8e3, n), "omega": random.normal(size=(n, 3)) * 1e4,
                "lay": random.normal(size=(n, 3)), "tag": random.integers(1, 1 << 40, n),
                "impact": random.integers(1, 99, n)}
        together = wall.impacts(v1, seed=3, **each)
        self.assertGreater(np.ptp(together["omega"]), 0)
        for i in range(n):
            alone = wall.impacts(v1[i], seed=3, **{name: value[i] for name, value in each.items()})
            self.assertEqual(alone[0], together[i])
        body = np.zeros(n, asperity.BODY)
        body["inverse_mass"], body["inverse_inertia"][:, :3], body["lever"] = 1e11, 1e22, each["d_p"][:, None] / 5
        bodies = wall.impacts(v1, seed=3, body=body, **each)
        alone = wall.impacts(v1[7], seed=3, body=body[7], **{name: value[7] for name, value in each.items()})
        self.assertEqual(alone[0], bodies[7])
        self.assertFalse(np.allclose(bodies["v2"], together["v2"]))
        changed = wall.impacts(v1, seed=3, **{**each, "lay": (0, 1, 0)})
        self.assertFalse(np.allclose(changed["delta_alpha"], together["delta_alpha"]))

    def test_coefficients(self):
        normals = np.array([[0, 0, 1], [0, 1, 0]])
        v1 = np.array([[3, 0, -4], [3, -4, 0]])
        wall = asperity.Wall("rebound constant 0.5 0.7")
        cor = asperity.coefficients(v1, wall.impacts(v1, 1e-5, normals), normals)
        np.testing.assert_allclose(cor["cor_n"], 0.5)
        np.testing.assert_allclose(cor["cor_t"], 0.7)
        np.testing.assert_allclose(cor["alpha2"], np.arctan2(2, 2.1))
        straight = wall.impacts((0, 0, -1), 1e-5)
        self.assertTrue(np.isnan(asperity.coefficients((0, 0, -1), straight)["cor_t"][0]))
        along = asperity.coefficients((1, 0, -1e-17), straight)
        self.assertTrue(np.isnan(along["cor_n"][0]) and np.isnan(along["cor_alpha"][0]))
        self.assertEqual(len(wall.impacts(np.zeros((0, 3)), 1e-5)), 0)

    def test_numbers_and_words(self):
        wall = asperity.Wall(f"surface ra 4um rdq 0.2 friction 0.4 {PAIR}")
        self.assertAlmostEqual(wall.surface()["r_q"], 4e-6 * np.sqrt(np.pi / 2), 15)
        self.assertAlmostEqual(wall.surface()["slope_rms"], 0.2, 12)
        self.assertEqual((wall.get("friction"), wall.get("spread")), (0.4, "visible"))
        self.assertEqual(asperity.Wall(wall.text).text, wall.text)
        kappa3 = (np.sqrt(3) * 1e-3 * wall.get("rq") / wall.get("lambda_c") ** 2) ** 3
        for tilt, part in (("isotropic", 0.92 + 0.37), ("plane", 0.92)): # of a sphere, and of a disc
            np.testing.assert_allclose(asperity.Wall(wall.text.replace("isotropic", tilt)).slope([0, 1e-3]),
                                       [0.2, 0.2 * (1 + part * kappa3) ** (-1 / 6)], rtol=1e-9)
        smooth = asperity.Wall("rebound walton 0.9 0.3 0")
        self.assertEqual((smooth.surface(), smooth.slope(1e-5)), ({}, 0))
        self.refused("the wall has no 'frictoin'", wall.get, "frictoin")

    def test_bad_input(self):
        self.refused("'surfcae'.*'surface'", asperity.Wall, "surfcae smooth")
        self.refused("'surface rq R' needs a length", asperity.Wall, "surface rq 5um")
        self.refused("cannot open 'no.csv'", asperity.Wall, f"surface profile no.csv {PAIR}", 1e-5)
        self.refused("materials needs two names .*'materials quartz", asperity.Wall, "surface rq 5um lambda_c 40um")
        self.refused("has no yield stress; say", asperity.Wall, "materials hastelloy-x quartz")
        self.refused("d_p is .*-1", asperity.Wall, PAIR, (-1, 1e-5))
        self.refused("alpha1 of impact 1 is 45; it must be > 0 and <= pi/2", asperity.velocities, 100, (1, 45))
        self.refused("alpha1 of impact 0 is nan", asperity.velocities, 100, np.nan)
        self.refused("speed of impact 0 is -100; it must be > 0", asperity.velocities, -100, 1)
        wall = asperity.Wall(f"surface rq 5um lambda_c 40um {PAIR}")
        for text, v1, keywords in ((r"v1 \. n of impact 1 is 1; it must be < 0", [(0, 0, -1), (0, 0, 1)], {}),
                                   (r"v1 \. n of impact 0 is nan", (0, 0, np.nan), {}),
                                   (r"shape \(2,\); it must be \(3,\) or \(1, 3\)", (0, -1), {}),
                                   (r"normals has the shape", (0, 0, -1), {"normals": np.eye(3)}),
                                   (r"length of the normal of impact 0 is 2", (0, 0, -1), {"normals": (0, 0, 2)}),
                                   (r"d_p of impact 0 is -1", (0, 0, -1), {"d_p": -1}),
                                   (r"tag of impact 0 is 1.5; it must be a whole", (0, 0, -1), {"tag": 1.5}),
                                   (r"tag of impact 1 is -1", [(0, 0, -1), (0, 0, -2)], {"tag": (1, -1)}),
                                   (r"impact of impact 0 is -1", (0, 0, -1), {"impact": -1}),
                                   (r"seed of impact 0 is 4.*e\+09", (0, 0, -1), {"seed": 1 << 32}),
                                   (r"d_p of impact 0 is inf", (0, 0, -1), {"d_p": np.inf}),
                                   (r"d_p is 20; this wall's size law", (0, 0, -1), {"d_p": 20}),
                                   (r"temperature of impact 0 is nan", (0, 0, -1), {"temperature": np.nan}),
                                   (r"d_p has the shape \(3,\); it must be one value or \(2,\)", [(0, 0, -1)] * 2, {"d_p": [1e-5] * 3}),
                                   (r"lay of impact 0 is nan", (0, 0, -1), {"lay": (np.nan, 0, 0)}),
                                   (r"inverse_mass of the body of impact 0 is 0; it must be > 0", (0, 0, -1),
                                    {"body": np.zeros((), asperity.BODY)}),
                                   (r"density of impact 0 is 0", (0, 0, -1), {"density": 0})):
            self.refused(text, wall.impacts, v1, **{"d_p": 1e-5, **keywords})
        measured = asperity.Wall(f"surface profile mine {PAIR}", (1e-5, 2e-5), **self.heights())
        self.refused("d_p of impact 0 is 3e-05; it must be 1e-05 to 2e-05 m", measured.impacts, (0, 0, -1), 3e-5)
        self.refused("surface", asperity.Wall, PAIR, **self.heights())

    def test_doubts_are_warnings(self):
        with self.assertWarnsRegex(UserWarning, "is it in another unit"):
            asperity.Wall(f"surface rq 5 lambda_c 40 {PAIR}", 1e-5)
        with self.assertWarnsRegex(UserWarning, "rq is 5, which is 5 m"):
            asperity.Wall(f"surface rq 5 lambda_c 40 {PAIR}")
        with self.assertWarnsRegex(UserWarning, "always stick"):
            asperity.Wall(f"surface_energy 1000 {PAIR}", 1e-6)
        with self.assertWarnsRegex(UserWarning, "covers 2 points"):
            asperity.Wall(f"surface profile mine {PAIR}", 2e-6, **self.heights())
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            wall = asperity.Wall(f"surface rq 5um lambda_c 40um {PAIR}", 1e-5)
            wall.impacts((0, 0, -1), 2e-5)
        wall = asperity.Wall(f"surface smooth {PAIR}", 1e-5)
        for found in (1, 0):  # of sizes that the wall does not know yet, once
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                wall.impacts(np.tile((0., 0., -1.), (2, 1)), (1e-5, 2e-3))
            self.assertEqual(len(caught), found)
        self.refused("d_p is 20; this wall's size law", asperity.Wall, f"surface rq 5um lambda_c 40um {PAIR}", 20)

    def test_copies_are_the_same_wall(self):
        """By copy, pickle and in another process, after the first one is gone."""
        v1 = asperity.velocities(100, np.full(50, 0.3))
        for words, arguments in ((f"surface profile mine {PAIR}", {"d_p": (1e-5, 2e-5), **self.heights()}),
                                 ("surface sigma 8 rebound walton 0.9 0.3 0", {"name": "mine"})):
            wall = asperity.Wall(words, **arguments)
            wanted = wall.impacts(v1, 1e-5)
            copies = [copy.copy(wall), copy.deepcopy(wall), pickle.loads(pickle.dumps(wall))]
            with multiprocessing.get_context("fork").Pool(1) as pool:
                in_pool = pool.apply_async(wall.impacts, (v1, 1e-5)).get(timeout=60)
            if "heights" in arguments:
                arguments["heights"][:] = 0
                copies.append(copy.copy(wall))
            del wall
            gc.collect()
            others = [asperity.Wall(f"surface sigma {s} rebound walton 0.1 0.9 0") for s in range(1, 30)]
            for found in [in_pool] + [each.impacts(v1, 1e-5) for each in copies]:
                np.testing.assert_array_equal(found, wanted)
            self.assertEqual(len(others), 29)

    @staticmethod
    def heights(rows=1, columns=4096):
        """Gaussian heights of 1 um, by a filter in Fourier space: lambda_c is 20 points."""
        noise = np.random.default_rng(1).normal(size=(rows, columns))
        along, across = (20 * np.pi * f for f in (np.fft.rfftfreq(columns), np.fft.fftfreq(rows)[:, None]))
        smooth = np.fft.irfft2(np.fft.rfft2(noise) * np.exp(-(along**2 + across**2) / 2), s=noise.shape)
        return {"heights": np.squeeze(smooth) / smooth.std() * 1e-6, "step": 1e-6, "periodic": True}

    def test_heights_are_those_of_a_file(self):
        """A profile and a map of an array, and the same of a file, which is read without its line."""
        x = np.arange(4096) * 1e-6
        z = self.heights()["heights"]
        z -= np.polyval(np.polyfit(x, z, 1), x)
        path = self.folder / "profile.csv"
        np.savetxt(path, np.stack([x, z], 1), "%.17g", ",", header="x_m,z_m", comments="")
        of_file = asperity.Wall(f"surface profile {path} {PAIR}", 1e-5)
        of_array = asperity.Wall(f"surface profile x {PAIR}", 1e-5, heights=z, step=1e-6)
        self.assertAlmostEqual(of_file.surface()["slope_rms"] / of_array.surface()["slope_rms"], 1, 9)
        self.assertAlmostEqual(of_array.surface()["r_q"] / z.std(), 1, 9)
        v1 = asperity.velocities(100, np.full(200, 0.2))
        np.testing.assert_allclose(of_file.impacts(v1, 1e-5)["v2"], of_array.impacts(v1, 1e-5)["v2"], 1e-6)
        given = {**self.heights(512, 1024), "step": (1e-6, 2e-6)}
        lengths = asperity.Wall(f"surface map x lay 0 1 0 {PAIR}", 2e-5, **given).surface()
        self.assertAlmostEqual(lengths["lambda_c"] / 20e-6, 1, delta=0.06)
        self.assertAlmostEqual(lengths["lambda_along"] / 40e-6, 1, delta=0.06)

    def test_tables(self):
        rows = ledger(self.folder, f"surface sigma 5 {PAIR}", "--angles", "20,90", "--samples", "4")
        self.assertEqual(list(np.isnan(rows["cor_t"])), [False] * 4 + [True] * 4)
        self.assertEqual((rows["hits"].dtype, rows["tag"][-1]), (np.dtype(int), 8))
        subprocess.run([COMMAND, "cor", *PAIR.split(), "--angles", "20", "--samples", "1", "-o", "one.csv"],
                       check=True, capture_output=True, cwd=self.folder, env={})
        one = asperity.read(self.folder / "one.csv")
        self.assertEqual((one.shape, one["outcome"][0], one["dp_um"][0]), ((1,), "rebound", 10))
        (self.folder / "none.csv").write_text("# wall\ntag,d_p\n")
        self.assertEqual(asperity.read(self.folder / "none.csv").shape, (0,))

    def sensitivity(self, table, *words):
        """What the command says of a ledger with these columns; its message where it refuses."""
        path, out = self.folder / "full.csv", self.folder / "out.csv"
        columns = {name: np.broadcast_to(values, len(table["tag"])) for name, values in table.items()}
        path.write_text("# made here\n" + ",".join(columns) + "\n" + "".join(
            ",".join(f"{x:.10g}" for x in row) + "\n" for row in zip(*columns.values())))
        done = subprocess.run([COMMAND, "sensitivity", path, *words, "--name", "python", "-o", out],
                              capture_output=True, env={}, text=True)
        return {row["result"]: row for row in asperity.read(out) if row["triangle"] == "all"} \
            if done.returncode == 0 else done.stderr

    def test_weights_are_those_of_the_command(self):
        own, n, h, spin = "surface rq 4um lambda_c 40um " + PAIR, 3000, 1e-3, (1e3, 0, 2e3)
        factors = {"to": 1.1, "up": np.exp(h), "down": np.exp(-h)}
        others = [asperity.Wall(f"surface rq {4 * f:.17g}um lambda_c 40um {PAIR}")
                  for f in factors.values()]
        v1 = asperity.velocities(30, np.radians(np.linspace(5, 60, n)))
        tag = np.arange(1, n + 1)
        made, weights = asperity.Wall(own).impacts(v1, 1e-5, omega=spin, others=others)
        self.assertEqual(made.tobytes(), asperity.Wall(own).impacts(v1, 1e-5, omega=spin).tobytes())
        self.assertLess(abs(weights[:, 0].mean() - 1), 4 * weights[:, 0].std() / n ** 0.5)
        mass, x = 2650 * np.pi / 6 * 1e-15, made["outcome"].astype(float)
        vectors = {f"{name}{axis}": values[..., k] for name, values in
                   (("n", np.array([0, 0, 1.])), ("v1", v1), ("v2", made["v2"]), ("omega1", np.array(spin)))
                   for k, axis in enumerate("xyz")}
        table = {"tag": tag, "impact": 1, "mesh": 1, "triangle": tag % 7, "d_p": 1e-5, "v1": 30,
                 "alpha1_deg": np.linspace(5, 60, n), "delta_alpha_deg": np.degrees(made["delta_alpha"]),
                 "tilt_out_deg": 1, "hits": made["hits"], "outcome": made["outcome"], "mass": mass,
                 "eroded_mass": 0, "body": 0, "cor_n": 1e300, **vectors}
        found = self.sensitivity(table, *own.split(), "--to", "surface rq 4.4um lambda_c 40um")
        off = (x - x.mean()) * n / (n - 1)
        score = np.log(weights[:, 1] / weights[:, 2]) / (2 * h)
        stuck = found["stuck_share"]
        for name, values in (("value", x), ("to", x + off * (weights[:, 0] - 1)), ("d_rq", off * score)):
            self.assertAlmostEqual(stuck[name], values.mean(), 5)
            self.assertLess(abs(stuck[name + "_se"] / (values.std() / n ** 0.5) - 1), 0.01)
        self.assertLess(abs(found["deposited_mass_kg"]["value"] / mass / x.sum() - 1), 1e-5)
        for changed, words, text in (
                ({}, own + " seed 2", "must be those of the run"),
                ({"body": 3}, own, "part of body 3"),
                ({"alpha1_deg": np.where(tag % 50, 30, 0)}, own, "rest at the wall.*at most 1 %"),
                ({}, "surface smooth " + PAIR, "must be given by rq and lambda_c, or by sigma"),
                ({}, "surface rq 4um lambda_c 40um spread visible plane collisions single " + PAIR, "has no weights")):
            self.assertRegex(self.sensitivity({**table, **changed}, *words.split()), text)
        for to, text in (("surface rq 5.7um lambda_c 40um", "1.4[0-9]* times as steep.*at most 1.4 times"),
                         ("surface profile w.csv", "--to is 'surface profile w.csv'.*rq and lambda_c")):
            self.assertRegex(self.sensitivity(table, *own.split(), "--to", to), text)
        self.assertRegex(self.sensitivity(table, *f"{own} spread traced".split()), "spread is 'traced'.*as visible")
        few = {name: np.broadcast_to(values, n)[:130] for name, values in table.items()}
        self.assertRegex(self.sensitivity(few, *own.split(), "--to", "surface rq 5.5um lambda_c 40um"),
                         "it must be at least 100")
        self.assertRegex(self.sensitivity(table, *own.split(), "--to", "rq 5um"), "--to is 'rq 5um'")
        del table["mass"]
        self.assertRegex(self.sensitivity(table, *own.split()), "'mass'.*columns full")

    def test_threads_share_a_wall(self):
        wall = asperity.Wall(f"surface rq 5um lambda_c 40um {PAIR}")
        v1 = asperity.velocities(100, np.full(4000, 0.3))
        found = [None] * 4
        threads = [threading.Thread(target=lambda k: found.__setitem__(k, wall.impacts(v1, 1e-5)), args=(k,))
                   for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for each in found:
            np.testing.assert_array_equal(each, wall.impacts(v1, 1e-5))


if __name__ == "__main__":
    unittest.main()
