import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  addSecondPanel,
  legOf,
  ownSecondPanel,
  removeSecondPanel,
  scaledLegs,
  setLeg,
  setMould,
} from '../src/edits/panels.ts';
import { lengthOf, removePoint } from '../src/edits/slit.ts';
import { setStripWidth } from '../src/edits/strips.ts';
import type { SlitSpec } from '../src/edits/slit-types.ts';
import type { Vec2 } from '../src/types.ts';

const leg: Vec2[] = [
  [300, 0],
  [300, 200],
  [300, 400],
];
const sheet = (): SlitSpec => ({
  thickness: 4,
  symmetric: false,
  sheet: { strips: 4, strip_width: 100, panel_height: 500, half_length: 2000 },
  leg_curve: { bezier: leg },
});
const chair = (): SlitSpec => ({
  ...sheet(),
  symmetric: true,
  seat_curve: { bezier: leg },
  end_angle: 'level',
  anchors: [{ strip: 0, ridge: 9, at: [1, 2, 3] }],
  sheet: { strips: [{ width: 200, end: 2400 }, { width: 200 }], panel_height: 500, half_length: 2000 },
});
const near = (a: number, b: number, tolerance = 1e-6) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);

test('what is set on a leg curve goes again', () => {
  const leaning = setLeg(setLeg(sheet(), 'leg', { lean: 90 }), 'leg', { fit: true });
  assert.deepEqual(leaning.leg_curve, { bezier: leg, lean: 90, fit: true });
  assert.deepEqual(setLeg(leaning, 'leg', { lean: undefined, fit: undefined }), sheet());
  assert.deepEqual(setLeg(sheet(), 'second', { lean: 5 }), sheet(), 'there is no second panel');
});

test('a second panel stands behind the first, in reach of all strips', () => {
  const two = addSecondPanel({ ...sheet(), ends: [{ strip: 0, position: [1, 2, 3] }] });
  assert.equal(two.second_panel!.height, 500);
  assert.equal('ends' in two, false);
  // The first runs to greater z, so that its front faces greater x.
  two.second_panel!.leg_curve.bezier.forEach(([x, z], i) => {
    near(x, 300 - 0.7 * 2000);
    near(z, leg[i]![1]);
  });
  assert.deepEqual(removeSecondPanel(two), sheet());
});

test('strips that end early have the higher part of the second panel to reach', () => {
  const uneven = {
    ...sheet(),
    sheet: { strips: [{ width: 200, end: 2100 }, { width: 200 }], panel_height: 500, half_length: 2000 },
  };
  const [[x]] = addSecondPanel(uneven).second_panel!.leg_curve.bezier as [Vec2];
  // 1600 mm of strip 0, which ends 400 mm above the edge of the first panel.
  near(300 - x, 0.7 * Math.sqrt(1600 ** 2 - 400 ** 2), 1e-3);
});

test('panels that lean towards each other stand farther apart', () => {
  const leaning = addSecondPanel(setLeg(sheet(), 'leg', { lean: 30 }));
  assert.equal(leaning.second_panel!.leg_curve.lean, 30);
  near(300 - leaning.second_panel!.leg_curve.bezier[0]![0], 0.7 * 2000 + 2 * 500 * 0.5, 1e-3);
});

test('the mirror image of a symmetric sheet becomes a panel of its own', () => {
  const own = ownSecondPanel(chair());
  assert.equal(own.symmetric, false);
  assert.deepEqual(
    own.second_panel!.leg_curve.bezier,
    leg.map(([x, z]) => [-x, z]),
  );
  // Strips of 1900 and 2000 mm to the middle.
  assert.equal(own.sheet.half_length, 4000);
  assert.deepEqual(own.sheet.strips, [{ width: 200, end: 500 + 2 * 1900 }, { width: 200 }]);
  for (const gone of ['seat_curve', 'end_angle', 'anchors']) assert.equal(gone in own, false, gone);
});

test('both leg curves grow with the sheet, but not those that the program scales', () => {
  const two = addSecondPanel(sheet()),
    wider = setStripWidth(two, 110);
  for (const panel of ['leg', 'second'] as const) near(lengthOf(legOf(wider, panel)!.bezier), 440, 1e-2);
  assert.deepEqual(scaledLegs(setLeg(two, 'second', { fit: true }), 2).second_panel!.leg_curve.bezier, [
    ...two.second_panel!.leg_curve.bezier,
  ]);
});

test('a control point of the second leg curve goes, its length stays', () => {
  const less = removePoint(addSecondPanel(sheet()), 'second', 1);
  assert.equal(less.second_panel!.leg_curve.bezier.length, 2);
  near(lengthOf(less.second_panel!.leg_curve.bezier), 400, 1e-2);
});

test('a mould of which nothing is set is left out', () => {
  const set = setMould(setMould(sheet(), { form: 'body' }), { base: 40 });
  assert.deepEqual(set.mould, { form: 'body', base: 40 });
  assert.deepEqual(setMould(set, { form: undefined, base: undefined }), sheet());
});
