import { html, nothing, svg } from 'lit-html';
import { drawnFeatures } from '../features.ts';
import { pieceOf } from '../report.ts';
import type { Shape } from '../types.ts';
import type { Ui } from '../ui.ts';

/** Above the flat pattern: what its lines mean, of the kinds of lines that it has. */
export function flatTitle(ui: Ui) {
  const { shape } = ui.state,
    features = pieceOf(ui.state)?.flat?.features ?? [];
  if (!shape?.facet_parent.length) return html`<span>${shape ? 'No flat pattern' : 'Flat pattern'}</span>`;
  const goes = directionsIn(shape);
  return html`<span>Flat pattern</span>
    <ul class="legend" data-testid="legend">
      ${line('cut', '--outline', '', 'Contours, openings and slits')}
      ${goes.has('up') ? line('bend up', '--up', '6 2', 'Bend lines of bends towards you') : nothing}
      ${goes.has('down') ? line('bend down', '--down', '7 3 2 3 7', 'Bend lines of bends away from you') : nothing}
      ${shape.edge_feature.some((feature) => feature >= 0)
        ? line('feature', '--form', '', `Drawn, not cut: ${drawnFeatures(shape, features)}`)
        : nothing}
    </ul>`;
}

const line = (name: string, color: string, dashes: string, meaning: string) =>
  html`<li title=${meaning} data-testid="legend-${name.replace(' ', '-')}">
    <svg viewBox="0 0 22 8" style="stroke: var(${color})">
      ${svg`<line x1="0" y1="4" x2="22" y2="4" stroke-dasharray=${dashes} />`}</svg
    >${name}
  </li>`;

/** The directions of the bends that have lines. */
const directionsIn = ({ parts, bend_line_part }: Shape) =>
  new Set([...new Set(bend_line_part)].map((row) => (parts[row]?.direction === 'down' ? 'down' : 'up')));
