import type {
  Slits,
  SlitsAnchor,
  SlitsEnd,
  SlitsLegCurve,
  SlitsMould,
  SlitsSheetStrip,
  SlitsWeights,
} from '../../generated/slits.ts';
import type { ReportSlitStrip } from '../../generated/report.ts';

/** As it is edited: either form of strips, or none where slits are curves. */
export interface SheetSpec {
  strips?: number | SlitsSheetStrip[];
  strip_width?: number;
  panel_height: number;
  half_length: number;
  margin?: number;
  width?: number;
}
export type SlitSpec = Omit<Slits, 'sheet'> & { sheet: SheetSpec };

export type {
  SlitsAnchor as AnchorSpec,
  SlitsEnd as StripEnd,
  SlitsLegCurve as LegCurve,
  SlitsMould as MouldSpec,
  SlitsSheetStrip as StripSpec,
  SlitsWeights as SlitWeights,
  ReportSlitStrip as StripRow,
};
export type PanelName = 'leg' | 'second';
export type CurveName = PanelName | 'seat';
/** A slit or a part of the outline, by its number, on the flat sheet. */
export type FlatCurveName = `${'slits' | 'outline'}-${number}`;
