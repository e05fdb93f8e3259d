import assert from 'node:assert/strict';
import test from 'node:test';
import { drawnFeatures } from '../src/features.ts';
import { circleOfEdge, featureOfEdge, markedWith } from '../src/lines.ts';
import { decodeShape, encodeShape } from '../src/shape.ts';
import { twoFlanges } from './two-flanges.ts';

/** Edges of arcs: middle, radius and sweep by edge; the features that they outline. */
function arcs(rows: { at: [number, number]; radius: number; sweep: number; feature?: number }[]) {
  const { header, arrays } = twoFlanges();
  return decodeShape(
    encodeShape(header, {
      ...arrays,
      edge_length: Float32Array.from(rows, (r) => Math.abs(r.radius * r.sweep)),
      edge_circle: Float32Array.from(rows.flatMap((r) => [...r.at, r.radius, r.sweep])),
      edge_feature: Int32Array.from(rows, (r) => r.feature ?? -1),
    }),
  );
}

test('two halves of a circle are one', () => {
  const shape = arcs([
    { at: [10, 10], radius: 3.3, sweep: -Math.PI },
    { at: [10, 10], radius: 3.3, sweep: -Math.PI },
    { at: [30, 10], radius: 3.3, sweep: -Math.PI },
  ]);
  const circle = circleOfEdge(shape, 0)!;
  assert.ok(circle.whole);
  assert.ok(Math.abs(circle.length - 2 * Math.PI * 3.3) < 1e-4);
  assert.deepEqual([...markedWith(shape, 1)], [0, 1]);
  assert.equal(circleOfEdge(shape, 2)!.whole, false);
});

test('a hole and the outline of a feature on the same circle are two', () => {
  const shape = arcs([
    { at: [10, 10], radius: 5, sweep: 2 * Math.PI },
    { at: [10, 10], radius: 5, sweep: 2 * Math.PI, feature: 1 },
    { at: [10, 10], radius: 5, sweep: 2 * Math.PI, feature: 2 },
  ]);
  assert.deepEqual(
    [0, 1, 2].map((n) => featureOfEdge(shape, n)),
    [null, 1, 2],
  );
  for (const n of [0, 1, 2]) {
    assert.deepEqual([...markedWith(shape, n)], [n]);
    assert.ok(circleOfEdge(shape, n)!.whole);
  }
});

test('the features that are drawn are counted by kind, the most first', () => {
  const circle = { at: [0, 0] as [number, number], radius: 1, sweep: 2 * Math.PI };
  const shape = arcs([circle, ...[0, 2, 2, 3].map((feature) => ({ ...circle, feature }))]),
    feature = (kind: string) => ({ kind, side: 'both' as const, at: null, size: null, openings: 0 });
  assert.equal(
    drawnFeatures(shape, ['countersink', 'contact', 'pocket', 'pocket'].map(feature)),
    '2 pockets, 1 countersink',
  );
});

test('shapes without features have none', () => {
  const { header, arrays } = twoFlanges();
  assert.equal(featureOfEdge(decodeShape(encodeShape(header, arrays)), 0), null);
});
