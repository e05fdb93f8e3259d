import { html, nothing, type TemplateResult } from 'lit-html';
import { redoesOrder, undoesOrder } from '../order-state.ts';
import type { Ui } from '../ui.ts';
import { segment } from './blocks.ts';
import { closeMenu, downloadMenu } from './download-menu.ts';

export function topBar(ui: Ui): TemplateResult {
  const { document: d, input, past, pending, future, order, units, theme } = ui.state;
  return html`<h1 class="brand">Planish<small>studio</small></h1>
    <button data-testid="open" title="Open a file (Ctrl+O)" @click=${chooseFile}>Open</button>
    <input
      id="file-input"
      data-testid="file-input"
      type="file"
      multiple
      accept=".step,.stp,.json,.xyz,.txt"
      hidden
      @change=${(e: Event) => {
        const input = e.target as HTMLInputElement;
        if (input.files?.length) ui.openFiles([...input.files]);
        input.value = '';
      }}
    />
    ${examplesMenu(ui)}
    ${d
      ? html`<button
          data-testid="start-page"
          title="Back to the start page; edits are kept among the recent files"
          @click=${ui.close}
        >
          Start page
        </button>`
      : nothing}
    <span class="name" tabindex="-1" data-testid="document-name" title=${d?.name ?? ''}>${d?.name ?? ''}</span>
    <span class="grow"></span>
    <span class="segments"
      ><button
        data-testid="undo"
        title="Undo (Ctrl+Z)"
        ?disabled=${!past.length && !pending && !undoesOrder(order, input)}
        @click=${() => ui.dispatch({ type: 'undo' })}
      >
        ↶ Undo</button
      ><button
        data-testid="redo"
        title="Redo (Ctrl+Shift+Z)"
        ?disabled=${!future.length && !redoesOrder(order, input)}
        @click=${() => ui.dispatch({ type: 'redo' })}
      >
        ↷ Redo
      </button></span
    >
    <span class="segments"
      >${(['mm', 'inch'] as const).map((unit) =>
        segment(unit, `units-${unit}`, units === unit, () => ui.dispatch({ type: 'units', units: unit })),
      )}</span
    >
    <button data-testid="theme" title="Light or dark" @click=${() => ui.setTheme(theme === 'light' ? 'dark' : 'light')}>
      ${theme === 'light' ? 'Dark' : 'Light'}
    </button>
    <button data-testid="help" title="Keyboard shortcuts (?)" @click=${() => ui.dispatch({ type: 'help', help: true })}>
      ?
    </button>
    ${downloadMenu(ui)}`;
}

export const chooseFile = () => document.getElementById('file-input')?.click();

function examplesMenu(ui: Ui) {
  return html`<details class="menu">
    <summary class="button" data-testid="examples-menu">Examples ▾</summary>
    <div class="list">
      ${ui.state.examples.length ? nothing : html`<p class="hint">No examples.</p>`}
      ${ui.state.description.makers.map(({ name }) => {
        const own = ui.state.examples.filter((e) => e.kind === name);
        return own.length
          ? html`<h2>${capitalised(name)}</h2>
              ${own.map(
                (e) =>
                  html`<button
                    data-testid="example-${e.name}"
                    @click=${(ev: Event) => {
                      closeMenu(ev);
                      ui.openExample(e.name);
                    }}
                  >
                    ${e.title}
                  </button>`,
              )}`
          : nothing;
      })}
    </div>
  </details>`;
}

const capitalised = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);
