import { Api, ApiError } from './api.ts';
import { geometryShown } from './timings.ts';
import type { Store } from './store.ts';
import type { ApiProblem, Request } from './types.ts';

const settle = 120; // ms without an edit before the whole result is asked for
export const patience = 500; // ms before a bar is shown
export const poll = 250;
const zooming = 150; // ms without zooming before curves are drawn finer
const restart = 120; // ms that a worker takes to restart after a cancelled request

/**
 * Keeps the shape in step with the input: drafts during editing, one at a time and always of the newest input, and the
 * result when editing pauses.
 */
export class Computation {
  private draftWanted = false;
  private resultWanted = false;
  private running: 'draft' | 'result' | null = null;
  private timer = 0;
  private busyTimer = 0;
  private dragAt: number | null = null;
  private generation = 0;
  private flight = new AbortController(); // of the request that is running
  private startedAt = 0;
  private resultTook = 0;
  private superseded = false;
  private chord = Infinity; // of the result that is shown
  private refining = false; // what is shown is asked for again, only finer
  private zoomTimer = 0;
  private givenUp: Promise<unknown> | null = null; // a result that an edit has made pointless is being cancelled

  private readonly api: Api;
  private readonly store: Store;
  private readonly reopen: () => Promise<boolean>;
  private readonly wantedChord: (shown: number) => number; // how far polygons may lie from curves as they are seen
  constructor(api: Api, store: Store, reopen: () => Promise<boolean>, wantedChord: (shown: number) => number) {
    this.reopen = reopen;
    this.wantedChord = wantedChord;
    this.api = api;
    this.store = store;
    store.subscribe((state, before) => {
      if (state.document?.id !== before.document?.id) this.restart();
      else if (state.input !== before.input || (before.pending && !state.pending))
        this.edited(state.input !== before.input, state.pending !== null);
    });
  }

  /** The next edit comes from a drag; it is timed from now. */
  dragged(at: number) {
    this.dragAt ??= at;
  }

  cancel() {
    const id = this.store.state.document?.id;
    this.resultWanted = this.draftWanted = false;
    clearTimeout(this.timer);
    if (id && this.running) this.stop(id);
  }

  finish() {
    this.resultWanted = true;
    void this.next();
  }

  /** Curves that are seen larger are drawn finer, once zooming pauses. */
  zoomed() {
    clearTimeout(this.zoomTimer);
    this.zoomTimer = window.setTimeout(() => {
      const { result, shape, shapeIsDraft, pending, stale } = this.store.state;
      if (!result?.facet_parent.length || result !== shape || shapeIsDraft || pending || stale) return;
      if (this.running || this.wantedChord(this.chord) >= this.chord) return;
      this.refining = this.resultWanted = true;
      void this.next();
    }, zooming);
  }

  private restart() {
    this.chord = Infinity;
    this.refining = false;
    ++this.generation;
    this.flight.abort();
    this.superseded = false;
    this.resultTook = 0;
    this.givenUp = null;
    this.running = null;
    this.draftWanted = this.store.state.document !== null;
    this.resultWanted = this.draftWanted;
    this.quiet();
    void this.next();
  }

  private edited(changed: boolean, live: boolean) {
    clearTimeout(this.timer);
    if (changed) this.draftWanted = true;
    this.resultWanted = false;
    if (changed) this.giveUpResult();
    if (!live)
      this.timer = window.setTimeout(() => {
        this.resultWanted = true;
        void this.next();
      }, settle);
    void this.next();
  }

  /** A result that would delay the draft for longer than a worker takes to restart. */
  private giveUpResult() {
    const { document, input } = this.store.state,
      left = this.resultTook - (performance.now() - this.startedAt);
    if (
      this.running !== 'result' ||
      this.refining ||
      this.givenUp ||
      !document ||
      !input.spec || // a file that is read again takes longer
      left < restart
    )
      return;
    this.stop(document.id);
    this.superseded = true;
  }

  /** Ends the running request, here at once and at the server; the next one waits until the server has done so. */
  private stop(id: string) {
    this.givenUp = this.api.cancel(id).catch(() => undefined);
    this.flight.abort();
  }

  private async next() {
    const { document, input } = this.store.state;
    if (this.running || !document || !(this.draftWanted || this.resultWanted)) return;
    const what = this.draftWanted ? 'draft' : 'result';
    if (what === 'draft') this.draftWanted = false;
    else this.resultWanted = false;
    if (what === 'draft') this.refining = false;
    const chord = what === 'result' ? this.wantedChord(this.chord) : undefined;
    const generation = this.generation;
    const draggedAt = this.dragAt;
    this.dragAt = null;
    this.running = what;
    this.flight = new AbortController();
    this.started(document.id);
    let ahead = false;
    try {
      const request: Request = { spec: input.spec ?? undefined, options: input.options, chord };
      const shape = await (what === 'draft'
        ? this.api.draft(document.id, request, this.flight.signal)
        : this.api.result(document.id, request, this.flight.signal));
      if (what === 'result' && !this.refining) this.resultTook = performance.now() - this.startedAt;
      if (generation !== this.generation) return;
      ahead = this.askAhead();
      if (chord !== undefined) this.chord = chord;
      this.store.dispatch({ type: 'shape', shape, draft: what === 'draft' });
      if (draggedAt !== null) geometryShown(draggedAt);
    } catch (error) {
      if (generation === this.generation) await this.failed(error);
    }
    if (ahead) return;
    await this.givenUp; // so that it cannot end the next request
    this.givenUp = null;
    this.superseded = false;
    if (generation !== this.generation) return;
    this.running = null;
    this.refining = false;
    this.quiet();
    if (what === 'result') this.zoomed(); // the views may have been fitted, or zoomed, meanwhile
    void this.next();
  }

  /** The next draft is requested before this one is drawn, so that the server computes it meanwhile. */
  private askAhead(): boolean {
    if (!this.draftWanted || this.givenUp) return false;
    this.running = null;
    this.quiet();
    void this.next();
    return true;
  }

  private async failed(error: unknown) {
    // begins anew by itself
    if (error instanceof ApiError && error.status === 404 && (await this.reopen().catch(() => false))) return;
    const problem = problemOf(error);
    if (problem.code === 'cancelled' && this.superseded) return;
    if (problem.code === 'cancelled') this.store.dispatch({ type: 'note', note: 'cancelled' });
    else this.store.dispatch({ type: 'problem', problem, ofInput: true });
  }

  private started(id: string) {
    this.startedAt = performance.now();
    this.store.dispatch({ type: 'computing', computing: true });
    if (this.busyTimer) return;
    const look = async () => {
      const progress = await this.api.progress(id).catch(() => null);
      if (this.running) this.store.dispatch({ type: 'busy', busy: true, progress });
      if (this.running) this.busyTimer = window.setTimeout(look, poll);
    };
    this.busyTimer = window.setTimeout(look, patience);
  }

  private quiet() {
    clearTimeout(this.busyTimer);
    this.busyTimer = 0;
    if (this.store.state.computing || this.store.state.busy) {
      this.store.dispatch({ type: 'computing', computing: false });
      this.store.dispatch({ type: 'busy', busy: false });
    }
  }
}

export const problemOf = (error: unknown): ApiProblem =>
  error instanceof ApiError
    ? error.problem
    : { code: 'page', message: error instanceof Error ? error.message : String(error) };
