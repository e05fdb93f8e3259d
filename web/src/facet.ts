import type { Shape } from './types.ts';

/** Whether a point of the flat pattern lies on facet `f`: in a polygon, and in no hole of it. */
export function insideFacet(shape: Shape, f: number, x: number, y: number): boolean {
  let inside = false;
  const p = shape.points;
  for (let q = shape.facet_starts[f]!; q < shape.facet_starts[f + 1]!; ++q)
    for (let r = shape.polygon_starts[q]!; r < shape.polygon_starts[q + 1]!; ++r) {
      const first = shape.ring_starts[r]!,
        end = shape.ring_starts[r + 1]!;
      for (let i = first, j = end - 1; i < end; j = i++) {
        const yi = p[2 * i + 1]!,
          yj = p[2 * j + 1]!;
        if (yi > y !== yj > y && x < ((p[2 * j]! - p[2 * i]!) * (y - yi)) / (yj - yi) + p[2 * i]!) inside = !inside;
      }
    }
  return inside;
}
