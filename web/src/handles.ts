import {
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  Group,
  Line,
  LineBasicMaterial,
  LineLoop,
  Points,
  PointsMaterial,
  SRGBColorSpace,
  type LineBasicMaterialParameters,
  type Material,
  type Texture,
} from 'three';
import type { Palette } from './theme.ts';
import type { AnchorSpec, SlitSpec } from './edits/slit-types.ts';
import type { Forces } from './slit-forces.ts';
import type { Handles, Vec3 } from './types.ts';

export interface Overlay {
  anchors: AnchorSpec[];
  scale: number; // millimetres in a unit of the anchors
  plate: string | null;
  numbered: string[]; // plates whose edges bear their numbers
  anchor: number | null;
  gizmo: 'translate' | 'rotate';
  ridges: number; // of a strip before it is subdivided
  loads: Pick<SlitSpec, 'loads' | 'symmetric'> | null; // of a slit sheet
  handles: boolean; // whether handles fit what is shown: not while it is partly folded
  before: Vec3[][]; // outlines of strips before the last change
}

export const noOverlay: Overlay = {
  anchors: [],
  scale: 1,
  plate: null,
  numbered: [],
  anchor: null,
  gizmo: 'translate',
  loads: null,
  handles: true,
  before: [],
  ridges: 10,
};

/** Curves and points beside the sheet: handles to drag, and the curves that the sheet follows. */
export class HandleObjects {
  readonly group = new Group();
  private readonly disc: Texture = discTexture();
  private readonly materials = new Map<string, Material>();

  set(
    handles: Handles,
    anchors: AnchorSpec[],
    palette: Palette,
    selected: { plate: string | null; anchor: number | null; numbered: string[]; before: Vec3[][] },
    scale: number,
    ridges: number,
    forces: Forces,
  ) {
    this.clear();
    this.forces(forces, palette);
    const faint = this.line(palette.outline, { transparent: true, opacity: 0.3 });
    for (const outline of selected.before) this.add(new LineLoop(through(outline), faint));
    for (const plate of handles.plates ?? [])
      if (plate.id === selected.plate)
        this.add(new LineLoop(through(plate.corners), this.line(palette.selected, { depthTest: false })));
    for (const plate of handles.plates ?? [])
      if (selected.numbered.includes(plate.id)) this.numbers(plate.corners, palette);
    for (const profile of handles.profiles ?? []) this.curve(profile.points, palette.curve, true);
    for (const curve of [handles.leg_curve, handles.second_leg_curve, handles.seat_curve])
      if (curve) this.curve(curve, palette.curve, false);
    this.points(
      ridgeEnds(handles, ridges).map((r) => r.at),
      palette.ridge,
      5,
    );
    this.points(handles.scan ?? [], palette.scan, 2);
    const at = anchors.map((a) => a.at.map((v) => v * scale) as Vec3);
    this.points(at, palette.anchor, 13);
    if (selected.anchor !== null && at[selected.anchor]) this.points([at[selected.anchor]!], palette.selected, 17);
  }

  /** Never culled: three.js would visit every point of geometry that lives for one frame. */
  private add(object: Line | Points) {
    object.frustumCulled = false;
    this.group.add(object);
  }

  private clear() {
    for (const child of [...this.group.children]) {
      this.group.remove(child);
      (child as Line).geometry.dispose();
    }
  }

  /** Materials are kept: with the last one of a kind three.js discards its program, which is costly to make again. */
  private material<M extends Material>(key: string, make: () => M): M {
    if (!this.materials.has(key)) this.materials.set(key, make());
    return this.materials.get(key) as M;
  }

  private line(color: string, more: LineBasicMaterialParameters = {}) {
    return this.material(`line ${color} ${JSON.stringify(more)}`, () => new LineBasicMaterial({ color, ...more }));
  }

  private curve(points: Vec3[], color: string, closed: boolean) {
    if (points.length > 1) this.add(new (closed ? LineLoop : Line)(through(points), this.line(color)));
  }

