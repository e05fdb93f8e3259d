import assert from 'node:assert/strict';
import { test } from 'node:test';
import { alone, between, type Answer } from '../src/measure/answer.ts';
import { edgeForms } from '../src/measure/edges.ts';
import { isSame, noMeasures, reduceMeasure } from '../src/measure/state.ts';
import { snapAt } from '../src/measure/snap.ts';
import { placeOfText, type Taken } from '../src/measure/text-place.ts';
import { labelText, wholeText } from '../src/measure/text.ts';
import { inPlace, thingOf, type Thing } from '../src/measure/things.ts';
import type { Vec2, Vec3 } from '../src/types.ts';
import { measured } from './two-flanges.ts';

const point = (...at: Vec3): Thing => ({ type: 'point', at }),
  line = (a: Vec3, b: Vec3): Thing => ({ type: 'line', a, b }),
  hole = (at: Vec3, radius: number, normal: Vec3 = [0, 0, 1], whole = true): Thing => ({
    type: 'circle',
    at,
    normal,
    radius,
    whole,
  }),
  plane = (at: Vec3, normal: Vec3): Thing => ({ type: 'plane', at, normal });

const near = (value: number, wanted: number, off = 1e-9) =>
  assert.ok(Math.abs(value - wanted) < off, `${value}, not ${wanted}`);
const more = (answer: Answer | null) =>
  Object.fromEntries((answer?.more ?? []).map(({ name, value }) => [name, Number(value.toFixed(9))]));

/** Whichever is picked first. */
function both(a: Thing, b: Thing, flat = true): Answer {
  const [there, back] = [between(a, b, flat), between(b, a, flat)];
  assert.ok(there && back);
  near(there.value, back.value);
  return there;
}

test('points: their distance, and its steps along the axes', () => {
  const flat = both(point(1, 2, 0), point(4, 6, 0));
  near(flat.value, 5);
  assert.deepEqual(more(flat), { dx: 3, dy: 4 });
  const space = both(point(0, 0, 0), point(2, 3, 6), false);
  near(space.value, 7);
  assert.deepEqual(more(space), { dx: 2, dy: 3, dz: 6 });
});

test('a point and an edge: perpendicular, also beyond its ends', () => {
  const answer = both(point(30, 7, 0), line([0, 0, 0], [10, 0, 0]));
  near(answer.value, 7);
  assert.deepEqual(answer.beyond, [
    [
      [10, 0, 0],
      [30, 0, 0],
    ],
  ]);
  assert.deepEqual(both(point(5, 7, 0), line([0, 0, 0], [10, 0, 0])).beyond, []);
});

test('edges: a distance if parallel, else the angle on the side on which they lie', () => {
  near(both(line([0, 0, 0], [10, 0, 0]), line([40, 3, 0], [20, 3, 0])).value, 3);
  for (const angle of [0.5, 30, 90, 120, 179]) {
    const [c, s] = [Math.cos((angle * Math.PI) / 180), Math.sin((angle * Math.PI) / 180)],
      answer = both(line([1, 0, 0], [9, 0, 0]), line([8 * c, 8 * s, 0], [2 * c, 2 * s, 0]));
    assert.equal(answer.of, 'angle');
    near(answer.value, angle, 1e-6);
  }
  const skew = both(line([-5, 0, 0], [5, 0, 0]), line([0, -5, 4], [0, 5, 4]), false);
  near(skew.value, 90);
  assert.deepEqual(more(skew), { apart: 4 });
});

test('holes: centres, diameters, and what is left between the rims', () => {
  const answer = both(hole([0, 0, 0], 3), hole([30, 40, 0], 5));
  near(answer.value, 50);
  assert.deepEqual(more(answer), { dx: 30, dy: 40, 'between rims': 42, Ø: 10 });
  assert.equal(wholeText(answer, 'mm'), '50 mm, dx 30, dy 40, between rims 42, Ø 6, Ø 10');
  const toEdge = both(hole([0, 12, 0], 3), line([-20, 0, 0], [20, 0, 0]));
  near(toEdge.value, 12);
  assert.deepEqual(more(toEdge), { 'to the rim': 9, Ø: 6 });
  const within = both(hole([0, 0, 0], 10), hole([2, 0, 0], 3));
  assert.equal(more(within)['between rims'], 5, 'one within the other: the narrowest place');
  const across = both(hole([0, 0, 0], 3), hole([30, 0, 5], 3, [1, 0, 0]), false);
  assert.equal(more(across)['between rims'], undefined, 'of holes in different planes there is no such place');
  const fillet = both(hole([0, 12, 0], 3, [0, 0, 1], false), line([-20, 0, 0], [20, 0, 0]));
  assert.deepEqual(more(fillet), { R: 3 });
});

