import type { Shape } from './types.ts';

/** From flat to the most sharply bent: the same in both themes, and told apart by who sees few colours. */
export const bendingColours = ['#3f6fb0', '#67b3a8', '#f0e28a', '#e58a3c', '#b8302a'] as const;

const muchWider = 3; // a flange beside a piece of a bend

/**
 * How sharply each facet is bent, 1/mm: what it is turned by at its hinges, over the width that they stand for, from
 * the middle of one facet to that of the next; beside a flange half a facet.
 */
export function curvatures(shape: Shape): Float32Array {
  const { facet_parent, facet_angle, facet_hinge: h } = shape,
    areas = areasOf(shape),
    sum = new Float32Array(facet_parent.length),
    hinges = new Uint16Array(facet_parent.length);
  facet_parent.forEach((parent, f) => {
    const length = Math.hypot(h[4 * f + 2]! - h[4 * f]!, h[4 * f + 3]! - h[4 * f + 1]!);
    if (parent < 0 || !length) return;
    const widths = [f, parent].map((facet) => areas[facet]! / length),
      [narrow, wide] = [Math.min(...widths), Math.max(...widths)],
      bent = Math.abs(facet_angle[f]!) / (wide > muchWider * narrow ? narrow / 2 : (narrow + wide) / 2);
    [f, parent].forEach((facet, i) => {
      if (widths[i]! > muchWider * narrow) return;
      sum[facet]! += bent;
      ++hinges[facet]!;
    });
  });
  return sum.map((s, f) => (hinges[f] ? s / hinges[f]! : 0));
}

/** Of the facets of bends; of other facets that of their whole part. */
function areasOf(shape: Shape): number[] {
  const { facet_starts, polygon_starts, ring_starts, points, facet_part, parts } = shape,
    own = Array.from(facet_part, (_, f) => {
      let twice = 0;
      for (let r = polygon_starts[facet_starts[f]!]!; r < polygon_starts[facet_starts[f + 1]!]!; ++r) {
        const [from, to] = [ring_starts[r]!, ring_starts[r + 1]!];
        for (let i = from; i < to; ++i) {
          const j = i + 1 < to ? i + 1 : from;
          twice += points[2 * i]! * points[2 * j + 1]! - points[2 * j]! * points[2 * i + 1]!;
        }
      }
      return Math.abs(twice) / 2;
    }),
    whole = new Map<number, number>();
  own.forEach((area, f) => whole.set(facet_part[f]!, (whole.get(facet_part[f]!) ?? 0) + area));
  return own.map((area, f) => (parts[facet_part[f]!]?.kind === 'bend' ? area : whole.get(facet_part[f]!)!));
}
