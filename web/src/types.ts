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
export type Options = Omit<SentOptions, keyof BrakeOptions | 'material' | 'check_bending' | 'first'> & {
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

export interface Facets {
  points: Float32Array;
  ring_starts: Uint32Array;
  polygon_starts: Uint32Array;
  facet_starts: Uint32Array;
  facet_parent: Int32Array;
  facet_hinge: Float32Array;
  facet_angle: Float32Array;
  facet_part: Uint32Array;
  edges: Float32Array;
  edge_facet: Uint32Array;
  edge_number: Uint32Array;
  edge_length: Float32Array; // by border
  edge_circle: Float32Array; // 4 a border: middle, radius (0: no arc), sweep
  edge_feature: Int32Array; // by border: the formed feature that it outlines, a row of the report's; −1: it is cut
  contour_points: Float32Array;
  contour_starts: Uint32Array;
  contour_part: Int32Array;
  bend_lines: Float32Array;
  bend_line_part: Uint32Array;
  overlaps: Float32Array;
  space_points: Float32Array;
  space_triangles: Uint32Array;
  space_faces: Uint32Array; // by triangle, from 1
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
