import { html, nothing } from 'lit-html';
import {
  addStrip,
  endAsItIs,
  endOf,
  ownWidths,
  removeStrip,
  setEnd,
  setMargin,
  setStrip,
  setStripCount,
  setStripWidth,
  stripsOf,
  uniform,
} from '../edits/strips.ts';
import {
  addFlatPoint,
  flatCurves,
  isFlatCurve,
  moveFlatPoint,
  removeSlit,
  withCurvedSlits,
} from '../edits/flat-curves.ts';
import type { LengthUnit, Vec3 } from '../types.ts';
import type { FlatCurveName, SlitSpec, StripEnd, StripSpec } from '../edits/slit-types.ts';
import { lengthText, millimetres } from '../units.ts';
import type { Ui } from '../ui.ts';
import { block } from './blocks.ts';
import { choice, lengthField, numberField, toggle } from './fields.ts';

type Change = (change: (s: SlitSpec) => SlitSpec) => void;

/**
 * How the sheet is divided: into strips of one width, or each of its own width; and, if it is not symmetric, where they
 * end.
 */
export function stripFields(ui: Ui, spec: SlitSpec) {
  if (spec.slits) return curvedSlits(ui, spec);
  const edit: Change = (change) => ui.edit<SlitSpec>(change),
    curved = withCurvedSlits(spec),
    own = typeof spec.sheet.strips !== 'number',
    strips = stripsOf(spec.sheet);
  return html` ${choice(
    'Strips are',
    'strip-kind',
    own ? 'own' : 'one',
    [
      ['one', 'of one width'],
      ['own', 'of their own widths'],
    ] as const,
    (v) => edit(v === 'own' ? ownWidths : uniform),
  )}
  ${own
    ? nothing
    : html` ${numberField({
        label: 'Strips',
        testid: 'strips',
        value: strips.length,
        min: 1,
        max: 200,
        whole: true,
        on: (v) => v && edit((s) => setStripCount(s, v)),
      })}
      ${lengthField(ui, {
        label: 'Strip width',
        testid: 'strip-width',
        value: spec.sheet.strip_width,
        from: spec.units,
        min: 1e-6,
        on: (v) => v && edit((s) => setStripWidth(s, v)),
      })}`}
  ${own || endsFreely(spec) ? strips.map((strip, i) => stripBlock(ui, spec, strip, i, own)) : nothing}
  ${lengthField(ui, {
    label: 'Margin after the last',
    testid: 'margin',
    value: spec.sheet.margin,
    from: spec.units,
    min: 0,
    placeholder: '0',
    on: (v) => edit((s) => setMargin(s, v ?? 0)),
  })}
  ${curved
    ? html`<p class="row">
        <button class="link" data-testid="slits-curved" @click=${() => edit(() => curved)}>
          Draw the slits as curves
        </button>
      </p>`
    : nothing}`;
}

/** Slits that are changed in the flat view, by their points. */
function curvedSlits(ui: Ui, spec: SlitSpec) {
  const { point } = ui.state.selection,
    chosen = point && isFlatCurve(point.curve) ? { name: point.curve, index: point.index } : null,
    curve = chosen && flatCurves(spec).find(({ name }) => name === chosen.name),
    at = curve?.control[chosen!.index];
  if (!chosen || !curve || !at)
    return html`<p class="hint" data-testid="slit-point">
      Slits are curves: drag their points in the flat view. A double click on one adds a point, Delete removes one.
    </p>`;
  const [list, number] = chosen.name.split('-') as [string, string],
    edit: Change = (change) => ui.edit<SlitSpec>(change);
  return html`<p class="hint" data-testid="slit-point">
      ${list === 'slits' ? 'Slit' : 'Part of the outline'} ${Number(number) + 1}, point ${chosen.index + 1}
    </p>
    ${(['along', 'across'] as const).map((axis, k) =>
      lengthField(ui, {
        label: axis === 'along' ? 'Along the sheet' : 'Across it',
        testid: `slit-${axis}`,
        value: at[k]!,
        from: spec.units,
        on: (v) =>
          v !== null && edit((s) => moveFlatPoint(s, chosen.name, chosen.index, k === 0 ? [v, at[1]] : [at[0], v])),
      }),
    )}
    ${pointButtons(ui, spec, chosen)}`;
}

