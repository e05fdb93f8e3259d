import {
  Box3,
  BufferGeometry,
  Color,
  EdgesGeometry,
  ExtrudeGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  Shape as Outline,
  Vector2,
  Vector3,
  AmbientLight,
  DirectionalLight,
} from 'three';
import { gaugeEdge, type Stage } from './stage.ts';
import type { Palette } from './theme.ts';
import type { OrderAnswer, StrokeRow, ToolName, Vec2 } from './types.ts';

const beside = 30; // mm by which beams are drawn longer than sheet and tools, though they are as long as the machine
const below = 55; // mm under the die's top that are to be seen
const above = 95;
const creased = 25; // degrees: edges that are drawn; rounded corners have none

type Kind = ToolName | 'finger';

/** Punch, die, beams and the fingers of the gauge, where they stand in a stroke. */
export class MachineObject {
  readonly group = new Group();
  private readonly upper = new Group(); // what moves with the punch
  private readonly lower = new Group();
  private readonly materials: Record<Kind, MeshLambertMaterial>;
  private readonly edges = new LineBasicMaterial({ transparent: true, opacity: 0.45 });
  private palette: Palette | null = null;
  private order: OrderAnswer | null = null;
  private stroke = -1;
  private hit: ToolName | null = null;

  constructor() {
    const tool = () => new MeshLambertMaterial({ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    const beam = () => new MeshLambertMaterial({ transparent: true, opacity: 0.28, depthWrite: false });
    this.materials = { punch: tool(), die: tool(), 'upper beam': beam(), 'lower beam': beam(), finger: tool() };
    const light = new DirectionalLight(0xffffff, 2.2);
    light.position.set(-0.4, -0.8, 1);
    const other = new DirectionalLight(0xffffff, 1.1);
    other.position.set(1, 0.2, 0.25);
    this.group.add(this.upper, this.lower, new AmbientLight(0xffffff, 1.5), light, other);
    this.group.visible = false;
  }

  /** The row of the stroke whose tools stand; −1: none. */
  get shown() {
    return this.stroke;
  }

  /** Shows the machine in a stage; null: nothing. */
  set(order: OrderAnswer | null, stage: Stage | null) {
    this.group.visible = stage !== null;
    if (!order || !stage) {
      this.order = null;
      this.stroke = -1;
      return;
    }
    if (order !== this.order || stage.stroke !== this.stroke) this.stand(order, stage.stroke, stage.span);
    this.upper.position.z = stage.punch;
    this.hit = stage.hit?.tool ?? null;
    this.color();
  }

  paint(palette: Palette) {
    this.palette = palette;
    this.color();
  }

  private color() {
    const { palette, materials } = this;
    if (!palette) return;
    const own: Record<Kind, string> = {
      punch: palette.punch,
      die: palette.die,
      'upper beam': palette.beam,
      'lower beam': palette.beam,
      finger: palette.finger,
    };
    for (const kind of Object.keys(own) as Kind[])
      materials[kind].color.copy(new Color(kind === this.hit ? palette.hit : own[kind]));
    this.edges.color.set(palette.edge);
  }

  /** The tools of a stroke. */
  private stand(order: OrderAnswer, stroke: number, span: [number, number]) {
    this.order = order;
    this.stroke = stroke;
    for (const group of [this.upper, this.lower]) clear(group);
    const row = order.strokes[stroke]!,
      { tools } = order,
      { scene } = row;
    const punch = tools.punches[row.punch] ?? [],
      die = tools.dies[row.die] ?? [];
    for (const [from, length] of scene.punch) this.add(this.upper, 'punch', punch, from, length, scene.across);
    for (const [from, length] of scene.feet)
      this.add(this.upper, 'punch', tools.feet[row.punch] ?? [], from, length, scene.across);
    for (const [from, length] of scene.die) this.add(this.lower, 'die', die, from, length, scene.across);
    const [first, last] = reach(row),
      from = Math.min(first, span[0]),
      long = Math.max(last, span[1]) - from + 2 * beside;
    this.add(this.upper, 'upper beam', tools.upper_beams[row.punch] ?? [], from - beside, long, scene.across);
    this.add(this.lower, 'lower beam', tools.lower_beam, from - beside, long, scene.across);
    this.addFingers(order, row);
  }

  private addFingers({ tools, thickness }: OrderAnswer, row: StrokeRow) {
    const edge = gaugeEdge(row.scene),
      [finger, width] = row.gauge?.nose ? [tools.nose, tools.nose_width] : [tools.finger, tools.finger_width];
    if (!edge || finger.length < 3) return;
    const up = thickness + row.scene.gauge_height,
      section = finger.map(([y, z]): Vec2 => [y, z + up]);
    const length = edge.to - edge.from,
      room = length - width,
      places = length < 3 * width ? [edge.from + room / 2] : [edge.from + 0.1 * room, edge.from + 0.9 * room];
    for (const from of places) this.add(this.lower, 'finger', section, from, width, edge.y);
  }

  private add(to: Group, kind: Kind, section: Vec2[], from: number, length: number, across: number) {
    if (section.length < 3 || length <= 0) return;
    const geometry = prism(section, length);
    const mesh = new Mesh(geometry, this.materials[kind]);
    mesh.position.set(from, across, 0);
    mesh.userData = { kind };
    const lines = new LineSegments(new EdgesGeometry(geometry, creased), this.edges);
    lines.position.copy(mesh.position);
    to.add(mesh, lines);
  }

  /** Where the tools work, along the line that is pressed; the machine goes on above and below. */
  boundsInto(box: Box3) {
    if (!this.group.visible || !this.order) return;
    const row = this.order.strokes[this.stroke]!,
      [from, to] = reach(row);
    for (const x of [from, to]) for (const z of [-below, above]) box.expandByPoint(new Vector3(x, row.scene.across, z));
  }
}

/** From where to where along x the tools of a stroke stand. */
function reach({ scene }: StrokeRow): [number, number] {
  const all = [...scene.punch, ...scene.feet, ...scene.die];
  return [Math.min(...all.map(([from]) => from)), Math.max(...all.map(([from, length]) => from + length))];
}

/** A section (y, z) drawn out along x. */
export function prism(section: Vec2[], length: number): BufferGeometry {
  const outline = new Outline(section.map(([y, z]) => new Vector2(y, z))),
    geometry = new ExtrudeGeometry(outline, { depth: length, bevelEnabled: false, steps: 1 });
  const position = geometry.getAttribute('position'),
    normal = geometry.getAttribute('normal'),
    v = new Vector3();
  // drawn in (y, z) and out along x: the axes change places in turn
  for (const attribute of [position, normal])
    for (let i = 0; i < attribute.count; ++i) {
      v.fromBufferAttribute(attribute, i);
      attribute.setXYZ(i, v.z, v.x, v.y);
    }
  return geometry;
}

function clear(group: Group) {
  for (const child of [...group.children]) {
    if (child instanceof Mesh || child instanceof LineSegments) (child.geometry as BufferGeometry).dispose();
    group.remove(child);
  }
}
