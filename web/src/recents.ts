import { ApiError, type Api } from './api.ts';
import { pictureOf, type Picture } from './bodies.ts';
import type { OptionsSet, State } from './state.ts';
import type { Store } from './store.ts';
import type { Kind } from './types.ts';

/** A file that was opened lately. Its bytes, and those of the files beside it, are kept on this machine. */
export interface Recent {
  key: string; // of its name and bytes, or its own if it was edited here
  name: string;
  kind: Kind;
  beside: string[];
  picture?: Picture;
  edited?: 'new' | 'file'; // it is kept as it was edited here; a new one was made here
  set?: OptionsSet; // as they were left
}

export const recentList = 'recent.json';
const most = 8;
const fileOf = (key: string, number = 0) => `recent-${key}-${number}`;

/** Files that were opened lately, the last first; those that cannot be kept are left out. */
export class Recents {
  private readonly api: Api;
  private readonly store: Store;
  private pending: Promise<unknown> = Promise.resolve();
  private latest: { key: string; document: string } | null = null;

  constructor(api: Api, store: Store) {
    this.api = api;
    this.store = store;
    store.subscribe((state, before) => {
      if (state.result !== before.result) this.pictured(state);
    });
  }

  /** A file that was opened as a document, with the files beside it. */
  opened(name: string, bytes: ArrayBuffer, beside: Record<string, ArrayBuffer>): Promise<Recent | null> {
    const { id, kind } = this.store.state.document!;
    return this.then(async () => {
      const key = await keyOf(name, bytes),
        others = Object.entries(beside),
        known = this.all.find((r) => r.key === key);
      const own: Recent = { key, name, kind, beside: others.map(([n]) => n), picture: known?.picture };
      try {
        if (!known || known.beside.join() !== own.beside.join()) {
          await this.api.keep(fileOf(key), new Blob([bytes]));
          for (const [i, [, other]] of others.entries()) await this.api.keep(fileOf(key, i + 1), new Blob([other]));
        }
        this.latest = { key, document: id };
        await this.write([own, ...this.all.filter((r) => r.key !== key)]);
      } catch {
        if (!known) await this.drop(own); // a part of it would stay without an entry
        return null;
      }
      this.pictured(this.store.state);
      return own;
    });
  }

  /** What was edited, as it is now; `rewritten`: its bytes, too. All at once, as the page may be closing. */
  keepEdited(own: Recent, main: ArrayBuffer, beside: Record<string, ArrayBuffer>, rewritten: boolean) {
    return this.then(async () => {
      const known = this.all.find((r) => r.key === own.key),
        others = Object.values(beside),
        isBeside = known?.beside.join() === own.beside.join();
      try {
        await Promise.all([
          !known || rewritten ? this.api.keep(fileOf(own.key), new Blob([main])) : null,
          ...(isBeside ? [] : others.map((other, i) => this.api.keep(fileOf(own.key, i + 1), new Blob([other])))),
          this.write([
            { ...own, picture: own.picture ?? known?.picture },
            ...this.all.filter((r) => r.key !== own.key),
          ]),
        ]);
      } catch {
        if (!known) await this.write(this.all.filter((r) => r.key !== own.key)).catch(() => this.drop(own));
        return null;
      }
      return own;
    });
  }

  /** Has been opened again: the first of all. */
  again(recent: Recent) {
    return this.then(async () => {
      await this.write([recent, ...this.all.filter((r) => r.key !== recent.key)]);
      return recent;
    });
  }

  remove(key: string) {
    return this.then(async () => {
      await this.write(this.all.filter((r) => r.key !== key));
      return true;
    });
  }

  /** The entry once all that was left is kept: it may be chosen in a list that does not show its last edits yet. */
  async asKept(recent: Recent): Promise<Recent> {
    await this.pending;
    return this.all.find((r) => r.key === recent.key) ?? recent;
  }

  async bytesOf(recent: Recent): Promise<{ main: ArrayBuffer; beside: Record<string, ArrayBuffer> }> {
    const { key, name, beside } = recent;
    try {
      const entries = beside.map(async (other, i) => [other, await this.api.kept(fileOf(key, i + 1))] as const);
      return { main: await this.api.kept(fileOf(key)), beside: Object.fromEntries(await Promise.all(entries)) };
    } catch (error) {
      if (!(error instanceof ApiError && error.status === 404)) throw error;
      void this.then(() => this.write(this.all.filter((r) => r.key !== key)));
      throw new ApiError(
        { code: 'not_found', message: `${name} is no longer kept on this machine; open it again` },
        404,
      );
    }
  }

  forget() {
    void this.then(() => this.write([]));
  }

  private get all() {
    return this.store.state.recents;
  }

  /** The picture of a file is that of its first result. */
  private pictured({ document, result }: State) {
    const { latest } = this;
    if (!result || !latest || document?.id !== latest.document) return;
    const picture = pictureOf(result);
    this.latest = null;
    if (picture) void this.then(() => this.write(this.all.map((r) => (r.key === latest.key ? { ...r, picture } : r))));
  }

  private async write(recents: Recent[]) {
    const kept = recents.slice(0, most),
      gone = this.all.filter((r) => !kept.some((k) => k.key === r.key));
    await this.api.keep(recentList, new Blob([JSON.stringify(kept)]));
    this.store.dispatch({ type: 'recents', recents: kept });
    for (const one of gone) await this.drop(one);
  }

  private async drop({ key, beside }: Recent) {
    for (let i = 0; i <= beside.length; ++i) await this.api.forget(fileOf(key, i)).catch(() => undefined);
  }

  /** One thing after the other. A machine on which nothing can be kept has no recent files, and that is all. */
  private then<T>(work: () => Promise<T>): Promise<T | null> {
    const done = this.pending.then(work).catch(() => null);
    this.pending = done;
    return done;
  }
}

export async function keyOf(name: string, bytes: ArrayBuffer): Promise<string> {
  const digest = await crypto.subtle.digest('SHA-256', await new Blob([name, '\n', bytes]).arrayBuffer());
  return [...new Uint8Array(digest).subarray(0, 12)].map((b) => b.toString(16).padStart(2, '0')).join('');
}
