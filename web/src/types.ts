// The types of docs/studio-api.md and of the files and reports of the program.

import type { BrakeOptions, OrderedStroke } from './order-types.ts';
import type { Numbers, Piece, Place, Remedy } from './said.ts';
import type { Spec } from './spec-types.ts';

export * from './order-types.ts';
export * from './said.ts';
export * from './spec-types.ts';

/** The name of a maker: a row of the description. */
export type Kind = string;
export type Vec2 = [number, number];
export type Vec3 = [number, number, number];
export type LengthUnit = 'mm' | 'inch' | 'm';

export interface ApiProblem {
  code: string;
  message: string;
  where?: string | null;
  places?: Place[];
  numbers?: Numbers;
  remedy?: Remedy;
  remedies?: Remedy[]; // if there are several
  wording?: Piece[]; // the message, where it names an option or a place
}

export interface Example {
  name: string;
  kind: Kind;
  title: string;
}

export interface BodyInfo {
  number: number;
  name: string;
  quantity: number;
  faces: number;
  size: number[];
  volume: number;
}
export interface FileInfo {
  format: 'planish/info';
  version: number;
  command: 'info';
  input: string;
  units: LengthUnit;
  status: 'ok' | 'refused';
  reason: ApiProblem | null;
  schema: string;
  cad_system: string;
  file_units: string;
  bodies: BodyInfo[];
  surface_bodies: number;
}

/** `given`: the file of the command line. */
export interface OpenDocument {
  id: string;
  given?: boolean;
  kind: Kind;
  name: string;
  info?: FileInfo | null;
  text?: string | null;
}

/** The content of a file given to an option. */
export interface OptionFile<Content> {
  name?: string;
  content: Content;
}
export interface Options {
  body?: number | string;
  root?: 'largest' | number;
  rip_edges?: string; // as in 21,56
  up?: 'auto' | 'reference' | 'other' | number;
  k?: number;
  k_table?: OptionFile<string>;
  din6935?: boolean;
  shop?: OptionFile<Record<string, unknown>>;
  material?: OptionFile<Record<string, unknown>> | string; // a string: one of the shop's
  bend_k?: Record<string, number>;
  inside_radius?: number;
  lateral?: 'auto' | 'straight' | 'arc' | 'corner';
  trade_off?: number;
  largest_span?: number;
  density?: number;
  piece?: number;
  units?: LengthUnit;
  extruded?: 'pilot' | 'through' | 'outline';
  relief?: 'none' | 'rip' | 'square' | 'round';
  bend_relief?: 'none' | 'square' | 'round';
  rip_width?: number;
  profile?: string;
  r12?: boolean;
  splines?: 'arcs' | 'keep';
  arc_tolerance?: number;
  bend_marks?: 'lines' | 'ticks';
  tick_length?: number;
  tangent_lines?: boolean;
  bend_text?: boolean;
  turn_to_blank?: boolean;
  process?: 'laser' | 'punch';
  rules?: OptionFile<Record<string, number | boolean | string>>;
  no_rules?: boolean;
  write_overlapping?: boolean;
}

/** What can be opened, asked and written; the menus are built from it. */
export interface Description {
  makers: MakerRow[];
  artifacts: ArtifactRow[];
}
export interface MakerRow {
  name: Kind;
  description: string;
  input: string;
  editable: boolean;
  options: OptionRow[];
  artifacts: string[];
}
export interface OptionRow {
  name: string;
  kind: string;
  group: string;
  description: string;
  default: string;
  words: string[];
}
export interface ArtifactRow {
  name: string;
  role: string;
  suffix: string;
  media_type: string;
  description: string;
}

export interface Request {
  spec?: Spec;
  options: Options;
  chord?: number; // how far polygons may lie from curves, mm
  brake?: BrakeOptions; // of `plan`
  order?: OrderedStroke[];
}
export interface Progress {
  stage: string;
  share: number;
}

