import assert from 'node:assert/strict';
import { test } from 'node:test';
import { flangeLengths } from '../src/flange-lengths.ts';
import { decodeShape, encodeShape } from '../src/shape.ts';
import type { BendRow, Shape, Vec2 } from '../src/types.ts';
import { twoFlanges } from './two-flanges.ts';

const near = (a: number, b: number, within = 1e-9) => assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);

/** The lengths alone. */
function outside(shape: Shape, bend: string): number[] | string | undefined {
  const lengths = flangeLengths(shape).get(bend);
  return Array.isArray(lengths) ? lengths.map(({ length }) => length) : lengths;
}

const decoded = (change: (bend: BendRow) => void = () => undefined): Shape => {
  const { header, arrays } = twoFlanges();
  change(header.report.flat!.bends[0]!);
  return decodeShape(encodeShape(header, arrays));
};

test('outside lengths, less the deduction, are the length of the blank', () => {
  const shape = decoded((bend) => (bend.deduction = 4.4)),
    [first, second] = outside(shape, 'B1') as number[] as Vec2;
  // 40 and 30 beside a bend of 8: the setback is half of 8 + 4.4
  near(first, 40 + 6.2, 1e-5);
  near(second, 30 + 6.2, 1e-5);
  near(first + second - 4.4, shape.report.flat!.size[0]!, 1e-5);
  const why = (change: (bend: BendRow) => unknown) => outside(decoded(change), 'B1');
  assert.match(why((bend) => (bend.deduction = null)) as string, /has no deduction/);
  assert.match(why((bend) => (bend.kind = 'cone')) as string, /radius of this bend changes/);
});

interface Facet {
  name: string; // of its part
  ring: Vec2[];
  parent: number;
  hinge?: [Vec2, Vec2];
}
interface Border {
  facet: number;
  points: Vec2[];
  circle?: [number, number, number, number];
}

/** A sheet of facets, whose bends have an allowance of 4 and the deductions that are given. */
function sheet(facets: Facet[], deductions: Record<string, number | null>, borders: Border[] = []): Shape {
  const { header } = twoFlanges(),
    names = [...new Set(facets.map((f) => f.name))].sort((a, b) => b.localeCompare(a)); // flanges first
  const starts = facets.reduce((all, { ring }) => [...all, all.at(-1)! + ring.length], [0]),
    count = Uint32Array.from([...facets.keys(), facets.length]),
    segments = borders.flatMap(({ points, facet }, border) =>
      points.slice(1).map((b, i) => ({ line: [points[i]!, b].flat(), facet, border })),
    );
  const bends = Object.entries(deductions).map(([id, deduction]) => ({
    ...header.report.flat!.bends[0]!,
    id,
    allowance: 4,
    deduction,
  }));
  return decodeShape(
    encodeShape(
      {
        ...header,
        parts: names.map((name) => ({ name, kind: name.startsWith('F') ? 'flange' : 'bend', faces: [] })),
        report: { ...header.report, flat: { ...header.report.flat!, bends } },
      },
      {
        points: Float32Array.from(facets.flatMap(({ ring }) => ring.flat())),
        ring_starts: Uint32Array.from(starts),
        polygon_starts: count,
        facet_starts: count,
        facet_parent: Int32Array.from(facets.map(({ parent }) => parent)),
        facet_hinge: Float32Array.from(facets.flatMap(({ hinge }) => hinge?.flat() ?? [0, 0, 0, 0])),
        facet_part: Uint32Array.from(facets.map(({ name }) => names.indexOf(name))),
        edges: Float32Array.from(segments.flatMap(({ line }) => line)),
        edge_facet: Uint32Array.from(segments.map(({ facet }) => facet)),
        edge_number: Uint32Array.from(segments.map(({ border }) => border)),
        edge_length: new Float32Array(borders.length),
        edge_circle: Float32Array.from(borders.flatMap(({ circle }) => circle ?? [0, 0, 0, 0])),
      },
    ),
  );
}

