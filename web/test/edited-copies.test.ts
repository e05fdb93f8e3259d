import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import type { Api } from '../src/api.ts';
import { EditedCopies } from '../src/edited-copies.ts';
import { Recents, recentList, type Recent } from '../src/recents.ts';
import { initialState } from '../src/state.ts';
import { Store } from '../src/store.ts';
import type { Spec } from '../src/types.ts';

const stored = new Map<string, string>();
Object.assign(globalThis, {
  window: globalThis,
  sessionStorage: {
    getItem: (key: string) => stored.get(key) ?? null,
    setItem: (key: string, value: string) => void stored.set(key, value),
    removeItem: (key: string) => void stored.delete(key),
  },
});

const plates = (thickness: number) =>
  ({ format: 'planish/plates', version: 1, thickness, plates: [] }) as unknown as Spec;
const bytes = new TextEncoder().encode('{}').buffer as ArrayBuffer;

/** A page on a machine that has room for `most` files. */
function page(most = 64) {
  const files = new Map<string, Blob>(),
    store = new Store(initialState('light'));
  const api = {
    keep: async (name: string, content: Blob) => {
      if (!files.has(name) && files.size >= most) throw new Error('no room');
      await tick();
      await tick();
      files.set(name, content);
    },
    forget: async (name: string) => void files.delete(name),
  } as unknown as Api;
  const recents = new Recents(api, store),
    copies = new EditedCopies(store, recents);
  const open = (isNew: boolean) => {
    const document = { id: 'd1', kind: 'connect', name: 'plates.json' };
    store.dispatch({ type: 'opened', document, spec: plates(2) });
    copies.begin({ name: document.name, bytes, beside: {}, isNew });
  };
  const edit = (thickness: number) =>
    store.dispatch({ type: 'edit', input: { spec: plates(thickness), options: {} }, live: false });
  return { files, store, recents, copies, open, edit };
}
const tick = () => new Promise((resolve) => setTimeout(resolve, 0));
const written = () => new Promise((resolve) => setTimeout(resolve, 50));

beforeEach(() => stored.clear());

test('what is edited is kept when it is left, and nothing else', async () => {
  const { files, store, copies, open, edit } = page();
  open(true);
  assert.equal(copies.end(), false);
  await written();
  assert.equal(files.size, 0, 'nothing was edited');
  open(true);
  edit(3);
  assert.equal(copies.end(), true);
  await written();
  const [kept] = JSON.parse(await files.get(recentList)!.text()) as Recent[];
  assert.deepEqual([kept!.name, kept!.kind, kept!.edited], ['plates.json', 'connect', 'new']);
  assert.deepEqual(JSON.parse(await files.get(`recent-${kept!.key}-0`)!.text()), plates(3));
  assert.equal(store.state.recents.length, 1);
  // Another document has an entry of its own.
  open(false);
  edit(4);
  copies.end();
  await written();
  assert.deepEqual(
    store.state.recents.map((r) => r.edited),
    ['file', 'new'],
  );
});

test('a drag that has not ended is kept as it was before', async () => {
  const { files, store, copies, open, edit } = page();
  open(true);
  edit(3);
  store.dispatch({ type: 'edit', input: { spec: plates(9), options: {} }, live: true });
  copies.rest();
  await written();
  const [kept] = store.state.recents;
  assert.deepEqual(JSON.parse(await files.get(`recent-${kept!.key}-0`)!.text()), plates(3));
});

test('edits that were undone leave no entry and no file', async () => {
  const { files, store, copies, open, edit } = page();
  open(true);
  edit(3);
  copies.rest();
  await written();
  assert.equal(files.size, 2);
  store.dispatch({ type: 'undo' });
  assert.equal(copies.rest(), false);
  await written();
  assert.deepEqual([...files.keys()], [recentList]);
  assert.deepEqual(store.state.recents, []);
});

test('it is said if there is no room', async () => {
  const { store, copies, open, edit } = page(0);
  open(true);
  edit(3);
  copies.rest();
  await written();
  assert.match(store.state.note ?? '', /no room left to keep plates.json as it is edited/);
});

test('the piece and the body that are shown are no edit', async () => {
  const { files, store, copies, open } = page();
  open(true);
  store.dispatch({ type: 'edit', input: { spec: plates(2), options: { piece: 2 } } });
  assert.equal(copies.end(), false);
  await written();
  assert.equal(files.size, 0);
});

test('of a part the entry of its file gets what was set, for each body, and it is opened with it', async () => {
  const { files, store, copies } = page(),
    document = { id: 'd2', kind: 'unfold', name: 'two.step' },
    set = { options: { k: 0.3, body: 2 }, others: { 1: { root: 4 } } };
  store.dispatch({ type: 'opened', document, spec: null });
  copies.begin({ name: document.name, bytes, beside: {}, listed: true });
  await written(); // its key
  store.dispatch({ type: 'edit', input: { spec: null, options: { body: 2 }, others: {} } });
  assert.equal(copies.rest(), false, 'choosing a body is no edit');
  store.dispatch({ type: 'edit', input: { spec: null, ...set } });
  assert.equal(copies.end(), true);
  await written();
  const [kept] = store.state.recents;
  assert.deepEqual([kept!.edited, kept!.set], ['file', set]);
  assert.equal(await files.get(`recent-${kept!.key}-0`)!.text(), '{}', 'the file itself');
  store.dispatch({ type: 'opened', document, spec: null, set: kept!.set });
  assert.deepEqual(store.state.input, { spec: null, ...set });
});

test('of a part that is left before its key is known the edits stay, and so does where they lie', async () => {
  const { store, copies } = page(),
    document = { id: 'd2', kind: 'unfold', name: 'two.step' };
  store.dispatch({ type: 'opened', document, spec: null });
  copies.begin({ name: document.name, bytes, beside: {}, listed: true });
  store.dispatch({ type: 'edit', input: { spec: null, options: { k: 0.3 } } });
  assert.equal(copies.end(), true);
  await written();
  const [kept] = store.state.recents;
  assert.deepEqual([kept!.edited, kept!.set], ['file', { options: { k: 0.3 } }]);
});

test('what is chosen in the list before its edits are kept is opened with them', async () => {
  const { store, copies, recents } = page(),
    document = { id: 'd2', kind: 'unfold', name: 'two.step' },
    edit = (k: number) => store.dispatch({ type: 'edit', input: { spec: null, options: { k } } });
  store.dispatch({ type: 'opened', document, spec: null });
  copies.begin({ name: document.name, bytes, beside: {}, listed: true });
  edit(0.3);
  copies.rest();
  await written();
  const [listed] = store.state.recents;
  edit(0.4);
  copies.end();
  await tick();
  assert.deepEqual(store.state.recents, [listed], 'the list shows it as it was');
  assert.deepEqual((await recents.asKept(listed!)).set, { options: { k: 0.4 } });
});
