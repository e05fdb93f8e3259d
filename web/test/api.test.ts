import assert from 'node:assert/strict';
import test from 'node:test';
import { problemOf } from '../src/api.ts';

const answer = (body: string, status = 422) => new Response(body, { status, statusText: 'No' });

test('a complaint keeps its places, numbers and remedy', async () => {
  const said = {
    code: 'not_connected',
    message: 'The given bends do not join plate "top" to plate "base".',
    where: 'apart.json/bends',
    places: [{ kind: 'plate', id: 'top' }],
    numbers: { gap: { value: 3, unit: 'mm' } },
    remedy: { change: 'Add a bend.' },
  };
  assert.deepEqual(await problemOf(answer(JSON.stringify(said))), said);
});

test('what is no complaint is said by its status', async () => {
  assert.equal((await problemOf(answer('oops', 502))).code, '502');
  assert.equal((await problemOf(answer('{"message": "no"}', 404))).code, '404');
  assert.equal((await problemOf(answer('', 403))).code, 'forbidden');
});
