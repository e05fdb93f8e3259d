import { html, nothing } from 'lit-html';
import {
  allowanceOf,
  contentOf,
  gaugeDeduction,
  gaugeK,
  gaugeOf,
  kRule,
  materialOf,
  sameAllowance,
  shopOf,
  withK,
  type KRule,
  type Shop,
  type ShopMaterial,
} from '../allowance.ts';
import { pieceOf } from '../report.ts';
import type { ApiProblem, LengthUnit, Options, Place } from '../types.ts';
import type { Ui } from '../ui.ts';
import { clean, convert, gaugeText, lengthText, unitName } from '../units.ts';
import { filesOf, type TableFile } from '../workshop-state.ts';
import { choice, numberField, section, toggle } from './fields.ts';

type FromFile = 'shop' | 'k_table';

const rules: [KRule, string][] = [
  ['default', 'default, 0.44'],
  ['number', 'a number'],
  ['din6935', 'by DIN 6935'],
  ['k_table', 'a bend table'],
  ['shop', 'a shop profile'],
];

/** Where K comes from, and what the part weighs. Files stay on this machine. */
export function allowanceSection(ui: Ui) {
  const { options } = ui.state.input,
    { everyPart } = ui.state.workshop,
    rule = ui.state.settingK?.kind ?? kRule(options);
  const set = (patch: Partial<Options>) => ui.editOptions((o) => ({ ...o, ...patch }));
  return html`${section(
    'Bend allowance',
    html`${choice('K-factor', 'k-rule', rule, rules, (v) => chooseRule(ui, v))}
      ${rule === 'number' || (options.k !== undefined && rule === 'shop')
        ? numberField({
            label: 'K of the part',
            testid: 'k-number',
            value: options.k,
            min: 0,
            max: 1,
            ...(rule === 'shop' ? { placeholder: 'the shop’s' } : {}),
            on: (v) => set({ k: v ?? undefined }),
          })
        : nothing}
      ${rule === 'k_table' ? fileRow(ui, 'k_table', 'Bend table', '.csv,.txt') : nothing}
      ${rule === 'shop' ? shopRows(ui) : nothing}
      ${toggle(
        'For every part opened here',
        'every-part',
        everyPart !== null && sameAllowance(everyPart, options),
        (on) => ui.dispatch({ type: 'every-part', options: on ? allowanceOf(options) : null }),
      )}
      <p class="hint">
        ${options.bend_k
          ? html`${ownK(Object.keys(options.bend_k).length)}
              <button class="link" data-testid="bend-k-clear" @click=${() => set({ bend_k: undefined })}>Clear</button>`
          : 'Each bend may have its own: enter it in the bend table.'}
      </p>`,
  )}
  ${massSection(ui)}`;
}

const ownK = (bends: number) => (bends === 1 ? 'One bend has its own K.' : `${bends} bends have their own K.`);

/** The mass follows from the density: one that is entered, that of the shop's material, or that of the file. */
export function massSection(ui: Ui) {
  const { options } = ui.state.input,
    set = (density: number | undefined) => ui.editOptions((o) => ({ ...o, density }));
  return section(
    'Mass',
    numberField({
      label: 'Density, kg/dm³',
      testid: 'density',
      value: options.density,
      min: 1e-3,
      max: 100,
      placeholder: densityKnown(ui) ? 'from the material' : 'unknown',
      on: (v) => set(v ?? undefined),
    }),
    html`<span class="chips densities"
      >${metals.map(
        ([name, density]) =>
          html`<button
            data-testid="density-${name}"
            aria-pressed=${options.density === density}
            class=${options.density === density ? 'on' : ''}
            title="${density} kg/dm³"
            @click=${() => set(options.density === density ? undefined : density)}
          >
            ${name}
          </button>`,
      )}</span
    >`,
  );
}

/** Radius, K and density of a shop, for files that say their own K otherwise. */
export function shopSection(ui: Ui) {
  const used = ui.state.settingK !== null || ui.state.input.options.shop !== undefined;
  return html`${section(
    'Shop',
    html`${choice(
      'Radius and K',
      'k-rule',
      used ? 'shop' : 'default',
      [
        ['default', 'from the file'],
        ['shop', 'from a shop profile'],
      ] as const,
      (v) => chooseRule(ui, v),
    )}
    ${used ? shopRows(ui) : nothing}`,
  )}
  ${massSection(ui)}`;
}

