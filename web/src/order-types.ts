// What `plan` takes and answers (docs/studio-api.md#plan).

import type { LengthUnit, OptionFile, Vec2 } from './types.ts';

/** Options of the press brake. */
export interface BrakeOptions {
  tools?: OptionFile<string>; // a tools file's text
  metal?: 'steel' | 'stainless' | 'aluminium';
  springback?: number;
  clearance?: number;
  shortfall?: number;
  opening?: number;
  weights?: string;
  fix?: string;
  search_time?: number;
}

/** What is pressed at once. */
export interface OrderedStroke {
  bends: string[];
  press_line?: number; // from 1, of a bend with several
  flattening?: boolean; // closes a hem that was bent before
}

export type ToolName = 'punch' | 'die' | 'upper beam' | 'lower beam';

/** What is in the way of a stroke. */
export interface Blocked {
  bend: string;
  hits: string | null;
  with: string | null; // the flange
  depth: number;
  at_turn: number | null; // degrees
  why?: string;
  tool: ToolName | null;
  sentence: string;
}

/** Where sheet and tools are at each turn, in degrees and mm of the machine frame. */
export interface Moments {
  turn: number[]; // the last one includes the springback
  slope: number[]; // by which the held body is turned about the x axis, before it is moved by y and z
  y: number[];
  z: number[];
  punch: number[]; // height of its lowest point
  die: number[]; // height of its top
}

/** A stroke in space, in mm; places in the flat pattern are those of the report. */
export interface Scene {
  origin: Vec2; // of the machine's x axis, in the pattern
  along: Vec2;
  pattern_up: boolean;
  held: Vec2; // a place on the body that is held; the rest of the sheet hangs on it
  across: number; // y of punch and die
  moments: Moments;
  punch: Vec2[]; // segments: from, length along x
  die: Vec2[];
  gauge: [Vec2, Vec2] | null; // the edge at the fingers, in the pattern
}

/** Segments side by side, from the left as the operator sees them. */
export interface SegmentRow {
  from: number;
  segments: number[];
}

export interface StrokeRow extends OrderedStroke {
  angle: number;
  punch: string;
  die: string;
  punch_segments: number[];
  punch_from: number;
  punch_rows?: SegmentRow[];
  die_segments: number[];
  die_from: number;
  die_rows?: SegmentRow[];
  side_up: 'reference' | 'other';
  to_gauge: string | null;
  gauge_direction: Vec2;
  gauge: { distance: number; edge: [Vec2, Vec2] } | null;
  force: number;
  clearance: number;
  blocked: Blocked | null;
  scene: Scene;
}

/** Sections (y, z) of the tools that are used, mm. */
export interface ToolTable {
  machine: string;
  punches: Record<string, Vec2[]>;
  upper_beams: Record<string, Vec2[]>; // above each punch
  dies: Record<string, Vec2[]>;
  lower_beam: Vec2[];
  finger: Vec2[];
  finger_width: number;
}

/** The cheapest order (the first four), or one that was given. */
export type OrderStatus = 'optimal' | 'feasible' | 'infeasible' | 'gave_up' | 'possible' | 'blocked';

export interface OrderAnswer {
  status: OrderStatus;
  sentence: string | null;
  notes: string[];
  units: LengthUnit;
  thickness: number; // mm
  cost: number | null;
  turn_overs: number;
  rotations: number;
  tool_changes: number;
  ungauged: number;
  strokes: StrokeRow[];
  tools: ToolTable;
}
