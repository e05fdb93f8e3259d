import { html } from 'lit-html';
import type { Options } from '../types.ts';
import type { PickMode } from '../state.ts';
import type { Ui } from '../ui.ts';
import { allowanceSection } from './allowance.ts';
import { bodyList } from './bodies.ts';
import { section } from './fields.ts';

export function unfoldPanel(ui: Ui) {
  const { options } = ui.state.input;
  const set = (patch: Partial<Options>) => ui.editOptions((o) => ({ ...o, ...patch }));
  return html`${bodyList(ui)} ${allowanceSection(ui)}
  ${section(
    'Lying flat',
    html` ${pickRow(
        ui,
        'root',
        'Stays in place',
        options.root === undefined || options.root === 'largest' ? 'the largest flange' : `face ${options.root}`,
        () => set({ root: undefined }),
      )}
      ${pickRow(
        ui,
        'up',
        'Faces up',
        options.up === undefined || options.up === 'auto'
          ? 'chosen by the program'
          : typeof options.up === 'number'
            ? `the side of face ${options.up}`
            : `the ${options.up} side`,
        () => set({ up: undefined }),
      )}
      <p class="row"><button data-testid="up-turn" @click=${() => ui.faceUp(false)}>Turn over</button></p>`,
  )}`;
}

function pickRow(ui: Ui, mode: PickMode, label: string, value: string, clear: () => void) {
  const on = ui.state.pick === mode;
  return html`<div class="pick">
    <span>${label}</span><b data-testid="${mode}-value">${value}</b>
    <button
      class=${on ? 'on' : ''}
      data-testid="pick-${mode}"
      aria-pressed=${on}
      @click=${() => ui.dispatch({ type: 'pick', pick: on ? 'none' : mode })}
    >
      ${on ? 'Click a flange …' : 'Pick'}
    </button>
    <button class="link" data-testid="clear-${mode}" title="Let the program choose" @click=${clear}>Reset</button>
  </div>`;
}
