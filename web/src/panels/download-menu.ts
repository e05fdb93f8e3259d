import { html, nothing, type TemplateResult } from 'lit-html';
import { dxfOptions, dxfUnit, type DxfChoices } from '../dxf-choices.ts';
import { isRefused } from '../report.ts';
import { makerOf } from '../state.ts';
import { refusedByClick } from '../typing.ts';
import type { LengthUnit, MakerRow, Options } from '../types.ts';
import type { Ui } from '../ui.ts';
import { choice, lengthField, toggle } from './fields.ts';

type Profile = NonNullable<Options['profile']>;

export function downloadMenu(ui: Ui): TemplateResult {
  const { artifacts } = ui.state.description,
    maker = makerOf(ui.state);
  const save = (artifact: string, suffix: string) => (e: Event) => {
    const field = refusedByClick();
    if (field) return field.select(); // what is wrong in it has been said
    closeMenu(e);
    const { dxf } = ui.state.workshop;
    ui.download(artifact, suffix, artifact === 'dxf' && maker ? dxfOptions(dxf, maker, ui.state.units) : {});
  };
  const refused = isRefused(ui.state);
  const button = (name: string, suffix: string, description: string, isAlways = false) =>
    html`<button
      data-testid="download-${name}"
      ?disabled=${refused && !isAlways}
      title=${refused && !isAlways ? 'Refused: there is nothing to write. The reason is at the top.' : nothing}
      @click=${save(name, suffix)}
    >
      ${description}
    </button>`;
  const rows = artifacts.filter((a) => maker?.artifacts.includes(a.name)),
    dxf = rows.find((a) => a.name === 'dxf');
  return html`<details class="menu right downloads">
    <summary class="button primary" data-testid="download-menu" aria-disabled=${!maker}>Download ▾</summary>
    <div class="list">
      ${!maker
        ? html`<p class="hint">Open something first.</p>`
        : html`${refused
            ? html`<p class="hint" data-testid="download-refused">
                Refused: there is no pattern to write. The reason is at the top.
              </p>`
            : nothing}
          ${dxf
            ? html`<div class="dxf" data-testid="dxf-panel">
                ${button(dxf.name, dxf.suffix, dxf.description)} ${dxfPanel(ui, maker)}
              </div>`
            : nothing}
          ${rows.filter((a) => a !== dxf).map((a) => button(a.name, a.suffix, a.description, a.role === 'report'))}
          ${maker.editable ? button('spec', '.json', 'JSON, the edited input', true) : nothing}`}
    </div>
  </details>`;
}

/** The focus goes back to where the menu was opened. */
export function closeMenu(e: Event) {
  const menu = (e.target as HTMLElement).closest('details');
  menu?.removeAttribute('open');
  menu?.querySelector('summary')?.focus();
}

const layerSystems: Record<string, string> = { inventor: 'Inventor', onshape: 'Onshape', solidedge: 'Solid Edge' };
const unitNames: Record<LengthUnit, string> = { mm: 'mm', inch: 'inch', m: 'm' };

/** The choices of a DXF, those that the maker takes. A shop profile may have chosen layers and release already. */
function dxfPanel(ui: Ui, maker: MakerRow) {
  const { dxf } = ui.state.workshop,
    words = (name: string) => maker.options.find((o) => o.name === name)?.words ?? [],
    takes = (name: keyof DxfChoices) => maker.options.some((o) => o.name === name),
    set = (patch: DxfChoices) =>
      ui.dispatch({ type: 'dxf', dxf: withoutHoles({ ...ui.state.workshop.dxf, ...patch }) });
  const ofShop = ui.state.input.options.shop ? ([['', 'from the shop profile']] as const) : [];
  const rows = [
    takes('units') &&
      choice(
        'Unit',
        'dxf-units',
        dxfUnit(dxf, ui.state.units),
        words('units').map((w) => [w as LengthUnit, unitNames[w as LengthUnit]] as const),
        (units) => set({ units }),
      ),
    takes('r12') &&
      choice<string>(
        'Release',
        'dxf-release',
        dxf.r12 === undefined ? (ofShop.length ? '' : '2000') : dxf.r12 ? '12' : '2000',
        [
          ...ofShop.map(([v]) => [v, 'from the shop profile'] as const),
          ['2000', '2000 (AC1015)'],
          ['12', '12 (AC1009)'],
        ],
        (v) => set({ r12: v === '12' ? true : v === '2000' && ofShop.length ? false : undefined }),
      ),
    takes('profile') &&
      choice<Profile | ''>(
        'Layers',
        'dxf-profile',
        dxf.profile ?? (ofShop.length ? '' : 'default'),
        [...ofShop, ...words('profile').map((w) => [w as Profile, layerSystems[w] ?? 'Planish'] as const)],
        (v) => set({ profile: v === '' || (v === 'default' && !ofShop.length) ? undefined : v }),
      ),
    takes('bend_marks') &&
      choice(
        'Bend lines',
        'dxf-marks',
        dxf.bend_marks ?? 'lines',
        [
          ['lines', 'whole'],
          ['ticks', 'their ends only'],
        ] as const,
        (v) => set({ bend_marks: v === 'lines' ? undefined : v }),
      ),
    takes('tick_length') &&
      dxf.bend_marks === 'ticks' &&
      lengthField(ui, {
        label: 'Length of the ends',
        testid: 'dxf-tick',
        from: 'mm',
        value: dxf.tick_length ?? 5,
        min: 1e-3,
        on: (v) => set({ tick_length: v ?? undefined }),
      }),
    takes('tangent_lines') &&
      toggle(
        dxf.profile === 'solidedge' ? 'Limits of bend zones (no layer for them)' : 'Limits of bend zones',
        'dxf-tangent',
        dxf.tangent_lines ?? false,
        (on) => set({ tangent_lines: on || undefined }),
      ),
    takes('splines') &&
      choice(
        'Splines',
        'dxf-splines',
        dxf.r12 ? 'arcs' : (dxf.splines ?? 'arcs'),
        dxf.r12
          ? ([['arcs', 'as arcs']] as const)
          : ([
              ['arcs', 'as arcs'],
              ['keep', 'as splines'],
            ] as const),
        (v) => set({ splines: v === 'arcs' ? undefined : v }),
      ),
    takes('arc_tolerance') &&
      (dxf.r12 || dxf.splines !== 'keep') &&
      lengthField(ui, {
        label: 'Arcs within',
        testid: 'dxf-arcs',
        from: 'mm',
        value: dxf.arc_tolerance ?? 0.01,
        min: 1e-5,
        max: 10,
        on: (v) => set({ arc_tolerance: v ?? undefined }),
      }),
    takes('bend_text') &&
      toggle('Text at each bend', 'dxf-text', dxf.bend_text ?? false, (on) => set({ bend_text: on || undefined })),
    takes('turn_to_blank') &&
      toggle('Turned to the blank', 'dxf-turned', dxf.turn_to_blank ?? false, (on) =>
        set({ turn_to_blank: on || undefined }),
      ),
  ];
  return html`${rows.map((row) => row || nothing)}
    <p class="kept">
      <span>Kept on this machine.</span>
      <button
        class="link"
        data-testid="dxf-reset"
        ?disabled=${Object.keys(dxf).length === 0}
        @click=${() => ui.dispatch({ type: 'dxf', dxf: {} })}
      >
        Back to the defaults
      </button>
    </p>`;
}

const withoutHoles = (choices: DxfChoices): DxfChoices =>
  Object.fromEntries(Object.entries(choices).filter(([, v]) => v !== undefined));