const metals: [string, number][] = [
  ['steel', 7.85],
  ['stainless', 7.9],
  ['aluminium', 2.7],
];

const densityKnown = (ui: Ui) => pieceOf(ui.state)?.sheet?.mass != null && ui.state.input.options.density === undefined;

function chooseRule(ui: Ui, rule: KRule) {
  if (rule === 'shop' || rule === 'k_table') {
    const [file, ...others] = filesOf(ui.state.workshop, rule);
    ui.dispatch({ type: 'setting-k', settingK: { kind: rule, file: null } });
    if (file && !others.length) void useFile(ui, file);
    return;
  }
  ui.dispatch({ type: 'setting-k', settingK: null });
  ui.editOptions((o) => withK(o, rule === 'number' ? { k: o.k ?? 0.44 } : rule === 'din6935' ? { din6935: true } : {}));
}

/** A file of the workshop: those that were opened before, another one, or one less. */
function fileRow(ui: Ui, kind: FromFile, label: string, accept: string) {
  const { workshop, settingK, input } = ui.state,
    kept = filesOf(workshop, kind),
    used = input.options[kind]?.name ?? '',
    chosen = settingK ? (settingK.file ?? '') : used,
    file = kept.find((f) => f.name === chosen);
  // One that came with the part's own state, after a reload, may have been forgotten since.
  const names = [...new Set([...(chosen ? [chosen] : []), ...kept.map((f) => f.name)])].sort();
  return html`${names.length
      ? choice<string>(
          label,
          `${kind}-file`,
          chosen,
          [...(chosen ? [] : ([['', 'choose …']] as const)), ...names.map((n) => [n, n] as const)],
          (name) => {
            const next = kept.find((f) => f.name === name);
            if (next) void useFile(ui, next);
          },
        )
      : nothing}
    <p class="row">
      ${file
        ? html`<button
            class="link"
            data-testid="${kind}-forget"
            title="Stops keeping ${file.name} on this machine; the part keeps what it took from it"
            @click=${() => ui.dispatch({ type: 'table-forgotten', file })}
          >
            Forget it
          </button>`
        : nothing}
      <label class="button"
        >Open a file …<input
          type="file"
          accept=${accept}
          class="away"
          data-testid="${kind}-open"
          aria-label="Open a ${label.toLowerCase()}"
          @change=${(e: Event) => void openFile(ui, kind, e.target as HTMLInputElement)}
      /></label>
    </p>`;
}

async function openFile(ui: Ui, kind: FromFile, input: HTMLInputElement) {
  const file = input.files?.[0];
  if (!file) return;
  const text = await file.text();
  input.value = '';
  await useFile(ui, { kind, name: file.name, text });
}

/** A file takes effect, and is kept, once the program has understood it; a shop, once its material is known. */
async function useFile(ui: Ui, file: TableFile) {
  const problem = (p: ApiProblem) => ui.dispatch({ type: 'problem', problem: p });
  let content: ReturnType<typeof contentOf>;
  try {
    content = contentOf(file);
  } catch (error) {
    return problem({ code: 'invalid_input', message: `${file.name} is not JSON: ${(error as Error).message}` });
  }
  const with_ = (material?: string) => withK(ui.state.input.options, { ...content, material });
  const materials = file.kind === 'shop' ? namesOfMaterials(content.shop?.content) : [],
    before = ui.state.input.options.material,
    again = materials.find((m) => m === before);
  // A file that names the part's material needs no choice; otherwise the shop is tried with any of its materials.
  const unsaid = await ui.refusal(with_(again)),
    wrong = unsaid && materials.length ? await ui.refusal(with_(materials[0])) : unsaid;
  if (wrong) return problem(inFile(wrong, file));
  ui.dispatch({ type: 'table-file', file });
  if (unsaid) return ui.dispatch({ type: 'setting-k', settingK: { kind: 'shop', file: file.name } });
  ui.dispatch({ type: 'setting-k', settingK: null });
  ui.editOptions((o) => withK(o, { ...content, material: again }));
}

