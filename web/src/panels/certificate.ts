import { html, type TemplateResult } from 'lit-html';
import { pieceOf } from '../report.ts';
import { millimetres, residualText, sizeText } from '../units.ts';
import type { Ui } from '../ui.ts';

const least = 1e-3; // mm: the largest residual of a good certificate

export function certificate(ui: Ui): TemplateResult {
  const report = ui.state.result ? pieceOf({ ...ui.state, shape: ui.state.result }) : null,
    v = report?.verification;
  if (!report || !v)
    return html`<p class="hint">${ui.state.computing ? 'Being verified …' : 'There is no certificate for this.'}</p>`;
  const length = (value: number) => residualText(value, report.units, ui.state.units),
    small = (value: number) => value * millimetres(report.units) < least;
  const said: [string, string, boolean][] = [];
  const ratio = v.explained_ratio ?? v.volume_ratio;
  if (ratio !== null && ratio !== undefined)
    said.push([
      `Volume agrees to ${sizeText(Math.abs(ratio - 1))}.`,
      'The area of the pattern, times the thickness, against the volume of the folded solid (K = ½).',
      Math.abs(ratio - 1) < 1e-4,
    ]);
  if (
    v.volume_ratio !== null &&
    v.explained_ratio !== null &&
    v.explained_ratio !== undefined &&
    Math.abs(v.volume_ratio - v.explained_ratio) > 1e-9
  )
    said.push([
      `${sizeText(Math.abs(v.volume_ratio - 1))} of the volume is explained.`,
      'By parts missing from the folded solid: corners cut off, open seams.',
      true,
    ]);
  if (v.length_error !== null)
    said.push([
      `Edges keep their lengths to ${length(v.length_error)}.`,
      'Every edge of the pattern against the same edge of the folded part.',
      small(v.length_error),
    ]);
  if (v.refold_deviation !== null && v.refold_deviation !== undefined)
    said.push([
      `Folded again, the pattern meets the part within ${length(v.refold_deviation)}.`,
      'The pattern is folded using only its bends and compared with the part.',
      small(v.refold_deviation),
    ]);
  if (v.closure !== null && v.closure !== undefined)
    said.push([
      `Cycles of faces close within ${length(v.closure)}.`,
      'Where faces meet again around a hole or a corner.',
      small(v.closure),
    ]);
  if (v.openings?.solid !== undefined) {
    const { solid, pattern, features, loops } = v.openings,
      found = pattern + features + (loops ?? 0);
    said.push([
      found === solid
        ? `All openings of the solid are there: ${solid}.`
        : `The solid has ${solid} openings, the pattern ${found}.`,
      'Counted in the solid by Euler’s formula, and in the pattern as it is written.',
      found === solid,
    ]);
  }
  return html`<ul class="certificate ${ui.state.shapeIsDraft ? 'old' : ''}" data-testid="certificate">
      ${said.map(
        ([text, why, good]) => html`<li class=${good ? 'good' : 'bad'}><b>${text}</b><small>${why}</small></li>`,
      )}
    </ul>
    ${(report.notes ?? []).map((n) => html`<p class="hint">${n}</p>`)}`;
}
