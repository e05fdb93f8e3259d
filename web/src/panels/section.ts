import { refusedSolid } from '../refused-solid.ts';
import { html, nothing } from 'lit-html';
import { isInMachine } from '../state.ts';
import { arrangementOf, type SectionAxis } from '../view-state.ts';
import type { Ui } from '../ui.ts';
import { clean, convert, unitName, type DisplayUnit } from '../units.ts';
import type { Vec3 } from '../types.ts';
import { measureButton } from './measures.ts';
import { bendingButton, slitFacts } from './slit-facts.ts';
import './section.css';

const axes: [SectionAxis, string, string][] = [
  ['x', 'X', 'Across the x axis'],
  ['y', 'Y', 'Across the y axis'],
  ['z', 'Z', 'Across the z axis'],
  ['view', 'View', 'Across the current view direction'],
];
const alongAxis: Record<'x' | 'y' | 'z', Vec3> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

/** What the section takes from the folded view: the direction towards the eye, and the part's length along one, mm. */
export interface FoldedPart {
  direction: () => Vec3;
  lengthAlong: (along: Vec3) => number;
}

/** Measuring, section, transparency, and how the views are arranged. */
export function viewTools(ui: Ui, folded: FoldedPart) {
  const { view, shape } = ui.state,
    { section, seeThrough } = view,
    none = !shape?.facet_parent.length,
    stacked = arrangementOf(view) === 'stacked';
  return html`${measureButton(ui)}
    <button
      data-testid="section"
      class=${section.on ? 'on' : ''}
      aria-pressed=${String(section.on)}
      title="Cut the part by a plane (X)"
      ?disabled=${none || isInMachine(ui.state)}
      @click=${() => switchSection(ui, folded.direction())}
    >
      Section
    </button>
    <button
      data-testid="see-through"
      class=${seeThrough ? 'on' : ''}
      aria-pressed=${String(seeThrough)}
      title="See through the sheet (G)"
      ?disabled=${none && !refusedSolid(ui.state).space_faces.length}
      @click=${() => ui.dispatch({ type: 'view', view: { seeThrough: !seeThrough } })}
    >
      Glass
    </button>
    ${bendingButton(ui)}
    <button
      data-testid="arrangement"
      title=${stacked ? 'Both views side by side' : 'The folded part above its pattern: more room for wide patterns'}
      @click=${() => ui.dispatch({ type: 'view', view: { arrangement: stacked ? 'beside' : 'stacked' } })}
    >
      ${stacked ? 'Side by side' : 'Stack'}
    </button>
    ${section.on && !none && !isInMachine(ui.state) ? sectionBar(ui, folded) : nothing} ${slitFacts(ui)}`;
}

/** What is nearer to the eye is cut away. */
function across(axis: SectionAxis, eye: Vec3) {
  const along = axis === 'view' ? eye : alongAxis[axis];
  return { axis, along, flipped: along[0] * eye[0] + along[1] * eye[1] + along[2] * eye[2] < 0 };
}

/** On and off. */
export function switchSection(ui: Ui, eye: Vec3) {
  const { on, axis } = ui.state.view.section;
  ui.dispatch({ type: 'section', section: on ? { on: false } : { on: true, ...across(axis, eye) } });
}

/** As fine as the folded view is, which folds the neutral surface. */
const placeText = (length: number, units: DisplayUnit) =>
  `${clean(convert(length, 'mm', units), units === 'mm' ? 1 : 2)} ${unitName(units)}`;

function sectionBar(ui: Ui, { direction, lengthAlong }: FoldedPart) {
  const { section } = ui.state.view,
    at = placeText(section.at * lengthAlong(section.along), ui.state.units),
    from = section.axis === 'view' ? 'its far end' : `its lower end along ${section.axis}`,
    set = (change: Partial<typeof section>) => ui.dispatch({ type: 'section', section: change });
  return html`<div class="section" data-testid="section-bar">
    <span class="segments" role="group" aria-label="Direction of the section">
      ${axes.map(
        ([axis, name, title]) =>
          html`<button
            data-testid="section-${axis}"
            class=${section.axis === axis ? 'on' : ''}
            aria-pressed=${String(section.axis === axis)}
            title=${title}
            @click=${() => set(across(axis, direction()))}
          >
            ${name}
          </button>`,
      )}
    </span>
    <input
      type="range"
      data-testid="section-slider"
      aria-label="Place of the section"
      aria-valuetext="${at} from ${from}"
      min="0"
      max="1"
      step="0.005"
      .value=${String(section.at)}
      @input=${(e: Event) => set({ at: Number((e.target as HTMLInputElement).value) })}
    />
    <output data-testid="section-place" title="How far the section lies from the part’s end: from ${from}"
      >${at}</output
    >
    <button data-testid="section-flip" title="Show the other side" @click=${() => set({ flipped: !section.flipped })}>
      Flip
    </button>
  </div>`;
}
