import type { Vec2 } from './types.ts';

export interface Label {
  text: string;
  at: Vec2;
  angle: number;
  room: number;
  color: string;
  weight?: 'bold' | 'normal';
}
interface Box {
  x: number;
  y: number;
  w: number;
  h: number;
}

/**
 * Writes labels that fit their room and cover no earlier label; one that does not fit is shortened to its first word,
 * then left out. More important labels come first.
 */
export class LabelWriter {
  private readonly taken: Box[] = [];
  private readonly c: CanvasRenderingContext2D;
  private readonly halo: string;
  constructor(c: CanvasRenderingContext2D, halo: string) {
    this.c = c;
    this.halo = halo;
  }

  write(label: Label): boolean {
    const short = label.text.split(' ')[0]!;
    for (const text of label.text === short ? [short] : [label.text, short]) if (this.attempt(label, text)) return true;
    return false;
  }

  reserve(box: Box) {
    this.taken.push(box);
  }

  private attempt(label: Label, text: string): boolean {
    const c = this.c;
    c.font = `${label.weight ?? 'normal'} 11px system-ui, sans-serif`;
    const width = c.measureText(text).width;
    if (width > label.room) return false;
    const angle = upright(label.angle),
      cos = Math.abs(Math.cos(angle)),
      sin = Math.abs(Math.sin(angle));
    const w = width * cos + 13 * sin + 2,
      h = width * sin + 13 * cos + 2;
    const box = { x: label.at[0] - w / 2, y: label.at[1] - h / 2, w, h };
    if (this.taken.some((b) => b.x < box.x + box.w && box.x < b.x + b.w && b.y < box.y + box.h && box.y < b.y + b.h))
      return false;
    this.taken.push(box);
    c.save();
    c.translate(...label.at);
    c.rotate(angle);
    c.textAlign = 'center';
    c.textBaseline = 'middle';
    c.fillStyle = this.halo;
    c.globalAlpha = 0.85;
    c.fillRect(-width / 2 - 3, -7, width + 6, 14);
    c.globalAlpha = 1;
    c.fillStyle = label.color;
    c.fillText(text, 0, 0);
    c.restore();
    return true;
  }
}

/** Read from below or from the right, as drawings are. */
export function upright(angle: number): number {
  let a = angle % Math.PI;
  if (a > Math.PI / 2 + 1e-6) a -= Math.PI;
  if (a <= -Math.PI / 2 + 1e-6) a += Math.PI;
  return a === Math.PI / 2 ? -a : a;
}
