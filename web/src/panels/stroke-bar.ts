import { html, nothing } from 'lit-html';
import { nameOf } from '../order-state.ts';
import { byPlates } from '../said.ts';
import { isStopped, turnAt } from '../stage.ts';
import type { Ui } from '../ui.ts';
import { clean, lengthText, unitName } from '../units.ts';
import { changesBefore, inOpening } from './bend-order.ts';

/** Below the part in the machine: from one stroke to the next, and what is seen. */
export function strokeBar(ui: Ui) {
  const { order } = ui.state,
    strokes = order.answer?.strokes ?? [],
    most = strokes.length,
    at = Math.min(Math.floor(order.time), most - 1),
    row = strokes[at];
  const step = (by: number) => ui.showStroke(Math.min(most - 1, Math.max(0, at + by)));
  return html`<button
      class="step"
      data-testid="stroke-back"
      aria-label="Stroke before"
      title="Stroke before"
      ?disabled=${at <= 0}
      @click=${() => step(-1)}
    >
      ‹
    </button>
    <button data-testid="stroke-play" title="Play the strokes (space)" ?disabled=${most === 0} @click=${ui.playStrokes}>
      ${order.playing ? 'Pause' : 'Play'}
    </button>
    <button
      class="step"
      data-testid="stroke-next"
      aria-label="Next stroke"
      title="Next stroke"
      ?disabled=${at >= most - 1}
      @click=${() => step(1)}
    >
      ›
    </button>
    <label
      ><input
        type="range"
        data-testid="stroke-slider"
        aria-label="Strokes"
        aria-valuetext=${row ? `stroke ${at + 1} of ${most}, ${nameOf(row)}` : 'no strokes'}
        min="0"
        max=${most}
        step="0.01"
        .value=${String(order.time)}
        @input=${(e: Event) => ui.showTime(Number((e.target as HTMLInputElement).value))}
    /></label>
    <output data-testid="stroke-shown"
      >${row ? `${at + 1} of ${most} · ${nameOf(row)} · ${clean(turnAt(row, order.time - at), 0)}°` : nothing}</output
    >`;
}

/** Above the part in the machine: which tool is which, and what collides. */
export function machineLegend(ui: Ui) {
  const { order, units } = ui.state,
    strokes = order.answer?.strokes ?? [],
    at = Math.min(Math.floor(order.time), strokes.length - 1),
    row = strokes[at];
  if (!row || !order.answer) return nothing;
  const gauge = row.gauge
    ? `gauge ${lengthText(row.gauge.distance, order.answer.units, units)} ${unitName(units)}${inOpening(row)}`
    : null;
  const hit = isStopped(row, order.time - at) ? row.blocked?.tool : null,
    color = (own: string, ...names: string[]) => (hit && names.includes(hit) ? '--hit' : own);
  const tools: [string, string][] = [
    [color('--punch', 'punch'), `punch ${row.punch}`],
    [color('--die', 'die'), `die ${row.die}`],
    [color('--beam', 'upper beam', 'lower beam'), 'beams'],
    ...(gauge ? [['--finger', gauge] as [string, string]] : []),
  ];
  return html`<details class="folding" data-testid="machine-tools"><summary>Tools</summary></details>
    <ul class="legend" data-testid="machine-legend">
      ${tools.map(([shown, name]) => html`<li><i style="background: var(${shown})"></i>${name}</li>`)}
    </ul>
    <p>
      <b>Stroke ${at + 1}: ${nameOf(row)}</b>
      ${changesBefore(order.answer, at).map((c) => html`<i class="change">${c}</i>`)}
    </p>
    ${row.blocked ? html`<p class="bad" data-testid="collision">${byPlates(ui.state, row.blocked)}</p>` : nothing}`;
}
