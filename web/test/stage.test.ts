import assert from 'node:assert/strict';
import { test } from 'node:test';
import { facetTransforms, inverse, place, product, transformsAt } from '../src/folding.ts';
import { moved, noOrder, orderOf, reduceOrder } from '../src/order-state.ts';
import { changesBefore, inOpening } from '../src/panels/bend-order.ts';
import { decodeShape } from '../src/shape.ts';
import { gaugeEdge, phases, Stages, turnAt } from '../src/stage.ts';
import type { OrderAnswer, StrokeRow } from '../src/types.ts';
import { twoFlangesShape } from './two-flanges.ts';

const near = (a: number, b: number, tolerance = 1e-6) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);

const thickness = 2,
  developed = 8,
  neutral = thickness / 2; // as facets have it
const sine = (t: number) => Math.sin((t * Math.PI) / 180),
  cosine = (t: number) => Math.cos((t * Math.PI) / 180);

/** A stroke of the two flanges, the second at the gauge: its bend line is at x = 44, the gauge at x = 78. */
function stroke(more: Partial<StrokeRow> = {}): StrokeRow {
  const turn = Array.from({ length: 91 }, (_, t) => t);
  // the tangent point of the inside skin, as math.md#stroke has it
  const radius = (t: number) => developed / ((t * Math.PI) / 180) - neutral;
  const start = (t: number) => (t === 0 ? [4, 0] : [radius(t) * sine(t / 2), radius(t) * (1 - cosine(t / 2))]);
  return {
    bends: ['B1'],
    angle: 90,
    v_wanted: 12,
    radius_drawn: 2,
    radius_made: 1.92,
    punch: 'P',
    die: 'V',
    punch_segments: [60],
    punch_from: 0,
    die_segments: [60],
    die_from: 0,
    side_up: 'reference',
    to_gauge: 'F2',
    gauge_direction: [1, 0],
    gauge: {
      touched: 1,
      distance: 34,
      edge: [
        [78, 0],
        [78, 60],
      ],
    },
    force: 12,
    clearance: 1,
    blocked: null,
    scene: {
      origin: [44, 0],
      along: [0, -1],
      pattern_up: true,
      held: [60, 30],
      across: 0,
      moments: {
        turn,
        slope: turn.map((t) => t / 2),
        y: turn.map((t) => start(t)[0]! - 4 * cosine(t / 2)),
        z: turn.map((t) => start(t)[1]! - 4 * sine(t / 2)),
        punch: turn.map(() => 0),
        die: turn.map((t) => -2 - t / 100),
      },
      punch: [[-60, 60]],
      die: [[-60, 60]],
      feet: [],
      gauge: [
        [78, 0],
        [78, 60],
      ],
      gauge_height: 0,
    },
    ...more,
  };
}

const answer = (strokes: StrokeRow[]): OrderAnswer => ({
  status: 'optimal',
  sentence: null,
  notes: [],
  units: 'mm',
  thickness,
  cost: 1,
  turn_overs: 0,
  rotations: 0,
  tool_changes: 0,
  ungauged: 0,
  v_away: 0,
  strokes,
  stations: [],
  tools: {
    machine: '',
    punches: {},
    feet: {},
    upper_beams: {},
    dies: {},
    lower_beam: [],
    finger: [],
    finger_width: 0,
    nose: [],
    nose_width: 0,
  },
});

const shape = decodeShape(twoFlangesShape(64));
const last = shape.facet_parent.length - 1;

test('each facet may be turned by a share of its own', () => {
  const none = facetTransforms(shape, new Float64Array(last + 1));
  assert.deepEqual([...none], [...facetTransforms(shape, 0)]);
  const half = facetTransforms(shape, new Float64Array(last + 1).fill(0.5));
  assert.deepEqual([...half], [...facetTransforms(shape, 0.5)]);
});

test('a facet is held where a matrix has it, and the others hang on it', () => {
  const at = [0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1],
    t = transformsAt(shape, 1, last, at),
    plain = facetTransforms(shape, 1);
  at.forEach((v, i) => near(t[16 * last + i]!, v));
  const seen = (m: Float64Array) => product(inverse(m, 16 * last), 0, m, 0);
  seen(t).forEach((v, i) => near(v, seen(plain)[i]!));
});

test('a stroke says that it is gauged in an opening', () => {
  const { gauge } = stroke();
  assert.equal(inOpening({ gauge }), '');
  assert.equal(inOpening({ gauge: { ...gauge!, opening: true } }), ' in the opening');
  assert.equal(inOpening({ gauge: null }), '');
});

test('before the stroke the sheet lies on the die, its bend line on the axis, its edge at the gauge', () => {
  const stage = new Stages(shape, answer([stroke()])).at(phases.down)!;
  const t = transformsAt(shape, stage.pose.share, stage.pose.held, stage.pose.at);
  for (let f = 0; f <= last; ++f) {
    const [x, y, z] = place(t, f, 44, 10);
    near(x, -10);
    near(y, 0);
    near(z, 1); // the middle of the sheet, whose lower side is on the die
  }
  near(place(t, last, 78, 30)[1], 34);
  near(stage.punch, 2);
  assert.deepEqual(gaugeEdge(stroke().scene), { from: -60, to: 0, y: 34 });
});

