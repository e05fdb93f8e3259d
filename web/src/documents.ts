import { Api, ApiError } from './api.ts';
import { problemOf } from './compute.ts';
import { keepDocument, keptDocument, noteOpened, openedHere } from './kept.ts';
import type { Store } from './state.ts';
import type { OpenDocument, SlitSpec, Spec } from './types.ts';

interface Given { name: string; bytes: ArrayBuffer }

/** Opening: the main file becomes the document, text files beside it the scans that it names. */
export class Documents {
  private readonly api: Api;
  private readonly store: Store;
  private adopted: string | null = null;
  private file: Given | null = null;
  private turn = 0;
  private beside: Record<string, ArrayBuffer> = {};
  constructor(api: Api, store: Store) {
    this.api = api;
    this.store = store;
  }

  async openFiles(files: File[]) {
    await this.attempt(async () => {
      const given = await Promise.all(files.map(async (f) => ({ name: f.name, bytes: await f.arrayBuffer() })));
      const main = given.find((g) => !isPoints(g.name)), points = given.filter((g) => isPoints(g.name));
      if (main) await this.open(main, async (name) => points.find((p) => p.name === name)?.bytes ?? null);
      else await this.addPoints(points);
    }, `Opening ${files[0]?.name ?? ''} …`);
  }

  async openExample(name: string) {
    await this.attempt(async () => {
      const folder = name.includes('/') ? name.slice(0, name.lastIndexOf('/') + 1) : '';
      await this.open({ name: name.slice(folder.length), bytes: await this.api.example(name) }, (file) => this.api.example(folder + file).catch(() => null));
    }, `Opening ${name} …`);
  }

  /** What was open here before the page was loaded again, else the file that was named on the command line. */
  async begin() {
    await this.attempt(async () => {
      const kept = keptDocument();
      if (kept) {
        await this.open(kept, async (name) => kept.beside[name] ?? null);
        return this.store.dispatch({ type: 'edit', input: kept.input });
      }
      const open = await this.api.documents().catch(() => []), named = open.find((d) => d.id === 'd1' && !openedHere(d.id)); // the first one; others belong to other pages
      if (named) {
        this.adopted = named.id;
        this.file = named.text ? { name: named.name, bytes: new TextEncoder().encode(named.text).buffer as ArrayBuffer } : null;
        await this.take(named, async () => null);
      }
    });
  }

  /** The same file once more, when the server has let the document go; the edits stay. False where the file is not known. */
  async reopen(): Promise<boolean> {
    const { file } = this;
    if (!file) return false;
    const document = await this.api.open(file.name, file.bytes);
    noteOpened(document.id);
    for (const [name, bytes] of Object.entries(this.beside)) await this.api.attach(document.id, name, bytes);
    this.store.dispatch({ type: 'reopened', document });
    return true;
  }

  /** Documents that others opened are left to them. */
  leave(id: string | undefined) {
    if (id && id !== this.adopted) void this.api.close(id).catch(() => undefined);
  }

  private async open(main: Given, beside: (name: string) => Promise<ArrayBuffer | null>) {
    const turn = ++this.turn, document = await this.api.open(main.name, main.bytes);
    noteOpened(document.id);
    if (turn !== this.turn) return this.leave(document.id); // another file was opened meanwhile
    this.file = main;
    const used: Record<string, ArrayBuffer> = {};
    await this.take(document, async (name) => {
      const bytes = await beside(name);
      if (bytes) used[name] = bytes;
      return bytes;
    });
    this.beside = used;
    keepDocument(main, used);
  }

  private async take(document: OpenDocument, beside: (name: string) => Promise<ArrayBuffer | null>) {
    const spec = document.text ? (JSON.parse(document.text) as Spec) : null;
    const missing: string[] = [];
    for (const file of pointFiles(document, spec)) {
      const bytes = await beside(file);
      if (bytes) await this.api.attach(document.id, file, bytes);
      else if (document.id !== this.adopted) missing.push(file);
    }
    const before = this.store.state.document;
    this.store.dispatch({ type: 'opened', document, spec });
    if (missing.length) this.store.dispatch({ type: 'note', note: `Drop the scans as well: ${missing.join(', ')}` });
    this.leave(before?.id);
  }

  private async addPoints(points: Given[]) {
    const d = this.store.state.document;
    if (d?.kind !== 'slit') throw new ApiError({ code: 'no_slit_file', message: 'points belong to a slit file; open that first, or both together' }, 0);
    for (const p of points) await this.api.attach(d.id, p.name, p.bytes);
    this.beside = { ...this.beside, ...Object.fromEntries(points.map((p) => [p.name, p.bytes])) };
    if (this.file) keepDocument(this.file, this.beside);
    this.store.dispatch({ type: 'edit', input: { ...this.store.state.input } });
  }

  private async attempt(work: () => Promise<void>, note: string | null = null) {
    this.store.dispatch({ type: 'problem', problem: null });
    this.store.dispatch({ type: 'note', note });
    try {
      await work();
      if (this.store.state.note === note) this.store.dispatch({ type: 'note', note: null });
    } catch (error) {
      this.store.dispatch({ type: 'problem', problem: problemOf(error) });
    }
  }
}

const isPoints = (name: string) => /\.(xyz|txt|asc|csv)$/i.test(name);

function pointFiles(document: OpenDocument, spec: Spec | null): string[] {
  if (document.kind !== 'slit' || !spec) return [];
  return ((spec as SlitSpec).scan ?? []).flatMap((s) => (typeof s.points === 'string' ? [s.points] : []));
}
