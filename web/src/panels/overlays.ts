import { html } from 'lit-html';
import type { Ui } from '../ui.ts';

const keys: [string, string][] = [
  ['Ctrl O', 'open a file'],
  ['Ctrl Z', 'undo'],
  ['Ctrl Shift Z, Ctrl Y', 'redo'],
  ['F', 'fit both views'],
  ['D', 'measure; Esc ends it'],
  ['← ↑ → ↓, Enter', 'while measuring: to the next thing, pick it'],
  ['V', 'while measuring: to the other view'],
  ['X, G', 'section, see through the sheet'],
  ['1 2 3 4', 'front, top, right, iso'],
  ['Space', 'fold and unfold; play the strokes'],
  ['Alt ↑, Alt ↓', 'move a stroke in the bend order'],
  ['Delete', 'remove the chosen plate, anchor or control point'],
  ['M, T', 'move or turn the chosen plate'],
  ['Esc', 'clear the selection'],
  ['?', 'this list'],
];

/** A dialog of the browser: it takes the focus and gives it back, and Escape closes it. `showHelp` opens it. */
export function helpDialog(ui: Ui) {
  const close = () => ui.dispatch({ type: 'help', help: false });
  return html`<dialog
    aria-label="Keyboard and mouse"
    data-testid="shortcuts"
    @close=${close}
    @click=${(e: Event) => {
      if (e.target === e.currentTarget) close();
    }}
  >
    <div class="card">
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
  </dialog>`;
}

/** Opens or closes the dialog that is drawn. */
export function showHelp(open: boolean) {
  const dialog = document.querySelector<HTMLDialogElement>('dialog')!;
  if (open && !dialog.open) dialog.showModal();
  if (!open && dialog.open) dialog.close();
}

export function foldBar(ui: Ui) {
  const { fold, shape } = ui.state,
    rigid = !shape?.facet_parent.length;
  return html`<button data-testid="animate" title="Fold and unfold (space)" ?disabled=${rigid} @click=${ui.animate}>
      ${fold > 0.5 ? 'Unfold' : 'Fold'}
    </button>
    <label
      ><span>flat</span
      ><input
        type="range"
        data-testid="fold-slider"
        aria-label="Share of the fold"
        ?disabled=${rigid}
        min="0"
        max="1"
        step="0.005"
        .value=${String(fold)}
        @input=${(e: Event) => ui.dispatch({ type: 'fold', fold: Number((e.target as HTMLInputElement).value) })}
      /><span>folded</span></label
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
