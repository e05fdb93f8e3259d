import { html, nothing, type TemplateResult } from 'lit-html';
import { pieceOf } from '../report.ts';
import type { Tab } from '../state.ts';
import { lengthText, unitName } from '../units.ts';
import type { Ui } from '../ui.ts';
import { connectPanel } from './connect.ts';
import { slitPanel } from './slit.ts';
import { bendTable, certificate, findingsList, findingsOf } from './tables.ts';
import { transitionPanel } from './transition.ts';
import { unfoldPanel } from './unfold.ts';

export function sidePanel(ui: Ui): TemplateResult {
  const { tab, document: d } = ui.state,
    count = ui.state.result ? findingsOf(ui).length : 0;
  const tabs: [Tab, string][] = [
    ['input', 'Input'],
    ['bends', 'Bends'],
    ['findings', count ? `Findings ${count}` : 'Findings'],
    ['certificate', 'Certificate'],
  ];
  return html`${summary(ui)}
    <nav class="tabs" role="tablist">
      ${tabs.map(
        ([id, title]) =>
          html`<button
            role="tab"
            aria-selected=${tab === id}
            data-testid="tab-${id}"
            class=${tab === id ? 'on' : ''}
            @click=${() => ui.dispatch({ type: 'tab', tab: id })}
          >
            ${title}
          </button>`,
      )}
    </nav>
    <div class="content" data-testid="panel">${d ? content(ui, tab) : nothing}</div>`;
}

function content(ui: Ui, tab: Tab) {
  if (tab === 'bends') return bendTable(ui);
  if (tab === 'findings') return findingsList(ui);
  if (tab === 'certificate') return certificate(ui);
  const kind = ui.state.document?.kind;
  if (kind === 'unfold') return unfoldPanel(ui);
  if (!ui.state.input.spec) return html`<p class="hint">The file cannot be edited here.</p>`;
  return kind === 'connect' ? connectPanel(ui) : kind === 'transition' ? transitionPanel(ui) : slitPanel(ui);
}

function summary(ui: Ui) {
  const report = pieceOf(ui.state),
    unit = unitName(ui.state.units),
    text = (v: number | undefined) => lengthText(v, report?.units, ui.state.units);
  const rows: [string, string, string][] = [
    [
      `Blank, ${unit}`,
      report?.flat ? `${text(report.flat.size[0])} × ${text(report.flat.size[1])}` : '–',
      'blank-size',
    ],
    ['Thickness', text(report?.sheet?.thickness), 'sheet-thickness'],
    [
      'Cut length',
      report?.flat?.cutting ? text(report.flat.cutting.outer + report.flat.cutting.inner) : '–',
      'cut-length',
    ],
    ['Bends', report?.sheet ? String(report.sheet.bends) : '–', 'bend-count'],
  ];
  return html`<dl class="summary">
    ${rows.map(
      ([name, value, id]) =>
        html`<div>
          <dt>${name}</dt>
          <dd data-testid=${id}>${value}</dd>
        </div>`,
    )}
  </dl>`;
}
