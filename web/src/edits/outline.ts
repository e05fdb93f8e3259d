import type { PlateSpec, PlatesSpec } from './plates-types.ts';
import type { Vec2, Vec3 } from '../types.ts';
import { round } from '../units.ts';
import { cross, dot, minus, normalised, plus, scaled } from '../vectors.ts';

/**
 * Two directions square to each other in a plate: `u` level, `v` up its slope; of level plates x and y. Coordinates
 * along them are counted from the origin of space, so that they do not change where another corner does.
 */
export interface Directions {
  u: Vec3;
  v: Vec3;
}

const level = 1e-6; // sine of a slope that counts as level

export function directionsOf(outline: Vec3[]): Directions {
  const n = normalOf(outline),
    slope = Math.hypot(n[0], n[1]);
  if (slope < level) return { u: [1, 0, 0], v: [0, 1, 0] };
  const along: Vec3 = [-n[1] / slope, n[0] / slope, 0];
  const u = scaled(along, Math.sign(Math.abs(along[0]) >= Math.abs(along[1]) ? along[0] : along[1]));
  const v = cross(n, u);
  return { u, v: scaled(v, Math.sign(v[2])) };
}

/** By Newell's method; up if there is none. */
function normalOf(outline: Vec3[]): Vec3 {
  const [o] = outline;
  if (!o) return [0, 0, 1];
  const sum = outline.reduce((s, p, i) => plus(s, cross(minus(p, o), minus(outline[(i + 1) % outline.length]!, o))), [
    0, 0, 0,
  ] as Vec3);
  return Math.hypot(...sum) > 0 ? normalised(sum) : [0, 0, 1];
}

export const along = ({ u, v }: Directions, p: Vec3): Vec2 => [dot(p, u), dot(p, v)];

export interface Extent {
  low: Vec2;
  high: Vec2;
}

/** Nothing at the origin, where there are no points. */
export function extentOf(d: Directions, points: Vec3[]): Extent {
  if (!points.length) return { low: [0, 0], high: [0, 0] };
  const at = points.map((p) => along(d, p)),
    limit = (pick: (...v: number[]) => number) => [0, 1].map((k) => pick(...at.map((p) => p[k]!))) as Vec2;
  return { low: limit(Math.min), high: limit(Math.max) };
}

const placed = (p: Vec3) => p.map((v) => round(v)) as Vec3;

type Hole = NonNullable<PlateSpec['holes']>[number];

/** The corners of a hole; none of a circle, a slot or a path. */
const cornersOf = (hole: Hole): Vec3[] => (Array.isArray(hole) ? hole : []);

/** The outline, then the holes. */
export const ringsOf = (plate: PlateSpec): Vec3[][] => [plate.outline, ...(plate.holes ?? []).map(cornersOf)];

function withRings(spec: PlatesSpec, id: string, change: (rings: Vec3[][], plate: PlateSpec) => Vec3[][]): PlatesSpec {
  const changed = (plate: PlateSpec): PlateSpec => {
    const rings = ringsOf(plate),
      { holes: before = [], ...rest } = plate;
    const shapes = new Map(before.flatMap((h, i) => (Array.isArray(h) ? [] : [[rings[i + 1]!, h]])));
    const [outline, ...changed] = change(rings, plate);
    const holes = changed.map((ring): Hole => shapes.get(ring) ?? ring);
    return { ...rest, outline: outline!, ...(holes.length ? { holes } : {}) };
  };
  return { ...spec, plates: spec.plates.map((p) => (p.id === id ? changed(p) : p)) };
}

const withRing = (spec: PlatesSpec, id: string, ring: number, change: (corners: Vec3[], d: Directions) => Vec3[]) =>
  withRings(spec, id, (rings, plate) => rings.map((r, i) => (i === ring ? change(r, directionsOf(plate.outline)) : r)));

/** A corner at another place along u (`axis` 0) or v (1): it stays in the plate's plane. */
export function moveCorner(
  spec: PlatesSpec,
  id: string,
  ring: number,
  corner: number,
  axis: 0 | 1,
  to: number,
): PlatesSpec {
  return withRing(spec, id, ring, (corners, d) =>
    corners.map((p, i) => (i === corner ? placed(plus(p, scaled(axis === 0 ? d.u : d.v, to - along(d, p)[axis]))) : p)),
  );
}

