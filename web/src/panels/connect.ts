import { html, nothing } from 'lit-html';
import {
  bendSpecOf,
  bendsOf,
  edgesText,
  parseEdges,
  radiusPatch,
  removeBend,
  setBend,
  surfacePatch,
} from '../edits/connect.ts';
import { knownPiece } from '../report.ts';
import type { Alternative, BendRow } from '../types.ts';
import type { BendSpec, PlatesSpec } from '../edits/plates-types.ts';
import { lengthText } from '../units.ts';
import type { Ui } from '../ui.ts';
import { shopSection } from './allowance.ts';
import { block } from './blocks.ts';
import { choice, lengthSlider, niceAbove, numberField, refuse, section } from './fields.ts';
import { kFactorField, thicknessField } from './sheet-fields.ts';
import { platesPart } from './plates.ts';

export function connectPanel(ui: Ui) {
  const spec = ui.state.input.spec as PlatesSpec,
    set = (patch: Partial<PlatesSpec>) => ui.edit<PlatesSpec>((s) => ({ ...s, ...patch }));
  const rows = knownPiece(ui.state)?.flat?.bends ?? [],
    bends = bendsOf(spec, rows);
  return html` ${section(
    'Sheet',
    html` ${thicknessField(ui, spec, set)} ${kFactorField(spec, '0.44', set)}
    ${choice(
      'Stays in place',
      'root',
      spec.root ?? '',
      [['', 'the largest plate'], ...spec.plates.map((p) => [p.id, p.id] as const)] as [string, string][],
      (v) => set({ root: v || undefined }),
    )}`,
  )}
  ${section('Plates', platesPart(ui, spec, rows))}
  ${section(
    'Bends',
    bends.length ? bends.map((b, i) => bendBlock(ui, spec, rows, b, i)) : html`<p class="hint">No bends yet.</p>`,
    spec.bends?.length
      ? html`<button
          class="link"
          data-testid="bends-free"
          title="Discard all bends given here and let the program choose"
          @click=${() => set({ bends: undefined })}
        >
          let the program choose
        </button>`
      : nothing,
  )}
  ${shopSection(ui)}`;
}

function bendBlock(
  ui: Ui,
  spec: PlatesSpec,
  rows: BendRow[],
  { between, row }: ReturnType<typeof bendsOf>[number],
  index: number,
) {
  const remove = html`<button
    class="link"
    data-testid="bend-remove-${index}"
    @click=${() => ui.edit<PlatesSpec>((s) => removeBend(s, rows, index))}
  >
    Remove
  </button>`;
  if (!row)
    return html`<div class="block missing" data-testid="bend-missing-${index}">
      <span>${between.join(' – ')}</span><em>not fitted</em>${remove}
    </div>`;
  const own = bendSpecOf(spec, rows, row);
  const set = (patch: Partial<BendSpec>, live = false) =>
    ui.edit<PlatesSpec>((s) => setBend(s, rows, row, patch), live);
  const radius = lengthText(row.inside_radius, knownPiece(ui.state)?.units, ui.state.units);
  return block(ui, {
    picks: { part: row.id },
    testid: `bend-head-${row.id}`,
    head: { name: row.id, said: between.join(' – '), aside: `${row.surface ?? row.kind}, R ${radius}` },
    content: () =>
      html`${bendFields(ui, spec, row, own, set)}
        <p class="row">${remove}</p>`,
  });
}

