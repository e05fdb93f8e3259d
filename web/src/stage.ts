import { Matrix4, Quaternion, Vector3 } from 'three';
import { insideFacet } from './facet.ts';
import { facetTransforms, inverse, product } from './folding.ts';
import { turnedPlace } from './orientation.ts';
import type { Pose } from './sheet-mesh.ts';
import type { OrderAnswer, Scene, Shape, StrokeRow, ToolName, Vec2 } from './types.ts';

/** The sheet and the tools at one time, with the middle of the die's top at the origin. */
export interface Stage {
  stroke: number; // its row
  turn: number; // degrees, of what is pressed
  pose: Pose;
  punch: number; // height of its lowest point
  span: [number, number]; // of the sheet along x, as it lies
  hit: { part: number; tool: ToolName | null } | null; // what collides now
}

/** Shares of a stroke's time: the sheet is brought, the punch comes down, it presses, it goes up. */
export const phases = { brought: 0.34, down: 0.44, pressed: 0.86 };

const degrees = Math.PI / 180;
const lowest = 60; // mm that the punch opens, at least
const highest = 300;

/** An order with what does not change while it is shown. */
export class Stages {
  readonly order: OrderAnswer;
  private readonly shape: Shape;
  private readonly key: (string | null)[]; // by facet: the line that it is turned by
  private readonly total = new Map<string, number>(); // degrees, by line
  private readonly size: number;
  private readonly middle: Vec2;

  constructor(shape: Shape, order: OrderAnswer) {
    this.shape = shape;
    this.order = order;
    const lines = new Map<string, number>();
    for (const row of order.strokes)
      for (const key of keysOf(row)) {
        this.total.set(key, (this.total.get(key) ?? 0) + angleOf(row));
        if (row.press_line) lines.set(row.bends[0]!, Math.max(row.press_line, lines.get(row.bends[0]!) ?? 0));
      }
    this.key = Array.from(shape.facet_parent, (parent, f) => (parent < 0 ? null : lineOf(shape, f, lines)));
    const box = boxOf(shape.points);
    this.size = Math.hypot(box[2] - box[0], box[3] - box[1]);
    this.middle = [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2];
  }

  isOf(shape: Shape, order: OrderAnswer) {
    return shape === this.shape && order === this.order;
  }

  /** The stage at a time: the whole part counts the strokes, the rest is the share of one. */
  at(time: number): Stage | null {
    const { strokes } = this.order;
    if (!strokes.length || !this.shape.facet_parent.length) return null;
    const stroke = Math.min(Math.floor(time), strokes.length - 1),
      share = Math.min(1, Math.max(0, time - stroke)),
      row = strokes[stroke]!,
      turn = turnAt(row, share),
      pose = this.poseAt(stroke, turn);
    const collides = isStopped(row, share);
    if (share < phases.brought) pose.at = this.between(stroke, share / phases.brought, pose);
    return {
      stroke,
      turn,
      pose,
      punch: punchAt(row, turn) + this.opening(stroke) * openAt(share),
      span: spanOf(this.shape, row.scene),
      hit: collides ? { part: this.partOf(row.blocked!.with), tool: row.blocked!.tool } : null,
    };
  }

  private partOf = (name: string | null) => (name === null ? -1 : this.shape.parts.findIndex((p) => p.name === name));

  /** By how much of its angle each facet is turned, while a stroke has turned its lines by so many degrees. */
  shares(stroke: number, turn: number): Float64Array {
    const turned = new Map<string, number>();
    this.order.strokes.slice(0, stroke + 1).forEach((row, i) => {
      for (const key of keysOf(row)) turned.set(key, (turned.get(key) ?? 0) + (i < stroke ? angleOf(row) : turn));
    });
    return Float64Array.from(this.key, (key) =>
      key === null || !this.total.get(key) ? 0 : (turned.get(key) ?? 0) / this.total.get(key)!,
    );
  }

  /** Where the sheet is in the machine while it is pressed. */
  private poseAt(stroke: number, turn: number): Pose {
    const { scene } = this.order.strokes[stroke]!,
      held = this.facetAt(turnedPlace(scene.held, this.shape.turn));
    return { share: this.shares(stroke, turn), held, at: heldAt(scene, this.order.thickness, this.shape.turn, turn) };
  }

  private facetAt([x, y]: Vec2): number {
    const found = this.shape.facet_parent.findIndex((_, f) => insideFacet(this.shape, f, x, y));
    return Math.max(0, found);
  }

  /** How far the punch opens: enough for what stands up. */
  private opening(stroke: number): number {
    const pose = this.poseAt(stroke, 0),
      up = heights(this.shape, pose);
    return Math.min(highest, Math.max(lowest, up + 20 - this.order.thickness));
  }

