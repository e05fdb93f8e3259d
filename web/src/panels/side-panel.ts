import { html, nothing, type TemplateResult } from 'lit-html';
import { pieceOf } from '../report.ts';
import type { Tab } from '../state.ts';
import type { PieceReport, Spec } from '../types.ts';
import { areaText, massText } from '../amounts.ts';
import { unconfirmedK } from '../default-k.ts';
import { clean, gaugeText, lengthText, unitName } from '../units.ts';
import type { Ui } from '../ui.ts';
import { bendOrder } from './bend-order.ts';
import { kinds } from './kinds.ts';
import { bendTable } from './bend-table.ts';
import { certificate } from './certificate.ts';
import { findingsList, findingsOf } from './findings.ts';

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
  const panel = kinds[ui.state.document?.kind ?? ''];
  if (!panel || (panel.edits && !ui.state.input.spec))
    return html`<p class="hint">This file cannot be edited here.</p>`;
  return panel.draw(ui);
}

function summary(ui: Ui) {
  const report = pieceOf(ui.state),
    unit = unitName(ui.state.units),
    text = (v: number | null | undefined) => lengthText(v, report?.units, ui.state.units),
    pierces = report?.flat ? (ui.state.shape?.pierces ?? null) : null;
  const rows: [string, string, string][] = [
    [
      `Blank, ${unit}`,
      report?.flat ? `${text(report.flat.size[0])} × ${text(report.flat.size[1])}` : '–',
      'blank-size',
    ],
    ['Thickness', gaugeText(report?.sheet?.thickness, report?.units, ui.state.units), 'sheet-thickness'],
    ['Cut length', text(cutLength(report)), 'cut-length'],
    ['Pierces', pierces === null ? '–' : String(pierces), 'pierces'],
    ['Area', areaText(report?.flat?.area, report?.units, ui.state.units), 'area'],
    ['Mass', massText(report?.sheet?.mass, ui.state.units), 'mass'],
    ['Bends', report?.sheet ? String(report.sheet.bends) : '–', 'bend-count'],
    ['K', kText(report), 'part-k'],
  ];
  return html`<div>
    <dl class="summary">
      ${rows.map(
        ([name, value, id]) =>
          html`<div title=${id === 'mass' ? massOf(report) : (explained[id] ?? nothing)}>
            <dt>${name}</dt>
            <dd data-testid=${id}>${value}</dd>
          </div>`,
      )}
    </dl>
    ${unconfirmed(ui, unconfirmedK(report))}
  </div>`;
}

/** Null where it is not known. */
function cutLength(report: PieceReport | null): number | null {
  const { outer = null, inner = null } = report?.flat?.cutting ?? {};
  return outer === null || inner === null ? null : outer + inner;
}

const explained: Record<string, string> = {
  pierces: 'Contours and slits that are cut',
  area: 'Of one side, without openings',
  'part-k': 'Of all bends',
};

/** What the mass is made of. */
function massOf(report: PieceReport | null): string {
  if (typeof report?.sheet?.mass !== 'number') return 'Needs a density: enter one, or choose a material';
  return report.sheet.volume
    ? 'Volume of the solid as drawn, times density; area × thickness × density differs a little, because of K'
    : 'Area × thickness × density';
}

function kText(report: PieceReport | null): string {
  if (!report?.sheet || !report.flat?.bends.length) return '–';
  return report.sheet.k_factor === null ? 'several' : clean(report.sheet.k_factor, 3);
}

/** A K that nobody chose must be confirmed, or replaced, before the blank can be relied on. */
function unconfirmed(ui: Ui, k: number | null) {
  if (k === null) return nothing;
  const confirm = () =>
    ui.state.input.spec
      ? ui.edit<Spec & { k_factor?: number }>((s) => ({ ...s, k_factor: k }))
      : ui.editOptions((o) => ({ ...o, k }));
  return html`<p class="unconfirmed" data-testid="unconfirmed">
    <span>K ${clean(k, 3)} is only a default.</span>
    <button data-testid="confirm-k" title="The part is made with this K; undo takes it back" @click=${confirm}>
      Confirm it
    </button>
  </p>`;
}