function bendFields(
  ui: Ui,
  spec: PlatesSpec,
  row: BendRow,
  own: BendSpec | undefined,
  set: (patch: Partial<BendSpec>, live?: boolean) => void,
) {
  const radius = own?.inside_radius ?? row.inside_radius ?? 0;
  const most = niceAbove(2.5 * Math.max(radius, spec.thickness));
  return html` ${choice<NonNullable<BendSpec['surface']>>(
    'Surface',
    'bend-surface',
    own?.surface ?? 'auto',
    [
      ['auto', 'chosen'],
      ['cylinder', 'cylinder'],
      ['cone', 'cone'],
      ['general', 'oblique cone'],
    ],
    (v) => set(surfacePatch(v)),
  )}
  ${own?.surface === 'general'
    ? nothing
    : lengthSlider(ui, spec.units, {
        label: 'Inside radius',
        testid: 'bend-radius',
        value: radius,
        least: 0,
        min: 0,
        max: ui.state.pending ? mostOf(ui, row, most) : most,
        step: most / 500,
        // Only plates that share an edge are folded sharply: the slider ends a little above.
        on: (v, live) => set(radiusPatch(live ? Math.max(v, spec.thickness / 1000) : v), live),
        commit: ui.commit,
      })}
  ${own?.inside_radius !== undefined
    ? html`<p class="row">
        <button class="link" data-testid="bend-radius-free" @click=${() => set({ inside_radius: undefined })}>
          the radius that extends the plates least
        </button>
      </p>`
    : nothing}
  ${choice<NonNullable<BendSpec['lateral']>>(
    'Sides end',
    'bend-lateral',
    own?.lateral ?? 'auto',
    [
      ['auto', 'chosen'],
      ['straight', 'straight'],
      ['arc', 'along an arc'],
      ['corner', 'at the corner'],
    ],
    (v) => set({ lateral: v === 'auto' ? undefined : v }),
  )}
  ${numberField({
    label: 'Trade-off γ',
    testid: 'bend-trade-off',
    value: own?.trade_off,
    min: 0,
    placeholder: '1',
    on: (v) => set({ trade_off: v ?? undefined }),
  })}
  ${(row.between ?? []).map((id) => edgesField(row, own, id, set))}
  ${row.alternatives?.length
    ? html`<h3>Alternatives</h3>
        <ul class="alternatives">
          ${row.alternatives.map(
            (a, i) =>
              html`<li>
                <span
                  >${bothEdges(a)}<small
                    >${a.surface}, ${a.facing}; ${lengthText(a.width, knownPiece(ui.state)?.units, ui.state.units)}
                    wide, ${lengthText(a.span, knownPiece(ui.state)?.units, ui.state.units)} long</small
                  ></span
                >
                <button data-testid="alternative-${i}" @click=${() => set({ edges: chosenEdges(a) })}>Use</button>
              </li>`,
          )}
        </ul>`
    : nothing}`;
}

/** The range of the slider as it was when the drag began. */
function mostOf(ui: Ui, row: BendRow, otherwise: number): number {
  const before = ui.state.pending?.spec as PlatesSpec | undefined,
    own = before && bendSpecOf(before, knownPiece(ui.state)?.flat?.bends ?? [], row);
  const radius = own?.inside_radius ?? ui.state.result?.report.flat?.bends.find((b) => b.id === row.id)?.inside_radius;
  return typeof radius !== 'number' ? otherwise : niceAbove(2.5 * Math.max(radius, before!.thickness));
}

function edgesField(row: BendRow, own: BendSpec | undefined, id: string, set: (patch: Partial<BendSpec>) => void) {
  const fixed = own?.edges?.[id],
    text = edgesText(fixed ?? []);
  const change = (e: Event) => {
    const input = e.target as HTMLInputElement,
      edges = parseEdges(input.value);
    if (edges === null) {
      refuse(input, `“${input.value}” is not a list of edges; write numbers such as 2 3 or 2…9.`);
      input.value = text;
      return;
    }
    const all = { ...own?.edges };
    if (edges) all[id] = edges;
    else delete all[id];
    set({ edges: Object.keys(all).length ? all : undefined });
  };
  return html`<label class="field"
    ><span>Edges of ${id}</span
    ><input
      type="text"
      data-testid="bend-edges-${id}"
      .value=${text}
      placeholder=${edgesText(row.edges?.[id] ?? []) || 'chosen'}
      @change=${change} /><em></em
  ></label>`;
}

const chosenEdges = (a: Alternative) => {
  const edges = Object.fromEntries(Object.entries(a.edges).filter((e): e is [string, number[]] => e[1] !== null));
  return Object.keys(edges).length ? edges : undefined;
};
const bothEdges = (a: Alternative) =>
  Object.entries(a.edges)
    .map(([id, e]) => `${id} ${edgesText(e ?? [])}`)
    .join(' – ');
