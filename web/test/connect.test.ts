import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  addBend,
  addPlate,
  bendsOf,
  copyPlate,
  notJoined,
  parseEdges,
  edgesText,
  movePlate,
  removeBend,
  removePlate,
  renamePlate,
  setBend,
  surfacePatch,
} from '../src/edits/connect.ts';
import { addCorner, addHole, along, directionsOf, moveCorner, removeCorner, removeHole } from '../src/edits/outline.ts';
import type { BendRow, Vec3 } from '../src/types.ts';
import type { PlatesSpec } from '../src/edits/plates-types.ts';

const level: Vec3[] = [
  [0, 0, 0],
  [200, 0, 0],
  [200, 100, 0],
  [0, 100, 0],
];
const leaning: Vec3[] = [
  [0, 130, 20],
  [200, 130, 20],
  [200, 190, 100],
  [0, 190, 100],
]; // 100 long, leaning by 3 : 4
const spec = (): PlatesSpec => ({
  thickness: 4,
  root: 'A',
  plates: [
    { id: 'A', outline: level },
    { id: 'B', outline: leaning },
    { id: 'C', outline: leaning.map(([x, y, z]) => [x, -y, z]) },
  ],
  bends: [{ between: ['A', 'B'], edges: { A: [2], B: [0] }, inside_radius: 5 }, { between: ['A', 'C'] }],
});
const row = (id: string, ...between: string[]) => ({ id, between }) as BendRow;
const rows = [row('B1', 'A', 'B'), row('B2', 'C', 'A')];
const plate = (s: PlatesSpec, id: string) => s.plates.find((p) => p.id === id)!;
const near = (a: number, b: number) => assert.ok(Math.abs(a - b) < 1e-6, `${a} is not ${b}`);

test('coordinates in a plate are x and y where it is level, else level and up its slope', () => {
  assert.deepEqual(directionsOf(level), { u: [1, 0, 0], v: [0, 1, 0] });
  for (const outline of [leaning, [...leaning].reverse()]) {
    const { u, v } = directionsOf(outline);
    [1, 0, 0].forEach((x, k) => near(u[k]!, x));
    [0, 0.6, 0.8].forEach((x, k) => near(v[k]!, x));
  }
});

test('a corner that is moved stays in its plate, and moves no other', () => {
  const moved = plate(moveCorner(spec(), 'B', 0, 2, 1, along(directionsOf(leaning), leaning[2]!)[1] + 50), 'B').outline;
  assert.deepEqual(moved[2], [200, 220, 140]);
  assert.deepEqual(
    moved.filter((_, i) => i !== 2),
    leaning.filter((_, i) => i !== 2),
  );
});

test('corners that come and go take the numbers of edges along in bends', () => {
  const edges = (s: PlatesSpec) => s.bends![0]!.edges!.A;
  assert.deepEqual(edges(addCorner(spec(), 'A', 0, 0)), [3]);
  assert.deepEqual(edges(addCorner(spec(), 'A', 0, 2)), [2, 3]);
  assert.deepEqual(edges(addCorner(spec(), 'A', 0, 3)), [2]);
  const pentagon = addCorner(spec(), 'A', 0, 2);
  assert.deepEqual(plate(pentagon, 'A').outline[3], [100, 100, 0]);
  assert.deepEqual(removeCorner(pentagon, 'A', 0, 3), spec());
  assert.deepEqual(edges(removeCorner(spec(), 'A', 0, 0)), [1]);
  assert.deepEqual(edges(removeCorner(spec(), 'A', 0, 2)), [1]);
  const triangle = removeCorner(spec(), 'A', 0, 0);
  assert.deepEqual(removeCorner(triangle, 'A', 0, 0), triangle, 'three remain');
});

test('an edge from the last corner to the first keeps its number when the first corner goes', () => {
  const s = setBend(spec(), rows, rows[0]!, { edges: { A: [3] } });
  assert.deepEqual(removeCorner(s, 'A', 0, 0).bends![0]!.edges, { A: [2] });
});

test('holes are added clear of one another and edited like outlines; edges keep their numbers', () => {
  const two = addHole(addHole(spec(), 'B'), 'B'),
    [a, b] = plate(two, 'B').holes as Vec3[][];
  const d = directionsOf(leaning),
    low = (ring: Vec3[], k: 0 | 1) => Math.min(...ring.map((p) => along(d, p)[k])),
    high = (ring: Vec3[], k: 0 | 1) => Math.max(...ring.map((p) => along(d, p)[k]));
  assert.ok(
    [0, 1].some((k) => high(a!, k as 0) <= low(b!, k as 0) + 1e-6 || high(b!, k as 0) <= low(a!, k as 0) + 1e-6),
  );
  for (const p of [...a!, ...b!]) near((p[1] - 130) * 0.8 - (p[2] - 20) * 0.6, 0);
  const more = addCorner(two, 'B', 1, 0);
  assert.equal((plate(more, 'B').holes![0] as Vec3[]).length, 5);
  assert.deepEqual(more.bends, spec().bends);
  assert.deepEqual(removeHole(removeHole(two, 'B', 1), 'B', 0), spec());
});

test('a plate is added in the plane of the chosen one, clear of it, or level', () => {
  const s = addPlate(spec(), 'B', [50, 20]),
    added = s.plates.at(-1)!;
  assert.equal(added.id, 'P1');
  assert.deepEqual(added.outline, [
    [205, 130, 20],
    [255, 130, 20],
    [255, 142, 36],
    [205, 142, 36],
  ]);
  assert.deepEqual(addPlate(s, null, [50, 20]).plates.at(-1), {
    id: 'P2',
    outline: [
      [260, -190, 0],
      [310, -190, 0],
      [310, -170, 0],
      [260, -170, 0],
    ],
  });
});

