import type { Measured } from '../src/measure/things.ts';
import { decodeShape, encodeShape } from '../src/shape.ts';
import type { Facets, Report, ShapeHeader } from '../src/types.ts';

/**
 * Two flanges, 40 and 30 mm deep and 60 wide, joined by a bend of 90° whose developed length is 8 mm, in `n` facets.
 * The first flange stays in the plane z = 0; the second stands up in +z.
 */
export function twoFlanges(
  n = 8,
  angle = Math.PI / 2,
  developed = 8,
  thickness = 2,
): { header: Omit<ShapeHeader, 'arrays'>; arrays: Partial<Facets> } {
  const xs = [0, 40, ...Array.from({ length: n }, (_, i) => 40 + (developed * (i + 1)) / n), 70 + developed];
  const points: number[] = [],
    rings = [0],
    polygons = [0],
    facets = [0],
    parent: number[] = [],
    hinge: number[] = [],
    turn: number[] = [],
    part: number[] = [];
  const edges: number[] = [],
    edgeFacet: number[] = [],
    edgeNumber: number[] = [];
  for (let i = 0; i + 1 < xs.length; ++i) {
    const a = xs[i]!,
      b = xs[i + 1]!;
    points.push(a, 0, b, 0, b, 60, a, 60);
    rings.push(4 * (i + 1));
    polygons.push(i + 1);
    facets.push(i + 1);
    parent.push(i - 1);
    hinge.push(a, 60, a, 0); // about −y: what lies at +x goes up
    turn.push(i === 0 ? 0 : i === 1 || i === n + 1 ? angle / n / 2 : angle / n);
    part.push(i === 0 ? 0 : i === n + 1 ? 2 : 1);
    edges.push(a, 0, b, 0, b, 60, a, 60);
    edgeFacet.push(i, i);
    const first = i === 0 ? 0 : i === n + 1 ? 4 : 2; // of a bend all pieces are one edge
    edgeNumber.push(first, first + 1);
  }
  const last = xs.at(-1)!;
  edges.push(0, 60, 0, 0, last, 0, last, 60);
  edgeFacet.push(0, n + 1);
  edgeNumber.push(6, 7);
  const middle = 40 + developed / 2;
  const report = {
    command: 'connect',
    units: 'mm',
    status: 'warning',
    reason: null,
    sheet: {
      thickness,
      k_factor: 0.44,
      k_source: 'default',
      flanges: 2,
      bends: 1,
      volume: 60 * last * thickness,
      mass: null,
    },
    flat: {
      area: 60 * last,
      perimeter: 2 * (60 + last),
      size: [last, 60],
      openings: 0,
      cutting: { outer: 2 * (60 + last), inner: 0 },
      bends: [
        {
          id: 'B1',
          kind: 'cylinder',
          angle: (angle * 180) / Math.PI,
          inside_radius: 4.2,
          k_factor: 0.44,
          allowance: developed,
          deduction: 4.4,
          direction: angle > 0 ? 'up' : 'down',
          length: 60,
          line: [
            [middle, 0],
            [middle, 60],
          ],
          between: ['A', 'B'],
          edges: { A: [1], B: [3] },
          surface: 'cylinder',
          lateral: 'straight',
          width: 60,
          span: developed,
          alternatives: [],
        },
      ],
    },
    verification: { volume_ratio: 1 + 3e-9, length_error: 1e-12, refold_deviation: 2e-12, closure: 0 },
    checks: [
      {
        code: 'flange_height',
        severity: 'warning',
        message: 'a flange that is shown here for a trial',
        at: [[60, 30]],
      },
    ],
  } as unknown as Report;
  return {
    header: {
      report,
      parts: [
        { name: 'F1', kind: 'flange', faces: [1] },
        { name: 'B1', kind: 'bend', angle: 90, faces: [] },
        { name: 'F2', kind: 'flange', faces: [2] },
      ],
      root: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
      handles: {},
      seconds: 0.001,
    },
    arrays: {
      points: Float32Array.from(points),
      ring_starts: Uint32Array.from(rings),
      polygon_starts: Uint32Array.from(polygons),
      facet_starts: Uint32Array.from(facets),
      facet_parent: Int32Array.from(parent),
      facet_hinge: Float32Array.from(hinge),
      facet_angle: Float32Array.from(turn),
      facet_part: Uint32Array.from(part),
      edges: Float32Array.from(edges),
      edge_facet: Uint32Array.from(edgeFacet),
      edge_number: Uint32Array.from(edgeNumber),
      edge_length: Float32Array.from([40, 60, developed, developed, 30, 30, 60, 60]),
      bend_lines: Float32Array.from([middle, 0, middle, 60]),
      bend_line_part: Uint32Array.from([1]),
    },
  };
}

export const twoFlangesShape = (n?: number, angle?: number) => {
  const { header, arrays } = twoFlanges(n, angle);
  return encodeShape(header, arrays);
};

/** Two flanges whose second one stands where it truly does: R 4.2, t 2, so 40 + 5.2 along, and 5.2 up. */
export function measured(): Measured {
  const shape = decodeShape(twoFlangesShape());
  shape.parts[0]!.place = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  shape.parts[2]!.place = [0, 0, -1, 45.2, 0, 1, 0, 0, 1, 0, 0, 5.2 - 48, 0, 0, 0, 1];
  shape.edge_circle = new Float32Array(4 * shape.edge_length.length);
  return { shape, thickness: 2, bends: shape.report.flat!.bends, units: 'mm' };
}