/** What is wrong in a file, by its name instead of its place in the request. */
function inFile(problem: ApiProblem, { kind, name }: TableFile): ApiProblem {
  const content = `/options/${kind}/content`,
    { message, where } = problem;
  if (!where?.startsWith(content)) return problem;
  const of = (place?: Place) => place?.kind === 'pointer' && String(place.id).startsWith(content),
    wording = (problem.wording ?? [{ text: message }]).map((piece) =>
      of(piece.place) ? { ...piece, text: String(piece.place!.id).replace(content, name) } : piece,
    );
  if (!wording.some((piece) => of(piece.place))) wording.unshift({ text: `${name}: ` });
  return { ...problem, wording, where: where.replace(content, name) };
}

/** Of a file that may be anything. */
function namesOfMaterials(content: unknown): string[] {
  const materials = (content as Partial<Shop> | undefined)?.materials;
  return Array.isArray(materials) ? materials.flatMap((m) => (typeof m?.name === 'string' ? [m.name] : [])) : [];
}

function shopRows(ui: Ui) {
  const { settingK, workshop, input } = ui.state,
    file = settingK?.file ? filesOf(workshop, 'shop').find((f) => f.name === settingK.file) : undefined,
    content = file ? contentOf(file) : settingK ? null : { shop: input.options.shop },
    shop = content ? shopOf(content) : null,
    material = shop ? materialOf(shop, settingK ? undefined : input.options.material) : null;
  const use = (name: string) => {
    ui.dispatch({ type: 'setting-k', settingK: null });
    ui.editOptions((o) => withK(o, { ...content, material: name || undefined }));
  };
  return html`${fileRow(ui, 'shop', 'Shop profile', '.json')}
  ${shop && shop.materials.length > 1
    ? choice<string>(
        'Material',
        'shop-material',
        material?.name ?? '',
        [
          ...(material ? [] : [['', settingK ? 'choose …' : 'from the file'] as const]),
          ...shop.materials.map((m) => [m.name, m.name] as const),
        ],
        use,
      )
    : nothing}
  ${shop && material ? gaugeTable(ui, shop, material) : nothing}`;
}

/** What the shop has of the material, and which of it the part is made of. */
function gaugeTable(ui: Ui, shop: Shop, material: ShopMaterial) {
  const sheet = pieceOf(ui.state)?.sheet,
    from: LengthUnit = shop.units ?? 'mm',
    thickness = typeof sheet?.thickness === 'number' ? convert(sheet.thickness, pieceOf(ui.state)?.units, from) : NaN,
    own = gaugeOf(shop, material, thickness),
    units = unitName(ui.state.units),
    text = (v: number) => lengthText(v, from, ui.state.units);
  return html`<table class="gauges" data-testid="gauges">
      <caption>
        ${material.name}${material.density ? `, ${clean(material.density, 3)} kg/dm³` : ''}
      </caption>
      <thead>
        <tr>
          <th>Thickness ${units}</th>
          <th>Radius ${units}</th>
          <th>K</th>
          <th>Deduct. 90° ${units}</th>
        </tr>
      </thead>
      <tbody>
        ${material.gauges.map(
          (g) =>
            html`<tr class=${g === own ? 'selected' : ''} aria-current=${g === own}>
              <td>${gaugeText(g.thickness, from, ui.state.units)}${g === own ? ' ✓' : ''}</td>
              <td>${text(g.inside_radius)}</td>
              <td>${clean(gaugeK(g), 3)}</td>
              <td>${text(gaugeDeduction(g))}</td>
            </tr>`,
        )}
      </tbody>
    </table>
    ${sheet && !own
      ? html`<p class="hint bad" data-testid="no-gauge">
          The part is ${gaugeText(sheet.thickness, pieceOf(ui.state)?.units, ui.state.units)} ${units} thick, which the
          shop does not stock, so its K and radius do not apply.
        </p>`
      : nothing}`;
}