test('circles and slots go with their plate, and stay when a polygon beside them is edited', () => {
  const slot = { slot: { from: [10, 10, 0], to: [30, 10, 0], width: 5 } } as const,
    given: PlatesSpec = {
      ...spec(),
      plates: spec().plates.map((p) => (p.id === 'A' ? { ...p, holes: [structuredClone(slot) as never] } : p)),
    };
  const more = addHole(given, 'A');
  assert.deepEqual(plate(more, 'A').holes![0], slot);
  assert.deepEqual(plate(addCorner(more, 'A', 2, 0), 'A').holes![0], slot);
  assert.deepEqual(removeHole(more, 'A', 1), given);
  const up = movePlate(given, 'A', ([x, y, z]) => [x, y, z + 7]);
  assert.deepEqual(plate(up, 'A').holes, [{ slot: { from: [10, 10, 7], to: [30, 10, 7], width: 5 } }]);
});

test('a copy stands beside its plate, holes and all', () => {
  const s = copyPlate(addHole(spec(), 'A'), 'A'),
    copy = s.plates.at(-1)!;
  assert.equal(copy.id, 'A-2');
  assert.deepEqual(
    copy.outline,
    level.map(([x, y, z]) => [x + 220, y, z]),
  );
  assert.equal(copy.holes!.length, 1);
  assert.equal(copyPlate(s, 'A-2').plates.at(-1)!.id, 'A-3');
});

test('with a plate go the bends that name it, and root', () => {
  const s = removePlate(spec(), 'A');
  assert.deepEqual(Object.keys(s).sort(), ['plates', 'thickness']);
  assert.deepEqual(removePlate(spec(), 'B').bends, [{ between: ['A', 'C'] }]);
  assert.equal(removePlate(spec(), 'B').root, 'A');
});

test('a plate has its new name wherever it is named', () => {
  const s = renamePlate(spec(), 'A', 'floor')!;
  assert.equal(s.root, 'floor');
  assert.deepEqual(s.bends, [
    { between: ['floor', 'B'], edges: { floor: [2], B: [0] }, inside_radius: 5 },
    { between: ['floor', 'C'] },
  ]);
  assert.deepEqual(
    s.plates.map((p) => p.id),
    ['floor', 'B', 'C'],
  );
  assert.equal(renamePlate(spec(), 'A', 'B'), null);
  assert.equal(renamePlate(spec(), 'A', ''), null);
});

test('bends that the program found are named before one is added or removed', () => {
  const { bends: _none, ...found } = spec();
  assert.deepEqual(addBend(found, rows, 'B', 'C').bends, [
    { between: ['A', 'B'] },
    { between: ['C', 'A'] },
    { between: ['B', 'C'] },
  ]);
  assert.deepEqual(removeBend(found, rows, 0).bends, [{ between: ['C', 'A'] }]);
  assert.equal('bends' in removeBend(removeBend(found, rows, 0), rows, 0), false);
  assert.deepEqual(notJoined(found, rows, 'B'), ['C']);
});

test('a bend that could not be fitted is shown without its row', () => {
  const s = addBend(spec(), rows, 'B', 'C');
  assert.deepEqual(
    bendsOf(s, rows).map((b) => b.row?.id ?? null),
    ['B1', 'B2', null],
  );
  assert.deepEqual(
    bendsOf(removePlate(s, 'C'), rows).map((b) => b.row?.id),
    ['B1'],
  );
});

test('of two sections on one plate each is edited by itself', () => {
  const s: PlatesSpec = {
      ...spec(),
      bends: [
        { between: ['A'], angle: 90 },
        { between: ['A'], angle: 45 },
      ],
    },
    both = [row('B1', 'A'), row('B2', 'A')];
  assert.deepEqual(setBend(s, both, both[1]!, { angle: 30 }).bends, [
    { between: ['A'], angle: 90 },
    { between: ['A'], angle: 30 },
  ]);
});

test('lists of edges are read as they are written', () => {
  for (const edges of [[2], [2, 3], [0, 1, 2, 3, 7], [5, 6, 7]]) assert.deepEqual(parseEdges(edgesText(edges)), edges);
  assert.equal(edgesText([0, 1, 2, 3, 7, 8]), '0…3 7 8');
  assert.deepEqual(parseEdges('1-3, 7; 9 .. 10'), [1, 2, 3, 7, 9, 10]);
  assert.equal(parseEdges(' '), undefined);
  for (const text of ['a', '1.5', '3-1', '-1', '1-2-3', '0-999999999']) assert.equal(parseEdges(text), null, text);
});

test('a bend of another surface keeps nothing that this cannot have', () => {
  const general: PlatesSpec = {
    ...spec(),
    bends: [{ between: ['A', 'B'], surface: 'general', tangent_point: [0, 0, 0], apex: 3 }],
  };
  const bend = (surface: Parameters<typeof surfacePatch>[0], s: PlatesSpec = general) =>
    setBend(s, rows, rows[0]!, surfacePatch(surface)).bends![0];
  assert.deepEqual(bend('auto'), { between: ['A', 'B'], apex: 3 });
  assert.deepEqual(bend('cylinder'), { between: ['A', 'B'], surface: 'cylinder' });
  assert.deepEqual(
    bend('general', spec()),
    { between: ['A', 'B'], edges: { A: [2], B: [0] }, surface: 'general' },
    'its radius goes',
  );
});
