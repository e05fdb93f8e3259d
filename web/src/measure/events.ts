import type { Project } from './draw.ts';
import type { Measured, Ref } from './things.ts';

/** What a view asks and tells while one measures in it. */
export interface MeasuringEvents {
  /** Whether a click measures, and what; `of` null: nothing that is here now. */
  measured(): { of: Measured | null } | null;
  measureHover(ref: Ref | null): void;
  measurePick(ref: Ref | null): void;
  /** Draws what was measured; says whether that is anything. */
  paintAbove(c: CanvasRenderingContext2D, project: Project): boolean;
}
