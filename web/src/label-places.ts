import { insideFacet } from './facet.ts';
import { distanceToSegment } from './lines.ts';
import type { Shape, Vec2 } from './types.ts';

/** Where the name of a flange stands, and how far material reaches about it. */
export interface Place {
  at: Vec2;
  room: number;
}

const grid = 14;

/** For each flange a place in its largest facet that is far from every edge, including those of openings. */
export function labelPlaces(shape: Shape): Map<number, Place> {
  const out = new Map<number, Place>();
  if (shape.facet_part.length > 1500) return out;
  for (let f = 0; f < shape.facet_part.length; ++f) {
    const part = shape.facet_part[f]!;
    if (shape.parts[part]?.kind !== 'flange') continue;
    const place = placeIn(shape, f, out.get(part)?.room ?? 0);
    if (place) out.set(part, place);
  }
  return out;
}

function placeIn(shape: Shape, f: number, least: number): Place | null {
  const segments = segmentsOf(shape, f);
  let [x0, x1, y0, y1] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const [ax, ay] of segments) {
    x0 = Math.min(x0, ax);
    x1 = Math.max(x1, ax);
    y0 = Math.min(y0, ay);
    y1 = Math.max(y1, ay);
  }
  if (Math.min(x1 - x0, y1 - y0) / 2 <= least) return null;
  let best: Place | null = null;
  // The middle is tried first; another place must be clearly better to replace it.
  const middle: Vec2 = [(x0 + x1) / 2, (y0 + y1) / 2];
  const consider = (at: Vec2, gain: number) => {
    const wanted = Math.max(least, (best?.room ?? 0) * gain),
      room = roomAt(segments, at, wanted);
    if (room > wanted && insideFacet(shape, f, at[0], at[1])) best = { at, room };
  };
  consider(middle, 1);
  for (let i = 0; i < grid; ++i)
    for (let j = 0; j < grid; ++j)
      consider([x0 + ((i + 0.5) / grid) * (x1 - x0), y0 + ((j + 0.5) / grid) * (y1 - y0)], 1.25);
  return best;
}

/** The distance from the nearest segment; one that is not above `wanted` is no longer looked for. */
function roomAt(segments: Segment[], [x, y]: Vec2, wanted: number): number {
  let room = Infinity;
  for (const [ax, ay, bx, by] of segments) {
    room = Math.min(room, distanceToSegment(x, y, ax, ay, bx, by).distance);
    if (room <= wanted) break;
  }
  return room;
}

type Segment = [number, number, number, number];

function segmentsOf(shape: Shape, f: number): Segment[] {
  const out: Segment[] = [],
    p = shape.points;
  for (let q = shape.facet_starts[f]!; q < shape.facet_starts[f + 1]!; ++q)
    for (let r = shape.polygon_starts[q]!; r < shape.polygon_starts[q + 1]!; ++r) {
      const first = shape.ring_starts[r]!,
        end = shape.ring_starts[r + 1]!;
      for (let i = first, j = end - 1; i < end; j = i++) out.push([p[2 * i]!, p[2 * i + 1]!, p[2 * j]!, p[2 * j + 1]!]);
    }
  return out;
}
