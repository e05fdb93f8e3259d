import { html, nothing } from 'lit-html';
import { makerOf } from '../state.ts';
import type { OptionRow, Options, Remedy } from '../types.ts';
import type { Ui } from '../ui.ts';

/** The name of an option in requests: "--rip-edges" is `rip_edges`. */
const nameOf = (option: string) => option.replace(/^--/, '').replaceAll('-', '_');

/** A value as requests have it. */
const valueOf = ({ kind }: OptionRow, text: string): string | number | boolean =>
  kind === 'flag' ? text === 'true' : ['number', 'whole', 'length'].includes(kind) ? Number(text) : text;

/** Buttons for what would change something: the options that the maker takes and that are not in force. */
export function remedies(
  ui: Ui,
  { remedy, remedies = remedy ? [remedy] : [] }: { remedy?: Remedy; remedies?: Remedy[] },
) {
  const { input } = ui.state,
    rows = makerOf(ui.state)?.options ?? [];
  const offered = remedies.flatMap(({ option = '', value = '', change = '' }) => {
    const row = rows.find((r) => r.name === nameOf(option));
    if (!row || String(input.options[row.name as keyof Options] ?? row.default) === value) return [];
    return [{ row, value, change }];
  });
  return offered.length
    ? html`<span class="remedies"
        >${offered.map(
          ({ row, value, change }) =>
            html`<button
              data-testid="remedy-${row.name}-${value}"
              title=${row.description}
              @click=${() => ui.editOptions((o) => ({ ...o, [row.name]: valueOf(row, value) }))}
            >
              ${change.replace(/\.$/, '')}
            </button>`,
        )}</span
      >`
    : nothing;
}
