import assert from 'node:assert/strict';
import { test } from 'node:test';
import { facetTransforms, place, transformsHolding } from '../src/folding.ts';
import { decodeShape } from '../src/shape.ts';
import { foldSheet, makeSheetMesh } from '../src/sheet-mesh.ts';
import { twoFlangesShape } from './two-flanges.ts';

const near = (a: number, b: number, tolerance = 1e-6) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);

test('unfolded, every facet lies where the pattern does', () => {
  const shape = decodeShape(twoFlangesShape());
  const t = facetTransforms(shape, 0);
  for (let f = 0; f < shape.facet_parent.length; ++f)
    assert.deepEqual(
      place(t, f, 7, 11).map((v) => v + 0),
      [7, 11, 0],
    );
});

test('folded by 90°, the second flange stands square to the first, towards +z', () => {
  const shape = decodeShape(twoFlangesShape(64));
  const t = facetTransforms(shape, 1);
  const last = shape.facet_parent.length - 1;
  const low = place(t, last, 48, 0),
    high = place(t, last, 78, 0);
  near(high[0] - low[0], 0, 1e-5);
  near(high[2] - low[2], 30, 1e-5);
  const radius = 8 / (Math.PI / 2); // of the neutral surface; inscribed chords are that close
  near(low[0], 40 + radius, 0.01);
  near(low[2], radius, 0.01);
});

test('a bend keeps its developed length at every stage', () => {
  const shape = decodeShape(twoFlangesShape());
  for (const share of [0, 0.3, 0.7, 1]) {
    const t = facetTransforms(shape, share);
    for (let f = 1; f < shape.facet_parent.length - 1; ++f) {
      const a = place(t, f, shape.points[8 * f]!, 0),
        b = place(t, f, shape.points[8 * f + 2]!, 0);
      near(Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 1, 1e-5);
    }
  }
});

test('the skins are the thickness apart, and those of neighbours meet', () => {
  const shape = decodeShape(twoFlangesShape());
  const mesh = makeSheetMesh(shape);
  const { positions } = foldSheet(mesh, 1, 2);
  const count = mesh.cornerFacet.length;
  const top = (c: number) => [...positions.slice(3 * c, 3 * c + 3)];
  const bottom = (c: number) => [...positions.slice(3 * (c + count), 3 * (c + count) + 3)];
  const [t, b] = [top(0), bottom(0)];
  near(Math.hypot(t[0]! - b[0]!, t[1]! - b[1]!, t[2]! - b[2]!), 2, 1e-5);
  for (
    let f = 0;
    f + 1 < shape.facet_parent.length;
    ++f // corner 1 of a facet is corner 0 of the next
  )
    for (const skin of [top, bottom]) {
      const [x, y] = [skin(4 * f + 1), skin(4 * f + 4)];
      near(Math.hypot(x[0]! - y[0]!, x[1]! - y[1]!, x[2]! - y[2]!), 0, 1e-4);
    }
});

test('a facet that is held stays where it is folded, at every stage', () => {
  const shape = decodeShape(twoFlangesShape());
  const last = shape.facet_parent.length - 1,
    folded = facetTransforms(shape, 1);
  for (const share of [0, 0.4, 1]) {
    const t = transformsHolding(shape, share, last);
    for (const [x, y] of [
      [48, 0],
      [78, 60],
    ] as const)
      place(t, last, x, y).forEach((v, k) => near(v, place(folded, last, x, y)[k]!, 1e-9));
  }
  const flat = transformsHolding(shape, 0, last),
    low = place(flat, 0, 0, 0),
    high = place(flat, last, 78, 0);
  near(Math.hypot(low[0] - high[0], low[1] - high[1], low[2] - high[2]), 78, 1e-5);
});
