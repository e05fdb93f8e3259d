"""A part of known size: the folded solid, and what its flat pattern measures."""

import dataclasses

from .sizes import MIDDLE, RULES


@dataclasses.dataclass
class Part:
    family: str
    text: str  # one sentence
    thickness: float
    solid: object
    flat: object = None  # Rule -> Flat
    bends: list = dataclasses.field(default_factory=list)
    refused: list = None  # reasons, any of which is right
    volume: float = None  # where it differs from area at K = ½ times thickness
    name: str = ""
    inch: bool = False

    def record(self):
        """What known_parts.json says of it."""
        row = {"id": self.name, "family": self.family, "text": self.text,
               "file_unit": "inch" if self.inch else "mm", "thickness": self.thickness and rounded(self.thickness)}
        if self.refused:
            return row | {"refused": self.refused}
        flats = {rule.name: self._flat(rule) for rule in RULES if self._has(rule)}
        volume = self.volume or self.thickness * flats[MIDDLE.name]["area"]
        return row | {"volume": rounded(volume), "flat": flats}

    def _has(self, rule):
        return all(rule.k(b.radius, self.thickness) is not None for b in self.bends) and (
            rule.constant is not None or all(b.measured for b in self.bends))

    def _flat(self, rule):
        flat = self.flat(rule)
        return {"area": rounded(flat.area),
                "perimeter": rounded(flat.outer + sum(flat.openings)),
                "outer": rounded(flat.outer), "inner": rounded(sum(flat.openings)),
                "size": flat.size and [rounded(x) for x in flat.size],
                "openings": len(flat.openings),
                "bends": [self._bend(bend, rule) for bend in self.bends]}

    def _bend(self, bend, rule):
        row = {"angle": rounded(bend.angle) if bend.angle else None,
               "direction": "up" if bend.up else "down",
               "length": None if bend.length is None else rounded(bend.length)}
        if not bend.measured:
            return row | {"inside_radius": None, "allowance": None, "deduction": None}
        deduction = bend.deduction(self.thickness, rule) if bend.angle < 179.9 else None
        return row | {"inside_radius": rounded(bend.radius),
                      "allowance": rounded(bend.allowance(self.thickness, rule)),
                      "deduction": None if deduction is None else rounded(deduction)}


def rounded(x):
    return round(x, 9)