const box = (x0: number, x1: number, y0 = 0, y1 = 100): Vec2[] => [
  [x0, y0],
  [x1, y0],
  [x1, y1],
  [x0, y1],
];
const across = (x: number, y0 = 0, y1 = 100): [Vec2, Vec2] => [
  [x, y0],
  [x, y1],
];

/** A channel: 20, bend of 4, web of 50, bend of 4, 30; all 100 wide. The web is the root. */
const channel = (): Facet[] => [
  { name: 'F2', ring: box(24, 74), parent: -1 },
  { name: 'B1', ring: box(20, 24), parent: 0, hinge: across(24) },
  { name: 'F1', ring: box(0, 20), parent: 1, hinge: across(20) },
  { name: 'B2', ring: box(74, 78), parent: 0, hinge: across(74) },
  { name: 'F3', ring: box(78, 108), parent: 3, hinge: across(78) },
];

test('a flange that ends in another bend goes on to its mould line', () => {
  const shape = sheet(channel(), { B1: 3, B2: 5 });
  const of = (bend: string) =>
    Object.fromEntries(
      (flangeLengths(shape).get(bend) as { flange: number; length: number }[]).map(({ flange, length }) => [
        shape.parts[flange]!.name,
        length,
      ]),
    );
  assert.deepEqual(of('B1'), { F1: 23.5, F2: 58 });
  assert.deepEqual(of('B2'), { F2: 58, F3: 34.5 });
  near(23.5 + 58 + 34.5 - 3 - 5, 108); // outside, less both deductions: the blank
  const unknown = sheet(channel(), { B1: 3, B2: null });
  assert.equal(outside(unknown, 'B1'), 'B2, in which a flange ends, has no mould line.');
  const cut = sheet(channel().slice(0, 4), { B1: 3, B2: 5 });
  assert.match(outside(cut, 'B2') as string, /no flange on one of its sides/);
});

test('a flange between two bends has one length, whichever its edges stick out beyond', () => {
  // The web sticks out by 0.02 beyond the bend line of B2, beside the bend, which is 80 wide.
  const facets = channel();
  facets[0]!.ring = [...box(24, 74).slice(0, 2), [74, 80], [74.02, 80], [74.02, 100], [24, 100]];
  for (const i of [3, 4]) facets[i]!.ring = facets[i]!.ring.map(([x, y]) => [x, Math.min(y, 80)]);
  facets[3]!.hinge = across(74, 0, 80);
  facets[4]!.hinge = across(78, 0, 80);
  near((outside(sheet(facets, { B1: 3, B2: 5 }), 'B1') as number[])[0]!, 50 + 3.5 + 4.5, 1e-5);
  near((outside(sheet(facets, { B1: 3, B2: 5 }), 'B2') as number[])[0]!, 50 + 3.5 + 4.5, 1e-5);
  // A tab that goes farther than the mould line is what the rule meets.
  facets[0]!.ring = facets[0]!.ring.map(([x, y]) => [x === 74.02 ? 80 : x, y]);
  near((outside(sheet(facets, { B1: 3, B2: 5 }), 'B1') as number[])[0]!, 80 - 24 + 3.5, 1e-5);
});

test('bends on the near side, or into a window, do not make a flange longer', () => {
  const lengths = (...more: Facet[]) =>
    (outside(sheet([...channel(), ...more], { B1: 3, B2: 5, B3: 60 }), 'B1') as number[])[0]!;
  // In a window of the web; its mould line lies 32 from its border.
  near(lengths({ name: 'B3', ring: box(50, 54, 40, 60), parent: 0, hinge: across(50, 40, 60) }), 58, 1e-5);
  near(lengths({ name: 'B3', ring: box(66, 70, 40, 60), parent: 0, hinge: across(70, 40, 60) }), 58, 1e-5);
  // Beside B1, in its line, to the same side.
  near(lengths({ name: 'B3', ring: box(20, 24, 0, 10), parent: 0, hinge: across(24, 0, 10) }), 58, 1e-5);
  // Beside B2, in its line, with a mould line farther out: 74 + 32 - 24.
  near(lengths({ name: 'B3', ring: box(74, 78, 80, 100), parent: 0, hinge: across(74, 80, 100) }), 82 + 3.5, 1e-5);
});

