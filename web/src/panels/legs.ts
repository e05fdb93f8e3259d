import { html, nothing } from 'lit-html';
import { addSecondPanel, legOf, ownSecondPanel, removeSecondPanel, setLeg } from '../edits/panels.ts';
import { fitted, lengthOf } from '../edits/slit.ts';
import { sheetWidth } from '../edits/strips.ts';
import type { LegCurve, PanelName, SlitSpec } from '../edits/slit-types.ts';
import { clean, lengthText } from '../units.ts';
import { restingSpec, type Ui } from '../ui.ts';
import { curveEditor } from './curve-editor.ts';
import { lengthField, slider, toggle } from './fields.ts';

/** The leg curve of a panel, and how the panel stands on it. */
export function legFields(ui: Ui, spec: SlitSpec, panel: PanelName) {
  const leg = legOf(spec, panel),
    resting = legOf(restingSpec<SlitSpec>(ui), panel)?.bezier;
  if (!leg || !resting) return nothing;
  const set = (patch: Partial<LegCurve>, live = false) => ui.edit<SlitSpec>((s) => setLeg(s, panel, patch), live);
  return html`${curveEditor(ui, {
      name: panel,
      axes: ['x', 'z'],
      control: leg.bezier,
      resting,
      units: spec.units,
      note: lengthNote(ui, spec, panel, leg, set),
      // the sheet does not grow
      on: (bezier, live) => set({ bezier: fitted(bezier, lengthOf(resting)) }, live),
      enter: (bezier) => set({ bezier }),
    })}
    ${toggle('Scaled to the sheet', `${panel}-fit`, leg.fit ?? false, (on) => set({ fit: on || undefined }))}
    ${slider({
      label: 'Leans back',
      testid: `${panel}-lean`,
      value: leg.lean ?? 0,
      min: -90,
      max: 90,
      least: -90,
      most: 90,
      step: 1,
      unit: '°',
      digits: 2,
      on: (v, live) => set({ lean: v || undefined }, live),
      commit: ui.commit,
    })}
    <p class="hint">Away from the sheet’s front; at 90° it lies level with the ground.</p>`;
}

/** How wide the sheet is that stands on the curve, and by how much the program scales it. */
function lengthNote(ui: Ui, spec: SlitSpec, panel: PanelName, leg: LegCurve, set: (patch: Partial<LegCurve>) => void) {
  const width = sheetWidth(spec),
    sheet = html`, the sheet ${lengthText(width, spec.units, ui.state.units)} wide`,
    scale = ui.state.shape?.report.slit?.leg_scales[panel === 'leg' ? 0 : 1];
  if (leg.fit)
    return html`${sheet}${scale ? html`; <span data-testid="${panel}-scale">× ${clean(scale, 4)}</span>` : nothing}`;
  return html`${sheet}
    <button
      class="link"
      data-testid="curve-${panel}-fit"
      title="Make it as long as the sheet is wide"
      @click=${() => set({ bezier: fitted(leg.bezier, width) })}
    >
      Fit
    </button>`;
}

/** The panel at the far ends of the strips. */
export function secondPanel(ui: Ui, spec: SlitSpec) {
  if (spec.second_panel) return ownPanel(ui, spec, spec.second_panel.height);
  const add = (change: (s: SlitSpec) => SlitSpec, text: string, title: string) =>
    html`<button class="link" data-testid="second-add" title=${title} @click=${() => ui.edit<SlitSpec>(change)}>
      ${text}
    </button>`;
  return spec.symmetric === false
    ? html`<p class="hint">
        The strips end
        freely.${' '}${add(addSecondPanel, 'Add one', 'Within reach of all strips; it replaces placed ends')}
      </p>`
    : html`<p class="hint">
        It is the mirror image of the
        first.${' '}${add(
          ownSecondPanel,
          'Give it its own form',
          'The sheet is no longer symmetric; its seat curve, anchors and scans are left out',
        )}
      </p>`;
}

function ownPanel(ui: Ui, spec: SlitSpec, height: number) {
  return html`${legFields(ui, spec, 'second')}
    ${lengthField(ui, {
      label: 'Height',
      testid: 'second-height',
      value: height,
      from: spec.units,
      min: 1e-6,
      on: (v) =>
        v && ui.edit<SlitSpec>((s) => (s.second_panel ? { ...s, second_panel: { ...s.second_panel, height: v } } : s)),
    })}
    <p class="row">
      <button
        class="link"
        data-testid="second-remove"
        title="The strips end freely"
        @click=${() => ui.edit<SlitSpec>(removeSecondPanel)}
      >
        Remove it
      </button>
    </p>`;
}