  /** Where the held facet is between the last stroke and this one: pulled out, turned, and put in again. */
  private between(stroke: number, share: number, to: Pose): number[] {
    const here = matrix(to.at),
      back = this.size * 0.75;
    const from =
      stroke === 0 ? here.clone().premultiply(new Matrix4().makeTranslation(0, -back, 0)) : this.left(stroke, to);
    const middle = this.middleOf(to);
    const [a, b] = [from, here].map((m) => ({
      turn: new Quaternion().setFromRotationMatrix(m),
      at: middle.clone().applyMatrix4(m),
    })) as [{ turn: Quaternion; at: Vector3 }, { turn: Quaternion; at: Vector3 }];
    const s = share * share * (3 - 2 * share),
      angle = a.turn.angleTo(b.turn),
      out = stroke === 0 ? 0 : back * Math.min(1, 0.25 + angle) * Math.sin(Math.PI * s);
    const turn = a.turn.clone().slerp(b.turn, s),
      at = a.at
        .clone()
        .lerp(b.at, s)
        .add(new Vector3(0, -out, 0.3 * out));
    const moved = new Matrix4().makeRotationFromQuaternion(turn);
    moved.setPosition(at.sub(middle.clone().applyMatrix4(moved)));
    return rows(moved);
  }

  /** The held facet of a stroke as the stroke before left it. */
  private left(stroke: number, to: Pose): Matrix4 {
    const last = this.poseAt(stroke - 1, angleOf(this.order.strokes[stroke - 1]!)),
      tree = facetTransforms(this.shape, to.share),
      moved = product(last.at, 0, inverse(tree, 16 * last.held), 0);
    return matrix(product(moved, 0, tree, 16 * to.held));
  }

  /** The middle of the sheet, seen from the held facet. */
  private middleOf(pose: Pose): Vector3 {
    const tree = facetTransforms(this.shape, pose.share),
      own = inverse(tree, 16 * pose.held);
    return new Vector3(this.middle[0], this.middle[1], 0)
      .applyMatrix4(matrix(tree.subarray(0, 16)))
      .applyMatrix4(matrix(own));
  }
}

const angleOf = ({ angle }: StrokeRow) => angle ?? 0;

/** The lines that a stroke presses. */
const keysOf = ({ bends, press_line }: StrokeRow) => bends.map((b) => `${b}/${press_line ?? ''}`);

/** Where in a shape's pattern the edge lies that touches the gauge, in the machine. */
export function gaugeEdge(scene: Scene): { from: number; to: number; y: number } | null {
  if (!scene.gauge) return null;
  const [a, b] = scene.gauge.map((p) => lyingAt(scene, p)) as [Vec2, Vec2];
  return { from: Math.min(a[0], b[0]), to: Math.max(a[0], b[0]), y: Math.max(a[1], b[1]) };
}

/** A place of the report's pattern in the machine, as the sheet lies. */
function lyingAt({ origin, along, pattern_up }: Scene, [x, y]: Vec2): Vec2 {
  const dx = x - origin[0],
    dy = y - origin[1],
    side = pattern_up ? 1 : -1;
  return [dx * along[0] + dy * along[1], side * (along[0] * dy - along[1] * dx)];
}

/** Where the facet that is held lies at a turn: its pattern in the machine, above the die. */
export function heldAt(scene: Scene, thickness: number, quarters: number, turn: number): number[] {
  const [ox, oy] = turnedPlace(scene.origin, quarters),
    [ux, uy] = turnedPlace(scene.along, quarters),
    s = scene.pattern_up ? 1 : -1,
    moment = momentAt(scene, turn),
    c = Math.cos(moment.slope * degrees),
    n = Math.sin(moment.slope * degrees);
  // y runs to the left of x as seen from above
  const [vx, vy] = [-s * uy, s * ux];
  const lying = [ux, uy, 0, -(ux * ox + uy * oy), vx, vy, 0, -(vx * ox + vy * oy), 0, 0, s, -thickness / 2, 0, 0, 0, 1];
  const moved = [1, 0, 0, 0, 0, c, -n, moment.y, 0, n, c, moment.z - moment.die, 0, 0, 0, 1];
  return product(moved, 0, lying, 0);
}

/** The moment of a turn, between those that are given. */
function momentAt({ moments }: Scene, turn: number) {
  const { turn: turns } = moments,
    sign = (turns.at(-1) ?? 0) < 0 ? -1 : 1;
  let i = 1;
  while (i < turns.length - 1 && sign * turns[i]! < sign * turn) ++i;
  const from = turns[i - 1] ?? 0,
    to = turns[i] ?? from,
    t = to === from ? 0 : Math.min(1, Math.max(0, (turn - from) / (to - from)));
  const value = (row: number[]) => row[i - 1]! + t * ((row[i] ?? row[i - 1]!) - row[i - 1]!);
  return {
    slope: value(moments.slope),
    y: value(moments.y),
    z: value(moments.z),
    punch: value(moments.punch),
    die: value(moments.die),
  };
}

/** The punch's height above the die's top. */
function punchAt({ scene }: StrokeRow, turn: number): number {
  const { punch, die } = momentAt(scene, turn);
  return punch - die;
}

