import { html, nothing, svg, type TemplateResult } from 'lit-html';
import { ref } from 'lit-html/directives/ref.js';
import { guard } from 'lit-html/directives/guard.js';
import { withBody, type BodyStatus, type Picture } from '../bodies.ts';
import { bodyOf } from '../state.ts';
import type { BodyInfo } from '../types.ts';
import type { Ui } from '../ui.ts';
import { gaugeText, lengthText, unitName } from '../units.ts';
import { section } from './fields.ts';

/** The bodies of an assembly: what became of each, and which one is shown. */
export function bodyList(ui: Ui): TemplateResult | typeof nothing {
  const { bodies: known, sheetsOnly, units, document } = ui.state,
    all = document?.info?.bodies ?? [],
    shown = bodyOf(ui.state);
  if (all.length < 2) return nothing;
  const sheets = all.filter((b) => isSheet(known[b.number])),
    waiting = all.filter((b) => !known[b.number]).length,
    title = `${all.length} bodies, ${sheets.length}${waiting ? ' or more' : ''} of them ${plural(sheets.length)}`,
    rows = sheetsOnly ? all.filter((b) => b.number === shown || isSheet(known[b.number])) : all;
  return section(
    title,
    html`${guard(
      [known, sheetsOnly, units, all, shown],
      () =>
        html`<div
          class="bodies"
          role="listbox"
          aria-label="Bodies"
          data-testid="bodies"
          ${ref((list) => list && showChosen(list as HTMLElement, `${document?.id} ${shown} ${sheetsOnly}`))}
          @keydown=${(e: KeyboardEvent) => step(e)}
        >
          ${rows.map((b) => row(ui, b, known[b.number], b.number === shown))}
        </div>`,
    )}${archiveRow(ui, sheets.length)}`,
    html`<label class="only"
      ><input
        type="checkbox"
        data-testid="sheets-only"
        .checked=${sheetsOnly}
        @change=${(e: Event) =>
          ui.dispatch({ type: 'sheets-only', sheetsOnly: (e.target as HTMLInputElement).checked })}
      />sheets only</label
    >`,
  );
}

const shownFor = new WeakMap<HTMLElement, string>();

/** Moves the list, and nothing else, to the body that is shown, once for each. */
function showChosen(list: HTMLElement, chosen: string) {
  if (shownFor.get(list) === chosen) return;
  shownFor.set(list, chosen);
  const show = () => {
    const row = list.querySelector('[aria-selected=true]')?.getBoundingClientRect(),
      box = list.getBoundingClientRect();
    if (!row || (row.top >= box.top && row.bottom <= box.bottom)) return;
    list.scrollTop += row.top + row.height / 2 - (box.top + box.height / 2);
  };
  queueMicrotask(show); // its rows are drawn by then
  requestAnimationFrame(show); // rows out of sight have heights of their own once they are seen
}

const plural = (sheets: number) => (sheets === 1 ? 'a sheet' : 'sheets');

const isSheet = (known: BodyStatus | undefined) => known !== undefined && known.status !== 'refused';

function row(ui: Ui, b: BodyInfo, known: BodyStatus | undefined, shown: boolean) {
  const { units } = ui.state,
    text = (v: number | null) => lengthText(v, known?.units, units),
    name = b.name || `body ${b.number}`;
  const sizes = [
    typeof known?.thickness === 'number' && isSheet(known) ? `t ${gaugeText(known.thickness, known.units, units)}` : '',
    known?.size ? `${text(known.size[0])} × ${text(known.size[1])} ${unitName(units)}` : '',
  ].filter(Boolean);
  return html`<button
    role="option"
    class="body ${known?.status ?? 'unknown'}"
    data-testid="body-${b.number}"
    aria-selected=${shown}
    tabindex=${shown ? 0 : -1}
    title=${known?.message ? `${name}\n${known.message}` : name}
    @click=${() => choose(ui, b.number)}
  >
    ${drawing(known?.picture)}
    <span class="what"
      ><b><span class="number">${b.number} · </span>${cutInTheMiddle(name)}</b><small>${sizes.join(' · ')}</small
      ><small class="said">${said(known)}</small></span
    >
    <span class="count" aria-label="${b.quantity} of them">× ${b.quantity}</span>
  </button>`;
}

const tail = 14; // characters at the end of a name that are always seen: there names of one maker differ

const cutInTheMiddle = (name: string) =>
  html`<span class="head">${name.slice(0, -tail)}</span><span class="tail">${name.slice(-tail)}</span>`;

const said = (known: BodyStatus | undefined): string =>
  known === undefined
    ? 'not looked at yet'
    : known.status === 'refused'
      ? `no flat pattern: ${(known.code ?? 'refused').replaceAll('_', ' ')}`
      : known.status === 'warning'
        ? 'sheet, with warnings'
        : 'sheet';

/** The pattern, or the solid; as long as neither is known an empty frame. */
export const drawing = (p: Picture | undefined) =>
  html`<svg class="pattern" viewBox="-2 -2 ${(p?.width ?? 0) + 4} ${(p?.height ?? 0) + 4}" aria-hidden="true">
    ${p?.image ? svg`<image href=${p.image} width=${p.width} height=${p.height}></image>` : nothing}
    ${p && !p.image
      ? svg`<path class="sheet" d=${p.sheet} fill-rule="evenodd"></path><path class="up" d=${p.up}></path><path
          class="down" d=${p.down}></path>`
      : nothing}
  </svg>`;

/** What was set for one body only waits for it. */
function choose(ui: Ui, number: number) {
  const { state } = ui,
    shown = bodyOf(state);
  if (number !== shown) ui.dispatch({ type: 'edit', input: withBody(state.input, shown, number) });
}

/** Arrow keys, Home and End move along the list; Enter or Space shows the body. */
function step(e: KeyboardEvent) {
  const rows = [...(e.currentTarget as HTMLElement).querySelectorAll<HTMLElement>('[role=option]')],
    at = rows.indexOf(e.target as HTMLElement);
  const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: rows.length - 1 }[e.key];
  if (to === undefined) return;
  rows[Math.min(rows.length - 1, Math.max(0, to))]?.focus();
  e.preventDefault();
}

function archiveRow(ui: Ui, sheets: number) {
  const { archive } = ui.state;
  return html`<p class="row archive">
    ${archive
      ? html`<span role="status">${archive.done} of ${archive.all} bodies</span>
          <progress data-testid="archive-progress" max=${archive.all} .value=${archive.done}></progress>
          <button data-testid="archive-cancel" @click=${ui.cancelArchive}>Cancel</button>`
      : html`<button
          data-testid="download-all"
          title="A ZIP with the DXF of every body that is a sheet, and a summary"
          ?disabled=${sheets === 0}
          @click=${ui.downloadAll}
        >
          Download all
        </button>`}
  </p>`;
}
