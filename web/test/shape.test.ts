import assert from 'node:assert/strict';
import { test } from 'node:test';
import { decodeShape } from '../src/shape.ts';
import { twoFlanges, twoFlangesShape } from './two-flanges.ts';

test('a shape comes out as it was put in', () => {
  const { header, arrays } = twoFlanges();
  const shape = decodeShape(twoFlangesShape());
  assert.deepEqual(shape.report, header.report);
  assert.deepEqual(shape.parts, header.parts);
  for (const [name, values] of Object.entries(arrays))
    assert.deepEqual([...shape[name as keyof typeof arrays]], [...values], name);
  assert.equal(shape.overlaps.length, 0);
});

test('bytes that are not a shape are refused', () => {
  assert.throws(() => decodeShape(new TextEncoder().encode('{"code": "no"}').buffer as ArrayBuffer), /not a shape/);
  assert.throws(() => decodeShape(twoFlangesShape().slice(0, 200)), /cut off/);
  const data = twoFlangesShape();
  assert.throws(() => decodeShape(data.slice(0, data.byteLength - 4)), /outside/);
});
