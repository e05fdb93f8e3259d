import { html, nothing, type TemplateResult } from 'lit-html';
import { isRefused, pieceOf } from '../report.ts';
import { severities, type Severity, type State } from '../state.ts';
import type { Finding } from '../types.ts';
import type { Ui } from '../ui.ts';
import { remedies } from './remedies.ts';

/** The findings of what was last computed whole: one for each rule. */
export const findingsOf = (state: State): Finding[] =>
  state.result ? (pieceOf({ ...state, shape: state.result })?.checks ?? []) : [];

/** The same, without places where the list leaves them out. */
export const markedFindings = (state: State): Finding[] =>
  findingsOf(state).map((f) => (state.hidden.includes(f.severity) ? { ...f, at: [], places: [] } : f));

/** The rules in the order of the report, those that are left out by severity too: their numbers stay. */
export function findingsList(ui: Ui): TemplateResult {
  const { state } = ui,
    findings = findingsOf(state);
  if (!state.result) return html`<p class="hint">Findings appear with the full result.</p>`;
  if (findings.length === 0 && isRefused(state))
    return html`<p class="hint" data-testid="no-findings">
      The part was refused, so it was not checked. The reason is at the top, beside “refused”.
    </p>`;
  if (findings.length === 0) return html`<p class="hint" data-testid="no-findings">No findings.</p>`;
  return html`${severityFilter(ui, findings)}
    <ol class="findings ${state.shapeIsDraft ? 'old' : ''}" data-testid="findings">
      ${findings.map((f, i) => (state.hidden.includes(f.severity) ? nothing : finding(ui, f, i)))}
    </ol>`;
}

const names: Record<Severity, [string, string]> = {
  error: ['error', 'errors'],
  warning: ['warning', 'warnings'],
  info: ['note', 'notes'],
};

/** A button for each severity that occurs, with the number of its rules. */
function severityFilter(ui: Ui, findings: Finding[]) {
  const { hidden } = ui.state;
  return html`<div class="severities" role="group" aria-label="Show">
    ${severities.map((severity) => {
      const count = findings.filter((f) => f.severity === severity).length,
        shown = !hidden.includes(severity);
      return count
        ? html`<button
            class="${severity} ${shown ? 'on' : ''}"
            data-testid="show-${severity}"
            aria-pressed=${shown}
            @click=${() => ui.dispatch({ type: 'severity', severity, shown: !shown })}
          >
            ${count} ${names[severity][count === 1 ? 0 : 1]}
          </button>`
        : nothing;
    })}
  </div>`;
}

function finding(ui: Ui, f: Finding, i: number) {
  const chosen = ui.state.selection.finding === i,
    places = f.count ?? 0;
  const choose = () => ui.dispatch({ type: 'select', selection: { finding: chosen ? null : i } });
  return html`<li class="${f.severity} ${chosen ? 'selected' : ''}" data-testid="finding-${i + 1}">
    <button class="finding" aria-expanded=${chosen} @click=${choose}>
      <b aria-label="${names[f.severity][0]} ${i + 1}">${i + 1}</b
      ><span>${f.message}<small>${f.code}${places > 1 ? `, ${places} places` : ''}</small></span>
    </button>
    ${remedies(ui, f)}${chosen ? placesOf(f) : nothing}
  </li>`;
}

/** All places of a chosen finding that has several. */
const placesOf = ({ places, count = 0 }: Finding) =>
  count > 1
    ? html`<ul class="places" data-testid="places" tabindex="0" aria-label="Places">
        ${places.map((place) => html`<li class="${place.severity}">${place.message ?? ''}</li>`)}
      </ul>`
    : nothing;
