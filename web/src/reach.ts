import { runsOf, type Run } from './sheet-lod.ts';
import type { Shape, Vec2 } from './types.ts';

/** A distance in the flat pattern: of points from a line, in the direction of its normal, a unit vector. */
export interface Distance {
  normal: Vec2;
  of: (p: Vec2) => number;
}

const draftChord = 0.15, // mm; how far a curve may lie from its polygon, at most
  neighbours = 3; // on either side of a segment, of those that tell how a curve goes on between its corners

/**
 * How far an outline reaches in the direction of a distance. Arcs count to their apex, other curves to that of the
 * curve through their corners, which lies beyond the corners themselves.
 */
export function reachOf(shape: Shape, corners: Vec2[], runs: Run[], distance: Distance): number {
  let most = -Infinity;
  for (const p of corners) most = Math.max(most, distance.of(p));
  for (const run of runs) {
    const apex = isArc(shape, run) ? apexOfArc(shape, run, distance) : apexOfCurve(shape, run, distance, most);
    most = Math.max(most, apex);
  }
  return most;
}

/** The curved borders of the outlines of facets, by facet. */
export function curvedRuns(shape: Shape): Map<number, Run[]> {
  const found = new Map<number, Run[]>();
  for (const run of runsOf(shape))
    if (run.end - run.first > 1 || isArc(shape, run)) found.set(run.facet, [...(found.get(run.facet) ?? []), run]);
  return found;
}

const isArc = ({ edge_circle, edge_number }: Shape, { first }: Run) => edge_circle[4 * edge_number[first]! + 2]! > 0;

function apexOfArc({ edges, edge_circle, edge_number }: Shape, { first, end }: Run, { normal, of }: Distance): number {
  const border = 4 * edge_number[first]!,
    [x, y, radius] = edge_circle.subarray(border, border + 3) as unknown as [number, number, number];
  const turn = (px: number, py: number) => normal[0] * (py - y) - normal[1] * (px - x);
  for (let e = first; e < end; ++e) {
    const [ax, ay, bx, by] = edges.subarray(4 * e, 4 * e + 4) as unknown as [number, number, number, number],
      ahead = normal[0] * (ax + bx - 2 * x) + normal[1] * (ay + by - 2 * y) > 0;
    // The apex lies between the ends of this segment, as seen from the middle.
    if (ahead && turn(ax, ay) * turn(bx, by) <= 0) return of([x, y]) + radius;
  }
  return -Infinity;
}

/** Of a curve that is known by its corners: only segments beside the farthest one can reach farther than `most`. */
function apexOfCurve({ edges }: Shape, { first, end }: Run, { of }: Distance, most: number): number {
  const points: Vec2[] = [];
  for (let e = first; e < end; ++e) points.push([edges[4 * e]!, edges[4 * e + 1]!]);
  points.push([edges[4 * end - 2]!, edges[4 * end - 1]!]);
  const d = points.map(of),
    farthest = d.indexOf(Math.max(...d));
  if (d[farthest]! < most - draftChord) return -Infinity;
  const along = [0];
  for (let i = 1; i < points.length; ++i)
    along.push(along[i - 1]! + Math.hypot(points[i]![0] - points[i - 1]![0], points[i]![1] - points[i - 1]![1]));
  let apex = d[farthest]!;
  for (const at of [farthest - 1, farthest]) {
    if (at < 0 || at + 1 >= points.length) continue;
    const from = Math.max(0, at + 1 - neighbours),
      to = Math.min(points.length, at + 1 + neighbours);
    const beyond = highest(along.slice(from, to), d.slice(from, to), along[at]!, along[at + 1]!);
    if (beyond - d[farthest]! <= draftChord) apex = Math.max(apex, beyond); // else the corners are corners
  }
  return apex;
}

/** The highest value, between two places, of the polynomial that has the values `v` at `s`. */
function highest(s: number[], v: number[], from: number, to: number): number {
  const value = (x: number) =>
    v.reduce((sum, vi, i) => sum + s.reduce((p, sj, j) => (j === i ? p : (p * (x - sj)) / (s[i]! - sj)), vi), 0);
  let [a, b] = [from, to];
  for (let step = 0; step < 40; ++step) {
    const third = (b - a) / 3;
    if (value(a + third) < value(b - third)) a += third;
    else b -= third;
  }
  return value((a + b) / 2);
}
