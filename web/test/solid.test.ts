import assert from 'node:assert/strict';
import test from 'node:test';
import { decodeShape, encodeShape } from '../src/shape.ts';
import { namedPieces, namedPlaces, pointOf, solidLines } from '../src/solid-mesh.ts';
import { namedPlates } from '../src/refused-solid.ts';
import { SolidNames } from '../src/solid-names.ts';
import { directionThatShows } from '../src/solid-sight.ts';
import { normalised } from '../src/vectors.ts';
import { pixelsOf, rasterOf } from '../src/solid-picture.ts';
import type { Place, Shape, Vec3 } from '../src/types.ts';
import type { PlatesSpec } from '../src/edits/plates-types.ts';

test('faces and edges are those among the places', () => {
  assert.deepEqual(
    namedPlaces([
      { kind: 'face', id: 8 },
      { kind: 'face', id: 7 },
      { kind: 'face', id: 8 },
    ]),
    {
      faces: [
        { name: 'face 8', number: 8 },
        { name: 'face 7', number: 7 },
      ],
      edges: [],
    },
  );
  // Of an edge the faces on both sides are named for its own sake.
  assert.deepEqual(namedPlaces([{ kind: 'edge', id: 73, faces: [6, 35] }]), {
    faces: [],
    edges: [{ name: 'edge 73', between: [6, 35] }],
  });
  assert.deepEqual(
    namedPlaces([
      { kind: 'point', at: [1, 2, 3] },
      { kind: 'bend', id: 'B1' },
    ]),
    { faces: [], edges: [] },
  );
  assert.deepEqual(namedPlaces(undefined), { faces: [], edges: [] });
});

const numbered = (faces: number[]) => faces.map((number) => ({ name: `face ${number}`, number }));

/** A box from the origin; faces 1 to 6: −x, +x, −y, +y, −z, +z. */
function box(size: Vec3, faces = [1, 2, 3, 4, 5, 6], at: Vec3 = [0, 0, 0]): Shape {
  const points = Array.from({ length: 8 }, (_, i) =>
    [i & 1, (i >> 1) & 1, i >> 2].map((s, k) => at[k]! + s * size[k]!),
  );
  const quads = [
    [0, 4, 6, 2],
    [1, 3, 7, 5],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 2, 3, 1],
    [4, 5, 7, 6],
  ];
  return withArrays({
    space_points: new Float32Array(points.flat()),
    space_triangles: new Uint32Array(quads.flatMap(([a, b, c, d]) => [a!, b!, c!, a!, c!, d!])),
    space_faces: new Uint32Array(faces.flatMap((f) => [f, f])),
  });
}

const withArrays = (arrays: Parameters<typeof encodeShape>[1]): Shape =>
  decodeShape(encodeShape({} as Parameters<typeof encodeShape>[0], arrays));

const together = (a: Shape, b: Shape): Shape => ({
  ...a,
  space_points: new Float32Array([...a.space_points, ...b.space_points]),
  space_triangles: new Uint32Array([
    ...a.space_triangles,
    ...b.space_triangles.map((i) => i + a.space_points.length / 3),
  ]),
  space_faces: new Uint32Array([...a.space_faces, ...b.space_faces]),
});

test('a solid has the edges at which its faces meet', () => {
  const shape = box([4, 3, 2]),
    lines = solidLines(shape);
  assert.equal(lines.length, 12, 'no diagonals');
  const lengths = lines.map(({ ends: [a, b] }) =>
    Math.hypot(...pointOf(shape, a).map((v, k) => v - pointOf(shape, b)[k]!)),
  );
  assert.deepEqual(lengths.sort(), [2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4]);
  const edge = namedPieces(shape, { faces: [], edges: [{ name: 'edge 1', between: [2, 6] }] })[0]![0]!;
  assert.deepEqual(edge.middle, [4, 1.5, 2]);
  assert.deepEqual(namedPieces(shape, { faces: [], edges: [{ name: 'edge 2', between: [1, 2] }] }), []);
});

test('the solid is turned so that what is named is seen, and not without need', () => {
  const corners: Vec3[] = [
    [1, -1, 1],
    [1, 1, 1],
    [-1, 1, 1],
    [-1, -1, 1],
    [1, -1, -1],
  ];
  const shape = box([4, 3, 2]),
    towards = (faces: number[], of = shape) => directionThatShows(of, { faces: numbered(faces), edges: [] }, corners);
  assert.deepEqual(towards([6]), [1, -1, 1]);
  assert.deepEqual(towards([3]), [1, -1, 1]);
  assert.deepEqual(towards([4]), [1, 1, 1], 'from behind');
  assert.deepEqual(towards([1]), [-1, 1, 1]);
  assert.deepEqual(towards([5]), [1, -1, -1], 'from below');
  // A wall before it.
  const hidden = together(shape, box([1, 40, 40], [7, 8, 9, 10, 11, 12], [6, -20, -20]));
  assert.deepEqual(towards([6], hidden), [-1, 1, 1]);
  assert.deepEqual(directionThatShows(shape, { faces: numbered([99]), edges: [] }, corners), [1, -1, 1]);
});

