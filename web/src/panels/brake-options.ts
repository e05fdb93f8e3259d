import { html, nothing } from 'lit-html';
import { shopOf } from '../allowance.ts';
import type { BrakeOptions } from '../types.ts';
import type { Ui } from '../ui.ts';
import { filesOf, type TableFile } from '../workshop-state.ts';
import { choice, lengthField, numberField, section } from './fields.ts';

/** What a bend order is planned with: tools, material and how strokes are made. */
export function brakeSection(ui: Ui) {
  const { brake } = ui.state.order,
    set = (patch: Partial<BrakeOptions>) =>
      ui.dispatch({ type: 'brake', brake: withoutHoles({ ...ui.state.order.brake, ...patch }) });
  return section(
    'Press brake',
    html`<div class="pick">
        <span>Tools</span
        ><b data-testid="tools-value">${brake.tools ? (brake.tools.name ?? 'a file') : builtInTools(ui)}</b>
        <label class="button"
          >File …<input
            type="file"
            accept=".json"
            hidden
            data-testid="tools-file"
            @change=${(e: Event) => void readTools(e.target as HTMLInputElement, ui)}
        /></label>
        <button class="link" data-testid="tools-clear" @click=${() => set({ tools: undefined })}>Reset</button>
      </div>
      ${keptTools(ui)}
      ${choice(
        'Material',
        'metal',
        brake.metal ?? '',
        [
          ['', 'steel, no springback'],
          ['steel', 'steel'],
          ['stainless', 'stainless steel'],
          ['aluminium', 'aluminium'],
        ] as const,
        (v) => set({ metal: v === '' ? undefined : v }),
      )}
      ${numberField({
        label: 'Springback',
        testid: 'springback',
        value: brake.springback,
        unit: '°',
        min: 0,
        max: 44.9,
        placeholder: brake.metal ? 'the metal’s' : '0',
        on: (v) => set({ springback: v ?? undefined }),
      })}
      ${lengthField(ui, {
        label: 'Clearance',
        testid: 'clearance',
        from: 'mm',
        value: brake.clearance,
        min: 0,
        placeholder: '0',
        on: (v) => set({ clearance: v ?? undefined }),
      })}
      ${waysToBend(ui, brake, set)}`,
  );
}

/** V, radii and gauging: most leave them as they are. */
function waysToBend(ui: Ui, brake: BrakeOptions, set: (patch: Partial<BrakeOptions>) => void) {
  return html`<details class="ways" data-testid="ways-to-bend">
    <summary>V, radii and gauging</summary>
    ${lengthField(ui, {
      label: 'Wanted V',
      testid: 'opening',
      from: 'mm',
      value: brake.opening,
      min: 0.1,
      placeholder: 'by thickness',
      on: (v) => set({ opening: v ?? undefined }),
    })}
    ${choice(
      'V taken',
      'v',
      brake.v ?? 'choice',
      [
        ['choice', 'the best from 4 T to 12 T'],
        ['wanted', 'only the wanted one'],
      ] as const,
      (v) => set({ v: v === 'wanted' ? v : undefined }),
    )}
    ${choice(
      'Inside radius',
      'as-drawn',
      brake.as_drawn ? 'drawn' : 'made',
      [
        ['made', 'what the tools leave'],
        ['drawn', 'only as drawn'],
      ] as const,
      (v) => set({ as_drawn: v === 'drawn' || undefined }),
    )}
    ${choice(
      'Large radii',
      'large-radii',
      brake.large_radii ?? '',
      [
        ['', 'over a V, by bumps, or rolled'],
        ['v', 'over a V'],
        ['bump', 'by bumps'],
        ['roll', 'rolled'],
      ] as const,
      (v) => set({ large_radii: v === '' ? undefined : v }),
    )}
    ${choice(
      'Gauge',
      'gauge-openings',
      brake.gauge_openings ? 'openings' : 'edges',
      [
        ['edges', 'at outer edges'],
        ['openings', 'also in openings'],
      ] as const,
      (v) => set({ gauge_openings: v === 'openings' || undefined }),
    )}
  </details>`;
}

/** A shop profile may say which of the tools that are built in the shop has. */
const builtInTools = ({ state }: Ui) =>
  shopOf(state.input.options)?.tools ? 'from the shop profile' : 'common European';

/** The tools files that were opened on this machine before. */
function keptTools(ui: Ui) {
  const kept = filesOf(ui.state.workshop, 'tools'),
    used = kept.find((f) => f.text === ui.state.order.brake.tools?.content);
  if (!kept.length) return nothing;
  const use = (name: string) => {
    const file = kept.find((f) => f.name === name);
    if (file) useTools(ui, file);
  };
  return html`${choice<string>(
    'Opened before',
    'tools-kept',
    used?.name ?? '',
    [...(used ? [] : [['', 'choose …'] as const]), ...kept.map((f) => [f.name, f.name] as const)],
    use,
  )}
  ${used
    ? html`<p class="row">
        <button
          class="link"
          data-testid="tools-forget"
          @click=${() => ui.dispatch({ type: 'table-forgotten', file: used })}
        >
          Forget it
        </button>
      </p>`
    : nothing}`;
}

function useTools(ui: Ui, file: TableFile) {
  ui.dispatch({ type: 'table-file', file });
  const tools = { name: file.name, content: file.text };
  ui.dispatch({ type: 'brake', brake: { ...ui.state.order.brake, tools } });
}

async function readTools(input: HTMLInputElement, ui: Ui) {
  const file = input.files?.[0];
  input.value = '';
  if (!file) return;
  useTools(ui, { kind: 'tools', name: file.name, text: await file.text() });
}

const withoutHoles = (o: BrakeOptions) =>
  Object.fromEntries(Object.entries(o).filter(([, v]) => v !== undefined)) as BrakeOptions;
