import type { Shape } from './types.ts';

/**
 * A line of a shape that can be picked: an edge of the outline by its number, or a bend by its row of `parts`.
 */
export type PickedLine = { edge: number } | { part: number };

/** Row of `parts` that edge `number` belongs to; null if there is no such edge. */
export function partOfEdge(shape: Shape, number: number): number | null {
  const at = shape.edge_number.indexOf(number);
  return at < 0 ? null : shape.facet_part[shape.edge_facet[at]!]!;
}

/** The formed feature that an edge outlines, as the report numbers them; null where it is cut. */
export function featureOfEdge({ edge_feature }: Shape, number: number): number | null {
  const feature = edge_feature[number] ?? -1;
  return feature < 0 ? null : feature;
}

/** The circle that an edge lies on, in the flat pattern, mm; null if it is no arc. */
export interface EdgeCircle {
  radius: number;
  whole: boolean; // it goes all round
  edges: Set<number>; // those that go round together, or the edge alone
  length: number; // of these
}

const alike = 1e-5; // of the radius: arrays hold seven digits

export function circleOfEdge(shape: Shape, number: number): EdgeCircle | null {
  const { edge_circle: c, edge_length } = shape,
    feature = featureOfEdge(shape, number);
  const [x, y, radius, sweep] = c.subarray(4 * number, 4 * number + 4) as unknown as [number, number, number, number];
  if (!(radius > 0)) return null;
  const near = alike * (radius + Math.abs(x) + Math.abs(y));
  const all: number[] = [];
  for (let n = 0; 4 * n < c.length; ++n)
    if (
      Math.abs(c[4 * n + 2]! - radius) <= near &&
      Math.hypot(c[4 * n]! - x, c[4 * n + 1]! - y) <= near &&
      c[4 * n + 3]! > 0 === sweep > 0 &&
      featureOfEdge(shape, n) === feature
    )
      all.push(n);
  const turned = Math.abs(all.reduce((sum, n) => sum + c[4 * n + 3]!, 0)),
    whole = Math.abs(turned - 2 * Math.PI) < 1e-4,
    edges = new Set(whole ? all : [number]);
  return { radius, whole, edges, length: [...edges].reduce((sum, n) => sum + edge_length[n]!, 0) };
}

/** The numbers of the edges that are marked with edge `number`: the whole circle, if it is part of one. */
export const markedWith = (shape: Shape, number: number | null): Set<number> =>
  number === null ? new Set() : (circleOfEdge(shape, number)?.edges ?? new Set([number]));

/** Rows of the parts that part `row` is joined to. */
export function partsBeside({ facet_parent, facet_part }: Shape, row: number): Set<number> {
  const out = new Set<number>();
  facet_parent.forEach((parent, f) => {
    if (parent < 0) return;
    const a = facet_part[f]!,
      b = facet_part[parent]!;
    if (a === row) out.add(b);
    if (b === row) out.add(a);
  });
  out.delete(row);
  return out;
}

/** Distance of (x, y) from the segment a–b, and where along it the nearest point is, 0 to 1. */
export function distanceToSegment(
  x: number,
  y: number,
  ax: number,
  ay: number,
  bx: number,
  by: number,
): { distance: number; along: number } {
  const dx = bx - ax,
    dy = by - ay,
    l = dx * dx + dy * dy;
  const along = l === 0 ? 0 : Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / l));
  return { distance: Math.hypot(x - ax - along * dx, y - ay - along * dy), along };
}
