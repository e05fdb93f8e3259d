import { Api, ApiError } from './api.ts';
import type { Bodies } from './bodies.ts';
import { patience, poll, problemOf } from './compute.ts';
import { EditedCopies, type Begun } from './edited-copies.ts';
import { isAtStart, keepDocument, keepSource, keepTab, keptDocument, keptTab, type Kept } from './kept.ts';
import { partOptions } from './open-state.ts';
import type { Recent, Recents } from './recents.ts';
import { makerOf, type OptionsSet } from './state.ts';
import type { Store } from './store.ts';
import { lookAt } from './survey.ts';
import type { OpenDocument, Spec } from './types.ts';
import type { SlitSpec } from './edits/slit-types.ts';

interface Given {
  name: string;
  bytes: ArrayBuffer;
}
type Beside = (name: string) => Promise<ArrayBuffer | null>;
type How = Pick<Begun, 'isNew' | 'recent' | 'listed' | 'isRestored'>;

const looking = 5000; // ms in which a sheet among the bodies is found, or the first body is shown

/** Opening: the main file becomes the document, text files beside it the scans that it names. */
export class Documents {
  private readonly api: Api;
  private readonly store: Store;
  private readonly recents: Recents;
  private adopted: string | null = null;
  private adoptedSet: OptionsSet | undefined; // as it was left
  private file: Given | null = null;
  private beside: Record<string, ArrayBuffer> = {};
  private isInTab = true; // the file, from where a reload takes it
  private flight = new AbortController(); // of the file that is being opened
  readonly copies: EditedCopies;
  constructor(api: Api, store: Store, recents: Recents) {
    this.api = api;
    this.store = store;
    this.recents = recents;
    this.copies = new EditedCopies(store, recents);
  }

  async openFiles(files: File[], isNew = false) {
    await this.attempt(files[0]?.name ?? '', async (signal) => {
      const given = await Promise.all(files.map(async (f) => ({ name: f.name, bytes: await f.arrayBuffer() })));
      const [main, ...others] = given.filter((g) => !isPoints(g.name)),
        points = given.filter((g) => isPoints(g.name));
      if (main) {
        const beside: Beside = async (name) => points.find((p) => p.name === name)?.bytes ?? null;
        await this.open(main, beside, signal, { isNew, listed: !isNew });
        if (!isNew) void this.remember(main);
      } else await this.addPoints(points);
      const said = leftOut(
        others.map((g) => g.name),
        main ? points.flatMap(({ name }) => (name in this.beside ? [] : [name])) : [],
      );
      if (said) this.store.dispatch({ type: 'note', note: [this.store.state.note ?? '', said].join(' ').trim() });
    });
  }

  async openRecent(recent: Recent) {
    await this.attempt(recent.name, async (signal) => {
      const kept = await this.recents.asKept(recent),
        main = await this.openKept(kept, signal);
      if (!kept.edited) void this.remember(main);
      else if ((await this.recents.again(kept)) && !this.isInTab) keepSource({ recent: kept });
    });
  }

  private async openKept(recent: Recent, signal: AbortSignal, how: How = {}): Promise<Given> {
    const { main, beside } = await this.recents.bytesOf(recent),
      given = { name: recent.name, bytes: main };
    await this.open(given, async (name) => beside[name] ?? null, signal, { recent, listed: true, ...how });
    return given;
  }

  /** Among the files opened lately, from where a reload takes one that is too large for the tab. */
  private async remember({ name, bytes }: Given) {
    const { document: opened } = this.store.state,
      recent = await this.recents.opened(name, bytes, this.beside);
    if (recent && !this.isInTab && this.store.state.document?.id === opened?.id) keepSource({ recent });
  }

  async openExample(name: string) {
    await this.attempt(name, async (signal) => {
      const folder = name.includes('/') ? name.slice(0, name.lastIndexOf('/') + 1) : '';
      await this.open(
        { name: name.slice(folder.length), bytes: await this.api.example(name) },
        (file) => this.api.example(folder + file).catch(() => null),
        signal,
        {},
      );
    });
  }

  /** The file of the command line, once more. */
  async openGiven() {
    const { given } = this.store.state;
    if (given) await this.attempt(given.name, (signal) => this.takeGiven(given, signal, false));
  }

