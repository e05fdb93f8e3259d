import type { BendRow, Shape, Vec2 } from './types.ts';
import { millimetres } from './units.ts';

/** Where a bend begins on a flange: the facet of the flange, and the border between them. */
interface Side {
  flange: number;
  from: Vec2;
  to: Vec2;
}

/**
 * The lengths of the flanges on both sides of each bend as a rule on the outside measures them, in mm: from the mould
 * line of the bend to the far edge of the flange, or to the mould line of the bend in which it ends. Their sum less the
 * deductions is the length of the blank. From 180° on there is no mould line, and the plane that touches the bend takes
 * its place. Of bends that have no such lengths, the reason.
 */
export function flangeLengths(shape: Shape): Map<string, Vec2 | string> {
  const { report, parts, facet_part } = shape,
    rows = new Map((report.flat?.bends ?? []).map((b) => [b.id, b])),
    rowOf = (part: number) => rows.get(parts[part]?.name ?? ''),
    all = sides(shape);
  const bendsAt = new Map<number, { part: number; side: Side }[]>();
  for (const [part, own] of all)
    for (const side of own) bendsAt.set(side.flange, [...(bendsAt.get(side.flange) ?? []), { part, side }]);
  const lengthsOf = (part: number, bend: BendRow): Vec2 | string => {
    const [first, second] = all.get(part) ?? [],
      own = setbackOf(bend, report.units);
    if (own === null) return bend.kind === 'cone' ? why.cone : why.noMouldLine;
    if (!first || !second) return why.noFlange;
    const of = (side: Side, other: Side): number | string => {
      const away = awayFrom(side, other);
      if (!away) return why.tapers;
      const width = Math.max(...corners(shape, side.flange).map(away));
      const ending = (bendsAt.get(side.flange) ?? []).find(
        (b) => b.part !== part && away(b.side.from) > width - same && away(b.side.to) > width - same,
      );
      const beyond = ending ? setbackOf(rowOf(ending.part), report.units) : 0;
      return beyond === null
        ? `${parts[ending!.part]!.name}, in which a flange ends, has no mould line.`
        : width + own + beyond;
    };
    const [a, b] = [of(first, second), of(second, first)];
    if (typeof a === 'string') return a;
    if (typeof b === 'string') return b;
    return facet_part[first.flange] === facet_part[second.flange] ? why.oneFlange : [a, b];
  };
  const lengths = new Map<string, Vec2 | string>();
  parts.forEach(({ name, kind }, part) => {
    const bend = kind === 'bend' && rows.get(name);
    if (bend) lengths.set(name, lengthsOf(part, bend));
  });
  return lengths;
}

/** Why a bend has no outside lengths. */
const why = {
  cone: 'The radius of this bend changes along it, so that it has no mould line to measure from.',
  noMouldLine: 'This bend has no deduction, and so no mould line to measure from.',
  noFlange: 'This bend has no flange on one of its sides, but another bend or the edge of the sheet.',
  tapers: 'This bend is wider at one end, so that its flanges have no one length.',
  oneFlange: 'This bend has one and the same flange on both sides.',
};

const same = 0.01; // mm

/** From the edge of the bend to its mould line: half of what allowance and deduction make together. */
function setbackOf(bend: BendRow | undefined, units: Shape['report']['units']): number | null {
  if (!bend || bend.deduction === null || (bend.kind !== 'cylinder' && bend.kind !== 'sharp')) return null;
  return ((bend.allowance + bend.deduction) / 2) * millimetres(units);
}

/** Of each bend, by its row of parts, the flanges beside it. */
function sides({ parts, facet_parent, facet_part, facet_hinge }: Shape): Map<number, Side[]> {
  const found = new Map<number, Side[]>();
  for (let f = 0; f < facet_parent.length; ++f) {
    const parent = facet_parent[f]!;
    if (parent < 0 || facet_part[f] === facet_part[parent]) continue;
    const [x0, y0, x1, y1] = facet_hinge.subarray(4 * f, 4 * f + 4) as unknown as [number, number, number, number];
    for (const [flange, bend] of [
      [parent, f],
      [f, parent],
    ] as const) {
      const row = facet_part[bend]!;
      if (parts[row]?.kind !== 'bend' || parts[facet_part[flange]!]?.kind !== 'flange') continue;
      found.set(row, [...(found.get(row) ?? []), { flange, from: [x0, y0], to: [x1, y1] }]);
    }
  }
  return found;
}

/** The distance of a point from the border of a bend, positive on the side of the flange; null if the bend tapers. */
function awayFrom({ from, to }: Side, other: Side): ((p: Vec2) => number) | null {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (!(length > 0)) return null;
  const normal: Vec2 = [(to[1] - from[1]) / length, (from[0] - to[0]) / length],
    along = (p: Vec2) => (p[0] - from[0]) * normal[0] + (p[1] - from[1]) * normal[1];
  const [a, b] = [along(other.from), along(other.to)];
  if (Math.abs(a - b) > same) return null;
  return a > 0 ? (p) => -along(p) : along;
}

function corners({ points, ring_starts, polygon_starts, facet_starts }: Shape, facet: number): Vec2[] {
  const first = ring_starts[polygon_starts[facet_starts[facet]!]!]!,
    end = ring_starts[polygon_starts[facet_starts[facet + 1]!]!]!;
  return Array.from(
    { length: end - first },
    (_, i) => [points[2 * (first + i)]!, points[2 * (first + i) + 1]!] as Vec2,
  );
}
