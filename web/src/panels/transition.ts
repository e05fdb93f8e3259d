import { html, nothing } from 'lit-html';
import {
  asKind,
  attitudeOf,
  halfSize,
  profileKind,
  rectangleOf,
  resized,
  seamPlaces,
  turnedTo,
  withProfile,
  type Attitude,
  type ProfileKind,
  type SeamKind,
} from '../edits/transition.ts';
import type { PressLines, Profile, ProfileSpec, Seam, TransitionSpec } from '../edits/transition-types.ts';
import type { Vec2, Vec3 } from '../types.ts';
import { restingSpec, type Ui } from '../ui.ts';
import { shopSection } from './allowance.ts';
import { choice, lengthField, lengthSlider, niceAbove, section, slider } from './fields.ts';
import { kFactorField, thicknessField } from './sheet-fields.ts';

type Set = (patch: Partial<TransitionSpec>, live?: boolean) => void;
type End = 'from' | 'to';

export function transitionPanel(ui: Ui) {
  const spec = ui.state.input.spec as TransitionSpec;
  const set: Set = (patch, live = false) => ui.edit<TransitionSpec>((s) => clear({ ...s, ...patch }), live);
  return html` ${section(
    'Sheet',
    html` ${thicknessField(ui, spec, set)} ${kFactorField(spec, '0.5', set)}
    ${choice(
      'Sizes are',
      'sizes-are',
      spec.sizes_are ?? 'mid',
      [
        ['inside', 'inside'],
        ['mid', 'of the middle'],
        ['outside', 'outside'],
      ] as const,
      (v) => set({ sizes_are: v }),
    )}`,
  )}
  ${profileSection(ui, spec, 'from', 'Profile below', set)} ${profileSection(ui, spec, 'to', 'Profile above', set)}
  ${section('Net', html`${seamFields(ui, spec, set)}${pieceFields(ui, spec, set)}${pressFields(ui, spec, set)}`)}
  ${shopSection(ui)}`;
}

const clear = (s: TransitionSpec) =>
  Object.fromEntries(Object.entries(s).filter(([, v]) => v !== undefined)) as unknown as TransitionSpec;

function profileSection(ui: Ui, spec: TransitionSpec, end: End, title: string, set: Set) {
  const own = spec[end],
    change = (patch: Partial<ProfileSpec>, live = false) => set({ [end]: { ...own, ...patch } }, live);
  const shape = (profile: Profile, live: boolean) => ui.edit<TransitionSpec>((s) => withProfile(s, end, profile), live);
  return section(
    title,
    html` ${choice(
      'Kind',
      `${end}-kind`,
      profileKind(own.profile),
      [
        ['polygon', 'polygon'],
        ['circle', 'circle'],
        ['ellipse', 'ellipse'],
        ['rounded_rectangle', 'rounded rectangle'],
        ['obround', 'obround'],
        ['spline', 'spline'],
      ] as [ProfileKind, string][],
      (kind) => shape(asKind(own.profile, kind), false),
    )}
    ${sizeFields(ui, spec, end, shape)} ${planeFields(ui, spec, end, change)}`,
  );
}

