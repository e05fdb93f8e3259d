import { Api, ApiError } from './api.ts';
import { problemOf } from './compute.ts';
import { shownBend } from './order-state.ts';
import { isInMachine } from './state.ts';
import type { Store } from './store.ts';
import type { OrderedStroke } from './types.ts';

const patience = 600; // ms after which a check that is no longer wanted is ended; sooner, ending it would take longer

/** Has the server plan the order of strokes and check others: one request at a time, always the newest. */
export class OrderWork {
  private running = false;
  private startedAt = 0;
  private waiting: { asked: OrderedStroke[] | null } | null = null;
  private ended: Promise<unknown> | null = null;
  private flight = new AbortController();

  private readonly api: Api;
  private readonly store: Store;
  private readonly reopen: () => Promise<boolean>;
  constructor(api: Api, store: Store, reopen: () => Promise<boolean>) {
    this.reopen = reopen;
    this.api = api;
    this.store = store;
    store.subscribe((state, before) => {
      if (state.document?.id !== before.document?.id) this.drop();
    });
  }

  /** `asked`: the order to be checked; null: the cheapest one is looked for. */
  ask(asked: OrderedStroke[] | null) {
    this.store.dispatch({ type: 'order-asked', asked });
    this.waiting = { asked };
    if (this.running && performance.now() - this.startedAt > patience) this.end();
    void this.next();
  }

  cancel() {
    this.waiting = null;
    if (this.running) this.end();
    else this.store.dispatch({ type: 'order-problem', problem: null });
  }

  private drop() {
    this.waiting = null;
    this.flight.abort();
  }

  /** Ends what runs, here and at the server, unless the shape is being computed there. */
  private end() {
    const { document, computing } = this.store.state;
    if (document && !computing) this.ended = this.api.cancel(document.id).catch(() => undefined);
    this.flight.abort();
  }

  private async next() {
    const { document, input, order } = this.store.state,
      wanted = this.waiting;
    if (this.running || !wanted || !document) return;
    this.waiting = null;
    this.running = true;
    this.startedAt = performance.now();
    this.flight = new AbortController();
    const of = document.id,
      { brake } = order;
    try {
      const answer = await this.api.plan(
        of,
        { spec: input.spec ?? undefined, options: input.options, brake, order: wanted.asked ?? undefined },
        this.flight.signal,
      );
      if (this.isShown(of))
        this.store.dispatch({ type: 'order', answer, of: input, ofBrake: brake, asked: wanted.asked });
    } catch (error) {
      const cancelled = error instanceof ApiError && error.problem.code === 'cancelled',
        gone = error instanceof ApiError && error.status === 404;
      if (gone && (await this.reopen().catch(() => false))) this.waiting ??= wanted;
      else if (this.isShown(of))
        this.store.dispatch({ type: 'order-problem', problem: cancelled ? null : problemOf(error) });
    }
    await this.ended; // so that it cannot end the next request
    this.ended = null;
    this.running = false;
    void this.next();
  }

  /** Whether an answer is of the document that is open, and no newer one is wanted. */
  private isShown = (id: string) => this.store.state.document?.id === id && !this.waiting;
}

/** Where another order puts another bend at the stroke that is shown, that bend is picked instead. */
export function followStroke(store: Store) {
  store.subscribe((state, before) => {
    if (state.order.answer === before.order.answer || !isInMachine(state) || !isInMachine(before)) return;
    const [was, part] = [shownBend(before.order), shownBend(state.order)];
    if (part !== undefined && part !== was && state.selection.part === was)
      store.dispatch({ type: 'select', selection: { part } });
  });
}