// ---- shapes -------------------------------------------------------------------------------------------------------

export interface Part {
  name: string;
  kind: 'flange' | 'bend';
  angle?: number;
  direction?: 'up' | 'down';
  faces: number[];
  plate?: string;
  place?: number[]; // of a flange: the matrix, row by row, from the flat pattern to the middle of its material
}

export interface Handles {
  plates?: { id: string; corners: Vec3[] }[];
  profiles?: { points: Vec3[] }[];
  leg_curve?: Vec3[];
  second_leg_curve?: Vec3[];
  seat_curve?: Vec3[];
  ridges?: [Vec3, Vec3][][];
  scan?: Vec3[];
}

export interface ArrayPlace {
  type: 'f32' | 'u32' | 'i32';
  at: number;
  count: number;
}

export interface ShapeHeader {
  report: Report;
  arrays: Record<string, ArrayPlace>;
  parts: Part[];
  root: number[];
  handles?: Handles;
  pierces?: number | null;
  seconds?: number;
}

/**
 * The sheet as plane regions hinged to each other, in the coordinates of the flat pattern (mm, z = 0): a flange is one
 * facet, a bend is many, between its rulings. A facet is turned about its hinge against its parent by its angle;
 * parents come first. At share s of the fold every angle is s times as large, so each stage is isometric.
 */
export interface Facets {
  points: Float32Array; // 2 a point: of polygons, in the flat pattern
  ring_starts: Uint32Array; // ring r has points ring_starts[r] to ring_starts[r + 1] − 1; holes are clockwise
  polygon_starts: Uint32Array; // in the same way the rings of each polygon, the outer one first
  facet_starts: Uint32Array; // in the same way the polygons of each facet
  facet_parent: Int32Array; // −1: the root
  facet_hinge: Float32Array; // 4 a facet: two points of the flat pattern
  facet_angle: Float32Array; // radians, right-handed about the hinge, +z towards the viewer of the pattern
  facet_part: Uint32Array; // row of `parts`
  edges: Float32Array; // 4 an edge: segments in the flat pattern, cut (contours, slits) or drawn (outlines of forms)
  edge_facet: Uint32Array; // on which each segment lies
  edge_number: Uint32Array; // its border, from 0: a line, arc or spline of a face; of a bend across its facets
  edge_length: Float32Array; // by border: its exact length in the flat pattern, mm
  edge_circle: Float32Array; // 4 a border: an arc's middle, radius, sweep (radians; ±2π: whole); others 0
  edge_feature: Int32Array; // by border: the formed feature that it outlines, a row of the report's; −1: it is cut
  contour_points: Float32Array; // 2 a point: closed contours in the flat pattern, to be filled
  contour_starts: Uint32Array; // in the same way the points of each contour; clockwise around openings
  contour_part: Int32Array; // row of `parts`; −1: the whole pattern; −2: a relief or rip beyond its parts
  bend_lines: Float32Array; // 4 a line: bend or press lines in the flat pattern
  bend_line_part: Uint32Array; // the bend, row of `parts`
  overlaps: Float32Array; // 2 a point: triangles covered twice, in the flat pattern; with a finding `overlap`
  space_points: Float32Array; // 3 a point: the solid of a refused part to unfold
  space_triangles: Uint32Array; // 3 a triangle
  space_faces: Uint32Array; // by triangle: its face in the solid, from 1
}

export interface Shape extends Facets {
  turn: number; // quarters by which the flat pattern is shown turned against the report and the files
  report: Report;
  parts: Part[];
  root: number[];
  handles: Handles;
  pierces: number | null; // contours and slits that are cut
  seconds: number;
}

// ---- reports ------------------------------------------------------------------------------------------------------

export interface Alternative {
  edges: Record<string, number[] | null>;
  surface: string;
  facing: string;
  width: number;
  span: number;
}

