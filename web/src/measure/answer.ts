import type { Vec3 } from '../types.ts';
import type { Thing } from './things.ts';

/** What was measured, in mm and degrees, and what is drawn of it. */
export interface Answer {
  value: number;
  of: 'distance' | 'angle' | 'diameter' | 'radius' | 'length';
  more: { name: string; value: number }[]; // lengths, and angles by the name "bend"
  ends: [Vec3, Vec3] | null; // of the dimension line
  beyond: [Vec3, Vec3][]; // lines that are drawn on, or beside
  corner: { at: Vec3; arms: [Vec3, Vec3] } | null; // of an angle: places in the directions of both arms; null: too far
}

const parallel = 0.005 * (Math.PI / 180); // of directions: half of what is displayed
const together = 1e-4; // mm: below what is displayed

/** Between two things; null where nothing can be said. `flat`: in the plane of the pattern. */
export function between(a: Thing, b: Thing, flat: boolean): Answer | null {
  if (rank[a.type] > rank[b.type]) return between(b, a, flat);
  if (a.type === 'plane') return b.type === 'plane' ? planes(a, b) : null;
  if (b.type === 'plane') return a.type === 'line' ? lineToPlane(a, b) : pointToPlane(a.at, b);
  if (a.type === 'line') return b.type === 'line' ? lines(a, b) : null;
  if (b.type === 'line') return pointToLine(a, b);
  return points(a, b, flat);
}
const rank = { point: 0, circle: 1, line: 2, plane: 3 };

/** Of one thing alone. */
export function alone(thing: Thing): Answer | null {
  if (thing.type === 'line') return distance(thing.a, thing.b, 'length');
  if (thing.type !== 'circle') return null;
  const { at, normal, radius, whole } = thing,
    across = scaled(anyAcross(normal), radius),
    ends: [Vec3, Vec3] = [whole ? minus(at, across) : at, plus(at, across)];
  return { ...distance(...ends), value: whole ? 2 * radius : radius, of: whole ? 'diameter' : 'radius' };
}

type Point = Extract<Thing, { type: 'point' | 'circle' }>;
type Line = Extract<Thing, { type: 'line' }>;
type Plane = Extract<Thing, { type: 'plane' }>;

function distance(a: Vec3, b: Vec3, of: Answer['of'] = 'distance'): Answer {
  return { value: norm(minus(b, a)), of, more: [], ends: [a, b], beyond: [], corner: null };
}

function points(a: Point, b: Point, flat: boolean): Answer {
  const answer = distance(a.at, b.at),
    d = minus(b.at, a.at),
    step = (name: string, k: number) => ({ name, value: Math.abs(d[k]!) });
  if (answer.value > together) answer.more.push(step('dx', 0), step('dy', 1), ...(flat ? [] : [step('dz', 2)]));
  if (flat && Math.min(...answer.more.slice(0, 2).map((m) => m.value)) > together) {
    const knee: Vec3 = [b.at[0], a.at[1], 0];
    answer.beyond.push([a.at, knee], [knee, b.at]);
  }
  const rims = [a, b].flatMap((p) => (p.type === 'circle' && p.whole ? [p.radius] : [])),
    circles = [a, b].filter((p) => p.type === 'circle');
  if (rims.length && rims.length === circles.length && inOnePlane(a, b)) {
    const [r, s = 0] = rims as [number, number?],
      gap = answer.value - r - s;
    answer.more.push({
      name: rims.length === 2 ? 'between rims' : 'to the rim',
      value: gap > 0 ? gap : Math.abs(Math.abs(r - s) - answer.value),
    });
  }
  answer.more.push(...sizes(a), ...sizes(b));
  return answer;
}

const sizes = (p: Point) =>
  p.type === 'circle' ? [{ name: p.whole ? 'Ø' : 'R', value: p.whole ? 2 * p.radius : p.radius }] : [];

function inOnePlane(a: Point, b: Point): boolean {
  const d = minus(b.at, a.at);
  return [a, b].every((p) => p.type !== 'circle' || Math.abs(dot(d, p.normal)) <= together) && isParallel(a, b);
}

const isParallel = (a: Point, b: Point) =>
  a.type !== 'circle' || b.type !== 'circle' || norm(cross(a.normal, b.normal)) < parallel;

/** Perpendicular to the line, drawn on where the foot lies beyond its ends. */
function pointToLine(p: Point, { a, b }: Line): Answer {
  const u = unit(minus(b, a)),
    foot = plus(a, scaled(u, dot(minus(p.at, a), u))),
    answer = { ...distance(p.at, foot), beyond: reaching(a, b, foot) };
  if (p.type === 'circle') {
    const inPlane = Math.abs(dot(u, p.normal)) < parallel && Math.abs(dot(minus(foot, p.at), p.normal)) <= together;
    if (p.whole && inPlane && answer.value > p.radius)
      answer.more.push({ name: 'to the rim', value: answer.value - p.radius });
    answer.more.push(...sizes(p));
  }
  return answer;
}

