"""The solids in a STEP file, as text: which there are, how large they are, and one of them as a file
of its own. The entities are copied as they stand; nothing is computed anew, so that the solid is
exactly the one in the file. Where an assembly places it is left behind."""

import itertools
import math
import re

INSTANCE = re.compile(r"#(\d+)\s*=\s*((?:'(?:[^']|'')*'|[^';])*);")
STRING = re.compile(r"'(?:[^']|'')*'")
REFERENCE = re.compile(r"#(\d+)")
SOLID = re.compile(r"\s*(MANIFOLD_SOLID_BREP|BREP_WITH_VOIDS|FACETED_BREP)\b")
COMMENT = re.compile(r"/\*.*?\*/", re.S)
PREFIXES = {"": 1000.0, "MILLI": 1.0, "CENTI": 10.0, "DECI": 100.0, "MICRO": 0.001, "KILO": 1e6}


class NotStep(Exception):
    pass


class StepSolids:
    def __init__(self, data):
        text = data.decode("latin-1")
        at = text.find("DATA;")
        if "ISO-10303-21" not in text[:2000] or at < 0:
            raise NotStep("it is not a STEP file")
        self.header = text[:at]
        self.entities = {int(m[1]): m[2] for m in INSTANCE.finditer(COMMENT.sub("", text[at + 5:]))}
        self.solids = [i for i, entity in self.entities.items() if SOLID.match(entity)]
        self._contexts = None

    def references(self, number):
        return [int(n) for n in REFERENCE.findall(STRING.sub("''", self.entities.get(number, "")))]

    def below(self, *roots):
        """The entities that these refer to, at any depth, and themselves."""
        seen, todo = set(), list(roots)
        while todo:
            number = todo.pop()
            if number not in seen and number in self.entities:
                seen.add(number)
                todo += self.references(number)
        return seen

    # ---- what tells one solid from another

    def facts(self, solid):
        """Faces, vertices, the largest distance between two vertices, and how far on the average
        (root mean square) they lie from their middle, in mm: the same wherever the solid lies."""
        below = self.below(solid)
        points = []
        for number in below:
            if self._is(number, "VERTEX_POINT"):
                points.append(self._coordinates(self.references(number)[0]))
        faces = sum(self._is(n, "ADVANCED_FACE") or self._is(n, "FACE_SURFACE") for n in below)
        points = list(dict.fromkeys(points))
        mm = self.millimetres(solid)
        return {"faces": faces, "vertices": len(points),
                "span": round(largest_distance(points) * mm, 6),
                "spread": round(mean_distance(points) * mm, 6)}

    def _is(self, number, kind):
        return self.entities[number].lstrip().startswith(kind)

    def _coordinates(self, number):
        inner = STRING.sub("", self.entities[number])
        inner = inner[inner.rindex("(") + 1:inner.index(")", inner.rindex("("))]
        return tuple(float(x) for x in inner.split(","))

    # ---- units

    def context(self, solid):
        """The representation context in which the solid stands."""
        if self._contexts is None:
            self._contexts = {}
            for number, entity in self.entities.items():
                if re.match(r"\s*(ADVANCED_BREP_|FACETED_BREP_|)SHAPE_REPRESENTATION\s*\(", entity):
                    *items, context = self.references(number)
                    self._contexts.update((item, context) for item in items)
        if solid not in self._contexts:
            raise NotStep(f"no representation holds solid #{solid}")
        return self._contexts[solid]

    def millimetres(self, solid):
        """Of one length unit."""
        for number in self.below(self.context(solid)):
            entity = self.entities[number]
            if "GLOBAL_UNIT_ASSIGNED_CONTEXT" in entity:
                units = re.search(r"GLOBAL_UNIT_ASSIGNED_CONTEXT\s*\(\s*\(([^)]*)\)", entity)
                for unit in map(int, REFERENCE.findall(units[1])):
                    if "LENGTH_UNIT" in self.entities[unit]:
                        return self._unit(unit)
        raise NotStep("its length unit is not given")

    def _unit(self, number):
        entity = self.entities[number]
        if "CONVERSION_BASED_UNIT" not in entity:
            prefix = re.search(r"SI_UNIT\s*\(\s*(?:\$|\.(\w*)\.)\s*,\s*\.METRE\.", entity)
            return PREFIXES[prefix[1] or ""]
        measure = next(n for n in self.references(number) if "MEASURE" in self.entities[n])
        value = re.search(r"LENGTH_MEASURE\s*\(\s*([-+.\dEe]+)", self.entities[measure])
        return float(value[1]) * self._unit(self.references(measure)[-1])

    # ---- one solid as a file

    def text_of(self, solid, name):
        context = self.context(solid)
        kept = self.below(solid, context)
        free = max(self.entities) + 1
        kind = ("FACETED" if self._is(solid, "FACETED_BREP") else "ADVANCED")
        added = [
            "APPLICATION_CONTEXT('automotive design')",
            f"APPLICATION_PROTOCOL_DEFINITION('','automotive_design',2000,#{free})",
            f"PRODUCT_CONTEXT('',#{free},'mechanical')",
            f"PRODUCT('{name}','{name}','',(#{free + 2}))",
            f"PRODUCT_DEFINITION_FORMATION('','',#{free + 3})",
            f"PRODUCT_DEFINITION_CONTEXT('part definition',#{free},'design')",
            f"PRODUCT_DEFINITION('design','',#{free + 4},#{free + 5})",
            f"PRODUCT_DEFINITION_SHAPE('','',#{free + 6})",
            f"{kind}_BREP_SHAPE_REPRESENTATION('{name}',(#{solid}),#{context})",
            f"SHAPE_DEFINITION_REPRESENTATION(#{free + 7},#{free + 8})"]
        lines = [f"#{n}={self.entities[n]};" for n in sorted(kept)]
        lines += [f"#{free + i}={entity};" for i, entity in enumerate(added)]
        return (self.header + "DATA;\n" + "\n".join(lines)
                + "\nENDSEC;\nEND-ISO-10303-21;\n").encode("latin-1")


def mean_distance(points):
    middle = tuple(sum(c) / len(points) for c in zip(*points))
    return math.sqrt(sum(math.dist(p, middle) ** 2 for p in points) / len(points))


def largest_distance(points):
    """Only points that are farthest in some direction can be its ends."""
    if len(points) > 400:
        directions = [(math.cos(a) * math.cos(b), math.sin(a) * math.cos(b), math.sin(b))
                      for a in (i * math.pi / 24 for i in range(24))
                      for b in (j * math.pi / 24 for j in range(-12, 13))]
        middle = tuple(sum(c) / len(points) for c in zip(*points))
        around = [(math.dist(p, middle), p) for p in points]
        extreme = set()
        for d in directions:
            along = [sum(x * y for x, y in zip(p, d)) for p in points]
            extreme |= {points[along.index(max(along))], points[along.index(min(along))]}
        extreme |= {p for _, p in sorted(around)[-100:]}
        points = sorted(extreme)
    return max((math.dist(p, q) for p, q in itertools.combinations(points, 2)), default=0.0)


def matches(facts, wanted):
    return (facts["faces"] == wanted["faces"] and facts["vertices"] == wanted["vertices"]
            and all(math.isclose(facts[key], wanted[key], rel_tol=2e-6) for key in ("span", "spread")))


def matching(file, wanted):
    """The solids of the file with these facts: one, or copies and mirror images of one."""
    return [solid for solid in file.solids if matches(file.facts(solid), wanted)]
