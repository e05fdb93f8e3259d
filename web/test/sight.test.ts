import assert from 'node:assert/strict';
import { test } from 'node:test';
import { OrthographicCamera } from 'three';
import { foldSheet, makeSheetMesh } from '../src/sheet-mesh.ts';
import { simplified } from '../src/sheet-lod.ts';
import { decodeShape } from '../src/shape.ts';
import { Sight } from '../src/sight.ts';
import type { Shape } from '../src/types.ts';
import { twoFlangesShape } from './two-flanges.ts';

/** A view of 200 × 100 pixels from above, one a millimetre, its middle over (50, 30). */
function fromAbove() {
  const camera = new OrthographicCamera(-100, 100, 50, -50, -1000, 1000);
  camera.position.set(50, 30, 100);
  camera.lookAt(50, 30, 0);
  return camera;
}

function seen(thickness = 2) {
  const mesh = makeSheetMesh(decodeShape(twoFlangesShape())),
    { positions } = foldSheet(mesh, 1, thickness);
  const lines = Array.from(mesh.shape.edge_number, (edge, e) => ({
    line: { edge },
    a: mesh.rim[2 * e]!,
    b: mesh.rim[2 * e + 1]!,
  }));
  const sight = new Sight();
  sight.look({ mesh, positions, lines }, 1, fromAbove(), 200, 100);
  return sight;
}

const all = () => true;
const onScreen = (x: number, y: number): [number, number] => [x + 50, 80 - y];

test('the nearer skin is seen, in its facet and at its place', () => {
  const hit = seen().skinAt(...onScreen(20, 10), all);
  assert.ok(hit);
  assert.deepEqual([hit.facet, hit.upper], [0, true]);
  [20, 10, 1].forEach((v, k) => assert.ok(Math.abs(hit.at[k]! - v) < 1e-4, `${hit.at}`));
  assert.equal(seen().skinAt(...onScreen(20, 70), all), null);
});

test('what is cut away is not seen: what lies below it is', () => {
  const hit = seen().skinAt(...onScreen(20, 10), (_x, _y, z) => z < 0);
  assert.ok(hit);
  assert.equal(hit.upper, false);
  assert.ok(Math.abs(hit.at[2] + 1) < 1e-4);
});

test('the nearest line that nothing hides is picked, with the skin that it lies on', () => {
  const sight = seen(),
    line = sight.lineAt(...onScreen(20, 2), 5, 0.5, all);
  assert.deepEqual(line?.line, { edge: 0 });
  assert.equal(line?.upper, true);
  assert.ok(Math.abs(line!.distance - 2) < 1e-4);
  assert.equal(sight.lineAt(...onScreen(20, 10), 5, 0.5, all), null, 'none within five pixels');
  const lower = sight.lineAt(...onScreen(20, 2), 5, 0.5, (_x, _y, z) => z < 0);
  assert.equal(lower?.upper, false, 'that of the lower skin, where the upper one is cut away');
});

/** A flange of 100 × 60 with a round hole of radius `r` in its middle, of `n` corners. */
function perforated(r: number, n: number): Shape {
  const at = (i: number): [number, number] => [
    50 + r * Math.cos((2 * Math.PI * i) / n),
    30 - r * Math.sin((2 * Math.PI * i) / n),
  ];
  const hole = Array.from({ length: n }, (_, i) => at(i)).flat(),
    segments = Array.from({ length: n }, (_, i) => [...at(i), ...at((i + 1) % n)]).flat();
  return {
    ...decodeShape(twoFlangesShape()),
    points: Float32Array.from([0, 0, 100, 0, 100, 60, 0, 60, ...hole]),
    ring_starts: Uint32Array.from([0, 4, 4 + n]),
    polygon_starts: Uint32Array.from([0, 2]),
    facet_starts: Uint32Array.from([0, 1]),
    facet_parent: Int32Array.from([-1]),
    facet_hinge: new Float32Array(4),
    facet_angle: new Float32Array(1),
    facet_part: new Uint32Array(1),
    edges: Float32Array.from([0, 0, 100, 0, 100, 0, 100, 60, 100, 60, 0, 60, 0, 60, 0, 0, ...segments]),
    edge_facet: new Uint32Array(4 + n),
    edge_number: Uint32Array.from([0, 1, 2, 3, ...new Array<number>(n).fill(4)]),
    edge_length: Float32Array.from([100, 60, 100, 60, 2 * Math.PI * r]),
    edge_circle: Float32Array.from([...new Array<number>(16).fill(0), 50, 30, r, -2 * Math.PI]),
    edge_feature: Int32Array.from(new Array<number>(5).fill(-1)),
    bend_lines: new Float32Array(),
    bend_line_part: new Uint32Array(),
  };
}

test('round edges are drawn by as few corners as a tolerance allows, and skins and rim still meet', () => {
  const r = 10,
    n = 720,
    whole = perforated(r, n);
  for (const tolerance of [0.05, 0.2, 0.8]) {
    const less = simplified(whole, tolerance),
      corners = less.ring_starts[2]! - 4,
      off = r * (1 - Math.cos(Math.PI / corners));
    assert.ok(off <= 1.05 * tolerance, `${corners} corners are ${off} off`);
    assert.ok(
      r * (1 - Math.cos(Math.PI / Math.max(corners - 1, 3))) > 0.9 * tolerance || corners === 4,
      'no more than it takes',
    );
    assert.equal(less.edge_number.length, 4 + corners);
    assert.deepEqual([...less.edges.slice(0, 16)], [...whole.edges.slice(0, 16)], 'straight edges stay');
    // each segment of the hole joins two corners of its ring, and the last one closes it
    const ring = new Set(
      Array.from({ length: corners }, (_, i) => [...less.points.slice(8 + 2 * i, 10 + 2 * i)].join()),
    );
    for (let e = 16; e < less.edges.length; e += 4) {
      assert.ok(ring.has([...less.edges.slice(e, e + 2)].join()));
      assert.deepEqual(
        [...less.edges.slice(e + 2, e + 4)],
        [...(e + 4 < less.edges.length ? less.edges.slice(e + 4, e + 6) : less.edges.slice(16, 18))],
      );
    }
  }
});