function sizeFields(ui: Ui, spec: TransitionSpec, end: End, on: (p: Profile, live: boolean) => void) {
  const p = spec[end].profile,
    before = restingSpec<TransitionSpec>(ui)[end].profile;
  const most = niceAbove(2.4 * Math.max(...halfSize(before)));
  const size = (label: string, key: string, value: number, to: (v: number) => Profile, max = most) =>
    lengthSlider(ui, spec.units, {
      label,
      testid: `${end}-${key}`,
      value,
      min: max / 200,
      max,
      least: 1e-6,
      step: max / 400,
      on: (v, live) => on(to(v), live),
      commit: ui.commit,
    });
  if ('circle' in p) return size('Radius', 'radius', p.circle.radius, (radius) => ({ circle: { radius } }));
  if ('ellipse' in p)
    return [
      size('Half-axis x', 'rx', p.ellipse.rx, (rx) => ({ ellipse: { ...p.ellipse, rx } })),
      size('Half-axis y', 'ry', p.ellipse.ry, (ry) => ({ ellipse: { ...p.ellipse, ry } })),
    ];
  if ('obround' in p)
    return [
      size('Length', 'length', p.obround.length, (length) => ({ obround: { ...p.obround, length } }), 2 * most),
      size('Width', 'width', p.obround.width, (width) => ({ obround: { ...p.obround, width } }), 2 * most),
    ];
  if ('rounded_rectangle' in p) {
    const r = p.rounded_rectangle;
    return [
      size('Width', 'width', r.width, (width) => ({ rounded_rectangle: { ...r, width } }), 2 * most),
      size('Height', 'height', r.height, (height) => ({ rounded_rectangle: { ...r, height } }), 2 * most),
      size('Radius', 'radius', r.radius, (radius) => ({ rounded_rectangle: { ...r, radius } })),
    ];
  }
  const polygon = 'polygon' in p,
    points = polygon ? p.polygon : p.spline,
    rectangle = polygon ? rectangleOf(points) : null;
  const make = (list: Vec2[]): Profile => (polygon ? { polygon: list } : { spline: list });
  return html` ${rectangle
      ? [
          size('Width', 'width', rectangle.width, (v) => ({ polygon: resized(points, v, rectangle.height) }), 2 * most),
          size(
            'Height',
            'height',
            rectangle.height,
            (v) => ({ polygon: resized(points, rectangle.width, v) }),
            2 * most,
          ),
        ]
      : nothing}
    <details class="corners" ?open=${!rectangle}>
      <summary>${points.length} ${polygon ? 'corners' : 'points'}</summary>
      ${points.map(
        (q, i) =>
          html`<div class="double">
            ${(['x', 'y'] as const).map((axis, k) =>
              lengthField(ui, {
                label: `${i} ${axis}`,
                name: `${axis} of ${polygon ? 'corner' : 'point'} ${i}`,
                testid: `${end}-corner-${i}-${axis}`,
                value: q[k]!,
                from: spec.units,
                on: (v) =>
                  v !== null &&
                  on(make(points.map((r, j) => (j === i ? (k === 0 ? [v, r[1]] : [r[0], v]) : r))), false),
              }),
            )}
            <button
              class="link"
              title="Remove"
              aria-label="Remove corner ${i}"
              ?disabled=${points.length <= 3}
              @click=${() => on(make(points.filter((_, j) => j !== i)), false)}
            >
              ×
            </button>
          </div>`,
      )} <button class="link" @click=${() => on(make(withOneMore(points)), false)}>Add one</button>
    </details>`;
}

/** Between the last and the first, a little outside, so that what was convex stays so. */
function withOneMore(points: Vec2[]): Vec2[] {
  const a = points.at(-1)!,
    b = points[0]!,
    c = points.reduce((s, p) => [s[0] + p[0] / points.length, s[1] + p[1] / points.length] as Vec2, [0, 0] as Vec2);
  const m: Vec2 = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2],
    l = Math.hypot(m[0] - c[0], m[1] - c[1]) || 1,
    out = 0.1 * Math.hypot(a[0] - b[0], a[1] - b[1]);
  return [...points, [m[0] + ((m[0] - c[0]) / l) * out, m[1] + ((m[1] - c[1]) / l) * out]];
}

function planeFields(
  ui: Ui,
  spec: TransitionSpec,
  end: End,
  change: (patch: Partial<ProfileSpec>, live?: boolean) => void,
) {
  const own = spec[end],
    origin = own.frame?.origin ?? [0, 0, 0],
    resting = restingSpec<TransitionSpec>(ui),
    before = resting[end].frame?.origin ?? [0, 0, 0];
  const reach = Math.max(...halfSize(resting.from.profile), ...halfSize(resting.to.profile));
  const move = (k: number, v: number, live: boolean) =>
    change({ frame: { ...own.frame, origin: origin.map((x, i) => (i === k ? v : x)) as Vec3 } }, live);
  const attitude = attitudeOf(own.frame),
    turn = (patch: Partial<Attitude>, live: boolean) =>
      change({ frame: turnedTo(own.frame, { ...attitude, ...patch }) }, live);
  const place = (label: string, key: string, k: number) => {
    const most = niceAbove(Math.max(1.5 * Math.abs(before[k]!), 1.2 * reach));
    return lengthSlider(ui, spec.units, {
      label,
      testid: `${end}-${key}`,
      value: origin[k]!,
      min: -most,
      max: most,
      step: most / 500,
      on: (v, live) => move(k, v, live),
      commit: ui.commit,
    });
  };
  const angle = (label: string, key: keyof Attitude, most: number) =>
    slider({
      label,
      testid: `${end}-${key}`,
      value: attitude[key],
      min: -most,
      max: most,
      step: 0.5,
      unit: '°',
      digits: 2,
      on: (v, live) => turn({ [key]: v }, live),
      commit: ui.commit,
    });
  return html`<details class="plane" ?open=${end === 'to'}>
    <summary>Its plane</summary>
    ${place('Offset x', 'x', 0)}${place('Offset y', 'y', 1)}${place('Height z', 'z', 2)}
    ${angle('Tilt to x', 'tiltX', 90)}${angle('Tilt to y', 'tiltY', 89)}${angle('Twist', 'twist', 180)}
  </details>`;
}

