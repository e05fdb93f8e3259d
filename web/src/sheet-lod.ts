import type { Shape } from './types.ts';

/** Parts with fewer segments in their outline are always drawn whole. */
const many = 6000;

export const isLarge = (shape: Shape): boolean => shape.edge_number.length > many;

/**
 * The shape with its round edges drawn by fewer corners, none of which leaves its circle by more than `tolerance`, mm.
 * Corners between edges stay, so that everything still meets.
 */
export function simplified(shape: Shape, tolerance: number): Shape {
  const edges: number[] = [],
    facets: number[] = [],
    numbers: number[] = [],
    gone = new Set<string>();
  for (const run of runsOf(shape)) {
    const kept = keptOf(shape, run, tolerance);
    for (let i = 0; i + 1 < kept.length; ++i) {
      const [a, b] = [kept[i]!, kept[i + 1]!];
      edges.push(shape.edges[4 * a]!, shape.edges[4 * a + 1]!);
      edges.push(...(b < run.end ? [shape.edges[4 * b]!, shape.edges[4 * b + 1]!] : lastOf(shape, run)));
      facets.push(shape.edge_facet[run.first]!);
      numbers.push(shape.edge_number[run.first]!);
      for (let e = a + 1; e < b; ++e) gone.add(keyOf(run.facet, shape.edges[4 * e]!, shape.edges[4 * e + 1]!));
    }
  }
  return {
    ...shape,
    ...withoutPoints(shape, gone),
    edges: Float32Array.from(edges),
    edge_facet: Uint32Array.from(facets),
    edge_number: Uint32Array.from(numbers),
  };
}

/** Segments `first` to `end` − 1 of one edge on one facet, each beginning where the one before ends. */
export interface Run {
  first: number;
  end: number;
  facet: number;
}

export function* runsOf({ edges, edge_facet, edge_number }: Shape): Generator<Run> {
  const count = edge_number.length;
  for (let first = 0; first < count; ) {
    let end = first + 1;
    while (
      end < count &&
      edge_number[end] === edge_number[first] &&
      edge_facet[end] === edge_facet[first] &&
      edges[4 * end] === edges[4 * end - 2] &&
      edges[4 * end + 1] === edges[4 * end - 1]
    )
      ++end;
    yield { first, end, facet: edge_facet[first]! };
    first = end;
  }
}

/** The segments of a run at whose beginnings corners stay, and its end. */
function keptOf({ edge_circle, edge_number }: Shape, { first, end }: Run, tolerance: number): number[] {
  const radius = edge_circle[4 * edge_number[first]! + 2]!,
    sweep = Math.abs(edge_circle[4 * edge_number[first]! + 3]!),
    count = end - first;
  const step = 2 * Math.acos(Math.max(-1, 1 - tolerance / radius)),
    wanted = radius > 0 ? Math.max(Math.ceil(sweep / step), Math.ceil((2 * sweep) / Math.PI), 1) : count;
  if (!(wanted < count)) return Array.from({ length: count + 1 }, (_, i) => first + i);
  return Array.from({ length: wanted + 1 }, (_, i) => first + Math.round((i * count) / wanted));
}

const lastOf = ({ edges }: Shape, { end }: Run) => [edges[4 * end - 2]!, edges[4 * end - 1]!];

const keyOf = (facet: number, x: number, y: number) => `${facet} ${x} ${y}`;

/** The polygons without some of their points, which are named by facet and place. */
function withoutPoints(shape: Shape, gone: Set<string>): Pick<Shape, 'points' | 'ring_starts'> {
  const { points, ring_starts, polygon_starts, facet_starts } = shape,
    out: number[] = [],
    starts = [0];
  for (let f = 0; f + 1 < facet_starts.length; ++f)
    for (let p = facet_starts[f]!; p < facet_starts[f + 1]!; ++p)
      for (let r = polygon_starts[p]!; r < polygon_starts[p + 1]!; ++r) {
        for (let i = ring_starts[r]!; i < ring_starts[r + 1]!; ++i)
          if (!gone.has(keyOf(f, points[2 * i]!, points[2 * i + 1]!))) out.push(points[2 * i]!, points[2 * i + 1]!);
        starts.push(out.length / 2);
      }
  return { points: Float32Array.from(out), ring_starts: Uint32Array.from(starts) };
}
