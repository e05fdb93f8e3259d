import assert from 'node:assert/strict';
import { test } from 'node:test';
import { distanceToSegment, lengthOfEdge, partOfEdge, partsBeside } from '../src/lines.ts';
import { decodeShape } from '../src/shape.ts';
import { twoFlangesShape } from './two-flanges.ts';

const shape = decodeShape(twoFlangesShape(8));

test('an edge is as long as its pieces together, across all facets of a bend', () => {
  assert.ok(Math.abs(lengthOfEdge(shape, 0) - 40) < 1e-5, 'the first flange ends at 40');
  assert.ok(Math.abs(lengthOfEdge(shape, 2) - 8) < 1e-5, 'the bend is 8 mm long, in eight facets');
  assert.equal(lengthOfEdge(shape, 6), 60);
  assert.equal(lengthOfEdge(shape, 99), 0);
});

test('an edge belongs to the part that it bounds', () => {
  assert.deepEqual(
    [0, 2, 4, 6, 7].map((edge) => partOfEdge(shape, edge)),
    [0, 1, 2, 0, 2],
  );
  assert.equal(partOfEdge(shape, 99), null);
});

test('a bend lies beside both its flanges, a flange beside its bend', () => {
  assert.deepEqual([...partsBeside(shape, 1)].sort(), [0, 2]);
  assert.deepEqual([...partsBeside(shape, 0)], [1]);
});

test('distances from a segment are those from its ends beyond them', () => {
  assert.deepEqual(distanceToSegment(3, 4, 0, 0, 10, 0), { distance: 4, along: 0.3 });
  assert.deepEqual(distanceToSegment(-3, 4, 0, 0, 10, 0), { distance: 5, along: 0 });
  assert.deepEqual(distanceToSegment(3, 4, 3, 0, 3, 0), { distance: 4, along: 0 });
});
