import assert from 'node:assert/strict';
import { test } from 'node:test';
import { capOf, cutAt, isKept } from '../src/section.ts';
import { foldSheet, makeSheetMesh } from '../src/sheet-mesh.ts';
import { decodeShape } from '../src/shape.ts';
import { cellAt, cellsOf, nameOfSide, sideBeside, sides, type Attitude } from '../src/view-cube.ts';
import { arrangementFor, arrangementOf, initialView, reduceView } from '../src/view-state.ts';
import type { Vec3 } from '../src/types.ts';
import { twoFlangesShape } from './two-flanges.ts';

/** Of triangles in space. */
function areaOf(p: Float32Array): number {
  let sum = 0;
  for (let i = 0; i < p.length; i += 9) {
    const at = (c: number, k: number) => p[i + 3 * c + k]!,
      u = [0, 1, 2].map((k) => at(1, k) - at(0, k)),
      v = [0, 1, 2].map((k) => at(2, k) - at(0, k));
    sum += Math.hypot(u[1]! * v[2]! - u[2]! * v[1]!, u[2]! * v[0]! - u[0]! * v[2]!, u[0]! * v[1]! - u[1]! * v[0]!) / 2;
  }
  return sum;
}

test('the material in a section has the area of the sheet that it runs through', () => {
  const thickness = 2,
    mesh = makeSheetMesh(decodeShape(twoFlangesShape())),
    at = (share: number) => foldSheet(mesh, share, thickness).positions;
  const section = (positions: Float32Array, along: Vec3, s: number) =>
    capOf(mesh, positions, cutAt(positions, along, s, false));
  // Across the bend line: the sheet is 60 wide there.
  for (const s of [0.1, 0.3]) assert.ok(Math.abs(areaOf(section(at(1), [1, 0, 0], s)) - 60 * thickness) < 1e-2);
  // Along the profile: its developed length, flat or folded; mitres keep the middle's.
  for (const share of [0, 0.5, 1])
    assert.ok(
      Math.abs(areaOf(section(at(share), [0, 1, 0], 0.37)) - 78 * thickness) < 0.02 * 78 * thickness,
      `${share}`,
    );
  assert.ok(Math.abs(areaOf(section(at(0), [0, 1, 0], 0.37)) - 78 * thickness) < 1e-2);
  // All of it lies in the plane, and the flip keeps the other side.
  const positions = at(1),
    cut = cutAt(positions, [0, 1, 0], 0.25, false),
    other = cutAt(positions, [0, 1, 0], 0.25, true),
    cap = capOf(mesh, positions, cut);
  for (let i = 0; i < cap.length; i += 3) assert.ok(Math.abs(cap[i + 1]! - 15) < 1e-4);
  assert.deepEqual([isKept(cut, 0, 14, 0), isKept(cut, 0, 16, 0)], [true, false]);
  assert.deepEqual([isKept(other, 0, 14, 0), isKept(other, 0, 16, 0)], [false, true]);
  assert.equal(capOf(mesh, positions, { normal: [0, 1, 0], constant: 10 }).length, 0, 'beside the sheet there is none');
});

/** Seen along a direction with z up. */
function seenFrom(d: Vec3): Attitude {
  const l = Math.hypot(...d),
    z = d.map((v) => v / l) as Vec3,
    r = Math.hypot(z[0], z[1]),
    x: Vec3 = [-z[1] / r, z[0] / r, 0],
    y: Vec3 = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]];
  return { axes: [0, 1, 2].map((k) => [x[k], y[k], z[k]] as Vec3) as [Vec3, Vec3, Vec3] };
}

test('the cube shows the sides that face the eye, and a click finds the side', () => {
  assert.equal(sides.length, 26);
  const front = cellsOf(seenFrom([0, -1, 0]));
  assert.deepEqual(
    front.faces.map((f) => f.name),
    ['Front'],
  );
  assert.equal(nameOfSide(cellAt(front.cells, [0, 0])!.side), 'Front');
  assert.equal(nameOfSide(cellAt(front.cells, [0.8, 0])!.side), 'Front right');
  assert.equal(nameOfSide(cellAt(front.cells, [0.8, 0.8])!.side), 'Front right top');
  assert.equal(cellAt(front.cells, [1.2, 0]), null);
  const iso = cellsOf(seenFrom([1, -1.25, 0.95]));
  assert.deepEqual(iso.faces.map((f) => f.name).sort(), ['Front', 'Right', 'Top']);
  assert.equal(iso.cells.length, 27);
  assert.equal(nameOfSide(cellAt(iso.cells, [0, 0])!.side).split(' ').length >= 1, true);
});

test('arrow keys go to the side beside, all round', () => {
  let side: Vec3 = [0, -1, 0];
  const names = [];
  for (let i = 0; i < 8; ++i) {
    side = sideBeside(side, 1, 0);
    names.push(nameOfSide(side));
  }
  assert.deepEqual(names, ['Front right', 'Right', 'Right back', 'Back', 'Back left', 'Left', 'Front left', 'Front']);
  assert.equal(nameOfSide(sideBeside([0, -1, 0], 0, 1)), 'Front top');
  assert.equal(nameOfSide(sideBeside([0, -1, 1], 0, 1)), 'Top');
  assert.equal(nameOfSide(sideBeside([0, -1, 0], 0, -1)), 'Front bottom');
});

test('wide patterns are shown below the part, others beside it, unless that was chosen', () => {
  assert.equal(arrangementFor([100, 90], 900, 640), 'beside');
  assert.equal(arrangementFor([1768, 360], 900, 640), 'stacked');
  assert.equal(arrangementFor([360, 1768], 900, 640), 'beside');
  const suggested = reduceView(initialView, { type: 'view', view: { suggested: 'stacked' } });
  assert.equal(arrangementOf(suggested), 'stacked');
  assert.equal(arrangementOf(reduceView(suggested, { type: 'view', view: { arrangement: 'beside' } })), 'beside');
  assert.equal(reduceView(initialView, { type: 'view', view: { split: 0.01 } }).split, 0.28, 'no view vanishes');
  assert.equal(reduceView(initialView, { type: 'section', section: { at: 0.2 } }).section.at, 0.2);
});