test('one thing alone has its own size', () => {
  assert.equal(labelText(alone(hole([0, 0, 0], 3.3))!, 'mm'), 'Ø 6.6 mm');
  assert.equal(labelText(alone(hole([0, 0, 0], 12.7, [0, 0, 1], false))!, 'inch'), 'R 0.5 in');
  assert.equal(labelText(alone(line([0, 0, 0], [3, 4, 0]))!, 'mm'), '5 mm');
  assert.equal(alone(point(0, 0, 0)), null);
});

test('flanges: the angle that they enclose, or the distance of the sides picked', () => {
  for (const bend of [10, 45, 90, 135]) {
    const a = (bend * Math.PI) / 180,
      answer = both(
        plane([-20, 0, 0], [0, 0, 1]),
        plane([20 * Math.cos(a), 0, 20 * Math.sin(a)], [-Math.sin(a), 0, Math.cos(a)]),
        false,
      );
    near(answer.value, 180 - bend, 1e-6);
    assert.deepEqual(more(answer), { bend });
    answer.corner!.at.forEach((v) => near(v, 0, 1e-9));
  }
  near(both(plane([1, 0, 5], [0, 1, 0]), plane([7, 60, 3], [0, -1, 0]), false).value, 60);
  near(both(plane([0, 0, 0], [0, 0, 1]), point(3, 4, 7), false).value, 7);
  near(both(plane([0, 0, 0], [0, 0, 1]), line([0, 0, 5], [9, 0, 5]), false).value, 5);
  near(both(plane([0, 0, 0], [0, 0, 1]), line([0, 0, 5], [5, 0, 10]), false).value, 45, 1e-6);
});

test('in the folded part things are where flanges have them, on the side picked', () => {
  const of = measured(),
    forms = edgeForms(of.shape);
  assert.ok(forms.every((f) => f.straight && f.ends));
  assert.deepEqual(forms[2]!.ends!.map((p) => p[0]).sort(), [40, 48], 'an edge of a bend runs across its facets');
  const top = thingOf(of, 'folded', { kind: 'edge', edge: 7, upper: false });
  assert.ok(top?.type === 'line');
  near(top.a[0], 46.2);
  near(top.a[2], 5.2 + 30);
  assert.equal(thingOf(of, 'folded', { kind: 'edge', edge: 2, upper: true }), null, 'a bend has no place of its own');
  const flange = (part: number, upper: boolean) =>
    thingOf(of, 'folded', { kind: 'flange', part, upper, at: [10, 10] })!;
  near(both(flange(0, true), flange(2, true), false).value, 90, 1e-6);
  // its axis: as far above the first flange as it is before the second
  const axis = thingOf(of, 'folded', { kind: 'bend', part: 1, line: 0 });
  assert.ok(axis?.type === 'line');
  [axis.a, axis.b].forEach((p) => {
    near(p[0], 40);
    near(p[2], 5.2);
  });
  const at = inPlace(of.shape, 2, [45.2, 12, 5.2 + 8]);
  near(at![0], 56);
  near(at![1], 12);
});

test('two picks are a measure, the same twice is one of it alone; other views begin anew', () => {
  const pick = (edge: number, view: 'flat' | 'folded' = 'flat') =>
    ({ type: 'measure-pick', view, ref: { kind: 'edge', edge, upper: true } }) as const;
  let state = reduceMeasure({ ...noMeasures, on: true }, pick(1));
  assert.equal(state.kept.length, 0);
  state = reduceMeasure(state, pick(2, 'folded'));
  assert.deepEqual([state.kept.length, state.first?.view], [0, 'folded']);
  state = reduceMeasure(state, pick(3, 'folded'));
  state = reduceMeasure(reduceMeasure(state, pick(4)), pick(4));
  assert.deepEqual(
    state.kept.map((m) => [m.id, m.view, m.b && 'edge' in m.b ? m.b.edge : null]),
    [
      [1, 'folded', 3],
      [2, 'flat', null],
    ],
  );
  assert.deepEqual(
    reduceMeasure(state, { type: 'measure-remove', id: 1 }).kept.map((m) => m.id),
    [2],
  );
  assert.equal(reduceMeasure(state, { type: 'measure-mode', on: false }).kept.length, 2, 'what was measured stays');
  assert.equal(reduceMeasure(state, { type: 'measure-clear' }).kept.length, 0);
  const flange = { kind: 'flange', part: 1, upper: true, at: [1, 2] as [number, number] } as const;
  assert.ok(isSame(flange, { ...flange, at: [3, 4] }));
});

