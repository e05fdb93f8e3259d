import type { Palette } from '../theme.ts';
import type { Vec2, Vec3 } from '../types.ts';
import type { Answer } from './answer.ts';
import { placeOfText, type Taken } from './text-place.ts';
import type { Ref, Thing } from './things.ts';

export type Project = (at: Vec3) => Vec2;

/**
 * A dimension in a view: its line and what it goes by. What is returned writes its text, above the lines of all.
 * `faint`: it is not kept yet.
 */
export function drawAnswer(
  c: CanvasRenderingContext2D,
  project: Project,
  answer: Answer,
  text: string,
  palette: Palette,
  faint: boolean,
  taken: Taken,
): () => void {
  c.strokeStyle = c.fillStyle = palette.measure;
  c.globalAlpha = faint ? 0.75 : 1;
  c.lineCap = 'butt';
  c.lineWidth = 1;
  c.setLineDash([4, 3]);
  for (const [a, b] of answer.beyond) line(c, project(a), project(b));
  c.setLineDash([]);
  c.lineWidth = 1.4;
  const { places, of } = answer.corner ? drawAngle(c, project, answer.corner) : drawDistance(c, project, answer);
  c.globalAlpha = 1;
  return write(c, text, places, of, palette, taken);
}

/** Places for a text, the best first, and what it belongs to. */
interface Places {
  places: Vec2[];
  of: Vec2;
}

function drawDistance(c: CanvasRenderingContext2D, project: Project, answer: Answer): Places {
  const [a, b] = (answer.ends ?? answer.beyond[0]!).map(project) as [Vec2, Vec2];
  if (answer.ends) arrows(c, a, b);
  const on = (t: number): Vec2 => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])],
    length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
  // a short line would be covered: its text, which is wider than high, stands beside its end
  const off = (16 + (32 * Math.abs(b[0] - a[0])) / length) / length;
  const shares = length < 90 ? [1 + off, -off, 1 + off + 32 / length] : [0.5, 0.36, 0.64, 0.22, 0.78];
  return { places: shares.map(on), of: on(0.5) };
}

function arrows(c: CanvasRenderingContext2D, a: Vec2, b: Vec2) {
  line(c, a, b);
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  if (length < 22) {
    for (const p of [a, b]) dot(c, p, 2.5);
    return;
  }
  const [ux, uy] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
  for (const [[x, y], s] of [
    [a, 1],
    [b, -1],
  ] as const) {
    c.beginPath();
    c.moveTo(x, y);
    c.lineTo(x + s * 9 * ux + 3.2 * uy, y + s * 9 * uy - 3.2 * ux);
    c.lineTo(x + s * 9 * ux - 3.2 * uy, y + s * 9 * uy + 3.2 * ux);
    c.closePath();
    c.fill();
  }
}

/** Both arms, and an arc between them as it is seen. */
function drawAngle(c: CanvasRenderingContext2D, project: Project, { at, arms }: NonNullable<Answer['corner']>): Places {
  const corner = project(at),
    ends = arms.map(project) as [Vec2, Vec2],
    lengths = arms.map((arm) => Math.hypot(...arm.map((v, k) => v - at[k]!))),
    radius = 0.5 * Math.min(...lengths),
    [u, v] = arms.map((arm, i) => arm.map((x, k) => (x - at[k]!) / (lengths[i]! || 1))) as [Vec3, Vec3];
  const cosine = Math.max(-1, Math.min(1, u[0] * v[0] + u[1] * v[1] + u[2] * v[2])),
    angle = Math.acos(cosine),
    on = (t: number): Vec2 => {
      // along the great arc from one direction to the other
      const [p, q] =
        angle < 1e-6 ? [1, 0] : [Math.sin((1 - t) * angle) / Math.sin(angle), Math.sin(t * angle) / Math.sin(angle)];
      return project(at.map((x, k) => x + radius * (p * u[k]! + q * v[k]!)) as Vec3);
    };
  for (const end of ends) line(c, corner, end);
  c.beginPath();
  for (let i = 0; i <= 32; ++i) c.lineTo(...on(i / 32));
  c.stroke();
  const places = angle > 3.14 ? [corner] : [0.5, 0.25, 0.75].map(on);
  return { places, of: places[0]! };
}

