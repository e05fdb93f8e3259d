#!/usr/bin/python3
"""No opening of a solid is lost: the genus of every real part, by Euler's formula on the entities of
its file (no CAD kernel, nothing of Planish), against the pattern; and the holes in its DXF."""

import collections
import os
import pathlib
import re
import subprocess
import sys

import ezdxf

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planish_cli import CLI, SECONDS, SOURCE, CliTest, main  # noqa: E402

PARTS = pathlib.Path(os.environ.get("PLANISH_PARTS") or SOURCE.parent / "shared" / "parts")
FORMED = {"sm088": 2, "sf006": 7, "sf012": 33, "sf014": 41}  # openings of these solids
FORGETTABLE = re.compile(r"'(?:[^']|'')*'|/\*.*?\*/", re.S)
ENTITY = re.compile(r"#(\d+)\s*=\s*(\w+)\s*\((.*)\)\s*$", re.S)


def files():
    return sorted(PARTS.glob("*.step")) if PARTS.is_dir() else []


class Solid:
    """The boundary of the one solid of a STEP file."""

    def __init__(self, text):
        self.entities = {}
        for row in FORGETTABLE.sub("''", text).split(";"):
            if found := ENTITY.match(row.strip()):
                self.entities[int(found[1])] = (found[2], [int(n) for n in re.findall(r"#(\d+)", found[3])])
        self.bodies = [n for n, (name, _) in self.entities.items()
                       if name in ("MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS")]

    def shells(self):
        """Numbers of the closed shells of the only body."""
        for part in self.entities[self.bodies[0]][1]:
            while self.entities[part][0] == "ORIENTED_CLOSED_SHELL":
                part = self.entities[part][1][0]
            yield part

    def genus(self):
        """None where edges are not shared by two faces each, so that the file does not say."""
        if len(self.bodies) != 1:
            return None
        total = 0
        for shell in self.shells():
            euler = self.euler_of(shell)
            if euler is None or euler % 2:
                return None
            total += (2 - euler) // 2
        return total

    def euler_of(self, shell):
        vertices, edges, euler = set(), collections.Counter(), 0
        for face in self.entities[shell][1]:
            bounds = [b for b in self.entities[face][1]
                      if self.entities.get(b, ("",))[0] in ("FACE_BOUND", "FACE_OUTER_BOUND")]
            euler += 2 - len(bounds)
            for bound in bounds:
                loop = self.entities[bound][1][0]
                if self.entities[loop][0] == "VERTEX_LOOP":
                    vertices.add(self.entities[loop][1][0])
                    continue
                for oriented in self.entities[loop][1]:
                    edge = self.entities[oriented][1][0]
                    edges[edge] += 1
                    vertices.update(self.entities[edge][1][:2])
        if any(uses != 2 for uses in edges.values()):
            return None
        return euler + len(vertices) - len(edges)


# Folded, these touch themselves beside a tongue and close its opening (tests/job/corpus_exceptions.json).
CLOSED_BY_TABS = {"sm165": 1}


class Openings(CliTest):
    def setUp(self):
        super().setUp()
        if not files():
            self.skipTest("the real parts are absent: tools/fetch_parts.py brings them")

    def unfold(self, path, *options):
        """The report; None where the part is refused, or one body of several has to be named."""
        done = subprocess.run([CLI, "unfold", path, "--json", "report.json", "--no-rules", "-q", *options],
                              cwd=self.dir, capture_output=True, timeout=SECONDS, check=False)
        if done.returncode in (2, 4):
            return None
        self.assertEqual(done.returncode, 0, done.stderr.decode())
        return self.json("report.json")

    def part(self, prefix):
        found = [path for path in files() if path.name.startswith(prefix + "_")]
        if not found:
            self.skipTest(f"{prefix} is absent")
        return found[0]

    def test_every_part_has_all_the_openings_of_its_solid(self):
        compared = 0
        for path in files():
            report = self.unfold(path, "--check")
            if report is None:
                continue
            with self.subTest(path.name):
                openings = report["verification"]["openings"]
                self.assertIn("solid", openings)
                self.assertEqual(openings["pattern"] + openings["features"] +
                                 openings.get("loops", 0),
                                 openings["solid"] + CLOSED_BY_TABS.get(path.name.split("_")[0], 0))
                self.assertFalse([c for c in report["checks"] if c["code"] == "lost_opening"])
                genus = Solid(path.read_text("latin-1")).genus()
                if genus is not None:
                    compared += 1
                    self.assertEqual(openings["solid"], genus)
        if len(files()) > 200:
            self.assertGreater(compared, 90)

    def test_a_hole_that_is_drawn_out_of_the_sheet_is_in_the_dxf(self):
        for prefix, solid in FORMED.items():
            with self.subTest(prefix):
                report = self.unfold(self.part(prefix), "-o", "part.dxf")
                self.assertEqual(report["verification"]["openings"]["solid"], solid)
                drawn = ezdxf.readfile(self.dir / "part.dxf").modelspace()
                cut = [e for e in drawn if e.dxf.layer == "INTERIOR_PROFILES"]
                self.assertEqual(len(cut), report["flat"]["openings"])
                self.assertTrue([e for e in drawn if e.dxf.layer == "FEATURE_PROFILES"])

    def test_the_option_says_what_is_cut(self):
        part = self.part("sm088")
        pilot, through, outline = (self.unfold(part, "--check", "--extruded", word)
                                   for word in ("pilot", "through", "outline"))
        for report, pattern, features in ((pilot, 2, 0), (through, 2, 0), (outline, 0, 2)):
            self.assertEqual(report["verification"]["openings"],
                             {"solid": 2, "pattern": pattern, "features": features})
            self.assertAlmostEqual(report["verification"]["explained_ratio"], 1.0, 5)
        self.assertLess(through["flat"]["area"], outline["flat"]["area"])
        self.assertGreaterEqual(pilot["flat"]["area"], through["flat"]["area"])


if __name__ == "__main__":
    main()
