import assert from 'node:assert/strict';
import { test } from 'node:test';
import { apart, arrows, nearestTo, stopsOf, towards } from '../src/measure/stops.ts';
import { thingOf } from '../src/measure/things.ts';
import type { Vec2 } from '../src/types.ts';
import { measured } from './two-flanges.ts';

/** What can be reached from a place by arrow keys alone. */
function reached(places: Vec2[], from: number): Set<number> {
  const seen = new Set([from]);
  for (const i of seen)
    for (const way of Object.values(arrows)) {
      const next = towards(places, places[i]!, way)[0];
      if (next !== undefined) seen.add(next);
    }
  return seen;
}

test('each thing is a stop once, in the pattern and in the folded part', () => {
  const of = measured(),
    kinds = (view: 'flat' | 'folded') => {
      const count: Record<string, number> = {};
      for (const { ref } of stopsOf(of, view)) count[ref.kind] = (count[ref.kind] ?? 0) + 1;
      return count;
    };
  // Two flanges and a bend, of which each end has an edge of its own: eight edges that share their corners.
  assert.deepEqual(kinds('flat'), { corner: 8, middle: 8, edge: 8, bend: 1 });
  // In the folded part edges of the bend have no place; the others are there on both sides.
  assert.deepEqual(kinds('folded'), { corner: 16, middle: 12, edge: 12, bend: 1, flange: 4 });
  for (const view of ['flat', 'folded'] as const)
    for (const { ref } of stopsOf(of, view)) assert.ok(thingOf(of, view, ref), `${view}: ${JSON.stringify(ref)}`);
});

test('arrow keys go to the nearest thing in their direction, and come back', () => {
  const places: Vec2[] = [
    [0, 0],
    [10, 0],
    [30, 1],
    [12, -14],
    [10, 40],
  ];
  const go = (from: number, key: string) => towards(places, places[from]!, arrows[key]!)[0];
  assert.equal(go(0, 'ArrowRight'), 1);
  assert.equal(go(1, 'ArrowRight'), 2);
  assert.equal(go(2, 'ArrowRight'), undefined, 'there is nothing further');
  assert.equal(go(2, 'ArrowLeft'), 1);
  assert.equal(go(1, 'ArrowUp'), 3, 'up is up on the screen');
  assert.equal(go(1, 'ArrowDown'), 4);
  assert.equal(go(4, 'ArrowUp'), 1);
  assert.equal(nearestTo(places, [26, 4])[0], 2);
});

test('every thing can be reached from every other one', () => {
  const flat = stopsOf(measured(), 'flat').map(({ at }): Vec2 => [4 * at[0], -4 * at[1]]);
  const rows = Array.from({ length: 60 }, (_, i): Vec2 => [13 * (i % 10), 17 * Math.floor(i / 10)]);
  // Holes in no order: numbers of a generator whose sequence is the same every time.
  let seed = 7;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647,
    scattered = Array.from({ length: 200 }, (): Vec2 => [900 * random(), 600 * random()]);
  const together: Vec2[] = [...rows, ...rows.slice(0, 5), ...rows.slice(0, 5), [13, 17]];
  for (const [name, places] of Object.entries({ flat, rows, scattered, together: apart(together) }))
    places.forEach((_, i) => assert.equal(reached(places, i).size, places.length, `${name}, from ${i}`));
  assert.ok(reached(together, 0).size < together.length, 'places that coincide would not be');
});
