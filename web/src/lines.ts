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

/** In the flat pattern, mm. */
export function lengthOfEdge({ edges: e, edge_number }: Shape, number: number): number {
  return edge_number.reduce(
    (sum, n, i) => (n === number ? sum + Math.hypot(e[4 * i + 2]! - e[4 * i]!, e[4 * i + 3]! - e[4 * i + 1]!) : sum),
    0,
  );
}

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
