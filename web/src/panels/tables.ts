import { html, nothing, type TemplateResult } from 'lit-html';
import { bendsToMark } from '../picked.ts';
import { knownPiece, pieceOf } from '../report.ts';
import { clean, lengthText, unitName } from '../units.ts';
import type { Ui } from '../ui.ts';
import { refuse, whyNot } from './fields.ts';
import type { BendRow } from '../types.ts';

const most = 120;

export function bendTable(ui: Ui): TemplateResult {
  const report = knownPiece(ui.state),
    rows = report?.flat?.bends ?? [];
  if (rows.length === 0) return html`<p class="hint">No bends.</p>`;
  const marked = bendsToMark(ui.state),
    units = unitName(ui.state.units);
  const at = rows.findIndex((r) => r.id === marked.picked),
    first = at >= most ? at - 10 : 0;
  return html`<table class="bends ${pieceOf(ui.state)?.flat ? '' : 'old'}" data-testid="bend-table">
      <thead>
        <tr>
          <th>Bend</th>
          <th>Angle<br />°</th>
          <th>Radius<br />${units}</th>
          <th>K</th>
          <th title="Bend allowance">Allow.<br />${units}</th>
          <th>Dir.</th>
          <th>Length<br />${units}</th>
        </tr>
      </thead>
      <tbody>
        ${rows.slice(first, first + most).map((r) => bendRow(ui, r, r.id === marked.picked, marked.beside.has(r.id)))}
      </tbody>
    </table>
    ${rows.length > most
      ? html`<p class="hint">${rows.length} bends; ${most} are shown, the report has all.</p>`
      : nothing}`;
}

function bendRow(ui: Ui, r: BendRow, selected: boolean, beside: boolean) {
  const from = knownPiece(ui.state)?.units,
    text = (v: number | null) => lengthText(v, from, ui.state.units);
  return html`<tr
    class=${selected ? 'selected' : beside ? 'beside' : ''}
    data-testid="bend-${r.id}"
    aria-selected=${selected}
    @click=${() => ui.dispatch({ type: 'select', selection: { part: selected ? null : r.id } })}
  >
    <td>
      <button
        class="row"
        aria-pressed=${selected}
        @click=${(e: Event) => {
          e.stopPropagation();
          ui.dispatch({ type: 'select', selection: { part: selected ? null : r.id } });
        }}
      >
        ${r.id}
      </button>
    </td>
    <td>${clean(r.angle, 2)}</td>
    <td>${text(r.inside_radius)}</td>
    <td>${kCell(ui, r)}</td>
    <td>${text(r.allowance)}</td>
    <td class=${r.direction}>${r.direction}</td>
    <td>${text(r.length)}</td>
  </tr>`;
}

function kCell(ui: Ui, r: BendRow) {
  const text = r.k_factor === null ? '–' : clean(r.k_factor, 3);
  if (ui.state.document?.kind !== 'unfold') return text;
  const own = ui.state.input.options.bend_k?.[r.id] !== undefined;
  const change = (e: Event) => {
    const input = e.target as HTMLInputElement,
      entered = input.value.trim().replace(',', '.'),
      k = Number(entered),
      no = entered === '' ? null : whyNot(entered, { label: `K of ${r.id}`, min: 0, max: 1 });
    if (no !== null) {
      input.value = text;
      refuse(input, no);
    } else
      ui.editOptions((o) => {
        const bend_k = { ...o.bend_k };
        if (entered === '') delete bend_k[r.id];
        else bend_k[r.id] = k;
        return { ...o, bend_k: Object.keys(bend_k).length ? bend_k : undefined };
      });
  };
  return html`<input
    class="cell ${own ? 'own' : ''}"
    aria-label="K-factor of ${r.id}"
    title="K-factor of this bend; empty: the part's"
    data-testid="bend-k-${r.id}"
    .value=${text}
    @click=${(e: Event) => {
      e.stopPropagation();
      ui.dispatch({ type: 'select', selection: { part: r.id } });
    }}
    @change=${change}
  />`;
}
