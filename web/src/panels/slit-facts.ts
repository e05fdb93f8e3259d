import { html, nothing } from 'lit-html';
import type { ReportSlit } from '../../generated/report.ts';
import type { SlitSpec } from '../edits/slit-types.ts';
import { bendingColours } from '../curvature.ts';
import type { Ui } from '../ui.ts';
import { clean, lengthText, unitName } from '../units.ts';
import { energyText, energyUnit, materialOf } from './loads.ts';
import { compared, standingText } from './standing-text.ts';
import './slit-facts.css';

/** Colours a slit sheet by how sharply it is bent. */
export function bendingButton(ui: Ui) {
  const { view, shape, document } = ui.state;
  if (document?.kind !== 'slit') return nothing;
  return html`<button
    data-testid="bending"
    class=${view.bending ? 'on' : ''}
    aria-pressed=${String(view.bending)}
    title="Colour the sheet by how sharply it is bent"
    ?disabled=${!shape?.facet_parent.length}
    @click=${() => ui.dispatch({ type: 'view', view: { bending: !view.bending } })}
  >
    Bending
  </button>`;
}

/** Beside the picture: energy, before an edit and now, how the sheet stands, and what its colours mean. */
export function slitFacts(ui: Ui) {
  const { state } = ui,
    slit = state.shape?.report.slit;
  if (!slit || state.document?.kind !== 'slit') return nothing;
  const spec = state.input.spec as SlitSpec,
    before = (state.shapeIsDraft ? state.result : state.earlier)?.report.slit ?? null;
  return html`<div class="slit-facts" data-testid="slit-facts">
    ${state.view.bending ? scale(ui, slit, spec) : nothing}
    <span data-testid="energy">${energySaid(slit, before, spec)}</span>
    <span data-testid="least-radius">${radiusSaid(ui, slit, before)}</span>
    ${standingText(slit, before).map((said) => html`<span data-testid="standing">${said}</span>`)}
  </div>`;
}

function energySaid(now: ReportSlit, before: ReportSlit | null, spec: SlitSpec) {
  const text = (slit: ReportSlit) => energyText(energyOf(slit), spec);
  return `energy ${compared(text(now), before && text(before))} ${energyUnit(spec)}`;
}

/** Nothing of a flat sheet. */
function radiusSaid(ui: Ui, now: ReportSlit, before: ReportSlit | null) {
  const text = (slit: ReportSlit) => lengthText(radiusOf(slit), ui.state.shape?.report.units, ui.state.units),
    was = before && Number.isFinite(radiusOf(before)) ? text(before) : null;
  return Number.isFinite(radiusOf(now)) ? `least radius ${compared(text(now), was)} ${unitName(ui.state.units)}` : '';
}

const radiusOf = ({ strips }: ReportSlit) => Math.min(...strips.map((s) => s.min_radius ?? Infinity));

const energyOf = ({ strips }: ReportSlit) => strips.reduce((sum, { energy }) => sum + energy, 0);

/** From flat to the sharpest bend, with its radius and, where the material is known, its stress. */
function scale(ui: Ui, slit: ReportSlit, spec: SlitSpec) {
  const radius = radiusOf(slit),
    { strips } = slit,
    stress = Math.max(...strips.map((s) => s.stress ?? 0)),
    limit = materialOf(spec)?.yield;
  return html`<span class="scale" data-testid="bending-scale"
    >flat<i style="background: linear-gradient(to right, ${bendingColours.join(', ')})"></i>${Number.isFinite(radius)
      ? `radius ${lengthText(radius, ui.state.shape?.report.units, ui.state.units)} ${unitName(ui.state.units)}`
      : ''}${stress ? `, ${Math.round(stress)} N/mm²${limit ? ` of ${clean(limit, 0)}` : ''}` : ''}</span
  >`;
}
