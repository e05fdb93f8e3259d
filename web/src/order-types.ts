// What `plan` takes and answers (docs/studio-api.md#plan).

import type { ReportPlan, ReportPlanBlocked, ReportPlanStroke } from '../generated/report.ts';
import type { LengthUnit, SentOptions, Vec2, Wording } from './types.ts';

/** Options of the press brake. */
export type BrakeOptions = Pick<
  SentOptions,
  | 'tools'
  | 'metal'
  | 'springback'
  | 'clearance'
  | 'shortfall'
  | 'opening'
  | 'v'
  | 'as_drawn'
  | 'large_radii'
  | 'chord_error'
  | 'gauge_openings'
  | 'weights'
  | 'fix'
  | 'search_time'
>;

/** What is pressed at once. */
export type OrderedStroke = Pick<ReportPlanStroke, 'bends' | 'press_line' | 'flattening'>;

export type ToolName = NonNullable<ReportPlanBlocked['tool']>;

/** What is in the way of a stroke. */
export interface Blocked extends ReportPlanBlocked {
  sentence: string;
  wording: Wording;
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
  feet: Vec2[]; // of the punch's ears
  gauge: [Vec2, Vec2] | null; // the edge at the fingers, in the pattern
  gauge_height: number; // of the fingers above the upper skin
}

export interface StrokeRow extends ReportPlanStroke {
  blocked: Blocked | null;
  scene: Scene;
}

/** Sections (y, z) of the tools that are used, mm. */
export interface ToolTable {
  machine: string;
  punches: Record<string, Vec2[]>;
  feet: Record<string, Vec2[]>; // of the ears of each punch that has them
  upper_beams: Record<string, Vec2[]>; // above each punch
  dies: Record<string, Vec2[]>;
  lower_beam: Vec2[];
  finger: Vec2[];
  finger_width: number;
  nose: Vec2[]; // of a finger, in openings
  nose_width: number;
}

/** The cheapest order, or whether one that was given can be made. */
export type OrderStatus = ReportPlan['status'] | 'possible' | 'blocked';

export interface OrderAnswer
  extends Pick<ReportPlan, 'cost' | 'turn_overs' | 'rotations' | 'tool_changes' | 'ungauged' | 'v_away' | 'stations'> {
  status: OrderStatus;
  sentence: string | null;
  wording?: Wording; // of the sentence
  notes: string[];
  units: LengthUnit;
  thickness: number; // mm
  strokes: StrokeRow[];
  tools: ToolTable;
}
