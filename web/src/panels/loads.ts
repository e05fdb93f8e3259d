import { html, nothing } from 'lit-html';
import type { SlitsLoad, SlitsMaterial } from '../../generated/slits.ts';
import type { SlitSpec } from '../edits/slit-types.ts';
import { millimetres } from '../units.ts';
import { numberField, toggle } from './fields.ts';

type Set = (patch: Partial<SlitSpec>) => void;

const springSteel: SlitsMaterial = { young: 200000, poisson: 0.3, density: 7.85, yield: 1100 };

/** The material as far as the file holds it; what a file of its own says is not known here. */
export const materialOf = ({ material }: SlitSpec): SlitsMaterial | null =>
  typeof material === 'object' ? material : null;

/** N mm, of which reports give what a rigidity of 1 has. */
export function rigidityOf(spec: SlitSpec): number | null {
  const material = materialOf(spec),
    thickness = spec.thickness * millimetres(spec.units);
  return material && (material.young * thickness ** 3) / (12 * (1 - (material.poisson ?? 0.3) ** 2));
}

/** In joules where the material is known. */
export const energyUnit = (spec: SlitSpec) => (rigidityOf(spec) ? 'J' : 'of D = 1');
export const energyText = (energy: number, spec: SlitSpec) =>
  String(Number(((energy * (rigidityOf(spec) ?? 1000)) / 1000).toPrecision(4)));
export const stressText = (stress: number | null | undefined) => (stress == null ? '–' : String(Math.round(stress)));

/** What bends the sheet besides its ends. */
export function loadFields(spec: SlitSpec, set: Set) {
  const named = typeof spec.material === 'string' ? spec.material : null;
  return html`${named
    ? html`<p class="hint">Material of ${named}.</p>`
    : toggle('Material is known', 'material', spec.material !== undefined, (on) =>
        set({ material: on ? springSteel : undefined }),
      )}
  ${materialFields(spec, set)}
  ${toggle('Its weight bends it', 'gravity', spec.gravity ?? false, (on) => set({ gravity: on || undefined }))}
  ${toggle('On the ground', 'ground', spec.ground ?? false, (on) => set({ ground: on || undefined }))}
  ${(spec.loads ?? []).map((load, i) => loadBlock(spec, load, i, set))}
  ${spec.material === undefined
    ? nothing
    : html`<p class="row">
        <button
          class="link"
          data-testid="load-add"
          @click=${() => set({ loads: [...(spec.loads ?? []), { strip: 0, at: 1, force: [0, -100, 0] }] })}
        >
          Add a load
        </button>
      </p>`}`;
}

const numbers: [keyof SlitsMaterial, string, string][] = [
  ['young', 'Young’s modulus, N/mm²', ''],
  ['poisson', 'Poisson’s ratio', '0.3'],
  ['density', 'Density, kg/dm³', 'none'],
  ['yield', 'Yield stress, N/mm²', 'none'],
];

function materialFields(spec: SlitSpec, set: Set) {
  const material = materialOf(spec);
  if (!material) return nothing;
  return numbers.map(([key, label, otherwise]) =>
    numberField({
      label,
      testid: `material-${key}`,
      value: material[key],
      min: 0,
      placeholder: otherwise,
      on: (v) => set({ material: { ...material, [key]: v ?? undefined } }),
    }),
  );
}

function loadBlock(spec: SlitSpec, load: SlitsLoad, i: number, set: Set) {
  const all = spec.loads ?? [],
    change = (patch: Partial<SlitsLoad>) => set({ loads: all.map((l, j) => (j === i ? { ...l, ...patch } : l)) });
  return html`<div class="block open" data-testid="load-${i}">
    ${numberField({
      label: 'On strip',
      testid: 'load-strip',
      value: load.strip + 1,
      min: 1,
      max: 200,
      whole: true,
      on: (v) => v && change({ strip: v - 1 }),
    })}
    ${numberField({
      label: 'At this share of its length',
      testid: 'load-at',
      value: load.at,
      min: 0,
      max: 1,
      placeholder: 'spread over it',
      on: (v) => change({ at: v ?? undefined }),
    })}
    ${forceFields(load, (force) => change({ force }))}
    <p class="row">
      <button
        class="link"
        data-testid="load-remove"
        @click=${() => set({ loads: all.length > 1 ? all.filter((_, j) => j !== i) : undefined })}
      >
        Remove
      </button>
    </p>
  </div>`;
}

const forceFields = (load: SlitsLoad, on: (force: SlitsLoad['force']) => void) =>
  html`<div class="triple">
    ${(['x', 'y', 'z'] as const).map((axis, k) =>
      numberField({
        label: `${axis}, N`,
        testid: `load-${axis}`,
        value: load.force[k] ?? 0,
        on: (v) => v !== null && on(load.force.map((f, j) => (j === k ? v : f)) as SlitsLoad['force']),
      }),
    )}
  </div>`;
