import { html, nothing, type TemplateResult } from 'lit-html';
import type { MakerRow } from '../types.ts';
import type { Ui } from '../ui.ts';
import type { DisplayUnit } from '../units.ts';

// Of the DXF as last chosen, names of its layers and its unit; not part of the document. The unit is the page's until
// another is chosen.
let profile: string | undefined, dxfUnits: DisplayUnit | undefined;

export function topBar(ui: Ui): TemplateResult {
  const { document: d, past, pending, future, units, theme } = ui.state;
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
    <span class="name" data-testid="document-name" title=${d?.name ?? ''}>${d?.name ?? ''}</span>
    <span class="grow"></span>
    <span class="segments"
      ><button
        data-testid="undo"
        title="Undo (Ctrl+Z)"
        ?disabled=${!past.length && !pending}
        @click=${() => ui.dispatch({ type: 'undo' })}
      >
        ↶ Undo</button
      ><button
        data-testid="redo"
        title="Redo (Ctrl+Shift+Z)"
        ?disabled=${!future.length}
        @click=${() => ui.dispatch({ type: 'redo' })}
      >
        ↷ Redo
      </button></span
    >
    <span class="segments"
      ><button
        data-testid="units-mm"
        class=${units === 'mm' ? 'on' : ''}
        @click=${() => ui.dispatch({ type: 'units', units: 'mm' })}
      >
        mm</button
      ><button
        data-testid="units-inch"
        class=${units === 'inch' ? 'on' : ''}
        @click=${() => ui.dispatch({ type: 'units', units: 'inch' })}
      >
        inch
      </button></span
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

function downloadMenu(ui: Ui) {
  const { makers, artifacts } = ui.state.description,
    maker = makers.find((m) => m.name === ui.state.document?.kind);
  const save = (artifact: string, suffix: string) => (e: Event) => {
    closeMenu(e);
    ui.download(artifact, suffix, artifact === 'dxf' ? { profile, units: dxfUnits ?? ui.state.units } : {});
  };
  const button = (name: string, suffix: string, description: string) =>
    html`<button data-testid="download-${name}" @click=${save(name, suffix)}>${description}</button>`;
  const rows = artifacts.filter((a) => maker?.artifacts.includes(a.name));
  return html`<details class="menu right">
    <summary class="button primary" data-testid="download-menu" aria-disabled=${!maker}>Download ▾</summary>
    <div class="list">
      ${!maker
        ? html`<p class="hint">Open something first.</p>`
        : html`${rows.map(({ name, suffix, description }) =>
            name === 'dxf'
              ? html`<div class="dxf">${button(name, suffix, description)}${unitChoice(ui)}${layerChoice(maker)}</div>`
              : button(name, suffix, description),
          )}
          ${maker.editable ? button('spec', '.json', 'JSON, the edited input') : nothing}`}
    </div>
  </details>`;
}

/** A DXF has a unit of its own: what is downloaded says which. */
function unitChoice(ui: Ui) {
  const chosen = dxfUnits ?? ui.state.units;
  return html`<label
    >in
    <select
      data-testid="dxf-units"
      @change=${(e: Event) => {
        dxfUnits = (e.target as HTMLSelectElement).value as DisplayUnit;
      }}
    >
      ${(['mm', 'inch'] as const).map(
        (unit) => html`<option value=${unit} .selected=${unit === chosen}>${unit}</option>`,
      )}
    </select></label
  >`;
}

function layerChoice(maker: MakerRow) {
  const words = maker.options.find((o) => o.name === 'profile')?.words ?? [];
  return html`<label
    >layers
    <select
      data-testid="dxf-profile"
      @change=${(e: Event) => {
        profile = (e.target as HTMLSelectElement).value;
      }}
    >
      ${words.map((word) => html`<option value=${word}>${layerSystems[word] ?? word}</option>`)}
    </select></label
  >`;
}

const layerSystems: Record<string, string> = { inventor: 'Inventor', onshape: 'Onshape', solidedge: 'Solid Edge' };

const closeMenu = (e: Event) => (e.target as HTMLElement).closest('details')?.removeAttribute('open');
