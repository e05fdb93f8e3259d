import assert from 'node:assert/strict';
import { test } from 'node:test';
import { asKind, profileKind, withProfile, type ProfileKind } from '../src/edits/transition.ts';
import type { Profile, Seam, TransitionSpec } from '../src/edits/transition-types.ts';

const square: Profile = {
  polygon: [
    [-150, -100],
    [150, -100],
    [150, 100],
    [-150, 100],
  ],
};
const spec = (seam?: Seam): TransitionSpec => ({
  thickness: 1.5,
  from: { profile: square },
  to: { profile: { circle: { radius: 80 } } },
  ...(seam ? { seam } : {}),
});

test('a profile becomes one of every kind that is asked for', () => {
  for (const kind of ['polygon', 'circle', 'ellipse', 'rounded_rectangle', 'obround', 'spline'] as ProfileKind[])
    assert.equal(profileKind(asKind(square, kind)), kind);
});

test('a seam stays where the first profile still has the place, and is free where it has not', () => {
  const seamOf = (seam: Seam, kind: ProfileKind) => withProfile(spec(seam), 'from', asKind(square, kind)).seam;
  assert.equal(seamOf({ edge: 0 }, 'circle'), undefined);
  assert.deepEqual(seamOf({ edge: 3 }, 'rounded_rectangle'), { edge: 3 });
  assert.equal(seamOf({ edge: 3 }, 'obround'), undefined);
  assert.equal(seamOf({ corner: 0 }, 'rounded_rectangle'), undefined, 'its corners are round');
  assert.deepEqual(seamOf({ parameter: 0.3 }, 'spline'), { parameter: 0.3 });
  assert.ok(
    !(
      'seam' in
      withProfile(spec({ corner: 3 }), 'from', {
        polygon: [
          [0, 0],
          [100, 0],
          [0, 100],
        ],
      })
    ),
  );
});

test('the second profile leaves the seam alone', () =>
  assert.deepEqual(withProfile(spec({ edge: 3 }), 'to', square).seam, { edge: 3 }));
