import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  addFlatPoint,
  flatCurves,
  moveFlatPoint,
  removeSlit,
  withCurvedSlits,
  withoutChosen,
} from '../src/edits/flat-curves.ts';
import type { SlitSpec } from '../src/edits/slit-types.ts';

const straight: SlitSpec = {
  thickness: 2,
  sheet: { strips: 3, strip_width: 50, panel_height: 100, half_length: 300 },
  leg_curve: {
    bezier: [
      [200, 0],
      [200, 150],
    ],
  },
};
const curved = withCurvedSlits(straight)!;

test('strips of one width become curves where their slits are', () => {
  assert.deepEqual(curved.sheet, { width: 150, panel_height: 100, half_length: 300 });
  assert.deepEqual(
    flatCurves(curved).map(({ control }) => control),
    [50, 100].map((across) => [100, 200, 300, 400].map((along) => [along, across])),
  );
  assert.equal(withCurvedSlits(curved), null);
  assert.deepEqual(flatCurves(straight), []);
});

test('a slit ends with the strips wherever its end is dragged, and begins where it is', () => {
  assert.deepEqual(moveFlatPoint(curved, 'slits-0', 3, [380, 60]).slits![0]!.bezier![3], [400, 60]);
  assert.deepEqual(moveFlatPoint(curved, 'slits-0', 0, [130, 60]).slits![0]!.bezier![0], [130, 60]);
  assert.deepEqual(moveFlatPoint(curved, 'slits-0', 1, [400, 60]).slits![0]!.bezier![1], [400, 60]);
});

test('a chain gets a corner in the middle of a line; inner points go, ends stay', () => {
  const chain: SlitSpec = {
    ...curved,
    slits: [
      {
        points: [
          [100, 50],
          [400, 60],
        ],
      },
    ],
  };
  const more = addFlatPoint(chain, 'slits-0', 0);
  assert.deepEqual(more.slits![0]!.points![1], [250, 55]);
  assert.deepEqual(withoutChosen(more, { curve: 'slits-0', index: 1 }, null).slits, chain.slits);
  assert.deepEqual(withoutChosen(more, { curve: 'slits-0', index: 2 }, null).slits, more.slits);
  assert.equal(addFlatPoint(curved, 'slits-1', 0).slits![1]!.bezier!.length, 5);
  assert.deepEqual(removeSlit(curved, 0).slits, [curved.slits![1]]);
});