/** Where it covers no other text; from away a line leads to what it belongs to. */
function write(c: CanvasRenderingContext2D, text: string, places: Vec2[], of: Vec2, palette: Palette, taken: Taken) {
  const font = 'bold 12px system-ui, sans-serif';
  c.font = font;
  const width = c.measureText(text).width,
    ratio = c.getTransform().a,
    view: Vec2 = [c.canvas.width / ratio, c.canvas.height / ratio],
    { at, offered, box } = placeOfText(places, [width, 20], taken, view),
    [x, y] = at;
  taken.push(box);
  c.strokeStyle = palette.measure;
  c.lineWidth = 1;
  if (!offered) line(c, of, at);
  return () => {
    c.font = font;
    c.textAlign = 'center';
    c.textBaseline = 'middle';
    c.strokeStyle = palette.measure;
    c.lineWidth = 1;
    c.fillStyle = palette.halo;
    c.beginPath();
    c.roundRect(x - width / 2 - 5, y - 10, width + 10, 20, 4);
    c.fill();
    c.stroke();
    c.fillStyle = palette.measure;
    c.fillText(text, x, y + 0.5);
  };
}

/** What was picked, or would be: corners are squares, middles triangles, circles have crosses in their middle. */
export function drawThing(
  c: CanvasRenderingContext2D,
  project: Project,
  kind: Ref['kind'],
  thing: Thing,
  palette: Palette,
) {
  c.strokeStyle = c.fillStyle = palette.measure;
  c.lineWidth = 2;
  c.setLineDash([]);
  if (thing.type === 'line') {
    c.lineWidth = 3.5;
    return line(c, project(thing.a), project(thing.b));
  }
  const [x, y] = project(thing.at);
  if (thing.type === 'plane') return dot(c, [x, y], 4);
  c.beginPath();
  if (thing.type === 'circle') {
    const points = circle(thing.at, thing.normal, thing.radius).map(project);
    points.forEach((p) => c.lineTo(...p));
    c.closePath();
    for (const [dx, dy] of [
      [7, 0],
      [0, 7],
    ] as const) {
      c.moveTo(x - dx, y - dy);
      c.lineTo(x + dx, y + dy);
    }
  } else if (kind === 'middle') {
    c.moveTo(x, y - 6);
    c.lineTo(x + 6, y + 5);
    c.lineTo(x - 6, y + 5);
    c.closePath();
  } else c.rect(x - 5, y - 5, 10, 10);
  c.stroke();
}

function circle(at: Vec3, n: Vec3, radius: number): Vec3[] {
  const across: Vec3 = Math.abs(n[0]) < 0.9 ? [0, -n[2], n[1]] : [n[2], 0, -n[0]], // n × x, n × y
    l = Math.hypot(...across),
    u = across.map((v) => v / l) as Vec3,
    v: Vec3 = [n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]];
  return Array.from({ length: 64 }, (_, i) => {
    const [cos, sin] = [Math.cos((i * Math.PI) / 32), Math.sin((i * Math.PI) / 32)];
    return at.map((x, k) => x + radius * (cos * u[k]! + sin * v[k]!)) as Vec3;
  });
}

function line(c: CanvasRenderingContext2D, a: Vec2, b: Vec2) {
  c.beginPath();
  c.moveTo(...a);
  c.lineTo(...b);
  c.stroke();
}

function dot(c: CanvasRenderingContext2D, [x, y]: Vec2, r: number) {
  c.beginPath();
  c.arc(x, y, r, 0, 2 * Math.PI);
  c.fill();
}
