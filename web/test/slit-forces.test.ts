import assert from 'node:assert/strict';
import { test } from 'node:test';
import { standingText } from '../src/panels/standing-text.ts';
import { forcesOf } from '../src/slit-forces.ts';
import type { ReportSlit } from '../generated/report.ts';
import type { Shape, Vec3 } from '../src/types.ts';

const near = (a: readonly number[], b: readonly number[]) =>
  a.forEach((v, k) => assert.ok(Math.abs(v - b[k]!) < 1e-9, `${a.join(' ')} is not ${b.join(' ')}`));

/** A strip from x = 300 to the plane x = 0, 400 high and 60 deep, of a sheet that is given in inches. */
const shape = (standing: ReportSlit['standing'] = null): Shape =>
  ({
    report: { units: 'inch', slit: { strips: [], standing } },
    handles: {
      ridges: [
        [300, 150, 0].map((x): [Vec3, Vec3] => [
          [x, 400, 0],
          [x, 400, 60],
        ]),
      ],
    },
  }) as unknown as Shape;

test('a force in the plane of symmetry is one arrow whose tip is where it acts', () => {
  const { arrows } = forcesOf(shape(), { loads: [{ strip: 0, at: 1, force: [0, -100, 0] }] });
  assert.equal(arrows.length, 1);
  const [tail, tip] = arrows[0]!;
  near(tip, [0, 400, 30]);
  near([tail[0], tail[2]], [0, 30]);
  assert.ok(tail[1] > 400, 'it pushes from above');
});

test('beside the plane each half bears half of it, and a spread one stands at three places', () => {
  const at = forcesOf(shape(), {
    loads: [
      { strip: 0, at: 0.5, force: [0, -100, 0] },
      { strip: 0, at: 1, force: [0, -100, 0] },
    ],
  }).arrows;
  near(at[0]![1], [150, 400, 30]);
  near(at[1]![1], [-150, 400, 30]);
  const length = ([tail, tip]: [Vec3, Vec3]) => Math.hypot(...tail.map((v, k) => v - tip[k]!));
  assert.ok(Math.abs(length(at[2]!) - 2 * length(at[0]!)) < 1e-9);
  assert.equal(forcesOf(shape(), { loads: [{ strip: 0, force: [0, -9, 0] }] }).arrows.length, 6);
  assert.equal(forcesOf(shape(), { symmetric: false, loads: [{ strip: 0, force: [0, -9, 0] }] }).arrows.length, 3);
  assert.deepEqual(forcesOf(shape(), { loads: [{ strip: 7, force: [0, -9, 0] }] }).arrows, []);
});

test('what the report says of balance is drawn in millimetres', () => {
  const standing = {
    stands: true,
    margin: 15.64,
    centre_of_mass: [0, 10, 1] as [number, number, number],
    support: [
      [-2, 0],
      [2, 0],
      [0, 3],
    ] as [number, number][],
  };
  const { centre, support } = forcesOf(shape(standing), null);
  near(centre!, [0, 254, 25.4]);
  near(support[2]!, [0, 0, 76.2]);
  assert.deepEqual(standingText({ standing } as unknown as ReportSlit), ['stands, may be tilted by 15.6°']);
  assert.deepEqual(standingText({ stable: false, standing: { ...standing, stands: false } } as unknown as ReportSlit), [
    'not stable',
    'falls over',
  ]);
});
