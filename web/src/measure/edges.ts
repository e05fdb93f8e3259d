import { circleOfEdge } from '../lines.ts';
import type { Shape, Vec2 } from '../types.ts';

/** What is known exactly of an edge of the outline, in the flat pattern. */
export interface EdgeForm {
  ends: [Vec2, Vec2] | null; // null: it closes on itself
  straight: boolean;
  circle: { centre: Vec2; radius: number; whole: boolean } | null; // whole: alone or with others it goes all round
  part: number; // row of parts
}

const known = new WeakMap<Shape, EdgeForm[]>();
const alike = 1e-6; // of the coordinates: arrays hold seven digits

/** By number; made once for a shape. */
export function edgeForms(shape: Shape): EdgeForm[] {
  const forms = known.get(shape) ?? segmentsByEdge(shape).map((own, edge) => formOf(shape, edge, own));
  known.set(shape, forms);
  return forms;
}

function segmentsByEdge({ edge_length, edge_number }: Shape): number[][] {
  const out: number[][] = Array.from(edge_length, () => []);
  edge_number.forEach((edge, segment) => out[edge]?.push(segment));
  return out;
}

function formOf(shape: Shape, edge: number, segments: number[]): EdgeForm {
  const { edges, edge_circle: c, edge_facet, facet_part } = shape,
    ends = endsOf(edges, segments),
    radius = c[4 * edge + 2] ?? 0;
  return {
    ends,
    straight: radius === 0 && ends !== null && segments.every((s) => liesOn(edges, s, ends)),
    circle:
      radius > 0
        ? {
            centre: [c[4 * edge]!, c[4 * edge + 1]!],
            radius,
            whole: !ends || (circleOfEdge(shape, edge)?.whole ?? false),
          }
        : null,
    part: facet_part[edge_facet[segments[0]!]!] ?? -1,
  };
}

/** Corners that one segment alone has. */
function endsOf(edges: Float32Array, segments: number[]): [Vec2, Vec2] | null {
  const seen = new Map<string, Vec2>();
  for (const s of segments)
    for (const i of [4 * s, 4 * s + 2]) {
      const at: Vec2 = [edges[i]!, edges[i + 1]!],
        key = at.join();
      if (!seen.delete(key)) seen.set(key, at);
    }
  const [a, b] = [...seen.values()];
  return a && b && seen.size === 2 ? [a, b] : null;
}

function liesOn(edges: Float32Array, segment: number, [a, b]: [Vec2, Vec2]): boolean {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]],
    length = Math.hypot(dx, dy),
    off = alike * 4 * Math.max(length, ...a.map(Math.abs), ...b.map(Math.abs));
  return [4 * segment, 4 * segment + 2].every(
    (i) => Math.abs((edges[i]! - a[0]) * dy - (edges[i + 1]! - a[1]) * dx) <= off * length,
  );
}