/** Adds a corner in the middle of the edge that begins at `corner`. A bend at that edge takes both halves. */
export function addCorner(spec: PlatesSpec, id: string, ring: number, corner: number): PlatesSpec {
  const more = withRing(spec, id, ring, (corners) => {
    const middle = placed(scaled(plus(corners[corner]!, corners[(corner + 1) % corners.length]!), 0.5));
    return [...corners.slice(0, corner + 1), middle, ...corners.slice(corner + 1)];
  });
  return ring === 0 ? withEdges(more, id, (e) => (e < corner ? [e] : e === corner ? [e, e + 1] : [e + 1])) : more;
}

/** Removes a corner: the edges on both sides of it become one. */
export function removeCorner(spec: PlatesSpec, id: string, ring: number, corner: number): PlatesSpec {
  const count = ringsOf(spec.plates.find((p) => p.id === id)!)[ring]!.length - 1;
  if (count < 3) return spec;
  const less = withRing(spec, id, ring, (corners) => corners.filter((_, i) => i !== corner));
  return ring === 0 ? withEdges(less, id, (e) => [e < corner ? e : (e - 1 + count) % count]) : less;
}

/** Updates the edges of bends whose numbers have changed. */
function withEdges(spec: PlatesSpec, id: string, to: (edge: number) => number[]): PlatesSpec {
  if (!spec.bends) return spec;
  const bends = spec.bends.map((b) =>
    b.edges?.[id] ? { ...b, edges: { ...b.edges, [id]: [...new Set(b.edges[id].flatMap(to))] } } : b,
  );
  return { ...spec, bends };
}

const share = 1 / 6; // of the plate's extent, for a new hole

/** A rectangle as near the middle as possible, clear of the other holes. */
export function addHole(spec: PlatesSpec, id: string): PlatesSpec {
  return withRings(spec, id, ([outline, ...holes]) => [outline!, ...holes, newHole(outline!, holes)]);
}

function newHole(outline: Vec3[], holes: Vec3[][]): Vec3[] {
  const d = directionsOf(outline),
    { low, high } = extentOf(d, outline),
    size: Vec2 = [share * (high[0] - low[0]), share * (high[1] - low[1])];
  const taken = holes.map((h) => extentOf(d, h));
  const tries = [2.5, 3.5, 1.5, 4.5, 0.5].flatMap((i) => [2.5, 3.5, 1.5, 4.5, 0.5].map((j): Vec2 => [i, j]));
  tries.sort((a, b) => Math.hypot(a[0] - 2.5, a[1] - 2.5) - Math.hypot(b[0] - 2.5, b[1] - 2.5));
  const box = ([i, j]: Vec2): Extent => {
    const at: Vec2 = [low[0] + i * size[0], low[1] + j * size[1]];
    return { low: at, high: [at[0] + size[0], at[1] + size[1]] };
  };
  const free = tries
    .map(box)
    .find((b) => !taken.some((t) => [0, 1].every((k) => t.low[k]! < b.high[k]! && b.low[k]! < t.high[k]!)));
  return rectangleAt(d, outline[0]!, free ?? box([2.5, 2.5]));
}

/** In the plane through `on`. */
export function rectangleAt(d: Directions, on: Vec3, { low, high }: Extent): Vec3[] {
  const [u0, v0] = along(d, on),
    origin = minus(on, plus(scaled(d.u, u0), scaled(d.v, v0)));
  const at = (u: number, v: number) => placed(plus(origin, plus(scaled(d.u, u), scaled(d.v, v))));
  return [at(low[0], low[1]), at(high[0], low[1]), at(high[0], high[1]), at(low[0], high[1])];
}

export const removeHole = (spec: PlatesSpec, id: string, hole: number): PlatesSpec =>
  withRings(spec, id, (rings) => rings.filter((_, i) => i !== hole + 1));
