#!/usr/bin/python3
"""What a STEP file says of materials and colours, with masses in closed form."""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import step_files  # noqa: E402
from planish_cli import CliTest, main  # noqa: E402


def flat_area(leg, depth, thickness=2.0, radius=2.0, k=0.5):
    return depth * (2 * (leg - thickness - radius) + math.pi / 2 * (radius + k * thickness))


class Materials(CliTest):
    def part(self, material=None, colour=None, exponent=-3):
        file = step_files.StepFile()
        shell = file.prism(*step_files.angle_profile(50.0, 2.0, 2.0), 60.0)
        definition, solid = file.product("angle", shell)
        if material:
            file.material(definition, *material, exponent=exponent)
        if colour:
            file.colour(solid, *colour)
        self.write("part.step", file.text())

    def report(self, *options):
        self.run_cli("unfold", "part.step", "-q", "--check", "--json", "r.json", *options)
        return self.json("r.json")

    def test_name_and_density_give_the_mass(self):
        # At K = 1/2 area times thickness is the volume: 60 · (92 + 1.5 π) · 2 mm³ of 2680 kg/m³.
        for exponent in (-3, 3):
            self.part(material=("AlMg3", 2680.0), exponent=exponent)
            report = self.report("--k", "0.5")
            self.assertEqual((report["material"], report["density"]), ("AlMg3", 2.68))
            self.assertAlmostEqual(report["sheet"]["mass"], flat_area(50.0, 60.0) * 2.0 * 2.68e-6, 12)

    def test_an_option_outweighs_the_file(self):
        self.part(material=("AlMg3", 2680.0))
        mass = self.report("--k", "0.5", "--density", "7.85")["sheet"]["mass"]
        self.assertAlmostEqual(mass, flat_area(50.0, 60.0) * 2.0 * 7.85e-6, 12)

    def test_a_density_that_no_material_has_is_left_out(self):
        self.part(material=("Steel", 7.85))  # of a file that says kg/m³ and means kg/dm³
        report = self.report()
        self.assertEqual(report["material"], "Steel")
        self.assertNotIn("density", report)
        self.assertIsNone(report["sheet"]["mass"])

    def test_the_colour_is_that_of_the_file(self):
        self.part(colour=(1.0, 128 / 255, 0.0))
        self.assertEqual(self.report()["colour"], "#ff8000")
        self.run_cli("info", "part.step", "--json", "i.json")
        self.assertEqual(self.json("i.json")["bodies"][0]["colour"], "#ff8000")

    def test_a_file_that_says_nothing(self):
        self.part()
        report = self.report()
        self.assertEqual({"material", "density", "colour"} & set(report), set())

    def test_the_same_shape_of_two_materials_is_two_bodies(self):
        file = step_files.StepFile()
        for i, material in enumerate(("Steel", "Steel", "Brass")):
            shell = file.prism(*step_files.angle_profile(50.0, 2.0, 2.0), 60.0, at=(100.0 * i, 0.0, 0.0))
            file.material(file.product(f"p{i}", shell)[0], material, 8000.0)
        self.write("part.step", file.text())
        self.run_cli("info", "part.step", "--json", "i.json")
        self.assertEqual([(one["material"], one["quantity"]) for one in self.json("i.json")["bodies"]],
                         [("Steel", 2), ("Brass", 1)])


if __name__ == "__main__":
    main()