  /** Back to the start page. What was edited is kept among the files opened lately. */
  close() {
    this.flight.abort();
    const { document } = this.store.state;
    this.end();
    this.file = null;
    this.beside = {};
    keepSource({ start: location.hash });
    this.store.dispatch({ type: 'closed' });
    this.leave(document?.id);
  }

  /** The file that was open here before a reload, else the file of the command line. */
  async begin(ready: Promise<void>) {
    const kept = keptDocument();
    const source = kept?.source,
      tab = keptTab(),
      restored = { isRestored: true };
    const restore = ({ history, order }: Kept) => {
      this.store.dispatch({ type: 'history', history, order });
      this.store.dispatch({ type: 'tab', tab });
    };
    this.store.subscribe((state, before) => {
      if (state.tab !== before.tab) keepTab(state.tab);
    });
    const work = async (signal: AbortSignal) => {
      const isGiven = !source || 'given' in source,
        [known] = await Promise.all([isGiven ? this.api.documents() : [], ready]);
      if (kept && !isGiven) {
        if ('bytes' in source) await this.open(source, async (name) => source.beside[name] ?? null, signal, restored);
        else {
          await this.openKept(source.recent, signal, restored);
          keepSource(source);
        }
        return restore(kept);
      }
      const named = known.find((d) => d.given);
      if (!named) return;
      this.adopted = named.id;
      this.store.dispatch({ type: 'given', document: named });
      if (isAtStart(location.hash)) return;
      // The token is another one at each start, at which the file may have changed.
      const isSame = kept && source && 'given' in source && source.given === location.hash;
      await this.takeGiven(named, signal, Boolean(isSame));
      if (isSame) restore(kept);
    };
    await this.attempt(source && 'bytes' in source ? source.name : '', work, true);
  }

  private async takeGiven(given: OpenDocument, signal: AbortSignal, isRestored: boolean) {
    const bytes = given.text ? (new TextEncoder().encode(given.text).buffer as ArrayBuffer) : null;
    await this.take(given, async () => null, signal, bytes ? undefined : this.adoptedSet);
    this.file = bytes && { name: given.name, bytes };
    this.beside = {};
    if (this.file) this.copies.begin({ ...this.file, beside: {}, isRestored });
    keepSource({ given: location.hash });
  }

  /**
   * Opens the same file again if the server has dropped the document; the edits stay. False if the file is not known.
   */
  async reopen(): Promise<boolean> {
    const { file } = this;
    if (!file) return false;
    const document = await this.read(file);
    for (const [name, bytes] of Object.entries(this.beside)) await this.api.attach(document.id, name, bytes);
    this.store.dispatch({ type: 'reopened', document });
    return true;
  }

  /** Abandons the file being opened; the previous document stays. */
  cancel() {
    this.flight.abort();
  }

  /** The page is left, for good or not. */
  hidden() {
    this.copies.rest();
    this.leave(this.store.state.document?.id);
  }

  /** Documents opened by others are not closed. */
  private leave(id: string | undefined) {
    if (id && id !== this.adopted) void this.api.close(id).catch(() => undefined);
  }

  private async open(main: Given, beside: Beside, signal: AbortSignal, how: How) {
    const document = await this.read(main, signal),
      used: Record<string, ArrayBuffer> = {};
    await this.take(
      document,
      async (name) => {
        const bytes = await beside(name);
        if (bytes) used[name] = bytes;
        return bytes;
      },
      signal,
      how.recent?.set,
    );
    this.file = main;
    this.beside = used;
    this.isInTab = keepDocument(main, used);
    this.copies.begin({ ...main, beside: used, ...how });
  }

  /** Has the server read a file. A file that cannot be read, or is abandoned, leaves no document behind. */
  private async read({ name, bytes }: Given, signal?: AbortSignal): Promise<OpenDocument> {
    const { id } = await this.api.create(name, bytes),
      watched = this.watch(id);
    try {
      return await this.api.open(id, signal);
    } catch (error) {
      if (signal?.aborted) await this.api.cancel(id).catch(() => undefined);
      this.leave(id);
      throw error;
    } finally {
      watched();
    }
  }

  /** Says how far the reading of a file is, from when it has taken long; until it is called off. */
  private watch(id: string): () => void {
    let timer = 0;
    const look = async () => {
      const asked = timer,
        progress = await this.api.progress(id).catch(() => null),
        { opening } = this.store.state;
      if (asked !== timer || !opening) return;
      this.store.dispatch({ type: 'opening', opening: { ...opening, long: true, progress } });
      timer = window.setTimeout(look, poll);
    };
    timer = window.setTimeout(look, patience);
    return () => {
      clearTimeout(timer);
      timer = 0;
    };
  }