/** A flange of 40 to the bend at x = 0, and beyond it one that ends in a curve from (30, -10) to (30, 10). */
const tongue = (points: Vec2[], circle?: Border['circle']): Shape =>
  sheet(
    [
      { name: 'F1', ring: box(-44, -4), parent: -1 },
      { name: 'B1', ring: box(-4, 0), parent: 0, hinge: across(-4) },
      { name: 'F2', ring: [[0, 100], [0, -100], ...points], parent: 1, hinge: across(0) },
    ],
    { B1: 4 },
    [{ facet: 2, points, circle }],
  );

test('a flange that ends in an arc reaches to its apex, not to a corner of its polygon', () => {
  // Even counts of corners leave out the apex.
  for (const corners of [2, 4, 6, 12])
    for (const tilt of [0, 0.3]) {
      const [middle, radius, sweep] = [20, 13, 2];
      const points = Array.from({ length: corners }, (_, i): Vec2 => {
        const angle = tilt + sweep * (i / (corners - 1) - 0.5);
        return [middle + radius * Math.cos(angle), radius * Math.sin(angle)];
      });
      for (const back of [false, true]) {
        const shape = tongue(back ? [...points].reverse() : points, [middle, 0, radius, back ? -sweep : sweep]);
        near((outside(shape, 'B1') as number[])[1]!, 33 + 4, 1e-5);
      }
    }
});

test('an arc that does not get to its apex counts to its end', () => {
  const points = [0.2, 0.4, 0.6].map((angle): Vec2 => [20 + 13 * Math.cos(angle), 13 * Math.sin(angle)]);
  near((outside(tongue(points, [20, 0, 13, 0.4]), 'B1') as number[])[1]!, 20 + 13 * Math.cos(0.2) + 4, 1e-5);
  // The far side of a hole is not the end of the flange, nor is the apex of a notch.
  const hollow = [-1, -0.5, 0, 0.5, 1].map((a): Vec2 => [40 - 13 * Math.cos(a), 13 * Math.sin(a)]);
  near((outside(tongue(hollow, [40, 0, 13, -2]), 'B1') as number[])[1]!, 40 - 13 * Math.cos(1) + 4, 1e-5);
});

test('a flange that ends in an ellipse reaches to it within 0.005 mm', () => {
  // Corners lie on the ellipse, and leave it by at most 0.05.
  let worst = 0;
  for (const [a, b] of [
    [12, 8],
    [30, 10],
    [8, 12],
    [100, 20],
  ] as const)
    for (const tilt of [0, 0.2, 0.5, 1])
      for (const begin of [0, 0.3, 0.7]) {
        const step = Math.sqrt((8 * 0.05) / Math.max(a, b)),
          count = Math.ceil(Math.PI / step);
        const points = Array.from({ length: count }, (_, i): Vec2 => {
          const t = -Math.PI / 2 + step * (i + begin);
          return [
            20 + a * Math.cos(tilt) * Math.cos(t) - b * Math.sin(tilt) * Math.sin(t),
            a * Math.sin(tilt) * Math.cos(t) + b * Math.cos(tilt) * Math.sin(t),
          ];
        });
        const apex = 20 + Math.hypot(a * Math.cos(tilt), b * Math.sin(tilt));
        worst = Math.max(worst, apex - Math.max(...points.map(([x]) => x)));
        near((outside(tongue(points), 'B1') as number[])[1]!, apex + 4, 0.005);
      }
  assert.ok(worst > 0.02, 'the farthest corner is not enough');
});

test('corners of a curve stay corners', () => {
  // A zigzag, as files write it as one curve.
  const points = [0, 1, 2, 3, 4, 5, 6].map((i): Vec2 => [30 + (i % 2) * 6, 10 - 4 * i]);
  near((outside(tongue(points), 'B1') as number[])[1]!, 36 + 4, 1e-5);
});
