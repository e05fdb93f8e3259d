import assert from 'node:assert/strict';
import { test } from 'node:test';
import { whyNot } from '../src/panels/fields.ts';
import { gaugeText, lengthText } from '../src/units.ts';

test('what cannot be a value is refused with a sentence that says what can be', () => {
  const k = { label: 'K of the part', min: 0, max: 1 };
  assert.equal(whyNot('5', k), 'K of the part cannot be 5; it must be from 0 to 1.');
  assert.equal(whyNot('abc', k), '“abc” is not a number; K of the part needs one.');
  assert.equal(whyNot('', k), 'K of the part needs a number.');
  assert.equal(whyNot('0.3', k), null);
  const thickness = { label: 'Thickness', min: 1e-6, unit: 'mm', digits: 3 };
  assert.equal(whyNot('-3', thickness), 'Thickness cannot be -3; it must be above 0.');
  assert.equal(whyNot('0.5', thickness), null);
  assert.equal(whyNot('2', { label: 'Strips', min: 3 }), 'Strips cannot be 2; it must be at least 3.');
  assert.equal(whyNot('3.5', { label: 'Strips', whole: true }), 'Strips cannot be 3.5; it must be a whole number.');
  assert.equal(whyNot('x', { label: '0 x', name: 'x of corner 0' }), '“x” is not a number; x of corner 0 needs one.');
  assert.equal(
    whyNot('91', { label: 'Leans', unit: '°', min: -90, max: 90 }),
    'Leans cannot be 91; it must be from -90° to 90°.',
  );
  assert.match(whyNot('1e12', thickness)!, /larger than anything/);
});

test('a length is written in one way, wherever it comes from: a half goes away from zero', () => {
  // 1/16 in as it is, by way of millimetres, and by way of an array of seven digits
  for (const [value, from] of [
    [0.0625, 'inch'],
    [1.5875, 'mm'],
    [Math.fround(1.5875), 'mm'],
    [Math.fround(0.0015875), 'm'],
  ] as const)
    assert.equal(lengthText(value, from, 'inch'), '0.063');
  assert.equal(lengthText(3.175, 'mm', 'mm'), '3.18');
  assert.equal(lengthText(-3.175, 'mm', 'mm'), '-3.18');
  assert.equal(lengthText(1.005, 'mm', 'mm'), '1.01');
  assert.equal(lengthText(3.1749, 'mm', 'mm'), '3.17');
  assert.equal(lengthText(-0.001, 'mm', 'mm'), '0');
  assert.equal(lengthText(1200, 'mm', 'mm'), '1200');
  assert.equal(gaugeText(0.0598, 'inch', 'inch'), '0.0598');
  assert.equal(gaugeText(3.175, 'mm', 'mm'), '3.175');
});
