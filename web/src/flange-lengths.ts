import { distanceToSegment } from './lines.ts';
import { curvedRuns, reachOf, type Distance } from './reach.ts';
import type { BendRow, Shape, Vec2 } from './types.ts';
import { millimetres } from './units.ts';

/** How long a flange is, in mm, as a rule on the outside measures it from a bend. */
export interface FlangeLength {
  flange: number; // row of parts
  length: number;
}

/** Where a bend begins on a flange: the facets of both, and the border between them. */
interface Side {
  flange: number;
  bend: number;
  from: Vec2;
  to: Vec2;
}

/**
 * The lengths of the flanges on both sides of each bend as a rule on the outside measures them: from the mould line of
 * the bend to the far edge of the flange, or to the mould line of a bend on that side that leads farther. Their sum
 * less the deductions is the length of the blank. From 180° on there is no mould line, and the plane that touches the
 * bend takes its place. Of bends that have no such lengths, the reason.
 */
export function flangeLengths(shape: Shape): Map<string, FlangeLength[] | string> {
  const { report, parts, facet_part } = shape,
    rows = new Map((report.flat?.bends ?? []).map((b) => [b.id, b])),
    setback = (part: number) => setbackOf(rows.get(parts[part]?.name ?? ''), report.units),
    all = sides(shape),
    curved = curvedRuns(shape);
  const bendsAt = new Map<number, { part: number; side: Side }[]>(),
    facetsOf = new Map<number, number[]>();
  for (const [part, own] of all)
    for (const side of own) {
      const flange = facet_part[side.flange]!;
      bendsAt.set(flange, [...(bendsAt.get(flange) ?? []), { part, side }]);
    }
  facet_part.forEach((part, facet) => facetsOf.set(part, [...(facetsOf.get(part) ?? []), facet]));

  /** From the border of a bend to where a flange ends, or the name of the bend that leaves that unknown. */
  const lengthOf = (part: number, side: Side, away: Distance): number | string => {
    const facets = facetsOf.get(facet_part[side.flange]!)!,
      corners = facets.flatMap((f) => outlineOf(shape, f)),
      runs = facets.flatMap((f) => curved.get(f) ?? []),
      width = reachOf(shape, corners, runs, away);
    let most = width;
    for (const other of bendsAt.get(facet_part[side.flange]!) ?? []) {
      if (other.part === part || !leadsOutward(shape, other.side, away)) continue;
      const beyond = setback(other.part),
        at = away.of(other.side.from);
      if (beyond !== null) most = Math.max(most, at + beyond);
      else if (at > width - same) return parts[other.part]!.name;
    }
    return most;
  };
  const lengthsOf = (part: number, bend: BendRow): FlangeLength[] | string => {
    const own = setback(part);
    if (own === null) return bend.kind === 'cone' ? why.cone : why.noMouldLine;
    const pair = opposite(all.get(part) ?? []);
    if (typeof pair === 'string') return pair;
    if (facet_part[pair[0]!.side.flange] === facet_part[pair[1]!.side.flange]) return why.oneFlange;
    const lengths: FlangeLength[] = [];
    for (const { side, away } of pair) {
      const length = lengthOf(part, side, away);
      if (typeof length === 'string') return `${length}, in which a flange ends, has no mould line.`;
      lengths.push({ flange: facet_part[side.flange]!, length: length + own });
    }
    return lengths;
  };
  const lengths = new Map<string, FlangeLength[] | string>();
  parts.forEach(({ name, kind }, part) => {
    const bend = kind === 'bend' && rows.get(name);
    if (bend) lengths.set(name, lengthsOf(part, bend));
  });
  return lengths;
}

/** Why a bend has no outside lengths. */
const why = {
  cone: 'The radius of this bend changes along it, so it has no mould line to measure from.',
  noMouldLine: 'This bend has no deduction, so it has no mould line to measure from.',
  noFlange: 'This bend has no flange on one of its sides: there is another bend, or the edge of the sheet.',
  tapers: 'This bend is wider at one end, so its flanges have no single length.',
  oneFlange: 'This bend has the same flange on both sides.',
};

const same = 0.01; // mm

/** From the edge of the bend to its mould line: half of what allowance and deduction make together. */
function setbackOf(bend: BendRow | undefined, units: Shape['report']['units']): number | null {
  if (
    !bend ||
    bend.deduction === null ||
    bend.allowance === null ||
    (bend.kind !== 'cylinder' && bend.kind !== 'sharp')
  )
    return null;
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
      found.set(row, [...(found.get(row) ?? []), { flange, bend, from: [x0, y0], to: [x1, y1] }]);
    }
  }
  return found;
}

/** The first flange of a bend and the one across it, each with the distances from its border; or why there is none. */
function opposite(all: Side[]): { side: Side; away: Distance }[] | string {
  const [first, ...others] = all;
  if (!first) return why.noFlange;
  const away = awayFrom(first),
    second = others.find((s) => Math.abs(away.of(s.from)) > same || Math.abs(away.of(s.to)) > same);
  if (!second) return why.noFlange;
  if (Math.abs(away.of(second.from) - away.of(second.to)) > same) return why.tapers;
  return [
    { side: first, away: turnedFrom(away, second.from) },
    { side: second, away: turnedFrom(awayFrom(second), first.from) },
  ];
}

/** The distance from the border of a bend, to one of its sides. */
function awayFrom({ from, to }: Side): Distance {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]),
    normal: Vec2 = [(to[1] - from[1]) / length, (from[0] - to[0]) / length];
  return { normal, of: (p) => (p[0] - from[0]) * normal[0] + (p[1] - from[1]) * normal[1] };
}

/** The same distance, negative where a place lies. */
const turnedFrom = (d: Distance, place: Vec2): Distance =>
  d.of(place) < 0 ? d : { normal: [-d.normal[0], -d.normal[1]], of: (p) => -d.of(p) };

/** Whether a bend lies along the far side of its flange and goes on from there, not into an opening of it. */
function leadsOutward(shape: Shape, { flange, bend, from, to }: Side, { of }: Distance): boolean {
  const at = of(from);
  if (at < same || Math.abs(of(to) - at) > same) return false;
  const corners = outlineOf(shape, bend),
    beyond = corners.reduce((sum, p) => sum + of(p) - at, 0);
  const [x, y] = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  return (
    beyond > 0 &&
    outlineOf(shape, flange).some(([ax, ay], i, ring) => {
      const [bx, by] = ring[(i + 1) % ring.length]!;
      return distanceToSegment(x, y, ax, ay, bx, by).distance < same;
    })
  );
}

/** The corners of a facet's outline. */
function outlineOf({ points, ring_starts, polygon_starts, facet_starts }: Shape, facet: number): Vec2[] {
  const first = ring_starts[polygon_starts[facet_starts[facet]!]!]!,
    end = ring_starts[polygon_starts[facet_starts[facet]!]! + 1]!;
  return Array.from(
    { length: end - first },
    (_, i) => [points[2 * (first + i)]!, points[2 * (first + i) + 1]!] as Vec2,
  );
}
