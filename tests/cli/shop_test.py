#!/usr/bin/python3
"""Shop profiles: one file that says what a shop stocks, how it bends and cuts."""

import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import step_files  # noqa: E402
from planish_cli import SOURCE, CliTest, main  # noqa: E402

EXAMPLE = SOURCE / "examples" / "shop" / "example.json"


def flat_length(k, leg=50.0, t=2.0, r=2.0):
    return 2 * (leg - t - r) + math.pi / 2 * (r + k * t)


def shop(**more):
    """A shop that bends steel of 2 mm to a radius of 2 mm with K = 0.3."""
    gauge = {"thickness": 2, "inside_radius": 2, "k": 0.3, **more.pop("gauge", {})}
    gauge = {key: value for key, value in gauge.items() if value is not None}
    return json.dumps({"format": "planish/shop", "version": 1, "name": "S",
                       "materials": [{"name": "steel", "density": 8.0, "gauges": [gauge]}], **more})


class Shop(CliTest):
    """The angle of step_files: 60 deep, legs of 50, t = r = 2, without openings."""

    def report(self, profile, *options, status=0):
        self.angle()
        self.write("shop.json", profile)
        self.run_cli("unfold", "part.step", "--shop", "shop.json", "--json", "report.json", *options, status=status)
        return self.json("report.json")

    def findings(self, report, code):
        return [check for check in report["checks"] if check["code"] == code]

    def test_gives_k_by_the_thickness_of_the_part(self):
        report = self.report(shop())
        self.assertAlmostEqual(report["flat"]["size"][0], flat_length(0.3), places=6)
        self.assertEqual(report["sheet"]["k_source"], "shop S, steel 2 mm: K")
        self.assertAlmostEqual(report["sheet"]["mass"], 8e-6 * report["sheet"]["volume"], places=9)
        self.assertEqual(report["status"], "ok")

    def test_turns_a_deduction_into_the_flat_length(self):
        # Two legs of 50 less the deduction, whatever K that is.
        report = self.report(shop(gauge={"k": None, "deduction": 3.8374}))
        self.assertAlmostEqual(report["flat"]["size"][0], 100 - 3.8374, places=6)
        self.assertAlmostEqual(report["flat"]["bends"][0]["deduction"], 3.8374, places=6)
        self.assertIn("deduction 3.837 mm at 90°", report["sheet"]["k_source"])

    def test_gives_way_to_k_given_beside_it(self):
        report = self.report(shop(), "--k", "0.5", "--density", "1")
        self.assertAlmostEqual(report["flat"]["size"][0], flat_length(0.5), places=6)
        self.assertAlmostEqual(report["sheet"]["mass"], 1e-6 * report["sheet"]["volume"], places=9)

    def test_says_that_a_thickness_is_not_stocked(self):
        report = self.report(shop(gauge={"thickness": 1.5}))
        (finding,) = self.findings(report, "shop_gauge")
        self.assertEqual(finding["severity"], "warning")
        self.assertIn("does not stock steel of 2 mm", finding["message"])
        self.assertIn("1.5 mm", finding["message"])
        self.assertEqual(report["status"], "warning")
        self.assertEqual(report["sheet"]["k_source"], "default")

    def test_says_that_a_radius_is_not_the_shops(self):
        report = self.report(shop(gauge={"inside_radius": 2.5}))
        (finding,) = self.findings(report, "shop_radius")
        self.assertIn("bend B1 has an inside radius of 2 mm", finding["message"])
        self.assertIn("is 2.5 mm", finding["message"])
        self.assertEqual(len(finding["at"]), 1)
        self.assertFalse(self.findings(self.report(shop(gauge={"inside_radius": 2.05})), "shop_radius"))

    def test_holds_parts_to_its_limits(self):
        # The blank is 96.08 × 60, its bend 60 long.
        tight = {"sheet": [90, 80], "smallest_part": [100, 10], "longest_bend": 59, "most_bends": 1}
        messages = [f["message"] for f in self.findings(self.report(shop(limits=tight)), "shop_limit")]
        self.assertEqual(len(messages), 3, messages)
        self.assertIn("largest sheet of S, 90 mm × 80 mm", messages[0])
        self.assertIn("smaller than the smallest part of S", messages[1])
        self.assertIn("bend B1 is 60 mm long", messages[2])
        loose = {"sheet": [60.1, 97], "smallest_part": [60, 60], "longest_bend": 60, "most_bends": 1}
        self.assertFalse(self.findings(self.report(shop(limits=loose)), "shop_limit"))

    def test_feeds_the_rules_of_manufacture(self):
        # The flange is 50 high from the outside of the bend.
        self.assertFalse(self.findings(self.report(shop(gauge={"smallest_flange": 49.9})), "flange_height"))
        self.assertTrue(self.findings(self.report(shop(gauge={"smallest_flange": 50.1})), "flange_height"))
        report = self.report(shop(gauge={"smallest_flange": 50.1}), "--process", "laser")
        self.assertFalse(self.findings(report, "flange_height"))
        self.assertTrue(self.findings(self.report(shop(rules={"flange_height_t": 30})), "flange_height"))

    def test_names_layers_and_linetypes(self):
        self.report(shop(dxf={"layers": {"outer": "CUT", "bend_up": "FOLD_UP", "bend_down": "FOLD_DOWN"},
                              "bend_lines": "continuous"}))
        dxf = (self.dir / "part.dxf").read_text()
        self.assertIn("\nCUT\n", dxf)
        self.assertRegex(dxf, "\nFOLD_(UP|DOWN)\n")
        self.assertNotIn("OUTER_PROFILE", dxf)
        self.assertNotRegex(dxf, r"  6\nDASHED\n 62\n")
        self.report(shop(dxf={"layers": {"outer": "CUT"}}), "--profile", "inventor")
        self.assertIn("IV_OUTER_PROFILE", (self.dir / "part.dxf").read_text())

    def test_is_taken_by_connect_with_its_radius(self):
        plates = {"thickness": 2, "plates": [
            {"id": "A", "outline": [[0, 0, 0], [100, 0, 0], [100, 50, 0], [0, 50, 0]]},
            {"id": "B", "outline": [[0, 60, 10], [100, 60, 10], [100, 60, 60], [0, 60, 60]]}]}
        self.write("plates.json", json.dumps(plates))
        self.write("shop.json", shop(gauge={"inside_radius": 3}))
        self.run_cli("connect", "plates.json", "--shop", "shop.json", "--json", "report.json")
        bend = self.json("report.json")["flat"]["bends"][0]
        self.assertAlmostEqual(bend["inside_radius"], 3.0, places=6)
        self.assertAlmostEqual(bend["allowance"], math.pi / 2 * (3 + 0.3 * 2), places=6)
        self.assertFalse(self.findings(self.json("report.json"), "shop_radius"))

    def test_is_taken_by_transition(self):
        self.write("shop.json", shop())
        spec = {"thickness": 2, "from": {"profile": {"circle": {"radius": 100}}},
                "to": {"profile": {"circle": {"radius": 60}}, "frame": {"origin": [0, 0, 150]}}}
        self.write("cone.json", json.dumps(spec))
        self.run_cli("transition", "cone.json", "--shop", "shop.json", "--material", "Steel", "--json", "report.json")
        self.assertAlmostEqual(self.json("report.json")["sheet"]["k_factor"], 0.3)

    def test_wants_the_material_where_there_are_several(self):
        self.angle()
        error = self.refused("unfold", "part.step", "--shop", EXAMPLE, status=2)
        self.assertIn("mild steel, aluminium 5754. Choose one with --material", error)
        error = self.refused("unfold", "part.step", "--shop", EXAMPLE, "--material", "brass", status=2)
        self.assertIn('no material "brass"', error)
        self.run_cli("unfold", "part.step", "--shop", EXAMPLE, "--material", "Mild steel", "--json", "report.json")
        self.assertAlmostEqual(self.json("report.json")["flat"]["size"][0], 100 - 3.84, places=6)

    def part_of(self, material):
        """The angle as a STEP file that names its material, of 2680 kg/m³."""
        file = step_files.StepFile()
        shell = file.prism(*step_files.angle_profile(50.0, 2.0, 2.0), 60.0)
        file.material(file.product("angle", shell)[0], material, 2680.0)
        self.write("part.step", file.text())

    def test_takes_the_material_that_the_file_names(self):
        self.part_of("Aluminium 5754")
        self.run_cli("unfold", "part.step", "--shop", EXAMPLE, "--json", "report.json")
        report = self.json("report.json")
        self.assertAlmostEqual(report["flat"]["size"][0], flat_length(0.42), places=6)
        self.assertAlmostEqual(report["sheet"]["mass"], 2.67e-6 * report["sheet"]["volume"], places=9)
        # What is chosen outweighs what the file says.
        self.run_cli("unfold", "part.step", "--shop", EXAMPLE, "--material", "mild steel", "--density", "7",
                     "--json", "report.json")
        report = self.json("report.json")
        self.assertAlmostEqual(report["flat"]["size"][0], 100 - 3.84, places=6)
        self.assertAlmostEqual(report["sheet"]["mass"], 7e-6 * report["sheet"]["volume"], places=9)
        self.part_of("brass")
        error = self.refused("unfold", "part.step", "--shop", EXAMPLE, status=2)
        self.assertIn("the part is made of brass, which the shop profile does not have; it has mild steel, aluminium 5754",
                      error)

    def test_gives_way_to_density_where_the_file_names_the_material(self):
        self.part_of("Mild Steel")
        self.run_cli("unfold", "part.step", "--shop", EXAMPLE, "--density", "7", "--json", "report.json")
        report = self.json("report.json")
        self.assertAlmostEqual(report["sheet"]["mass"], 7e-6 * report["sheet"]["volume"], places=9)

    def test_says_what_is_wrong_with_a_profile(self):
        self.angle()
        for text, words in (("{", "shop.json:1:1"), ("", "is not JSON"),
                            (shop(gauge={"k": 3}), "shop.json/materials/0/gauges/0/k"),
                            (shop(gauge={"colour": 3}), "shop.json/materials/0/gauges/0/colour"),
                            (shop(gauge={"k": None, "deduction": 30}), "K must be from 0 to 1")):
            self.write("shop.json", text)
            self.assertIn(words, self.refused("unfold", "part.step", "--shop", "shop.json", status=3))
        self.assertIn("none.json", self.refused("unfold", "part.step", "--shop", "none.json", status=3))


if __name__ == "__main__":
    main()
