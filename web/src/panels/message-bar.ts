import { html, nothing } from 'lit-html';
import { pickedEdgeText } from '../picked.ts';
import { sentence } from '../said.ts';
import type { State } from '../state.ts';
import type { ApiProblem, Progress } from '../types.ts';
import type { Ui } from '../ui.ts';
import { remedies } from './remedies.ts';

/** A line that is always present, so that nothing moves when a message appears. */
export function messageBar(ui: Ui) {
  const { problem, note, opening, busy, progress } = ui.state,
    shown = opening?.name || note !== null ? null : problem; // a note is newer than the problem
  return html`<span class="pill ${tone(ui.state)}" data-testid="status">${statusOf(ui.state)}</span>
    <span
      class="message ${shown ? 'error' : ''}"
      role="status"
      data-testid="message"
      title=${shown ? `${textOf(shown)} ${placeOf(shown)}` : ''}
      >${shown
        ? html`${textOf(shown)}<small>${placeOf(shown)}</small>`
        : opening?.name
          ? `Opening ${opening.name} …`
          : (note ?? hint(ui.state))}</span
    >
    <span class="work"
      >${opening?.long
        ? bar(ui, opening.progress, 'reading')
        : busy
          ? bar(ui, progress, 'computing')
          : shown && !ui.state.stale
            ? remedies(ui, shown)
            : unfinished(ui.state)
              ? html`<button
                  data-testid="finish"
                  title="Verify it, look for findings, subdivide strips as the file says"
                  @click=${ui.finish}
                >
                  Finish
                </button>`
              : nothing}</span
    >`;
}

/** A draft whose result was abandoned. */
const unfinished = (s: State) => s.document !== null && s.shapeIsDraft && !s.computing && !s.pending && !s.problem;

const textOf = (p: ApiProblem) => sentence(p) + (wantsScans(p) ? ' Drop its files of points on the page too.' : '');

const placeOf = (p: ApiProblem) => `[${p.code}]${p.where ? ` ${p.where}` : ''}`;

const wantsScans = (p: ApiProblem) => p.code === 'cannot_read' && /\/scan\/\d+\/points$/.test(p.where ?? '');

function bar(ui: Ui, progress: Progress | null, otherwise: string) {
  return html`<span>${progress?.stage ?? otherwise}</span
    ><progress aria-label="Progress" data-testid="progress" max="1" .value=${progress?.share ?? 0}></progress>
    <button data-testid="cancel" @click=${() => ui.cancel()}>Cancel</button>`;
}

/** Errors that say nothing about the input. */
const ofServer = new Set([
  'worker_ended',
  'worker_timeout',
  'out_of_memory',
  'internal',
  'no_server',
  'forbidden',
  'page',
  'too_large',
  'too_many_documents',
]);

function statusOf(s: State): string {
  if (s.opening) return 'opening';
  if (s.problem)
    return ofServer.has(s.problem.code) || !s.document || (!s.stale && s.shape?.report.status !== 'refused')
      ? 'error'
      : 'refused';
  if (!s.document) return 'ready';
  if (!s.shape) return 'computing';
  if (s.shapeIsDraft) return 'draft';
  return s.shape.report.status === 'warning' ? 'warning' : 'ok';
}

const tone = (s: State) =>
  (({ ok: 'good', warning: 'warning', refused: 'error', error: 'error' }) as Record<string, string>)[statusOf(s)] ?? '';

function hint(s: State): string {
  if (s.pick === 'root') return 'Click the flange that should stay in place. Esc cancels.';
  if (s.pick === 'up') return 'Click the side that should face up in the flat pattern. Esc cancels.';
  const edge = pickedEdgeText(s);
  if (edge) return edge;
  if (!s.result || s.shapeIsDraft) return '';
  const count = s.result.report.checks.length;
  return count ? `${count} finding${count > 1 ? 's' : ''}; see “Findings”.` : 'No findings.';
}
