import type { Api } from './api.ts';
import { problemOf } from './compute.ts';
import type { Store } from './state.ts';
import { emptyWorkshop, soundWorkshop, type Workshop } from './workshop-state.ts';

const file = 'workshop.json';

/** Keeps the workshop at the server, which has it on this machine's disk: a browser would keep it by the port. */
export class WorkshopKeeper {
  private known: Workshop = emptyWorkshop; // as it is kept, as far as this page has seen
  private saving = false;

  private readonly api: Api;
  private readonly store: Store;
  constructor(api: Api, store: Store) {
    this.api = api;
    this.store = store;
    store.subscribe((state, before) => {
      if (state.workshop !== before.workshop) void this.save();
    });
  }

  /** What was kept; nothing where it cannot be read. */
  async load() {
    this.known = await this.kept().catch(() => emptyWorkshop);
    this.store.dispatch({ type: 'workshop', workshop: this.known });
  }

  private async kept(): Promise<Workshop> {
    const there = (await this.api.kept()).some(({ name }) => name === file);
    return there ? soundWorkshop(JSON.parse(await this.api.readKept(file))) : emptyWorkshop;
  }

  /** One at a time, always the newest; what another page has changed meanwhile stays. */
  private async save() {
    if (this.saving) return;
    this.saving = true;
    try {
      while (this.store.state.workshop !== this.known) {
        const { workshop } = this.store.state,
          changed = Object.entries(workshop).filter(([key, value]) => this.known[key as keyof Workshop] !== value),
          before = await this.kept().catch(() => emptyWorkshop);
        await this.api.keep(file, JSON.stringify({ ...before, ...Object.fromEntries(changed) }));
        this.known = workshop;
      }
    } catch (error) {
      this.store.dispatch({ type: 'problem', problem: problemOf(error) });
    }
    this.saving = false;
  }
}
