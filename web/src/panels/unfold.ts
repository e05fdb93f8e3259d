import { html, nothing } from 'lit-html';
import type { BodyInfo, Options } from '../types.ts';
import type { BodyStatus, PickMode } from '../state.ts';
import type { Ui } from '../ui.ts';
import { choice, numberField, section } from './fields.ts';

export function unfoldPanel(ui: Ui) {
  const { options } = ui.state.input,
    bodies = ui.state.document?.info?.bodies ?? [];
  const set = (patch: Partial<Options>) => ui.editOptions((o) => ({ ...o, ...patch }));
  return html` ${bodies.length > 1
    ? section(
        'Body',
        html`<div class="bodies">
          ${choice(
            'Body',
            'body',
            String(options.body ?? bodies[0]!.number),
            bodies.map((b) => [String(b.number), bodyText(b, ui.state.bodies[b.number])] as const),
            (v) => set({ body: Number(v), root: undefined, up: undefined, bend_k: undefined }),
          )}
        </div>`,
      )
    : nothing}
  ${section(
    'Bend allowance',
    html` ${choice(
        'K-factor',
        'k-rule',
        kRule(options),
        [
          ['default', 'default, 0.44'],
          ['number', 'a number'],
          ['din6935', 'by DIN 6935'],
        ] as const,
        (v) => set({ k: v === 'number' ? (options.k ?? 0.44) : undefined, din6935: v === 'din6935' || undefined }),
      )}
      ${options.k !== undefined
        ? numberField({
            label: 'K of the part',
            testid: 'k-number',
            value: options.k,
            min: 0,
            max: 1,
            on: (v) => v !== null && set({ k: v }),
          })
        : nothing}
      <p class="hint">
        ${options.bend_k
          ? html`${Object.keys(options.bend_k).length} bend(s) have a K of their own.
              <button class="link" data-testid="bend-k-clear" @click=${() => set({ bend_k: undefined })}>Clear</button>`
          : 'Each bend may have its own: enter it in the bend table.'}
      </p>`,
  )}
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

/** A body for the list: its name, how many there are, and what is known of it. */
const bodyText = (b: BodyInfo, known: BodyStatus | undefined) =>
  [b.number, `${b.name || 'unnamed'}${b.quantity > 1 ? ` × ${b.quantity}` : ''}`, statusText(known)].join(' · ');

/** What is known of a body. */
const statusText = (known: BodyStatus | undefined): string =>
  known === undefined
    ? '…'
    : known.status === 'refused'
      ? `no flat pattern: ${(known.code ?? 'refused').replaceAll('_', ' ')}`
      : known.status === 'warning'
        ? 'sheet, with warnings'
        : 'sheet';

const kRule = (o: Options) => (o.din6935 ? 'din6935' : o.k === undefined ? 'default' : 'number');

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