  /** Loads as arrows; the centre of mass above the ground that bears it. */
  private forces({ arrows, centre, support }: Forces, palette: Palette) {
    for (const [tail, tip] of arrows) this.curve(arrow(tail, tip), palette.anchor, false);
    this.curve(support, palette.measure, true);
    if (!centre) return;
    this.curve([centre, [centre[0], 0, centre[2]]], palette.measure, false);
    this.points([centre], palette.measure, 15);
  }

  /** The numbers of a plate's edges, as files name them, in the middle of each. */
  private numbers(corners: Vec3[], palette: Palette) {
    corners.forEach((a, i) => {
      const b = corners[(i + 1) % corners.length]!,
        middle = a.map((v, k) => (v + b[k]!) / 2) as Vec3;
      const material = this.material(
        `number ${i} ${palette.label} ${palette.halo}`,
        () =>
          new PointsMaterial({
            size: 20,
            sizeAttenuation: false,
            map: numberTexture(i, palette),
            transparent: true,
            depthTest: false,
          }),
      );
      const point = new Points(through([middle]), material);
      point.renderOrder = 3;
      this.add(point);
    });
  }

  private points(at: Vec3[], color: string, size: number) {
    if (!at.length) return;
    const material = this.material(
      `points ${color} ${size}`,
      () =>
        new PointsMaterial({
          color,
          size,
          sizeAttenuation: false,
          map: this.disc,
          alphaTest: 0.5,
          depthTest: size < 10,
        }),
    );
    const points = new Points(through(at), material);
    if (size >= 10) points.renderOrder = 2;
    this.add(points);
  }
}

export interface RidgeEnd {
  strip: number;
  ridge: number;
  side: 'left' | 'right';
  at: Vec3;
}

/** Around each strip: along its left edge and back along its right one. */
export const stripOutlines = (handles: Handles): Vec3[][] =>
  (handles.ridges ?? []).map((rows) => [...rows.map(([left]) => left), ...rows.map(([, right]) => right).reverse()]);

/** Both ends of the original ridges, `count` quads per strip; those between come from subdivision. */
export function ridgeEnds(handles: Handles, count: number): RidgeEnd[] {
  return (handles.ridges ?? []).flatMap((rows, strip) => {
    const step = Math.max(1, Math.round((rows.length - 1) / count));
    return rows.flatMap(([left, right], row) =>
      row % step
        ? []
        : [
            { strip, ridge: row / step, side: 'left' as const, at: left },
            { strip, ridge: row / step, side: 'right' as const, at: right },
          ],
    );
  });
}

/** A shaft, and a head of two barbs a tenth as long, drawn in one stroke. */
function arrow(tail: Vec3, tip: Vec3): Vec3[] {
  const along = tip.map((v, k) => v - tail[k]!) as Vec3,
    across: Vec3 = Math.hypot(along[0], along[1]) > 0 ? [along[1], -along[0], 0] : [Math.hypot(...along), 0, 0],
    barb = (side: number) => tip.map((v, k) => v - 0.15 * along[k]! + 0.08 * side * across[k]!) as Vec3;
  return [tail, tip, barb(1), tip, barb(-1)];
}

const through = (points: Vec3[]) =>
  new BufferGeometry().setAttribute('position', new BufferAttribute(Float32Array.from(points.flat()), 3));

function discTexture(): Texture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 32;
  const c = canvas.getContext('2d')!;
  c.fillStyle = '#fff';
  c.beginPath();
  c.arc(16, 16, 14, 0, 2 * Math.PI);
  c.fill();
  return new CanvasTexture(canvas);
}

function numberTexture(number: number, palette: Palette): Texture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 40;
  const c = canvas.getContext('2d')!;
  c.fillStyle = palette.halo;
  c.globalAlpha = 0.85;
  c.beginPath();
  c.arc(20, 20, 17, 0, 2 * Math.PI);
  c.fill();
  c.globalAlpha = 1;
  c.fillStyle = palette.label;
  c.font = 'bold 22px system-ui, sans-serif';
  c.textAlign = 'center';
  c.textBaseline = 'middle';
  c.fillText(String(number), 20, 21);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}