export interface BendRow {
  id: string;
  order?: number;
  kind: string;
  angle: number;
  inside_radius: number;
  k_factor: number | null;
  k_source?: string;
  allowance: number;
  deduction: number | null;
  direction: 'up' | 'down';
  length: number;
  line: Vec2[];
  lines?: Vec2[][];
  between?: string[];
  edges?: Record<string, number[]>;
  surface?: string;
  lateral?: string;
  facing?: string;
  slope?: number;
  offset?: number;
  apex?: number | null;
  half_angle?: number | null;
  inside_radii?: number[];
  frame?: { origin: Vec3; d: Vec3; e1: Vec3; e2: Vec3; beta: number; rise: number[] };
  width?: number;
  span?: number;
  joined?: number;
  stretches?: { edges: Record<string, number[]>; width: number }[];
  extension_area?: number;
  alternatives?: Alternative[];
}

export interface Finding {
  code: string;
  severity: 'info' | 'warning' | 'error';
  message: string;
  at?: Vec2[] | null;
  count?: number; // of a rule's places
  numbers?: Numbers;
  places?: FindingPlace[]; // of a rule: those where it is broken, the worst first
  remedy?: Remedy;
  remedies?: Remedy[];
}

export interface FindingPlace extends Place {
  severity?: 'info' | 'warning' | 'error'; // of a rule's place, as the next two
  message?: string;
  points?: Vec2[];
  numbers?: Numbers;
}

export interface Verification {
  volume_ratio: number | null;
  explained_ratio?: number | null;
  length_error: number | null;
  refold_deviation?: number | null;
  closure?: number | null;
  area_at_half?: number | null;
  openings?: { solid?: number; pattern: number; features: number; loops?: number };
  places?: Record<'length_error' | 'refold_deviation', Vec2 | null>;
}

export interface SheetRow {
  thickness: number;
  thickness_spread?: number;
  k_factor: number | null;
  k_source?: string | null;
  flanges: number;
  bends: number;
  volume: number | null;
  mass?: number | null;
}

export interface FeatureRow {
  kind: string;
  side?: 'both' | 'up' | 'down';
  at: Vec2 | null;
  size: Vec2 | null;
  openings?: number;
}

export interface FlatRow {
  area: number;
  perimeter: number;
  size: Vec2;
  openings?: number;
  cutting?: { outer: number; inner: number };
  bends: BendRow[];
  labels?: { text: string; at: Vec2 }[];
  features?: FeatureRow[];
}

export interface StripRow {
  status: string;
  gap: number;
  shortfall: number;
  min_radius: number | null;
  iterations?: number;
  seat_distance?: number;
  anchor_distance?: number;
  scan_distance?: number;
  crosses?: number[]; // strips of higher numbers
  crosses_plane?: boolean;
  ridges?: { flat: Vec2[]; folded: Vec3[]; fold: number | null }[];
}

export interface PieceReport {
  body?: string;
  units: LengthUnit;
  status: 'ok' | 'warning' | 'refused';
  reason: ApiProblem | null;
  sheet: SheetRow | null;
  flat: FlatRow | null;
  verification: Verification | null;
  checks: Finding[];
  notes?: string[];
  files?: string[];
}

export interface Report extends PieceReport {
  format: 'planish/report';
  version: number;
  command: Kind;
  input: string;
  body_number?: number;
  quantity?: number;
  pieces?: PieceReport[];
  slit?: { gap: number; flat_deviation: number | null; leg_scales: (number | null)[]; strips: StripRow[] };
  transition?: {
    area: number;
    perimeters: number[];
    patches: { kind: string; area: number; borders: number[]; turn: number }[];
    press_lines: { id: string; piece: string; angle: number; direction: 'up' | 'down'; line: Vec2[] }[];
    true_lengths: {
      from: string;
      to: string;
      length: number;
      piece: string;
      press_line: string | null;
      points: Vec3[];
    }[];
  };
}
