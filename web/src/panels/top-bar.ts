import { html, nothing, type TemplateResult } from 'lit-html';
import type { DxfProfile, FileFormat, Kind } from '../types.ts';
import type { Ui } from '../ui.ts';

let profile: DxfProfile = 'standard'; // as last chosen; not part of the document

export function topBar(ui: Ui): TemplateResult {
  const { document: d, past, pending, future, units, theme } = ui.state;
  return html`<span class="brand">Planish<small>studio</small></span>
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
  const kinds: [Kind, string][] = [
    ['unfold', 'Unfold'],
    ['connect', 'Connect'],
    ['transition', 'Transition'],
    ['slit', 'Slit'],
  ];
  return html`<details class="menu">
    <summary class="button" data-testid="examples-menu">Examples ▾</summary>
    <div class="list">
      ${ui.state.examples.length ? nothing : html`<p class="hint">No examples.</p>`}
      ${kinds.map(([kind, title]) => {
        const own = ui.state.examples.filter((e) => e.kind === kind);
        return own.length
          ? html`<h4>${title}</h4>
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

const kindFormats: [FileFormat, string, Kind[]][] = [
  ['svg', 'SVG, flat pattern', ['unfold', 'connect', 'transition', 'slit']],
  ['step', 'STEP, folded', ['connect', 'transition', 'slit']],
  ['flat.step', 'STEP, flat', ['unfold', 'connect', 'transition', 'slit']],
  ['stl', 'STL, folded', ['connect', 'transition', 'slit']],
  ['mould.stl', 'STL, mould', ['slit']],
  ['json', 'JSON, report', ['unfold', 'connect', 'transition', 'slit']],
  ['spec', 'JSON, the edited input', ['connect', 'transition', 'slit']],
];

function downloadMenu(ui: Ui) {
  const kind = ui.state.document?.kind;
  const save = (format: FileFormat) => (e: Event) => {
    closeMenu(e);
    ui.download(format, format === 'dxf' ? profile : undefined);
  };
  return html`<details class="menu right">
    <summary class="button primary" data-testid="download-menu" aria-disabled=${!kind}>Download ▾</summary>
    <div class="list">
      ${!kind
        ? html`<p class="hint">Open something first.</p>`
        : html` <div class="dxf">
              <button data-testid="download-dxf" @click=${save('dxf')}>DXF, flat pattern</button>
              <label
                >layers
                <select
                  data-testid="dxf-profile"
                  @change=${(e: Event) => {
                    profile = (e.target as HTMLSelectElement).value as DxfProfile;
                  }}
                >
                  <option value="standard">standard</option>
                  <option value="inventor">Inventor</option>
                  <option value="onshape">Onshape</option>
                  <option value="solid_edge">Solid Edge</option>
                </select></label
              >
            </div>
            ${kindFormats
              .filter(([, , kinds]) => kinds.includes(kind))
              .map(
                ([format, title]) =>
                  html`<button data-testid="download-${format}" @click=${save(format)}>${title}</button>`,
              )}`}
    </div>
  </details>`;
}

const closeMenu = (e: Event) => (e.target as HTMLElement).closest('details')?.removeAttribute('open');