test('while it is pressed both sides rise alike, about the punch', () => {
  const stages = new Stages(shape, answer([stroke()]));
  for (const share of [0.5, 0.65, phases.pressed]) {
    const stage = stages.at(share)!,
      t = transformsAt(shape, stage.pose.share, stage.pose.held, stage.pose.at);
    near(stage.turn, 90 * ((share - phases.down) / (phases.pressed - phases.down)), 1e-9);
    const slope = (f: number, a: number, b: number) => {
      const [p, q] = [place(t, f, a, 30), place(t, f, b, 30)];
      return [q[1] - p[1], q[2] - p[2]].map((v) => v / Math.abs(b - a)) as [number, number];
    };
    const [right, left] = [slope(last, 48, 78), slope(0, 40, 0)];
    near(right[0], cosine(stage.turn / 2), 1e-3);
    near(right[1], sine(stage.turn / 2), 1e-3);
    near(left[0], -right[0], 1e-3);
    near(left[1], right[1], 1e-3);
    // the lowest point of the inside is under the punch's tip
    near(place(t, 32, 44, 30, 1)[1], 0, 0.1);
    near(place(t, 32, 44, 30, 1)[2], stage.punch, 0.02);
  }
});

test('what collides is red from the turn on at which it does, and the stroke stops there', () => {
  const blocked = {
    bend: 'B1',
    hits: 'punch P',
    with: 'F1',
    depth: 2,
    at_turn: 45,
    tool: 'punch' as const,
    sentence: '',
    wording: [],
  };
  const row = stroke({ blocked }),
    stages = new Stages(shape, answer([row]));
  assert.equal(stages.at(0.5)!.hit, null);
  const stopped = stages.at(phases.pressed)!;
  assert.deepEqual(stopped.hit, { part: 0, tool: 'punch' });
  near(stopped.turn, 45);
  near(turnAt({ ...row, blocked: { ...blocked, at_turn: 92 } }, 1), 92); // by its springback
});

test('between two strokes the sheet goes from where the first left it to where the second wants it', () => {
  const other = stroke({ bends: ['B2'], scene: { ...stroke().scene, along: [0, 1], pattern_up: true } });
  const stages = new Stages(shape, answer([stroke(), other]));
  const at = (time: number) => {
    const { pose } = stages.at(time)!,
      t = transformsAt(shape, pose.share, pose.held, pose.at);
    return place(t, 0, 10, 20);
  };
  at(1 - 1e-9).forEach((v, i) => near(v, at(1 + 1e-9)[i]!, 1e-3));
  at(1 + phases.brought - 1e-9).forEach((v, i) => near(v, at(1 + phases.brought + 1e-9)[i]!, 1e-3));
  assert.ok(at(1 + phases.brought / 2)[1] < -30); // out towards the operator
});

test('an order that was asked for takes the place of the one that is shown', () => {
  const input = { spec: null, options: {} };
  let state = reduceOrder(noOrder, {
    type: 'order',
    answer: answer([stroke(), stroke()]),
    of: input,
    ofBrake: {},
    asked: null,
  });
  state = reduceOrder(state, { type: 'stroke-time', time: 1.4, playing: true });
  assert.equal(state.playing, true);
  const asked = orderOf(state.answer!);
  state = reduceOrder(state, { type: 'order-asked', asked });
  assert.equal(state.playing, false);
  assert.equal(state.asked, asked);
  state = reduceOrder(state, { type: 'order', answer: answer([stroke()]), of: input, ofBrake: {}, asked });
  assert.deepEqual([state.time, state.given, state.asked], [1, true, null]);
  state = reduceOrder(state, { type: 'stroke-time', time: 7, playing: true });
  assert.deepEqual([state.time, state.playing], [1, false]);
});

test('a stroke is moved to another place', () => {
  assert.deepEqual(moved(['a', 'b', 'c', 'd'], 0, 2), ['b', 'c', 'a', 'd']);
  assert.deepEqual(moved(['a', 'b', 'c', 'd'], 3, 0), ['d', 'a', 'b', 'c']);
  assert.deepEqual(moved(['a', 'b'], 1, 1), ['a', 'b']);
});

test('what is done before a stroke follows from how it differs from the last', () => {
  const set = (setUp: number, strokes: number[]) => ({
    set_up: setUp,
    punch: 'P',
    die: 'V',
    from: 0,
    segments: [60],
    die_from: 0,
    die_segments: [60],
    strokes,
  });
  const before = (more: Partial<StrokeRow>, stations = [set(1, [1, 2])]) =>
    changesBefore({ strokes: [stroke(), stroke(more)], stations }, 1);
  assert.deepEqual(changesBefore({ strokes: [stroke()], stations: [] }, 0), []);
  assert.deepEqual(before({}), []);
  assert.deepEqual(before({ side_up: 'other', gauge_direction: [-1, 0] }), ['turn over', 'rotate']);
  assert.deepEqual(before({}, [set(1, [1]), set(1, [2])]), ['go to B']);
  assert.deepEqual(before({}, [set(1, [1]), set(2, [2])]), ['new set-up']);
});
