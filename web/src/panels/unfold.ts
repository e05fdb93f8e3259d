import { html, nothing } from 'lit-html';
import type { Options } from '../types.ts';
import { hasFlanges } from '../report.ts';
import type { PickMode } from '../state.ts';
import type { Ui } from '../ui.ts';
import { allowanceSection } from './allowance.ts';
import { bodyList } from './bodies.ts';
import { choice, section } from './fields.ts';

const noPattern = 'There is no pattern';

export function unfoldPanel(ui: Ui) {
  const { options } = ui.state.input;
  const set = (patch: Partial<Options>) => ui.editOptions((o) => ({ ...o, ...patch }));
  return html`${bodyList(ui)} ${allowanceSection(ui)}
  ${section(
    'Lying flat',
    html`${rootChoice(ui)}
      <div class="pick">
        ${pickButton(ui, 'root')}<span class="hint" data-testid="pick-hint"
          >${ui.state.pick === 'root' ? 'in a view; Esc cancels' : 'and click it in a view'}</span
        >
      </div>
      <div class="pick">
        <span>Faces up</span
        ><b data-testid="up-value"
          >${options.up === undefined || options.up === 'auto'
            ? 'chosen by the program'
            : typeof options.up === 'number'
              ? `the side of face ${options.up}`
              : `the ${options.up} side`}</b
        >
        ${pickButton(ui, 'up')}
        <button
          class="link"
          data-testid="clear-up"
          title="Let the program choose"
          @click=${() => set({ up: undefined })}
        >
          Reset
        </button>
      </div>
      ${options.rip_edges
        ? html`<div class="pick">
            <span>Ripped along</span
            ><b data-testid="rip-edges">edge ${String(options.rip_edges).replaceAll(',', ', ')}</b><span></span>
            <button
              class="link"
              data-testid="clear-rips"
              title="Close it again"
              @click=${() => set({ rip_edges: undefined })}
            >
              Reset
            </button>
          </div>`
        : nothing}
      <p class="row">
        <button
          data-testid="up-turn"
          ?disabled=${!hasFlanges(ui.state)}
          title=${hasFlanges(ui.state) ? nothing : noPattern}
          @click=${() => ui.faceUp(false)}
        >
          Turn over
        </button>
      </p>`,
  )}`;
}

/** The flange that is not moved by unfolding, by its name. */
function rootChoice(ui: Ui) {
  const { input, shape } = ui.state,
    { root } = input.options,
    flanges = (shape?.parts ?? []).flatMap((p) => (p.kind === 'flange' && p.faces.length ? [p] : [])),
    chosen = typeof root === 'number' ? flanges.find((p) => p.faces.includes(root)) : undefined;
  return choice<string>(
    'Stays in place',
    'root',
    typeof root === 'number' ? String(chosen?.faces[0] ?? root) : 'largest',
    [
      ['largest', 'the largest flange'],
      ...(typeof root === 'number' && !chosen ? [[String(root), `face ${root}`] as const] : []),
      ...flanges.map((p) => [String(p.faces[0]), p.name] as const),
    ],
    (v) => ui.editOptions((o) => ({ ...o, root: v === 'largest' ? undefined : Number(v) })),
  );
}

function pickButton(ui: Ui, mode: PickMode) {
  const possible = hasFlanges(ui.state),
    on = possible && ui.state.pick === mode;
  return html`<button
    ?disabled=${!possible}
    title=${possible ? nothing : noPattern}
    class=${on ? 'on' : ''}
    data-testid="pick-${mode}"
    aria-pressed=${on}
    @click=${() => ui.dispatch({ type: 'pick', pick: on ? 'none' : mode })}
  >
    ${on ? 'Click a flange' : 'Pick'}
  </button>`;
}
