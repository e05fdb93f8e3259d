import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Api } from '../src/api.ts';
import { initialState, Store } from '../src/state.ts';
import { WorkshopKeeper } from '../src/workshop-kept.ts';

/** A server that keeps files, and how often it was asked to. */
function server() {
  const files = new Map<string, string>(),
    said = { writes: 0, broken: false };
  const api = {
    kept: async () => [...files.keys()].map((name) => ({ name, size: 1 })),
    readKept: async (name: string) => files.get(name)!,
    keep: async (name: string, text: string) => {
      if (said.broken) throw new Error('the disk is full');
      ++said.writes;
      files.set(name, text);
    },
  } as unknown as Api;
  return { api, files, said };
}
async function page(api: Api) {
  const store = new Store(initialState('light'));
  await new WorkshopKeeper(api, store).load();
  return store;
}
const rest = () => new Promise((resolve) => setTimeout(resolve, 20));
const table = { kind: 'k_table', name: 'steel.csv', text: 'r/t, k\n1, 0.4\n' } as const;

test('what is kept is there for the next page', async () => {
  const { api, said } = server(),
    first = await page(api);
  assert.equal(said.writes, 0, 'reading writes nothing');
  first.dispatch({ type: 'dxf', dxf: { r12: true } });
  first.dispatch({ type: 'table-file', file: table });
  first.dispatch({ type: 'every-part', options: { k: 0.4 } });
  await rest();
  assert.ok(said.writes <= 2, 'what changes meanwhile is written at once');
  assert.deepEqual((await page(api)).state.workshop, first.state.workshop);
});

test('two pages do not take away what the other has kept', async () => {
  const { api } = server(),
    [one, two] = [await page(api), await page(api)];
  one.dispatch({ type: 'table-file', file: table });
  await rest();
  two.dispatch({ type: 'dxf', dxf: { r12: true } });
  await rest();
  const { workshop } = (await page(api)).state;
  assert.deepEqual([workshop.files, workshop.dxf], [[table], { r12: true }]);
});

test('what cannot be read is as if nothing was kept, and what cannot be written is said', async () => {
  const { api, files, said } = server();
  files.set('workshop.json', 'no JSON');
  const store = await page(api);
  assert.deepEqual(store.state.workshop.files, []);
  said.broken = true;
  store.dispatch({ type: 'dxf', dxf: { r12: true } });
  await rest();
  assert.equal(store.state.problem?.message, 'the disk is full');
});
