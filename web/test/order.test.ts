import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ApiError, type Api } from '../src/api.ts';
import { OrderWork } from '../src/order-work.ts';
import { initialState } from '../src/state.ts';
import { Store } from '../src/store.ts';
import type { OrderAnswer, OrderedStroke, Request } from '../src/types.ts';

const order = (...bends: string[]): OrderedStroke[] => bends.map((b) => ({ bends: [b] }));
const turn = () => new Promise((resolve) => setTimeout(resolve, 0));

/** A server whose answers are given by the test. */
class Answers {
  readonly asked: Request[] = [];
  cancelled = 0;
  private readonly open: { resolve: (a: OrderAnswer) => void; reject: (e: Error) => void }[] = [];
  plan = (_: string, request: Request, signal?: AbortSignal) => {
    this.asked.push(request);
    return new Promise<OrderAnswer>((resolve, reject) => {
      this.open.push({ resolve, reject });
      signal?.addEventListener('abort', () => reject(problem('cancelled')));
    });
  };
  cancel = () => Promise.resolve(void ++this.cancelled);
  async answer(status: OrderAnswer['status']) {
    this.open.shift()!.resolve({ status, strokes: [] } as unknown as OrderAnswer);
    await turn();
  }
  async fail(error: Error) {
    this.open.shift()!.reject(error);
    await turn();
  }
}

const problem = (code: string, status = 0) => new ApiError({ code, message: code }, status);

function opened(reopen = () => Promise.resolve(false)) {
  const store = new Store(initialState('light')),
    server = new Answers();
  store.dispatch({ type: 'opened', document: { id: 'd1', kind: 'unfold', name: 'a.step' }, spec: null });
  return { store, server, work: new OrderWork(server as unknown as Api, store, reopen) };
}

test('of orders that come faster than answers only the newest is checked and shown', async () => {
  const { store, server, work } = opened();
  work.ask(order('B1', 'B2', 'B3'));
  work.ask(order('B2', 'B1', 'B3'));
  work.ask(order('B2', 'B3', 'B1'));
  assert.equal(server.asked.length, 1);
  assert.deepEqual(store.state.order.asked, order('B2', 'B3', 'B1'));
  await server.answer('possible');
  assert.deepEqual([store.state.order.answer], [null], 'the first answer is of an order that is no longer wanted');
  assert.deepEqual(
    server.asked.map((r) => r.order),
    [order('B1', 'B2', 'B3'), order('B2', 'B3', 'B1')],
  );
  await server.answer('blocked');
  const { answer, computing, asked, given } = store.state.order;
  assert.deepEqual([answer?.status, computing, asked, given], ['blocked', false, null, true]);
});

test('the options of the press brake go with the request, and the answer is known to be of them', async () => {
  const { store, server, work } = opened();
  store.dispatch({ type: 'brake', brake: { metal: 'stainless' } });
  work.ask(null);
  assert.deepEqual(server.asked[0], { spec: undefined, options: {}, brake: { metal: 'stainless' }, order: undefined });
  store.dispatch({ type: 'brake', brake: { metal: 'steel' } });
  await server.answer('optimal');
  assert.deepEqual(store.state.order.ofBrake, { metal: 'stainless' });
});

test('planning that is given up ends at the server, and what was shown stays', async () => {
  const { store, server, work } = opened();
  work.ask(null);
  await server.answer('optimal');
  work.ask(order('B1'));
  work.cancel();
  await turn();
  const { answer, computing, problem: said } = store.state.order;
  assert.deepEqual([server.cancelled, answer?.status, computing, said], [1, 'optimal', false, null]);
});

test('what the server says is shown; a document that is gone is opened again', async () => {
  const { store, server, work } = opened();
  work.ask(null);
  await server.fail(problem('no_tool'));
  assert.equal(store.state.order.problem?.code, 'no_tool');
  const again = opened(() => {
    again.store.dispatch({ type: 'reopened', document: { id: 'd2', kind: 'unfold', name: 'a.step' } });
    return Promise.resolve(true);
  });
  again.work.ask(null);
  await again.server.fail(problem('not_found', 404));
  assert.equal(again.server.asked.length, 2);
  await again.server.answer('optimal');
  assert.equal(again.store.state.order.answer?.status, 'optimal');
});
