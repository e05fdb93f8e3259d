import { html, nothing } from 'lit-html';
import type { Ui } from '../ui.ts';
import { chooseFile } from './top-bar.ts';

export function startScreen(ui: Ui) {
  if (ui.state.document) return nothing;
  const firsts = ui.state.description.makers.flatMap(({ name }) =>
    ui.state.examples.filter((e) => e.kind === name).slice(0, 3),
  );
  return html`<div class="start" data-testid="start">
    <h1>Drop a file here</h1>
    <p>A STEP part to unfold, or a plates, transition or slit file (JSON).</p>
    <p><button class="primary" data-testid="start-open" @click=${chooseFile}>Choose a file …</button></p>
    ${firsts.length
      ? html`<h2>or start with an example</h2>
          <div class="tiles">
            ${firsts.map(
              (e) =>
                html`<button data-testid="start-${e.name}" @click=${() => ui.openExample(e.name)}>
                  <b>${e.title}</b><small>${e.kind}</small>
                </button>`,
            )}
          </div>`
      : nothing}
  </div>`;
}

const keys: [string, string][] = [
  ['Ctrl O', 'open a file'],
  ['Ctrl Z', 'undo'],
  ['Ctrl Shift Z, Ctrl Y', 'redo'],
  ['F', 'fit both views'],
  ['D', 'measure; Esc ends it'],
  ['X, G', 'section, see through the sheet'],
  ['1 2 3 4', 'front, top, right, iso'],
  ['Space', 'fold and unfold; play the strokes'],
  ['Alt ↑, Alt ↓', 'move a stroke in the bend order'],
  ['Delete', 'remove the plate, anchor or control point that is chosen'],
  ['M, T', 'move, turn the plate that is chosen'],
  ['Esc', 'clear the selection'],
  ['?', 'this list'],
];

export function helpDialog(ui: Ui) {
  if (!ui.state.help) return nothing;
  const close = () => ui.dispatch({ type: 'help', help: false });
  return html`<div class="dialog" data-testid="shortcuts" @click=${close}>
    <div class="card" role="dialog" aria-label="Keyboard shortcuts" @click=${(e: Event) => e.stopPropagation()}>
      <h2>Keyboard</h2>
      <table>
        ${keys.map(
          ([key, what]) =>
            html`<tr>
              <td><kbd>${key}</kbd></td>
              <td>${what}</td>
            </tr>`,
        )}
      </table>
      <h2>Mouse</h2>
      <table>
        <tr>
          <td>Left</td>
          <td>orbit (folded), pan (flat); a click picks</td>
        </tr>
        <tr>
          <td>Right</td>
          <td>pan (folded)</td>
        </tr>
        <tr>
          <td>Wheel</td>
          <td>zoom to the pointer</td>
        </tr>
      </table>
      <p><button data-testid="shortcuts-close" @click=${close}>Close</button></p>
    </div>
  </div>`;
}

export function foldBar(ui: Ui) {
  const { fold, shape } = ui.state,
    rigid = !shape?.facet_parent.length;
  return html`<button data-testid="animate" title="Fold and unfold (space)" ?disabled=${rigid} @click=${ui.animate}>
      ${fold > 0.5 ? 'Unfold' : 'Fold'}
    </button>
    <label
      >flat<input
        type="range"
        data-testid="fold-slider"
        aria-label="Share of the fold"
        ?disabled=${rigid}
        min="0"
        max="1"
        step="0.005"
        .value=${String(fold)}
        @input=${(e: Event) => ui.dispatch({ type: 'fold', fold: Number((e.target as HTMLInputElement).value) })}
      />folded</label
    >
    <output data-testid="fold-share">${Math.round(100 * fold)} %</output>`;
}

export function viewButtons(ui: Ui) {
  return html`${(['front', 'top', 'right', 'iso'] as const).map(
      (v, i) =>
        html`<button data-testid="view-${v}" title="${v} (${i + 1})" @click=${() => ui.look(v)}>
          ${v[0]!.toUpperCase() + v.slice(1)}
        </button>`,
    )} <button data-testid="view-fit" title="Fit (F)" @click=${ui.fit}>Fit</button>`;
}
