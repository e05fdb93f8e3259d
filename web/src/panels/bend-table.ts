import { html, nothing, type TemplateResult } from 'lit-html';
import { flangeLengths, type FlangeLength } from '../flange-lengths.ts';
import { isDefaultK } from '../default-k.ts';
import { bendsToMark } from '../picked.ts';
import { isRefused, knownPiece, pieceOf } from '../report.ts';
import { makerOf } from '../state.ts';
import type { BendRow, Shape } from '../types.ts';
import type { Ui } from '../ui.ts';
import { clean, lengthText, unitName } from '../units.ts';
import { refuse, whyNot } from './fields.ts';

const most = 120;
const outside =
  'The flanges on both sides, measured outside: from the mould line to the far edge, or to the next mould line if ' +
  'that is farther; from 180° on from the plane that touches the bend. Point at a number to light up its flange';
const deduction =
  'Bend deduction: how much shorter the pattern is than both outside lengths together. They go to the mould ' +
  'line, where the outside faces would meet, above 90° too; from 180° on, where these do not meet, to the plane that ' +
  'touches the bend';

/** What the deduction of a bend that goes beyond 90° is measured to: there are two readings. */
function deductionTo({ angle, kind, deduction: value }: BendRow): string | typeof nothing {
  if (value === null) return kind === 'cone' ? 'It changes along the bend, as the radius does' : nothing;
  if (angle === null) return nothing;
  if (angle >= 180) return 'Measured to the plane that touches the bend: from 180° on there is no mould line';
  return angle > 90 + 1e-6 ? 'Measured to the mould line, not to the plane that touches the bend' : nothing;
}

/** Two lines a bend: what it is, and what follows for the pattern and for whoever measures the part. */
export function bendTable(ui: Ui): TemplateResult {
  const report = knownPiece(ui.state),
    rows = report?.flat?.bends ?? [];
  if (rows.length === 0)
    return html`<p class="hint">${isRefused(ui.state) ? 'Refused: no bends are known.' : 'No bends.'}</p>`;
  const marked = bendsToMark(ui.state),
    lengths = outsideLengths(ui.state.shape),
    units = unitName(ui.state.units);
  const at = rows.findIndex((r) => r.id === marked.picked),
    first = at >= most ? at - 10 : 0;
  return html`<table class="bends ${pieceOf(ui.state)?.flat ? '' : 'old'}" data-testid="bend-table">
      <thead>
        <tr>
          <th>Bend</th>
          <th>Angle °</th>
          <th>Radius ${units}</th>
          <th>K</th>
          <th>Length ${units}</th>
        </tr>
        <tr class="second">
          <th>Dir.</th>
          <th title="Bend allowance: the length of the bend in the pattern">Allow. ${units}</th>
          <th data-testid="deduction-head" title=${deduction}>Deduct. ${units}</th>
          <th colspan="2" title=${outside}>Outside lengths ${units}</th>
        </tr>
      </thead>
      ${rows
        .slice(first, first + most)
        .map((r) => bendRows(ui, r, lengths.get(r.id), r.id === marked.picked, marked.beside.has(r.id)))}
    </table>
    ${rows.length > most
      ? html`<p class="hint">${rows.length} bends; ${most} are shown, the report has all.</p>`
      : nothing}`;
}

let measured: { shape: Shape; lengths: ReturnType<typeof flangeLengths> } | null = null;

/** Found out once for each shape. */
function outsideLengths(shape: Shape | null): ReturnType<typeof flangeLengths> {
  if (!shape?.report.flat) return new Map();
  if (measured?.shape !== shape) measured = { shape, lengths: flangeLengths(shape) };
  return measured.lengths;
}

function bendRows(
  ui: Ui,
  r: BendRow,
  lengths: FlangeLength[] | string | undefined,
  selected: boolean,
  beside: boolean,
) {
  const from = knownPiece(ui.state)?.units,
    text = (v: number | null) => lengthText(v, from, ui.state.units),
    pick = () => ui.dispatch({ type: 'select', selection: { part: selected ? null : r.id } }),
    marks = selected ? 'selected' : beside ? 'beside' : '';
  return html`<tbody @click=${pick}>
    <tr class=${marks} data-testid="bend-${r.id}" aria-selected=${selected}>
      <td>
        <button
          class="row"
          aria-pressed=${selected}
          @click=${(e: Event) => {
            e.stopPropagation();
            pick();
          }}
        >
          ${r.id}
        </button>
      </td>
      <td>${clean(r.angle, 2)}</td>
      <td>${text(r.inside_radius)}</td>
      <td class=${isDefaultK(r) ? 'default' : ''}>${kCell(ui, r)}</td>
      <td>${text(r.length)}</td>
    </tr>
    <tr class="second ${marks}">
      <td class=${r.direction}>${r.direction}</td>
      <td>${text(r.allowance)}</td>
      <td data-testid="deduction-${r.id}" title=${deductionTo(r)}>${text(r.deduction)}</td>
      ${outsideCell(ui, r.id, lengths)}
    </tr>
  </tbody>`;
}

/** Both numbers say whose they are: by their titles, to screen readers, and by the flange that lights up. */
function outsideCell(ui: Ui, bend: string, lengths: FlangeLength[] | string | undefined) {
  if (!Array.isArray(lengths))
    return html`<td colspan="2" data-testid="outside-${bend}" title=${lengths ?? nothing}>–</td>`;
  const rows = lengths.map(({ flange, length }) => {
    const part = ui.state.shape?.parts[flange];
    return { flange, name: part?.plate ?? part?.name ?? '', text: lengthText(length, 'mm', ui.state.units) };
  });
  const said = rows.map(({ name, text }) => `${name} ${text}`).join(', ');
  return html`<td colspan="2" data-testid="outside-${bend}" aria-label=${said}>
    ${rows.map(
      ({ flange, name, text }, i) =>
        html`${i ? ' + ' : nothing}<span
            class="outside"
            title="Flange ${name}"
            @mouseenter=${() => ui.light(flange)}
            @mouseleave=${() => ui.light(null)}
            >${text}</span
          >`,
    )}
  </td>`;
}

function kCell(ui: Ui, r: BendRow) {
  const text = r.k_factor === null ? '–' : clean(r.k_factor, 3);
  if (!makerOf(ui.state)?.options.some(({ name }) => name === 'bend_k')) return text;
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
    title=${isDefaultK(r)
      ? 'K is a default that nobody has confirmed. Enter the K of this bend, or confirm it above'
      : `K-factor of this bend, ${r.k_source ?? ''}; empty: the part's`}
    aria-label="K of ${r.id}${isDefaultK(r) ? ', a default' : ''}"
    data-testid="bend-k-${r.id}"
    .value=${text}
    @click=${(e: Event) => {
      e.stopPropagation();
      ui.dispatch({ type: 'select', selection: { part: r.id } });
    }}
    @change=${change}
  />`;
}