/** How far a stroke has turned its lines: no further than where something collides. */
export function turnAt(row: StrokeRow, share: number): number {
  const most = row.blocked?.at_turn ?? angleOf(row),
    t = (share - phases.down) / (phases.pressed - phases.down),
    turn = angleOf(row) * Math.min(1, Math.max(0, t));
  if (row.blocked && t >= 1) return most; // it may collide only when bent beyond its angle
  return row.blocked ? Math.min(turn, most) : turn;
}

/** Whether a stroke that cannot be made has come to where something collides. */
export const isStopped = (row: StrokeRow, share: number): boolean =>
  row.blocked !== null && share > phases.brought && turnAt(row, share) >= (row.blocked.at_turn ?? 0) - 1e-9;

/** From where to where along x the pattern lies. */
function spanOf({ points, turn }: Shape, scene: Scene): [number, number] {
  const [ox, oy] = turnedPlace(scene.origin, turn),
    [ux, uy] = turnedPlace(scene.along, turn);
  let lo = Infinity,
    hi = -Infinity;
  for (let i = 0; i < points.length; i += 2) {
    const x = (points[i]! - ox) * ux + (points[i + 1]! - oy) * uy;
    lo = Math.min(lo, x);
    hi = Math.max(hi, x);
  }
  return [lo, hi];
}

/** How far open the machine is, of its opening. */
function openAt(share: number): number {
  if (share < phases.brought) return 1;
  if (share < phases.down) return 1 - (share - phases.brought) / (phases.down - phases.brought);
  return share <= phases.pressed ? 0 : (share - phases.pressed) / (1 - phases.pressed);
}

/** How high what lies in a pose goes. */
function heights(shape: Shape, pose: Pose): number {
  const tree = facetTransforms(shape, pose.share),
    moved = product(pose.at, 0, inverse(tree, 16 * pose.held), 0);
  let most = 0;
  shape.facet_starts.forEach((polygon, f) => {
    if (f + 1 >= shape.facet_starts.length) return;
    const at = product(moved, 0, tree, 16 * f),
      first = shape.ring_starts[shape.polygon_starts[polygon]!]!,
      end = shape.ring_starts[shape.polygon_starts[shape.facet_starts[f + 1]!]!]!;
    for (let i = first; i < end; ++i)
      most = Math.max(most, at[8]! * shape.points[2 * i]! + at[9]! * shape.points[2 * i + 1]! + at[11]!);
  });
  return most;
}

/** The line that turns the hinge of a facet: of its bend, and of several lines the nearest. */
function lineOf(shape: Shape, f: number, lines: Map<string, number>): string | null {
  const h = shape.facet_hinge,
    x = (h[4 * f]! + h[4 * f + 2]!) / 2,
    y = (h[4 * f + 1]! + h[4 * f + 3]!) / 2;
  const isBend = (row: number) => shape.parts[row]?.kind === 'bend';
  const own = shape.facet_part[f]!,
    parent = shape.facet_part[shape.facet_parent[f]!]!,
    row = isBend(own) ? own : isBend(parent) ? parent : nearestLine(shape, x, y, null).row;
  const name = shape.parts[row]?.name;
  if (name === undefined) return null;
  return lines.has(name) ? `${name}/${nearestLine(shape, x, y, row).number}` : `${name}/`;
}

/** The bend line nearest to a place: its bend, and its number among that bend's, from 1. */
function nearestLine(shape: Shape, x: number, y: number, of: number | null): { row: number; number: number } {
  const l = shape.bend_lines,
    seen = new Map<number, number>();
  let best = { row: -1, number: 1 },
    least = Infinity;
  shape.bend_line_part.forEach((row, i) => {
    const number = (seen.get(row) ?? 0) + 1;
    seen.set(row, number);
    if (of !== null && row !== of) return;
    const ux = l[4 * i + 2]! - l[4 * i]!,
      uy = l[4 * i + 3]! - l[4 * i + 1]!,
      along = Math.min(1, Math.max(0, ((x - l[4 * i]!) * ux + (y - l[4 * i + 1]!) * uy) / (ux * ux + uy * uy || 1))),
      d = Math.hypot(l[4 * i]! + along * ux - x, l[4 * i + 1]! + along * uy - y);
    if (d < least) {
      least = d;
      best = { row, number };
    }
  });
  return best;
}

function boxOf(points: Float32Array): [number, number, number, number] {
  const box: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i += 2) {
    box[0] = Math.min(box[0], points[i]!);
    box[1] = Math.min(box[1], points[i + 1]!);
    box[2] = Math.max(box[2], points[i]!);
    box[3] = Math.max(box[3], points[i + 1]!);
  }
  return box;
}

const matrix = (m: ArrayLike<number>) => new Matrix4().fromArray(Array.from(m)).transpose();
const rows = (m: Matrix4): number[] => m.clone().transpose().toArray();
