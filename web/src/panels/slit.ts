import { html, nothing } from 'lit-html';
import { removeAnchor, moveAnchor } from '../edits/slit.ts';
import { sheetWidth } from '../edits/strips.ts';
import type { AnchorSpec, SlitSpec, SlitWeights, StripRow } from '../edits/slit-types.ts';
import type { Vec3 } from '../types.ts';
import { convert, lengthText, sizeText, unitName } from '../units.ts';
import { restingSpec, type Ui } from '../ui.ts';
import { curveEditor } from './curve-editor.ts';
import { massSection } from './allowance.ts';
import { block } from './blocks.ts';
import { choice, lengthField, numberField, section, slider, toggle } from './fields.ts';
import { legFields, secondPanel } from './legs.ts';
import { mouldFields } from './mould.ts';
import { thicknessField } from './sheet-fields.ts';
import { energyText, energyUnit, loadFields, stressText } from './loads.ts';
import { stripFields } from './strips.ts';

type Set = (patch: Partial<SlitSpec>, live?: boolean) => void;

export function slitPanel(ui: Ui) {
  const spec = ui.state.input.spec as SlitSpec,
    set: Set = (patch, live = false) => ui.edit<SlitSpec>((s) => clear({ ...s, ...patch }), live);
  return html` ${section('Leg curve, on the ground', legFields(ui, spec, 'leg'))}
  ${section('Second panel', secondPanel(ui, spec))} ${section('Seat curve, in the middle', seatEditor(ui, spec, set))}
  ${section('Anchors', anchorFields(ui, spec))} ${section('Strips', stripTable(ui, spec))}
  ${section('Material, weight and loads', loadFields(spec, set))} ${section('Fineness', fineness(spec, set))}
  ${section('Weights', weightSliders(ui, spec, set))}
  ${spec.scan?.length ? section('Scan', scanFields(ui, spec, set)) : nothing}
  ${section('Sheet', sheetFields(ui, spec, set))} ${section('Mould', mouldFields(ui, spec))} ${massSection(ui)}`;
}

const fineness = (spec: SlitSpec, set: Set) =>
  html` ${numberField({
      label: 'Ridges at the start',
      testid: 'ridges',
      value: spec.ridges ?? 10,
      min: 3,
      max: 200,
      whole: true,
      on: (v) => v && set({ ridges: v }),
    })}
    <div class="field">
      <span>Halved ${spec.subdivisions ?? 0} ×</span
      ><span class="segments">
        <button
          data-testid="coarser"
          ?disabled=${!(spec.subdivisions ?? 0)}
          @click=${() => set({ subdivisions: (spec.subdivisions ?? 0) - 1 })}
        >
          Coarser</button
        ><button
          data-testid="subdivide"
          ?disabled=${(spec.subdivisions ?? 0) >= 6}
          @click=${() => set({ subdivisions: (spec.subdivisions ?? 0) + 1 })}
        >
          Subdivide
        </button></span
      ><em></em>
    </div>`;

const clear = (s: SlitSpec) =>
  Object.fromEntries(Object.entries(s).filter(([, v]) => v !== undefined)) as unknown as SlitSpec;

function seatEditor(ui: Ui, spec: SlitSpec, set: Set) {
  const resting = restingSpec<SlitSpec>(ui).seat_curve?.bezier;
  if (!spec.seat_curve || !resting) {
    const width = sheetWidth(spec),
      high = spec.sheet.panel_height;
    return html`<p class="hint">
      No seat
      curve.${spec.symmetric === false
        ? ' Seat curves belong to symmetric sheets.'
        : html` <button
            class="link"
            data-testid="seat-add"
            @click=${() =>
              set({
                seat_curve: {
                  bezier: [
                    [0.8 * high, 0],
                    [0.75 * high, width / 3],
                    [0.75 * high, (2 * width) / 3],
                    [1.2 * high, width],
                  ],
                },
              })}
          >
            Add one
          </button>`}
    </p>`;
  }
  return html`${curveEditor(ui, {
      name: 'seat',
      axes: ['y', 'z'],
      control: spec.seat_curve.bezier,
      resting,
      units: spec.units,
      on: (bezier, live) => set({ seat_curve: { ...spec.seat_curve, bezier } }, live),
      enter: (bezier) => set({ seat_curve: { ...spec.seat_curve, bezier } }),
    })}
    ${toggle('Scaled to the strips', 'seat-fit', spec.seat_curve.fit ?? false, (on) =>
      set({ seat_curve: { bezier: spec.seat_curve!.bezier, fit: on || undefined } }),
    )}
    <p class="row">
      <button class="link" data-testid="seat-remove" @click=${() => set({ seat_curve: undefined })}>Remove it</button>
    </p>`;
}

