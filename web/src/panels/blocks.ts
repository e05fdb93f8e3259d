import { html, nothing } from 'lit-html';
import type { Selection } from '../state.ts';
import type { Ui } from '../ui.ts';

/** A row of a list that opens when it is picked: what its head says, and what it holds. */
export interface Block<Key extends keyof Selection> {
  picks: { [K in Key]: NonNullable<Selection[K]> };
  testid: string;
  head: { name: unknown; said: unknown; aside: unknown };
  content: () => unknown;
}

export function block<Key extends keyof Selection>(ui: Ui, { picks, testid, head, content }: Block<Key>) {
  const [[key, id]] = Object.entries(picks) as [[Key, unknown]],
    open = ui.state.selection[key] === id;
  return html`<div class="block ${open ? 'open' : ''}">
    <button
      class="head"
      data-testid=${testid}
      aria-expanded=${open}
      @click=${() => ui.dispatch({ type: 'select', selection: { [key]: open ? null : id } })}
    >
      <b>${head.name}</b><span>${head.said}</span><em>${head.aside}</em>
    </button>
    ${open ? content() : nothing}
  </div>`;
}

/** One of the buttons between which something is chosen. */
export const segment = (text: string, testid: string, chosen: boolean, on: () => void) =>
  html`<button data-testid=${testid} class=${chosen ? 'on' : ''} @click=${on}>${text}</button>`;
