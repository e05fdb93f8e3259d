import { html, nothing, type TemplateResult } from 'lit-html';
import { pieceOf } from '../report.ts';
import type { Tab } from '../state.ts';
import { lengthText, unitName } from '../units.ts';
import type { Ui } from '../ui.ts';
import { bendOrder } from './bend-order.ts';
import { panels } from './kinds.ts';
import { certificate } from './certificate.ts';
import { findingsList, findingsOf } from './findings.ts';
import { bendTable } from './tables.ts';

export function sidePanel(ui: Ui): TemplateResult {
  const { tab, document: d } = ui.state,
    count = ui.state.result ? findingsOf(ui.state).length : 0;
  const tabs: [Tab, string][] = [
    ['input', 'Input'],
    ['bends', 'Bends'],
    ['order', 'Bend order'],
    ['findings', count ? `Findings ${count}` : 'Findings'],
    ['certificate', 'Certificate'],
  ];
  return html`${summary(ui)}
    <nav class="tabs" role="tablist" aria-label="Panels" @keydown=${besides}>
      ${tabs.map(
        ([id, title]) =>
          html`<button
            role="tab"
            id="tab-${id}"
            aria-controls="panel"
            aria-selected=${tab === id}
            tabindex=${tab === id ? 0 : -1}
            data-testid="tab-${id}"
            class=${tab === id ? 'on' : ''}
            @click=${() => ui.dispatch({ type: 'tab', tab: id })}
          >
            ${title}
          </button>`,
      )}
    </nav>
    <div class="content" id="panel" role="tabpanel" aria-labelledby="tab-${tab}" tabindex="0" data-testid="panel">
      ${d ? content(ui, tab) : nothing}
    </div>`;
}

/** The arrow keys choose the tab beside. */
function besides(e: KeyboardEvent) {
  const by = e.key === 'ArrowRight' ? 1 : e.key === 'ArrowLeft' ? -1 : 0;
  if (!by) return;
  const tabs = [...(e.currentTarget as HTMLElement).querySelectorAll<HTMLElement>('[role=tab]')],
    at = tabs.indexOf(e.target as HTMLElement),
    next = tabs[(at + by + tabs.length) % tabs.length]!;
  next.focus();
  next.click();
  e.preventDefault();
}

function content(ui: Ui, tab: Tab) {
  if (tab === 'bends') return bendTable(ui);
  if (tab === 'order') return bendOrder(ui);
  if (tab === 'findings') return findingsList(ui);
  if (tab === 'certificate') return certificate(ui);
  const panel = panels[ui.state.document?.kind ?? ''];
  if (!panel || (panel.edits && !ui.state.input.spec))
    return html`<p class="hint">This file cannot be edited here.</p>`;
  return panel.draw(ui);
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