function seamFields(ui: Ui, spec: TransitionSpec, set: Set) {
  const seam = spec.seam,
    first = spec.from.profile,
    kind: SeamKind | 'shortest' = seam ? (Object.keys(seam)[0] as SeamKind) : 'shortest';
  const make = (k: typeof kind): Seam | undefined =>
    k === 'edge' ? { edge: 0 } : k === 'corner' ? { corner: 0 } : k === 'parameter' ? { parameter: 0 } : undefined;
  const numbers =
    kind === 'shortest'
      ? []
      : Array.from({ length: seamPlaces(first, kind) }, (_, i) => [String(i), String(i)] as const);
  const kinds = (
    [
      ['shortest', 'where it is shortest'],
      ['edge', 'in the middle of an edge'],
      ['corner', 'at a corner'],
      ['parameter', 'anywhere'],
    ] as const
  ).filter(([k]) => k === 'shortest' || k === kind || seamPlaces(first, k));
  return html` ${choice('Seam', 'seam', kind, kinds, (v) => set({ seam: make(v) }))}
  ${kind === 'edge' || kind === 'corner'
    ? choice(
        kind === 'edge' ? 'Edge' : 'Corner',
        'seam-number',
        String((seam as Record<string, number>)[kind]),
        numbers,
        (v) => set({ seam: { [kind]: Number(v) } as Seam }),
      )
    : nothing}
  ${kind === 'parameter'
    ? slider({
        label: 'Along the profile',
        testid: 'seam-parameter',
        value: (seam as { parameter: number }).parameter,
        min: 0,
        max: 1,
        least: 0,
        most: 1,
        step: 0.005,
        on: (v, live) => set({ seam: { parameter: v } }, live),
        commit: ui.commit,
      })
    : nothing}`;
}

function pieceFields(ui: Ui, spec: TransitionSpec, set: Set) {
  const count = ui.state.shape?.report.pieces?.length ?? 1,
    piece = ui.state.input.options.piece ?? 0;
  return html` ${choice(
    'Pieces',
    'pieces',
    String(spec.pieces ?? 1),
    [
      ['1', 'one'],
      ['2', 'two halves'],
      ['per_side', 'one for each side'],
    ] as [string, string][],
    (v) => {
      set({ pieces: v === 'per_side' ? v : v === '2' ? 2 : 1 });
      if (piece) ui.editOptions((o) => ({ ...o, piece: undefined }));
    },
  )}
  ${count > 1
    ? choice(
        'Shown',
        'piece',
        String(piece),
        Array.from({ length: count }, (_, i) => [String(i), `piece ${i + 1} of ${count}`] as const),
        (v) => ui.editOptions((o) => ({ ...o, piece: Number(v) || undefined })),
      )
    : nothing}`;
}

function pressFields(ui: Ui, spec: TransitionSpec, set: Set) {
  const lines = spec.press_lines,
    kind = lines ? (Object.keys(lines)[0] as 'count' | 'max_angle' | 'chord') : 'rolled';
  const chord = niceAbove(Math.max(...halfSize(spec.from.profile), ...halfSize(spec.to.profile)) / 2);
  const make = (k: typeof kind): PressLines | undefined =>
    k === 'count'
      ? { count: 9 }
      : k === 'max_angle'
        ? { max_angle: 10 }
        : k === 'chord'
          ? { chord: chord / 5 }
          : undefined;
  return html` ${choice(
    'Curved parts',
    'press-lines',
    kind,
    [
      ['rolled', 'rolled'],
      ['count', 'pressed, number of lines'],
      ['max_angle', 'pressed, angle of a line'],
      ['chord', 'pressed, distance between lines'],
    ] as const,
    (v) => set({ press_lines: make(v) }),
  )}
  ${lines && 'count' in lines
    ? slider({
        label: 'Lines per bend',
        testid: 'press-count',
        value: lines.count,
        min: 1,
        max: 60,
        least: 1,
        whole: true,
        step: 1,
        on: (v, live) => set({ press_lines: { count: v } }, live),
        commit: ui.commit,
      })
    : nothing}
  ${lines && 'max_angle' in lines
    ? slider({
        label: 'At most',
        testid: 'press-angle',
        value: lines.max_angle,
        min: 1,
        max: 45,
        least: 1e-3,
        step: 0.5,
        unit: '°',
        on: (v, live) => set({ press_lines: { max_angle: v } }, live),
        commit: ui.commit,
      })
    : nothing}
  ${lines && 'chord' in lines
    ? lengthSlider(ui, spec.units, {
        label: 'Distance',
        testid: 'press-chord',
        value: lines.chord,
        min: chord / 50,
        max: chord,
        least: 1e-6,
        step: chord / 200,
        on: (v, live) => set({ press_lines: { chord: v } }, live),
        commit: ui.commit,
      })
    : nothing}`;
}
