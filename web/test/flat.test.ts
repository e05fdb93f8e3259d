import assert from 'node:assert/strict';
import { test } from 'node:test';
import { findingMarks, findingUnder } from '../src/finding-marks.ts';
import { dimensionReach } from '../src/flat-dimensions.ts';
import { sidesAsReported } from '../src/rectangle.ts';
import type { Finding, FindingPlace, Vec2 } from '../src/types.ts';

const finding = (...at: Vec2[]): Finding => ({
  code: 'opening_to_edge',
  severity: 'warning',
  message: '',
  at,
  places: [],
  numbers: {},
});

test('the sides of the blank are as long as the report says, in whatever order it names them', () => {
  assert.deepEqual(sidesAsReported([121.24, 130.64], [130.68, 121.27]), [121.27, 130.68]);
  assert.deepEqual(sidesAsReported([300, 200], [300.01, 200]), [300.01, 200]);
  assert.deepEqual(sidesAsReported([300, 200], [250, 240]), [300, 200], 'a report of something else says nothing');
});

test('dimension lines are on the sides away from the pattern', () => {
  const reach = dimensionReach([
    [0, 0],
    [100, 0],
    [100, 50],
    [0, 50],
  ]);
  assert.ok(
    reach.some(({ at, by }) => at[0] === 0 && by[0] < -20) && reach.some(({ at, by }) => at[1] === 0 && by[1] < -20),
  );
  assert.ok(!reach.some(({ at, by }) => (at[0] === 100 && by[0] > 1) || (at[1] === 50 && by[1] > 1)));
});

test('marks of findings that would cover each other step aside, never that of the chosen one', () => {
  const findings = [finding([0, 0]), finding([5, 0], [100, 0]), finding([6, 0])],
    at = (p: Vec2) => p;
  const numbered = (selected: number | null) => findingMarks(findings, at, selected).filter((m) => m.numbered);
  for (const selected of [null, 0, 1, 2]) {
    const marks = numbered(selected),
      chosen = marks.filter((m) => m.finding === selected);
    assert.deepEqual(new Set(marks.map((m) => m.finding)), new Set([0, 1, 2]), 'each has a number');
    chosen.forEach((m) => assert.deepEqual(m.at, m.of));
    for (const [i, m] of marks.entries()) {
      assert.ok(Math.hypot(m.at[0] - m.of[0], m.at[1] - m.of[1]) <= 32, 'near to its place');
      for (const n of marks.slice(0, i))
        assert.ok(Math.hypot(m.at[0] - n.at[0], m.at[1] - n.at[1]) >= m.radius + n.radius - 1, 'none covers another');
    }
  }
  assert.deepEqual(
    numbered(1)
      .map((m) => m.at[0])
      .filter((x) => x === 5 || x === 100),
    [100, 5],
  );
  // Places of the chosen finding that lie closer than its numbers are dots.
  assert.deepEqual(
    findingMarks([finding([0, 0], [5, 0])], at, 0).map((m) => [m.at[0], m.numbered]),
    [
      [5, false],
      [0, true],
    ],
  );
});

test('a finding whose place could not be measured has no mark', () => {
  const nowhere: Finding = { ...finding(), at: [[null, 3]] };
  assert.deepEqual(
    findingMarks([nowhere, finding([1, 2])], (p) => p, null).map((m) => [m.finding, m.at]),
    [[1, [1, 2]]],
  );
});

test('a rule has one mark, at its worst place, until it is chosen: then one at each place', () => {
  const places = Array.from(
      { length: 300 },
      (_, i): FindingPlace => ({ kind: 'point', severity: i ? 'info' : 'warning', message: '', points: [[30 * i, 0]] }),
    ),
    rules: Finding[] = [1, 2, 3].map((y) => ({
      ...finding(),
      count: places.length,
      places: places.map((p) => ({ ...p, points: [[p.points![0]![0]!, 100 * y]] })),
    }));
  const marks = (selected: number | null) => findingMarks(rules, (p) => p, selected);
  assert.deepEqual(
    marks(null).map((m) => [m.finding, m.at[0], m.severity]),
    [
      [2, 0, 'warning'],
      [1, 0, 'warning'],
      [0, 0, 'warning'],
    ],
  );
  assert.equal(marks(1).filter((m) => m.finding === 1).length, 300);
  assert.equal(marks(1).length, 302);
});

test('a click on a mark means its finding, the uppermost one', () => {
  const marks = findingMarks([finding([0, 0]), finding([5, 0]), finding([40, 0])], (p) => p, null);
  assert.deepEqual([findingUnder(marks, 5, 0), findingUnder(marks, 40, 6), findingUnder(marks, 20, 0)], [0, 2, null]);
});