/** The two flanges with a hole of Ø 2 whose middle is (3, 3), made of two arcs. */
function withHole() {
  const of = measured(),
    { shape } = of,
    n = shape.edge_length.length,
    rim = Array.from({ length: 49 }, (_, i) => [
      3 + Math.cos((i * Math.PI) / 24),
      3 + Math.sin((i * Math.PI) / 24),
    ]) as Vec2[];
  const more = rim
    .slice(1)
    .map((to, i) => ({ ends: [...rim[i]!, ...to].map(Math.fround), edge: n + Math.floor(i / 24) }));
  more.at(-1)!.ends.splice(2, 2, ...more[0]!.ends.slice(0, 2));
  const holed = {
    ...shape,
    edges: Float32Array.from([...shape.edges, ...more.flatMap((m) => m.ends)]),
    edge_facet: Uint32Array.from([...shape.edge_facet, ...more.map(() => 0)]),
    edge_number: Uint32Array.from([...shape.edge_number, ...more.map((m) => m.edge)]),
    edge_length: Float32Array.from([...shape.edge_length, Math.PI, Math.PI]),
    edge_circle: Float32Array.from([...shape.edge_circle, 3, 3, 1, Math.PI, 3, 3, 1, Math.PI]),
    edge_feature: new Int32Array(n + 2).fill(-1),
  };
  return { of: { ...of, shape: holed }, hole: n };
}

test('on the rim of a small hole it is the hole that is taken, not what is near', () => {
  const { of, hole } = withHole();
  assert.ok(edgeForms(of.shape)[hole]!.circle?.whole && edgeForms(of.shape)[hole]!.ends);
  const at = (x: number, y: number, distance: number | null) =>
    snapAt(
      of,
      'flat',
      (px, py) => [2 * px, -2 * py], // pixels
      [2 * x, -2 * y],
      () => true,
      distance === null ? null : { edge: hole, upper: true, distance },
    );
  const diagonal = 3 - Math.SQRT1_2;
  assert.deepEqual(at(diagonal, diagonal, null)?.kind, 'corner', 'the corner of the flange is 6.5 pixels off');
  for (let i = 0; i < 48; ++i) {
    const [x, y] = [3 + Math.cos((i * Math.PI) / 24), 3 + Math.sin((i * Math.PI) / 24)];
    for (const off of [0, 1.4]) assert.equal(at(x, y, off)?.kind, 'circle', `${i}, ${off} pixels off`);
  }
  assert.equal(at(3, 3, 2)?.kind, 'circle', 'its centre');
  assert.equal(at(0.1, 0.1, 1.4)?.kind, 'corner', 'what is nearer than the rim');
  assert.equal(at(1, 1, 2.4)?.kind, 'corner', 'a rim that is only near');
});

test('texts of measures cover no other text, and stay in the view', () => {
  const taken: Taken = [],
    view: Vec2 = [400, 300];
  const put = (...places: Vec2[]) => {
    const placed = placeOfText(places, [60, 20], taken, view);
    taken.push(placed.box);
    return placed;
  };
  assert.deepEqual(put([200, 150], [250, 150]).at, [200, 150], 'where it belongs');
  assert.deepEqual(put([200, 150], [290, 150]).at, [290, 150], 'the next place that is offered');
  for (let i = 0; i < 20; ++i) {
    const { at, offered } = put([200, 150]);
    assert.ok(!offered && Math.hypot(at[0] - 200, at[1] - 150) < 160, at.join());
  }
  for (const [i, a] of taken.entries())
    for (const b of taken.slice(i + 1))
      assert.ok(a.x >= b.x + b.w || b.x >= a.x + a.w || a.y >= b.y + b.h || b.y >= a.y + a.h, `${i}`);
  const { at, box } = put([-5, 20]);
  assert.ok(box.x >= 0 && box.y >= 0, at.join());
  assert.deepEqual(
    placeOfText([[1000, 1000]], [60, 20], [], view).at,
    [1000, 1000],
    'what is out of sight stays there',
  );
});