  private async take(document: OpenDocument, beside: Beside, signal: AbortSignal, set?: OptionsSet) {
    const spec = document.text ? (JSON.parse(document.text) as Spec) : null;
    const missing: string[] = [];
    for (const file of pointFiles(spec)) {
      const bytes = await beside(file);
      if (bytes) await this.api.attach(document.id, file, bytes);
      else if (document.id !== this.adopted) missing.push(file);
    }
    if (signal.aborted) this.leave(document.id);
    signal.throwIfAborted();
    const sheet = await this.firstSheet(document, set, signal),
      before = this.store.state.document,
      isKept = this.end();
    this.store.dispatch({ type: 'opened', document, spec, ...sheet, set });
    if (isKept) this.store.dispatch({ type: 'note', note: `${before?.name} is kept as edited: see the start page.` });
    if (missing.length) this.store.dispatch({ type: 'note', note: `Drop the scans as well: ${missing.join(', ')}` });
    this.leave(before?.id);
  }

  /** What is open is left: says whether it was edited and is kept. */
  private end(): boolean {
    const { document, pending, input } = this.store.state,
      { spec: _, ...set } = pending ?? input;
    if (document && document.id === this.adopted) this.adoptedSet = set;
    return this.copies.end();
  }

  /** The first body of an assembly that is a sheet, if one is soon found: that is what one came for. */
  private async firstSheet(
    document: OpenDocument,
    set: OptionsSet | undefined,
    signal: AbortSignal,
  ): Promise<{ body?: number; bodies: Bodies }> {
    if (set) return { bodies: {} }; // of the body that was chosen
    const all = document.info?.bodies ?? [],
      of = partOptions(this.store.state),
      bodies: Bodies = {},
      end = performance.now() + looking;
    for (const { number } of all.length > 1 ? all : []) {
      bodies[number] = await lookAt(this.api, document.id, number, of, signal);
      signal.throwIfAborted();
      if (bodies[number].status !== 'refused') return { body: number === all[0]!.number ? undefined : number, bodies };
      if (performance.now() > end) break;
    }
    return { bodies };
  }

  private async addPoints(points: Given[]) {
    const d = this.store.state.document;
    if (!d || !makerOf(this.store.state)?.names_files)
      throw new ApiError(
        { code: 'no_slit_file', message: 'points belong to a slit file; open that first, or both together' },
        0,
      );
    for (const p of points) await this.api.attach(d.id, p.name, p.bytes);
    this.beside = { ...this.beside, ...Object.fromEntries(points.map((p) => [p.name, p.bytes])) };
    if (this.file) this.isInTab = keepDocument(this.file, this.beside);
    this.copies.besides(this.beside);
    this.store.dispatch({ type: 'edit', input: { ...this.store.state.input } });
  }

  /** Opens the latest request; a file still being opened is abandoned. */
  private async attempt(name: string, work: (signal: AbortSignal) => Promise<void>, first = false) {
    this.flight.abort();
    const flight = new AbortController(),
      say: Store['dispatch'] = (action) => {
        if (flight === this.flight) this.store.dispatch(action);
      };
    this.flight = flight;
    say({ type: 'opening', opening: { name, first, long: false, progress: null } });
    try {
      await work(flight.signal);
    } catch (error) {
      say(flight.signal.aborted ? { type: 'note', note: 'cancelled' } : { type: 'problem', problem: problemOf(error) });
    }
    say({ type: 'opening', opening: null });
  }
}

/** What is said of files that were dropped with one that was opened. */
function leftOut(others: string[], points: string[]): string {
  return [
    ...(others.length ? [`One file at a time; left out: ${others.join(', ')}.`] : []),
    ...(points.length ? [`Not opened: ${points.join(', ')}, which the file does not name.`] : []),
  ].join(' ');
}

const isPoints = (name: string) => /\.(xyz|txt|asc|csv)$/i.test(name);

function pointFiles(spec: Spec | null): string[] {
  return ((spec as SlitSpec | null)?.scan ?? []).flatMap((s) => (typeof s.points === 'string' ? [s.points] : []));
}