test('the solid is turned so that all that is named is seen, if there is such a direction', () => {
  const shape = box([40, 3, 2]),
    both = { faces: numbered([2, 3]), edges: [] };
  // The face of 80 mm² is before that of 6 mm², and both are seen from one corner only.
  const corners: Vec3[] = [
    [-1, -1, 1],
    [1, 1, 1],
    [1, -1, 1],
  ];
  assert.deepEqual(directionThatShows(shape, both, corners), [1, -1, 1]);
  assert.deepEqual(directionThatShows(shape, both, corners.slice(0, 2)), [-1, -1, 1], 'the larger one');
  assert.deepEqual(directionThatShows(shape, both, corners.slice(0, 2), [[1, -1, 0]]), [1, -1, 0], 'by a side');
  assert.deepEqual(directionThatShows(shape, { faces: numbered([3]), edges: [] }, corners, [[0, -1, 0]]), corners[0]);
});

test('a name stands beside a place that is seen, and says where there is none', () => {
  const names = new SolidNames();
  // Before the right half of face 3 stands a wall.
  const shape = together(box([40, 3, 20]), box([20, 1, 40], [7, 8, 9, 10, 11, 12], [20, -9, -10]));
  names.set(shape, { faces: numbered([3, 4]), edges: [{ name: 'edge 1', between: [1, 3] }] });
  const from = (...towards: Vec3) => names.seenFrom(normalised(towards)),
    [front, back, edge] = from(0, -1, 0);
  assert.deepEqual([front!.behind, back!.behind, edge!.behind], [false, true, false]);
  assert.ok(front!.at[0] < 20 && front!.at[1] === 0, String(front!.at));
  assert.equal(back!.text, 'face 4');
  // It stays where it is as long as it is seen there.
  assert.deepEqual(from(0.01, -1, 0)[0]!.at, front!.at);
  assert.deepEqual(
    from(0, 1, 0).map((name) => name.behind),
    [true, false, true],
  );
  names.set(together(box([40, 3, 20]), box([60, 1, 40], [7, 8, 9, 10, 11, 12], [-10, -9, -10])), {
    faces: numbered([3]),
    edges: [],
  });
  assert.equal(from(0, -1, 0)[0]!.behind, true, 'the wall hides all of it');
});

test('plates are those among the places, and those of fields of the file', () => {
  const spec = {
    plates: ['base', 'left', 'right "1"'].map((id) => ({ id, outline: [] })),
    bends: [{ between: ['base', 'left'] }],
  } as unknown as PlatesSpec;
  const named = (...places: Place[]) => namedPlates(places, spec).faces;
  const plate = (id: string): Place => ({ kind: 'plate', id }),
    pointer = (id: string): Place => ({ kind: 'pointer', id });
  const [base, left] = [
    { name: 'base', number: 1 },
    { name: 'left', number: 2 },
  ];
  assert.deepEqual(named(plate('left'), plate('base')), [left, base]);
  assert.deepEqual(named(plate('other')), []);
  assert.deepEqual(named(pointer('/plates/0/outline/3')), [base]);
  assert.deepEqual(named(pointer('/bends/0/inside_radius')), [base, left]);
  assert.deepEqual(named(pointer('/bends/7')), []);
  assert.deepEqual(named(pointer('/root')), []);
});

test('a picture of a solid shows the three faces that are turned to the eye, each as bright as it lies', () => {
  const raster = rasterOf(box([40, 30, 20]), 200)!,
    count = new Map<number, number>(),
    bright = new Map<number, number>();
  raster.faces.forEach((face, i) => {
    count.set(face, (count.get(face) ?? 0) + 1);
    bright.set(face, raster.bright[i]!);
  });
  assert.deepEqual([...count.keys()].sort(), [0, 2, 3, 6], 'those at +x, −y and +z; the nearest hide the others');
  // A face appears as large as its area times the share of its normal that is turned to the eye.
  const eye = [1, -1.25, 0.95].map((v) => v / Math.hypot(1, 1.25, 0.95)),
    seen = { 2: 600 * eye[0]!, 3: -800 * eye[1]!, 6: 1200 * eye[2]! },
    share = (face: 2 | 3 | 6) => count.get(face)! / (count.get(2)! + count.get(3)! + count.get(6)!),
    all = seen[2] + seen[3] + seen[6];
  for (const face of [2, 3, 6] as const)
    assert.ok(Math.abs(share(face) - seen[face] / all) < 0.005, `face ${face}: ${share(face)}`);
  assert.ok(bright.get(6)! > bright.get(3)! && bright.get(3)! > bright.get(2)!, 'light comes from above, left');
  assert.equal(Math.max(raster.width, raster.height), 200);
  const { width, height, data } = pixelsOf(raster);
  assert.deepEqual([width, height], [Math.ceil(raster.width / 2), Math.ceil(raster.height / 2)]);
  assert.equal(data[3], 0, 'its corner is empty');
  assert.equal(data[4 * (Math.floor(height / 2) * width + Math.floor(width / 2)) + 3], 255);
  assert.equal(rasterOf(box([0, 0, 0]), 200), null);
});
