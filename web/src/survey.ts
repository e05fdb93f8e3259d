import { ApiError, type Api } from './api.ts';
import { optionsOf, refused, sameOptions, statusOfShape, type BodyStatus } from './bodies.ts';
import { poll, problemOf } from './compute.ts';
import { bodyOf } from './state.ts';
import type { Store } from './store.ts';
import type { Options } from './types.ts';

/**
 * What becomes of one body: whether it is a sheet, how large, what it looks like. Of the whole result, which takes as
 * long as a draft and knows the warnings. Throws where nobody can say.
 */
export async function lookAt(
  api: Api,
  id: string,
  body: number,
  of: Options,
  signal?: AbortSignal,
): Promise<BodyStatus> {
  try {
    return statusOfShape(await api.result(id, { options: { ...of, body } }, signal), of);
  } catch (error) {
    if (!saysWhy(error)) throw error;
    return refused(problemOf(error), of);
  }
}

/** Whether an error is about what was asked for, or about the work on it; others are about the server. */
export const saysWhy = (error: unknown) => error instanceof ApiError && [409, 422].includes(error.status);

/** Looks at the bodies of an assembly, one by one, while nothing else is computed; again when K or the shop changes. */
export class Survey {
  private running = false;
  private flight = new AbortController(); // of the body that is being looked at

  private readonly api: Api;
  private readonly store: Store;
  constructor(api: Api, store: Store) {
    this.api = api;
    this.store = store;
    store.subscribe((state, before) => {
      if (state.document?.id !== before.document?.id) this.flight.abort();
      if (state.document?.id !== before.document?.id || state.input !== before.input) void this.run();
    });
  }

  private async run() {
    if (this.running) return;
    this.running = true;
    await this.look().catch(() => undefined); // the server is asked again with the next edit
    this.running = false;
  }

  private async look() {
    while (this.next() !== null) {
      await this.quiet();
      const body = this.next(), // of what is open by now
        { state } = this.store,
        { document, input } = state;
      if (body === null || !document) break;
      this.flight = new AbortController();
      const of = optionsOf(input, body, bodyOf(state)),
        status = await lookAt(this.api, document.id, body, of, this.flight.signal).catch((error: unknown) =>
          this.otherOpened(document.id, error),
        );
      if (!status) continue;
      this.store.dispatch({ type: 'body', id: document.id, number: body, status });
    }
  }

  /** Null where the error is only that another file was opened meanwhile. */
  private otherOpened(id: string, error: unknown): null {
    if (this.store.state.document?.id === id) throw error;
    return null;
  }

  /** A body that is not known as it would be made now; the one that is shown makes itself known. */
  private next(): number | null {
    const { state } = this.store,
      all = state.document?.info?.bodies ?? [],
      shown = bodyOf(state);
    if (all.length < 2) return null;
    const known = (n: number) => state.bodies[n] && sameOptions(state.bodies[n].of, optionsOf(state.input, n, shown));
    return all.find((b) => (b.number !== shown || !state.bodies[b.number]) && !known(b.number))?.number ?? null;
  }

  private async quiet() {
    const busy = () => {
      const { computing, pending, opening, order, archive } = this.store.state;
      return computing || pending !== null || opening !== null || order.computing || archive !== null;
    };
    while (busy()) await new Promise((resolve) => setTimeout(resolve, poll));
  }
}
