import { html, nothing } from 'lit-html';
import { answerOf, measuredOf } from '../measure/measuring.ts';
import type { Measure } from '../measure/state.ts';
import { nameOfRef, wholeText } from '../measure/text.ts';
import type { Ref } from '../measure/things.ts';
import type { Ui } from '../ui.ts';
import './measures.css';

/** Turns measuring on and off. */
export const measureButton = (ui: Ui) =>
  html`<button
    data-testid="measure"
    class=${ui.state.measure.on ? 'on' : ''}
    aria-pressed=${String(ui.state.measure.on)}
    title="Measure between two things, in either view (D)"
    ?disabled=${measuredOf(ui.state) === null}
    @click=${() => ui.dispatch({ type: 'measure-mode', on: !ui.state.measure.on })}
  >
    Measure
  </button>`;

/** What is to be picked next, and what was measured. */
export function measureList(ui: Ui) {
  const { on, kept } = ui.state.measure;
  if (!on && !kept.length) return nothing;
  return html`<section class="measures" aria-label="Measures" data-testid="measures">
    ${on ? html`<p data-testid="measure-hint" role="status">${hint(ui)}</p>` : nothing}
    ${kept.length
      ? html`<details open>
          <summary>${kept.length === 1 ? '1 measure' : `${kept.length} measures`}</summary>
          <div class="kept">
            <ol>
              ${kept.map((m) => row(ui, m))}
            </ol>
          </div>
          <button data-testid="measure-clear" @click=${() => ui.dispatch({ type: 'measure-clear' })}>Clear all</button>
        </details>`
      : nothing}
  </section>`;
}

function hint(ui: Ui): string {
  const { first } = ui.state.measure;
  if (!first) return 'Pick a corner, an edge, a hole, a bend or, in the folded part, a flange.';
  const the = first.ref.kind === 'flange' || first.ref.kind === 'bend' ? '' : 'the ';
  return `From ${the}${name(ui, first.ref)}: pick a second one, or the same again for its own size. Esc drops it.`;
}

function row(ui: Ui, { id, a, b, view }: Measure) {
  const of = measuredOf(ui.state),
    answer = of && answerOf(of, { a, b, view }),
    text = answer ? wholeText(answer, ui.state.units) : '–',
    what = b ? `${name(ui, a)} – ${name(ui, b)}` : name(ui, a);
  return html`<li data-testid="measure-${id}">
    <span title="${what}, ${view}"><b>${text}</b> <small>${what}</small></span>
    <button
      data-testid="measure-remove-${id}"
      aria-label="Remove ${text}, ${what}"
      title="Remove"
      @click=${() => ui.dispatch({ type: 'measure-remove', id })}
    >
      ×
    </button>
  </li>`;
}

function name(ui: Ui, ref: Ref): string {
  const { shape } = ui.state;
  return shape ? nameOfRef(shape, ref) : '';
}

/** Escape: what was picked first is dropped, then measuring ends. Says whether there was anything to end. */
export function escapeMeasuring(ui: Ui): boolean {
  const { on, first } = ui.state.measure;
  if (on) ui.dispatch(first ? { type: 'measure-drop' } : { type: 'measure-mode', on: false });
  return on;
}
