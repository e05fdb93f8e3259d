import { Api, ApiError } from './api.ts';
import type { Bodies } from './bodies.ts';
import { patience, poll, problemOf } from './compute.ts';
import { keepDocument, keepSource, keptDocument } from './kept.ts';
import type { Recent, Recents } from './recents.ts';
import { partOptions, type Store } from './state.ts';
import { lookAt } from './survey.ts';
import type { OpenDocument, SlitSpec, Spec } from './types.ts';

interface Given {
  name: string;
  bytes: ArrayBuffer;
}

const looking = 5000; // ms in which a sheet among the bodies is found, or the first body is shown

/** Opening: the main file becomes the document, text files beside it the scans that it names. */
export class Documents {
  private readonly api: Api;
  private readonly store: Store;
  private readonly recents: Recents;
  private adopted: string | null = null;
  private file: Given | null = null;
  private beside: Record<string, ArrayBuffer> = {};
  private isInTab = true; // the file, from where a reload takes it
  private flight = new AbortController(); // of the file that is being opened
  constructor(api: Api, store: Store, recents: Recents) {
    this.api = api;
    this.store = store;
    this.recents = recents;
  }

  async openFiles(files: File[], isNew = false) {
    await this.attempt(files[0]?.name ?? '', async (signal) => {
      const given = await Promise.all(files.map(async (f) => ({ name: f.name, bytes: await f.arrayBuffer() })));
      const [main, ...others] = given.filter((g) => !isPoints(g.name)),
        points = given.filter((g) => isPoints(g.name));
      if (main) {
        await this.open(main, async (name) => points.find((p) => p.name === name)?.bytes ?? null, signal);
        if (!isNew) void this.remember(main);
      } else await this.addPoints(points);
      if (others.length)
        this.store.dispatch({
          type: 'note',
          note: `One file at a time: ${others.map((g) => g.name).join(', ')} was left out.`,
        });
    });
  }

  async openRecent(recent: Recent) {
    await this.attempt(recent.name, async (signal) => {
      const main = await this.openKept(recent, signal);
      void this.remember(main);
    });
  }

  private async openKept(recent: Recent, signal: AbortSignal): Promise<Given> {
    const { main, beside } = await this.recents.bytesOf(recent),
      given = { name: recent.name, bytes: main };
    await this.open(given, async (name) => beside[name] ?? null, signal);
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
      );
    });
  }

  /** The file that was open here before a reload, else the file of the command line. */
  async begin(ready: Promise<void>) {
    const kept = keptDocument();
    const source = kept?.source;
    const work = async (signal: AbortSignal) => {
      const isGiven = !source || 'given' in source,
        [known] = await Promise.all([isGiven ? this.api.documents() : [], ready]);
      if (kept && !isGiven) {
        if ('bytes' in source) await this.open(source, async (name) => source.beside[name] ?? null, signal);
        else {
          await this.openKept(source.recent, signal);
          keepSource(source);
        }
        return this.store.dispatch({ type: 'history', history: kept.history, order: kept.order });
      }
      const named = known.find((d) => d.given);
      if (!named) return;
      this.adopted = named.id;
      this.file = named.text
        ? { name: named.name, bytes: new TextEncoder().encode(named.text).buffer as ArrayBuffer }
        : null;
      await this.take(named, async () => null, signal);
      // The token is another one at each start, at which the file may have changed.
      if (kept && source && 'given' in source && source.given === location.hash)
        this.store.dispatch({ type: 'history', history: kept.history, order: kept.order });
      keepSource({ given: location.hash });
    };
    await this.attempt(source && 'bytes' in source ? source.name : '', work, true);
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

  /** Documents opened by others are not closed. */
  leave(id: string | undefined) {
    if (id && id !== this.adopted) void this.api.close(id).catch(() => undefined);
  }

  private async open(main: Given, beside: (name: string) => Promise<ArrayBuffer | null>, signal: AbortSignal) {
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
    );
    this.file = main;
    this.beside = used;
    this.isInTab = keepDocument(main, used);
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

  private async take(
    document: OpenDocument,
    beside: (name: string) => Promise<ArrayBuffer | null>,
    signal: AbortSignal,
  ) {
    const spec = document.text ? (JSON.parse(document.text) as Spec) : null;
    const missing: string[] = [];
    for (const file of pointFiles(document, spec)) {
      const bytes = await beside(file);
      if (bytes) await this.api.attach(document.id, file, bytes);
      else if (document.id !== this.adopted) missing.push(file);
    }
    if (signal.aborted) this.leave(document.id);
    signal.throwIfAborted();
    const before = this.store.state.document,
      { body, bodies } = await this.firstSheet(document, signal);
    this.store.dispatch({ type: 'opened', document, spec, body, bodies });
    if (missing.length) this.store.dispatch({ type: 'note', note: `Drop the scans as well: ${missing.join(', ')}` });
    this.leave(before?.id);
  }

  /** The first body of an assembly that is a sheet, if one is soon found: that is what one came for. */
  private async firstSheet(document: OpenDocument, signal: AbortSignal): Promise<{ body?: number; bodies: Bodies }> {
    const all = document.info?.bodies ?? [],
      of = partOptions(this.store.state, document),
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
    if (d?.kind !== 'slit')
      throw new ApiError(
        { code: 'no_slit_file', message: 'points belong to a slit file; open that first, or both together' },
        0,
      );
    for (const p of points) await this.api.attach(d.id, p.name, p.bytes);
    this.beside = { ...this.beside, ...Object.fromEntries(points.map((p) => [p.name, p.bytes])) };
    if (this.file) this.isInTab = keepDocument(this.file, this.beside);
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

const isPoints = (name: string) => /\.(xyz|txt|asc|csv)$/i.test(name);

function pointFiles(document: OpenDocument, spec: Spec | null): string[] {
  if (document.kind !== 'slit' || !spec) return [];
  return ((spec as SlitSpec).scan ?? []).flatMap((s) => (typeof s.points === 'string' ? [s.points] : []));
}