function anchorFields(ui: Ui, spec: SlitSpec) {
  const anchors = spec.anchors ?? [];
  return html`<p class="hint">
      Pull a strip at the end of a ridge, in the folded view, or click there: an anchor holds it. Delete releases it.
    </p>
    ${anchors.map((a, i) => anchorBlock(ui, spec, a, i))}`;
}

function anchorBlock(ui: Ui, spec: SlitSpec, a: AnchorSpec, i: number) {
  return block(ui, {
    picks: { anchor: i },
    testid: `anchor-${i}`,
    head: {
      name: i + 1,
      said: `strip ${a.strip + 1}, ridge ${a.ridge + 1}, ${a.side ?? 'left'}`,
      aside: a.at.map((v) => lengthText(v, spec.units, ui.state.units)).join(' · '),
    },
    content: () =>
      html`<div class="triple">
          ${(['x', 'y', 'z'] as const).map((axis, k) =>
            lengthField(ui, {
              label: axis,
              testid: `anchor-${axis}`,
              value: a.at[k]!,
              from: spec.units,
              on: (v) =>
                v !== null && ui.edit<SlitSpec>((s) => moveAnchor(s, i, a.at.map((x, j) => (j === k ? v : x)) as Vec3)),
            }),
          )}
        </div>
        <p class="row">
          <button
            class="link"
            data-testid="anchor-remove"
            @click=${() => {
              ui.edit<SlitSpec>((s) => removeAnchor(s, i));
              ui.dispatch({ type: 'select', selection: {} });
            }}
          >
            Remove
          </button>
        </p>`,
  });
}

/** How far each strip is from its targets. */
function stripTable(ui: Ui, spec: SlitSpec) {
  const strips = ui.state.shape?.report.slit?.strips ?? [];
  if (!strips.length) return html`<p class="hint">No strip is solved yet.</p>`;
  const columns = stripColumns(ui, spec, strips);
  return html`<table data-testid="strip-table">
    <thead>
      <tr>
        <th>Strip</th>
        ${columns.map(([name, , unit]) => html`<th>${name}<br />${unit ?? unitName(ui.state.units)}</th>`)}
      </tr>
    </thead>
    <tbody>
      ${strips.map(
        (s, i) =>
          html`<tr data-testid="strip-${i}" class=${s.status === 'solved' ? '' : 'warning'} title=${stateOf(s)}>
            <td>${i + 1}${s.crosses?.length || s.crosses_plane ? ' ✕' : ''}</td>
            ${columns.map(([, value]) => html`<td>${value(s)}</td>`)}
          </tr>`,
      )}
    </tbody>
  </table>`;
}

/** What is told of each strip; lengths unless another unit is named. */
function stripColumns(ui: Ui, spec: SlitSpec, strips: StripRow[]) {
  const from = ui.state.shape?.report.units,
    text = (v: number | null | undefined) => lengthText(v, from, ui.state.units);
  const columns: [string, (s: StripRow) => string, string?][] = [
    ['Gap', ({ gap }) => (gap === null ? '–' : sizeText(convert(gap, from, ui.state.units)))],
    ['Least radius', (s) => text(s.min_radius)],
  ];
  columns.push(['Energy', (s) => energyText(s.energy, spec), energyUnit(spec)]);
  if (strips.some((s) => s.stress != null)) columns.push(['Stress', (s) => stressText(s.stress), 'N/mm²']);
  if (spec.seat_curve) columns.push(['Off seat', (s) => text(s.seat_distance)]);
  if (spec.anchors?.length) columns.push(['Off anchors', (s) => text(s.anchor_distance)]);
  if (spec.scan?.length) columns.push(['Off scan', (s) => text(s.scan_distance)]);
  return columns;
}

