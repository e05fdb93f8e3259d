import assert from 'node:assert/strict';
import { test } from 'node:test';
import { facetTransforms, place } from '../src/folding.ts';
import { asBefore, turnedPlace } from '../src/orientation.ts';
import { decodeShape } from '../src/shape.ts';
import type { Shape, Vec2 } from '../src/types.ts';
import { twoFlangesShape } from './two-flanges.ts';

/** The same sheet, laid flat by another of its bends: turned by `degrees` and moved, its root where it was. */
function laidOtherwise(shape: Shape, degrees: number): Shape {
  const a = (degrees * Math.PI) / 180,
    [c, s] = [Math.cos(a), Math.sin(a)],
    [dx, dy] = [17, -5];
  const points = (from: Float32Array) =>
    from.map((_, i) => {
      const [x, y] = [from[i - (i % 2)]!, from[i - (i % 2) + 1]!];
      return i % 2 ? s * x + c * y + dy : c * x - s * y + dx;
    });
  // the inverse motion, after which the root's own: here the identity
  const root = [c, s, 0, -c * dx - s * dy, -s, c, 0, s * dx - c * dy, 0, 0, 1, 0, 0, 0, 0, 1];
  return {
    ...shape,
    root,
    points: points(shape.points),
    facet_hinge: points(shape.facet_hinge),
    edges: points(shape.edges),
    bend_lines: points(shape.bend_lines),
  };
}

const directionOf = ({ bend_lines: l }: Shape): Vec2 => [
  Math.sign(Math.round(l[2]! - l[0]!)),
  Math.sign(Math.round(l[3]! - l[1]!)),
];

test('a pattern that is laid by another bend is shown as it was', () => {
  const before = decodeShape(twoFlangesShape());
  for (const degrees of [90, 180, 270]) {
    const shown = asBefore(laidOtherwise(before, degrees), before);
    assert.deepEqual(directionOf(shown), directionOf(before), `${degrees}°`);
    assert.equal(shown.turn, (360 - degrees) / 90);
  }
  const little = laidOtherwise(before, 8);
  assert.equal(asBefore(little, before), little, 'less than half a quarter is as the files have it');
});

test('what is shown turned folds to the same place', () => {
  const before = decodeShape(twoFlangesShape()),
    other = laidOtherwise(before, 90),
    shown = asBefore(other, before);
  const corners = (s: Shape) => {
    const t = facetTransforms(s, 1);
    return [0, s.facet_parent.length - 1].map((f) => place(t, f, s.points[8 * f]!, s.points[8 * f + 1]!));
  };
  const [was, is] = [corners(other), corners(shown)];
  was.forEach((p, i) => p.forEach((v, k) => assert.ok(Math.abs(v - is[i]![k]!) < 1e-4)));
});

test('places of the report turn with the pattern', () => {
  assert.deepEqual(
    [0, 1, 2, 3].map((q) => turnedPlace([3, 1], q)),
    [
      [3, 1],
      [-1, 3],
      [-3, -1],
      [1, -3],
    ],
  );
});
