// The types of docs/studio-api.md. What a schema describes (reports, requests, files) is generated from it.

import type { Info, InfoBody } from '../generated/info.ts';
import type {
  Report,
  ReportCheck,
  ReportCheckPlace,
  ReportFlatBend,
  ReportFlatBendAlternative,
  ReportFlatFeature,
  ReportPiece,
  ReportReason,
  ReportReasonPlace,
  ReportReasonRemedy,
} from '../generated/report.ts';
import type { RequestOptions } from '../generated/request.ts';
import type { BrakeOptions, OrderedStroke } from './order-types.ts';

export * from './order-types.ts';
export type {
  Report,
  ReportCheck as Finding,
  ReportCheckPlace as FindingPlace,
  ReportFlatBend as BendRow,
  ReportFlatBendAlternative as Alternative,
  ReportFlatFeature as FeatureRow,
  ReportReasonPlace as Place,
  ReportReasonRemedy as Remedy,
  Info as FileInfo,
  InfoBody as BodyInfo,
};

/** The name of a maker: a row of the description. */
export type Kind = string;
export type Vec2 = [number, number];
export type Vec3 = [number, number, number];
export type LengthUnit = Report['units'];

/** The report of a part, or of one of its pieces. */
export type PieceReport = Pick<Report, keyof Report & keyof ReportPiece>;

/** Length and width of a blank. */
export type FlatSize = NonNullable<Report['flat']>['size'];

/** A refusal, or an error of the server, which knows less. */
export type ApiProblem = Pick<ReportReason, 'code' | 'message'> & Partial<ReportReason>;

/** A sentence in pieces; none where it names nothing. */
export type Wording = NonNullable<ReportReason['wording']>;

/** An input file as the page edits it; each maker's has more. */
export interface Spec {
  units?: LengthUnit;
  thickness: number;
}

export interface Example {
  name: string;
  kind: Kind;
  title: string;
}

/** `given`: the file of the command line. */
export interface OpenDocument {
  id: string;
  given?: boolean;
  kind: Kind;
  name: string;
  info?: Info | null;
  text?: string | null;
}

type IsFile<Value> = [Extract<Value, { content: unknown }>] extends [never] ? false : true;
/** Options as the page sends them: left out rather than null, and files by their content rather than their path. */
export type SentOptions = {
  [Name in keyof RequestOptions]: Exclude<
    RequestOptions[Name],
    null | (IsFile<RequestOptions[Name]> extends true ? string : never)
  >;
};
/** `material`: a string is one of the shop's. */
export type Options = Omit<SentOptions, keyof BrakeOptions | 'material' | 'check_bending' | 'first' | 'as_made'> & {
  material?: SentOptions['material'] | string;
};

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
  names_files: boolean; // its input may name other files, of points
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
  root: number[] | null; // without facets
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