const stateOf = (s: StripRow) =>
  [
    s.status,
    ...(s.crosses?.length ? [`runs through ${s.crosses.map((other) => other + 1).join(', ')}`] : []),
    ...(s.crosses_plane ? ['runs through its mirror image'] : []),
    ...(s.below_ground ? ['goes below the ground'] : []),
  ].join(', ');

const objectiveOf = (spec: SlitSpec) => spec.objective ?? (spec.weights?.smooth == null ? 'energy' : 'smooth');

const weights: [keyof SlitWeights, string, number][] = [
  ['smooth', 'Smooth', 0.04],
  ['spacing', 'Spacing', 0.01],
  ['anchors', 'Anchors', 0.03],
  ['seat', 'Seat curve', 0.03],
  ['spread', 'Spread', 0.003],
  ['scan', 'Scan', 0.03],
];

function weightSliders(ui: Ui, spec: SlitSpec, set: Set) {
  const ofObjective = weights.filter(([key]) => key !== 'smooth' || objectiveOf(spec) === 'smooth');
  return ofObjective.map(([key, label, usual]) =>
    slider({
      label,
      testid: `weight-${key}`,
      value: spec.weights?.[key] ?? usual,
      min: 0,
      max: 5 * usual,
      least: 0,
      most: 1e4,
      step: usual / 20,
      digits: 4,
      on: (v, live) => set({ weights: { ...spec.weights, [key]: v } }, live),
      commit: ui.commit,
    }),
  );
}

function scanFields(ui: Ui, spec: SlitSpec, set: Set) {
  const count = ui.state.shape?.handles.scan?.length ?? 0;
  return html`<p class="hint" data-testid="scan-state">Scanned strips: ${spec.scan!.length}; points drawn: ${count}.</p>
    ${toggle('Move scans to the shape first', 'align-scan', spec.align_scan ?? false, (v) =>
      set({ align_scan: v || undefined }),
    )}`;
}

function sheetFields(ui: Ui, spec: SlitSpec, set: Set) {
  const { sheet } = spec,
    change = (patch: object) => set({ sheet: { ...sheet, ...patch } });
  return html` ${thicknessField(ui, spec, set)} ${stripFields(ui, spec)}
  ${lengthField(ui, {
    label: 'Panel height',
    testid: 'panel-height',
    value: sheet.panel_height,
    from: spec.units,
    min: 1e-6,
    on: (v) => v && change({ panel_height: v }),
  })}
  ${sheet.half_length !== undefined
    ? lengthField(ui, {
        label: spec.symmetric === false ? 'Length of the strips' : 'Half length',
        testid: 'half-length',
        value: sheet.half_length,
        from: spec.units,
        min: 1e-6,
        on: (v) => v && change({ half_length: v }),
      })
    : nothing}
  ${spec.symmetric === false
    ? nothing
    : choice(
        'Strips end',
        'end-angle',
        spec.end_angle ?? 'right_angle',
        [
          ['right_angle', 'square to the middle'],
          ['level', 'level'],
          ['free', 'free'],
        ] as const,
        (v) => set({ end_angle: v }),
      )}
  ${choice(
    'Strips have least',
    'objective',
    objectiveOf(spec),
    [
      ['energy', 'bending energy'],
      ['smooth', 'change of their folds'],
    ] as const,
    (v) => set({ objective: v, weights: v === 'energy' ? { ...spec.weights, smooth: undefined } : spec.weights }),
  )}
  ${lengthField(ui, {
    label: 'Least inside radius',
    testid: 'min-radius',
    value: spec.min_inside_radius,
    from: spec.units,
    min: 0,
    placeholder: 'any',
    on: (v) => set({ min_inside_radius: v ?? undefined }),
  })}
  ${lengthField(ui, {
    label: 'Kerf',
    testid: 'kerf',
    value: spec.kerf,
    from: spec.units,
    min: 0,
    placeholder: '0',
    on: (v) => set({ kerf: v ?? undefined }),
  })}
  ${lengthField(ui, {
    label: 'Stop hole',
    testid: 'stop-hole',
    value: spec.stop_hole,
    from: spec.units,
    min: 0,
    placeholder: '0',
    on: (v) => set({ stop_hole: v ?? undefined }),
  })}`;
}
