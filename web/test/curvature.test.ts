import assert from 'node:assert/strict';
import { test } from 'node:test';
import { curvatures } from '../src/curvature.ts';
import { decodeShape } from '../src/shape.ts';
import { twoFlangesShape } from './two-flanges.ts';

test('a bend of 90° over 8 mm is bent by π/16 a millimetre everywhere, its flanges are not', () => {
  for (const facets of [2, 3, 8, 64]) {
    const bent = curvatures(decodeShape(twoFlangesShape(facets)));
    assert.equal(bent.length, facets + 2);
    for (let f = 0; f < facets + 2; ++f) {
      const wanted = f === 0 || f === facets + 1 ? 0 : Math.PI / 16;
      assert.ok(Math.abs(bent[f]! - wanted) < 1e-4, `${facets} facets, ${f}: ${bent[f]}`);
    }
  }
});