/** From the nearer end of a line to a place on it beyond that end. */
function reaching(a: Vec3, b: Vec3, at: Vec3): [Vec3, Vec3][] {
  const length = norm(minus(b, a)),
    [from, to] = [norm(minus(at, a)), norm(minus(at, b))];
  if (Math.max(from, to) <= length + together) return [];
  return [[from < to ? a : b, at]];
}

/** Parallel lines have a distance, others an angle, on the side on which both lie. */
function lines(p: Line, q: Line): Answer {
  const u = unit(minus(p.b, p.a)),
    v = unit(minus(q.b, q.a)),
    n = cross(u, v),
    sine = norm(n);
  if (sine < parallel) {
    const middle = middleOf(p),
      along = dot(minus(middle, q.a), v),
      foot = plus(q.a, scaled(v, along));
    return { ...distance(middle, foot), beyond: reaching(q.a, q.b, foot) };
  }
  // the nearest places of both: where they cross, if they lie in one plane
  const d = minus(q.a, p.a),
    at = plus(p.a, scaled(u, dot(cross(d, v), n) / sine ** 2)),
    other = plus(q.a, scaled(v, dot(cross(d, u), n) / sine ** 2)),
    far = norm(minus(at, middleOf(p))) > 20 * (norm(minus(p.b, p.a)) + norm(minus(q.b, q.a))),
    arms = [awayFrom(at, p), awayFrom(other, q)] as [Vec3, Vec3],
    gap = norm(minus(other, at));
  return {
    value: degrees(Math.acos(clamp(dot(...arms)))),
    of: 'angle',
    more: gap > together ? [{ name: 'apart', value: gap }] : [],
    ends: null,
    beyond: far ? [[middleOf(p), middleOf(q)]] : [...reaching(p.a, p.b, at), ...reaching(q.a, q.b, other)],
    corner: far ? null : { at, arms: [armOf(at, p, arms[0]), armOf(other, q, arms[1])] },
  };
}

/** The direction in which a line lies from a place on it: of both, the longer way. */
function awayFrom(at: Vec3, { a, b }: Line): Vec3 {
  const [from, to] = [minus(a, at), minus(b, at)];
  return unit(norm(from) > norm(to) ? from : to);
}

const armOf = (at: Vec3, line: Line, direction: Vec3): Vec3 =>
  plus(at, scaled(direction, Math.max(norm(minus(line.a, at)), norm(minus(line.b, at)))));

function pointToPlane(p: Vec3, plane: Plane): Answer {
  const off = dot(minus(p, plane.at), plane.normal);
  return distance(p, minus(p, scaled(plane.normal, off)));
}

function lineToPlane(line: Line, plane: Plane): Answer {
  const sine = dot(unit(minus(line.b, line.a)), plane.normal);
  if (Math.abs(sine) < parallel) return pointToPlane(middleOf(line), plane);
  const u = unit(minus(line.b, line.a)),
    at = plus(line.a, scaled(u, dot(minus(plane.at, line.a), plane.normal) / sine)),
    arm = awayFrom(at, line),
    shadow = minus(arm, scaled(plane.normal, dot(arm, plane.normal))),
    reach = norm(minus(armOf(at, line, arm), at)),
    other = norm(shadow) < 1e-9 ? anyAcross(plane.normal) : unit(shadow);
  return {
    value: degrees(Math.asin(clamp(Math.abs(sine)))),
    of: 'angle',
    more: [],
    ends: null,
    beyond: reaching(line.a, line.b, at),
    corner: { at, arms: [armOf(at, line, arm), plus(at, scaled(other, reach))] },
  };
}

/** Parallel flanges have a distance between the sides picked, others the angle that they enclose. */
function planes(p: Plane, q: Plane): Answer {
  const n = cross(p.normal, q.normal),
    sine = norm(n),
    turned = degrees(Math.atan2(sine, dot(p.normal, q.normal)));
  if (sine < parallel) return pointToPlane(p.at, q);
  // the line in which they cross, at the height of both places
  const middle = scaled(plus(p.at, q.at), 0.5),
    u = unit(n),
    [dp, dq, c] = [dot(p.normal, p.at), dot(q.normal, q.at), dot(p.normal, q.normal)],
    base = plus(scaled(p.normal, (dp - dq * c) / sine ** 2), scaled(q.normal, (dq - dp * c) / sine ** 2)),
    at = plus(base, scaled(u, dot(minus(middle, base), u)));
  const inPlane = (plane: Plane): Vec3 => {
    const d = minus(plane.at, at);
    return plus(at, minus(d, scaled(u, dot(d, u))));
  };
  return {
    value: 180 - turned,
    of: 'angle',
    more: [{ name: 'bend', value: turned }],
    ends: null,
    beyond: [],
    corner: { at, arms: [inPlane(p), inPlane(q)] },
  };
}

const middleOf = ({ a, b }: Line): Vec3 => scaled(plus(a, b), 0.5);
const degrees = (radians: number) => (radians * 180) / Math.PI;
const clamp = (v: number) => Math.max(-1, Math.min(1, v));
const plus = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const scaled = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const norm = (a: Vec3) => Math.hypot(...a);
const unit = (a: Vec3): Vec3 => scaled(a, 1 / (norm(a) || 1));
const anyAcross = (n: Vec3): Vec3 => unit(cross(n, Math.abs(n[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