function pointButtons(ui: Ui, spec: SlitSpec, chosen: { name: FlatCurveName; index: number }) {
  const [list, number] = chosen.name.split('-') as [string, string],
    edit: Change = (change) => ui.edit<SlitSpec>(change);
  return html`<p class="row">
    <button
      class="link"
      data-testid="slit-raise"
      @click=${() => edit((s) => addFlatPoint(s, chosen.name, chosen.index))}
    >
      + point
    </button>
    ${list === 'slits' && spec.slits!.length > 1
      ? html`<button
          class="link"
          data-testid="slit-remove"
          @click=${() => {
            edit((s) => removeSlit(s, Number(number)));
            ui.dispatch({ type: 'select', selection: {} });
          }}
        >
          Remove the slit
        </button>`
      : nothing}
  </p>`;
}

/** Whether the ends of strips can be placed. */
const endsFreely = (spec: SlitSpec) => spec.symmetric === false && !spec.second_panel;

function stripBlock(ui: Ui, spec: SlitSpec, strip: StripSpec, i: number, own: boolean) {
  const text = (v: number) => lengthText(v, spec.units, ui.state.units);
  return block(ui, {
    picks: { strip: i },
    testid: `strip-head-${i}`,
    head: {
      name: i + 1,
      said: `${text(strip.width)} wide${strip.gap ? `, gap ${text(strip.gap)}` : ''}`,
      aside: endOf(spec, i)?.position ? 'end is placed' : '',
    },
    content: () =>
      html`${own ? ownFields(ui, spec, strip, i) : nothing}${endsFreely(spec) ? endFields(ui, spec, i) : nothing}`,
  });
}

function ownFields(ui: Ui, spec: SlitSpec, strip: StripSpec, i: number) {
  const { panel_height, half_length } = spec.sheet;
  const usual = (v: number | undefined) => (v === undefined ? '' : lengthText(v, spec.units, ui.state.units));
  const field = (label: string, key: keyof StripSpec, otherwise: string) =>
    lengthField(ui, {
      label,
      testid: `strip-${key}`,
      value: strip[key],
      from: spec.units,
      min: key === 'gap' ? 0 : 1e-6,
      placeholder: otherwise,
      on: (v) => ui.edit<SlitSpec>((s) => setStrip(s, i, { [key]: v ?? undefined })),
    });
  const width = lengthField(ui, {
    label: 'Width',
    testid: 'strip-width',
    value: strip.width,
    from: spec.units,
    min: 1e-6,
    on: (v) => v && ui.edit<SlitSpec>((s) => setStrip(s, i, { width: v })),
  });
  const count = stripsOf(spec.sheet).length;
  return html`${width}${field('Gap before it', 'gap', '0')}${field(
      'Left slit begins at',
      'left_start',
      usual(panel_height),
    )}${field('Right slit begins at', 'right_start', usual(panel_height))}
    ${spec.symmetric === false ? field('Ends at', 'end', usual(half_length)) : nothing}
    <p class="row">
      <button class="link" data-testid="strip-add" @click=${() => ui.edit<SlitSpec>((s) => addStrip(s, i))}>
        One more
      </button>
      <button
        class="link"
        data-testid="strip-remove"
        ?disabled=${count < 2}
        @click=${() => {
          ui.edit<SlitSpec>((s) => removeStrip(s, i));
          ui.dispatch({ type: 'select', selection: {} });
        }}
      >
        Remove
      </button>
    </p>`;
}

type EndKey = 'position' | 'direction' | 'across';
const ends: [EndKey, string][] = [
  ['position', 'The end is placed'],
  ['direction', 'Its direction is set'],
  ['across', 'Its last ridge is set'],
];

/** Where a strip ends in space; what is switched on starts from its present value. */
function endFields(ui: Ui, spec: SlitSpec, i: number) {
  const end = endOf(spec, i),
    now = endAsItIs(spec, ui.state.shape?.handles.ridges?.[i] ?? [], millimetres(spec.units));
  const set = (patch: Omit<Partial<StripEnd>, 'strip'>) => ui.edit<SlitSpec>((s) => setEnd(s, i, patch));
  return ends.map(
    ([key, label]) =>
      html`${toggle(label, `end-${key}`, end?.[key] !== undefined, (on) => set({ [key]: on ? now?.[key] : undefined }))}
      ${end?.[key] ? vectorFields(ui, spec.units, key, end[key], (v) => set({ [key]: v })) : nothing}`,
  );
}

function vectorFields(ui: Ui, units: LengthUnit | undefined, key: EndKey, at: Vec3, on: (v: Vec3) => void) {
  return html`<div class="triple">
    ${(['x', 'y', 'z'] as const).map((axis, k) => {
      const o = {
        label: axis,
        testid: `end-${key}-${axis}`,
        value: at[k]!,
        on: (v: number | null) => v !== null && on(at.map((x, j) => (j === k ? v : x)) as Vec3),
      };
      return key === 'position' ? lengthField(ui, { ...o, from: units }) : numberField(o);
    })}
  </div>`;
}
