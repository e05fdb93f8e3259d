import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bezierPoints, fitted, lengthOf, lowered, raised, removePoint } from '../src/edits/slit.ts';
import {
  addStrip,
  endAsItIs,
  ownWidths,
  removeStrip,
  setEnd,
  setStrip,
  setStripCount,
  setStripWidth,
  sheetWidth,
  uniform,
} from '../src/edits/strips.ts';
import type { SlitSpec } from '../src/edits/slit-types.ts';
import type { Vec2, Vec3 } from '../src/types.ts';

const straight: Vec2[] = [
  [360, 0],
  [360, 120],
  [360, 240],
  [360, 360],
];
const curved: Vec2[] = [
  [330, 0],
  [300, 120],
  [310, 240],
  [640, 360],
];
const chair = (): SlitSpec => ({
  thickness: 4,
  sheet: { strips: 6, strip_width: 60, panel_height: 420, half_length: 464 },
  leg_curve: { bezier: straight },
  seat_curve: { bezier: curved },
  anchors: [
    { strip: 2, ridge: 5, at: [1, 2, 3] },
    { strip: 5, ridge: 1, at: [1, 2, 3] },
  ],
});
const plume = (): SlitSpec => ({
  thickness: 10,
  symmetric: false,
  leg_curve: {
    bezier: [
      [0, 0],
      [0, 740],
    ],
  },
  sheet: {
    panel_height: 900,
    half_length: 3000,
    margin: 60,
    strips: [{ width: 160, gap: 60, end: 2500 }, { width: 220, gap: 10 }, { width: 230 }],
  },
  ends: [
    { strip: 0, position: [1, 2, 3] },
    { strip: 2, position: [7, 8, 9] },
  ],
});
const near = (a: number, b: number, tolerance: number) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);

test('strips become uniform and their own again on a sheet that keeps its width', () => {
  for (const spec of [chair(), plume()]) {
    const width = sheetWidth(spec);
    near(sheetWidth(uniform(spec)), width, 1e-5);
    near(sheetWidth(ownWidths(uniform(spec))), width, 1e-5);
    assert.deepEqual(uniform(spec).leg_curve, spec.leg_curve);
  }
  assert.deepEqual(uniform(ownWidths(chair())), chair());
  assert.equal(uniform(plume()).sheet.strip_width, 226.666667);
});

test('the leg curve grows with the sheet, from its first point', () => {
  const wider = setStripWidth(chair(), 90);
  assert.deepEqual(wider.leg_curve.bezier, [
    [360, 0],
    [360, 180],
    [360, 360],
    [360, 540],
  ]);
  near(lengthOf(setStrip(plume(), 1, { width: 294 }).leg_curve.bezier), 740 * (814 / 740), 1e-3);
  assert.deepEqual(setStrip(plume(), 0, { end: 2600 }).leg_curve, plume().leg_curve);
});

test('a key of a strip that is left to the program is not written', () => {
  assert.deepEqual(setStrip(plume(), 0, { end: undefined, gap: undefined }).sheet.strips, [
    { width: 160 },
    { width: 220, gap: 10 },
    { width: 230 },
  ]);
});

test('what names strips follows them when some come or go', () => {
  assert.deepEqual(removeStrip(plume(), 1).ends, [
    { strip: 0, position: [1, 2, 3] },
    { strip: 1, position: [7, 8, 9] },
  ]);
  assert.deepEqual(removeStrip(plume(), 2).ends, [{ strip: 0, position: [1, 2, 3] }]);
  assert.deepEqual(
    addStrip(plume(), 0).ends!.map((e) => e.strip),
    [0, 3],
  );
  assert.deepEqual(addStrip(plume(), 0).sheet.strips, [
    { width: 160, gap: 60, end: 2500 },
    { width: 160, gap: 60, end: 2500 },
    { width: 220, gap: 10 },
    { width: 230 },
  ]);
  assert.deepEqual(setStripCount(chair(), 3).anchors, [{ strip: 2, ridge: 5, at: [1, 2, 3] }]);
  assert.equal('anchors' in setStripCount(chair(), 2), false);
  const one = removeStrip(removeStrip(plume(), 0), 0);
  assert.equal(removeStrip(one, 0), one, 'one remains');
});

test('ends are placed and freed strip by strip', () => {
  const placed = setEnd(plume(), 1, { position: [4, 5, 6], direction: [1, 0, 0] });
  assert.deepEqual(
    placed.ends!.map((e) => e.strip),
    [0, 1, 2],
  );
  assert.deepEqual(setEnd(placed, 1, { position: undefined }).ends![1], { strip: 1, direction: [1, 0, 0] });
  assert.deepEqual(setEnd(setEnd(placed, 1, { position: undefined }), 1, { direction: undefined }), plume());
  assert.equal('ends' in setEnd(setEnd(plume(), 0, { position: undefined }), 2, { position: undefined }), false);
});

test('an end that is switched on is where the strip ends now', () => {
  const ridges: [Vec3, Vec3][] = [
    [
      [0, 0, 0],
      [0, 100, 0],
    ],
    [
      [300, 0, 400],
      [300, 100, 400],
    ],
  ];
  assert.deepEqual(endAsItIs({ ...plume(), units: 'm' }, ridges, 1000), {
    position: [0.3, 0.05, 0.4],
    direction: [0.6, 0, 0.8],
    across: [0, 1, 0],
  });
  assert.equal(endAsItIs(plume(), [], 1), null);
});

test('a control point more is the same curve, one less keeps its ends', () => {
  bezierPoints(raised(curved), 20).forEach((p, i) =>
    p.forEach((v, k) => near(v, bezierPoints(curved, 20)[i]![k]!, 1e-5)),
  );
  assert.deepEqual(lowered(curved, 1), [curved[0], curved[2], curved[3]]);
  assert.equal(lowered(curved, 0), curved);
  assert.equal(lowered(curved, 3), curved);
  assert.deepEqual(removePoint(chair(), 'seat', 2).seat_curve!.bezier, [curved[0], curved[1], curved[3]]);
  const bowed = { ...chair(), leg_curve: { bezier: fitted(curved, 360) } };
  near(lengthOf(removePoint(bowed, 'leg', 1).leg_curve.bezier), 360, 1e-3);
});
