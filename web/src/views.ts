import { refusedPlaces, refusedSolid } from './refused-solid.ts';
import type { Matrix4 } from 'three';
import { Vector3 } from 'three';
import { movePlate } from './edits/connect.ts';
import { addFlatPoint, flatCurves, moveFlatPoint } from './edits/flat-curves.ts';
import { addAnchor, moveAnchor } from './edits/slit.ts';
import { FlatView, type PickedInFlat, type PickInFlat } from './flat-view.ts';
import { FoldedView } from './folded-view.ts';
import { noGrips, type Grips } from './grips.ts';
import { stripOutlines, type RidgeEnd } from './handles.ts';
import type { PickedLine } from './lines.ts';
import { Measuring } from './measure/measuring.ts';
import { bendText, edgeText, pickedRow } from './picked.ts';
import { chordFor } from './chord.ts';
import { knownPiece, pieceOf } from './report.ts';
import { isInMachine, type State } from './state.ts';
import { findingsOf, markedFindings } from './panels/findings.ts';
import { Stages } from './stage.ts';
import { readPalette } from './theme.ts';
import type { MeasuringEvents } from './measure/events.ts';
import type { MeasuredView } from './measure/things.ts';
import type { PlatesSpec } from './edits/plates-types.ts';
import type { Shape, Vec2, Vec3 } from './types.ts';
import { turnedPlace } from './orientation.ts';
import type { SlitSpec } from './edits/slit-types.ts';
import type { Ui } from './ui.ts';
import { millimetres } from './units.ts';

/** Both views: tells them what changed, and turns actions in them into edits. */
export class Views {
  readonly folded: FoldedView;
  readonly flat: FlatView;
  private readonly ui: Ui;
  private readonly dragged: (at: number) => void;
  private palette = readPalette();
  private shown: string | null = null;
  private resultShown: string | null = null; // for sheets that are solved step by step the first draft may be far off
  private stages: Stages | null = null; // of the order that is shown in the machine
  readonly measuring: Measuring;
  private hovered: PickedLine | null = null;
  private plateAtStart: { id: string; spec: PlatesSpec } | null = null;

  constructor(ui: Ui, folded: HTMLElement, flat: HTMLElement, dragged: (at: number) => void, zoomed: () => void) {
    this.ui = ui;
    this.dragged = dragged;
    this.measuring = new Measuring(ui, (view) => this[view].drawAbove());
    this.folded = new FoldedView(folded, this.palette, {
      pickLine: (line) => this.pickLine(line),
      hover: (under) => this.light(under),
      ...this.measuringIn('folded'),
      pickFacet: (facet, upper) => this.pickFacet(facet, upper),
      pickAnchor: (anchor) => this.ui.dispatch({ type: 'select', selection: { anchor } }),
      pickRidgeEnd: (end) => this.addAnchorAt(end),
      dragAnchor: (anchor, at, event) => this.dragAnchor(anchor, at, event),
      dragPlate: (id, moved, event) => this.dragPlate(id, moved, event),
      dragEnd: () => {
        this.plateAtStart = null;
        this.ui.commit();
      },
      zoomed,
    });
    this.flat = new FlatView(flat, this.palette, {
      pick: (picked, facet) => this.pickInFlat(picked, facet),
      describe: (picked) => this.describe(picked),
      hover: (under) => this.light(under),
      grips: () => this.grips(),
      pickGrip: ({ curve, index }) => this.ui.dispatch({ type: 'select', selection: { point: { curve, index } } }),
      dragGrip: ({ curve, index }, at, event) => {
        this.dragged(event);
        this.ui.edit<SlitSpec>((s) => moveFlatPoint(s, curve, index, this.onSheet(at)), true);
      },
      dragEnd: () => this.ui.commit(),
      addGrip: ({ curve, index }) => this.ui.edit<SlitSpec>((s) => addFlatPoint(s, curve, index)),
      ...this.measuringIn('flat'),
      zoomed,
    });
  }

  /** How far polygons may lie from curves, so that a quarter of a pixel is not exceeded in either view, mm. */
  chord(shown: number): number {
    return chordFor(
      Math.max(this.flat.scale, this.folded.scale) * window.devicePixelRatio,
      this.ui.state.result,
      shown,
    );
  }

  /** New geometry, handed to the renderer at once. */
  private show(shape: Shape) {
    const { state } = this.ui,
      id = shownOf(state),
      fresh = state.past.length === 0 && !state.pending;
    const first =
      this.shown !== id || (!state.shapeIsDraft && fresh && state.document?.kind === 'slit' && this.resultShown !== id);
    if (!state.shapeIsDraft) this.resultShown = id;
    this.light(null); // rows and numbers may be others
    this.folded.setShape(state.shape, state.fold, this.thickness(state), this.picked(state), heldFacet(state));
    this.folded.follow();
    this.showMachine(state);
    this.showFlat(state);
    if (this.showRefused(state, first) || (first && shape.facet_parent.length)) {
      this.shown = id;
      this.folded.fit();
      this.flat.fit();
    }
  }

  /** What a refused input has to show; says whether that is the first thing to be seen of it. */
  private showRefused(state: State, first: boolean): boolean {
    const solid = refusedSolid(state);
    this.folded.setSolid(solid, refusedPlaces(state), first);
    return first && solid.space_faces.length > 0;
  }

  changed(state: State, before: State) {
    if (state.theme !== before.theme) {
      this.palette = readPalette();
      this.folded.paint(this.palette, this.picked(state));
    }
    if (state.document !== before.document) {
      this.shown = null;
      this.folded.setUp(state.document?.kind === 'slit' ? 'y' : 'z');
      if (!state.shape) {
        this.folded.setShape(null, 1, 1, { part: null, edge: null });
        this.folded.look('iso');
      }
    }
    if (state.measure !== before.measure || state.units !== before.units) {
      this.light(null);
      for (const view of ['flat', 'folded'] as const) {
        if (!state.measure.on) this.measuring.hover(view, null);
        this[view].drawAbove();
      }
    }
    if (state.view !== before.view || isInMachine(state) !== isInMachine(before))
      this.folded.setSection(state.view, isInMachine(state));
    this.folded.setMoving(state.pending !== null);
    if (state.fold !== before.fold) this.folded.setShare(state.fold);
    if (isInMachine(state) !== isInMachine(before) || state.order !== before.order) this.showMachine(state);
    if (state.selection !== before.selection) this.folded.paint(this.palette, this.picked(state));
    const anchors = (s: State) => (s.input.spec as SlitSpec | null)?.anchors,
      loads = (s: State) => (s.input.spec as SlitSpec | null)?.loads;
    if (
      state.selection !== before.selection ||
      anchors(state) !== anchors(before) ||
      loads(state) !== loads(before) ||
      state.earlier !== before.earlier ||
      state.shapeIsDraft !== before.shapeIsDraft ||
      state.fold !== before.fold ||
      state.gizmo !== before.gizmo ||
      isInMachine(state) !== isInMachine(before) ||
      state.document !== before.document
    )
      this.folded.setOverlay(this.overlay(state));
    if (state.input !== before.input || state.selection !== before.selection) this.flat.drawAbove();
    if (state.shape && state.shape !== before.shape) this.show(state.shape);
    else if (!state.shape && (state.problem !== before.problem || state.input !== before.input)) {
      if (!this.showRefused(state, this.shown !== shownOf(state))) return;
      this.shown = shownOf(state);
      this.folded.fit();
    } else if (
      state.selection !== before.selection ||
      state.theme !== before.theme ||
      state.units !== before.units ||
      state.result !== before.result ||
      state.hidden !== before.hidden ||
      state.shape !== before.shape
    )
      this.showFlat(state);
  }

  /** The sheet in the machine, at the time that is looked at; else as it is folded. */
  private showMachine(state: State) {
    const { answer, time } = state.order,
      { shape } = state;
    if (!isInMachine(state) || !answer || !shape) {
      if (this.stages) this.folded.setStage(null, null, state.fold);
      this.stages = null;
      return;
    }
    if (!this.stages?.isOf(shape, answer)) this.stages = new Stages(shape, answer);
    this.folded.setStage(answer, this.stages.at(time), state.fold, state.order.playing);
  }

  fit() {
    this.folded.fit();
    this.flat.fit();
  }

  private showFlat(state: State) {
    this.flat.set({
      shape: state.shape,
      report: pieceOf(state)?.flat ? pieceOf(state) : knownPiece(state),
      findings: markedFindings(state),
      turn: state.result?.turn ?? 0,
      selected: pickedRow(state),
      edge: state.selection.edge,
      finding: state.selection.finding,
      units: state.units,
      palette: this.palette,
    });
  }

  /** Slits and outline of a slit sheet, where they lie in the pattern that is shown. */
  private grips(): Grips {
    const { input, document, selection, shape } = this.ui.state;
    if (document?.kind !== 'slit' || !input.spec || !shape) return noGrips;
    const spec = input.spec as SlitSpec,
      scale = millimetres(spec.units),
      placed = (points: Vec2[]) => points.map(([x, y]) => turnedPlace([x * scale, y * scale], shape.turn)),
      curves = flatCurves(spec).map(({ name, control, drawn }) => {
        const at = placed(control);
        return { name, control: at, drawn: drawn === control ? at : placed(drawn) };
      });
    return {
      curves,
      grips: curves.flatMap(({ name, control }) =>
        control.map((at, index) => ({
          curve: name,
          index,
          at,
          chosen: selection.point?.curve === name && selection.point.index === index,
        })),
      ),
    };
  }

  /** A place of the pattern that is shown as one of the sheet, in its unit. */
  private onSheet(at: Vec2): Vec2 {
    const { input, shape } = this.ui.state,
      scale = millimetres((input.spec as SlitSpec).units);
    return turnedPlace(at, (4 - (shape?.turn ?? 0)) % 4).map((v) => v / scale) as Vec2;
  }

  /** Strips before the last change, as what is said beside the picture; not of another sheet. */
  private before(state: State): Vec3[][] {
    const was = state.shapeIsDraft ? state.result : state.earlier;
    return was && state.document?.kind === 'slit' ? stripOutlines(was.handles) : [];
  }

  private overlay(state: State) {
    const spec = state.input.spec as SlitSpec | null;
    return {
      anchors: spec?.anchors ?? [],
      scale: millimetres(spec?.units),
      plate: state.selection.plate,
      numbered: this.numbered(state),
      anchor: state.selection.anchor,
      gizmo: state.gizmo,
      loads: state.document?.kind === 'slit' ? spec : null,
      handles: state.fold > 0.999 && !isInMachine(state),
      before: state.fold > 0.999 && !isInMachine(state) ? this.before(state) : [],
      ridges: spec?.ridges ?? 10,
    };
  }

  /** Shows edge numbers while a bend's edges are being set. */
  private numbered(state: State): string[] {
    return knownPiece(state)?.flat?.bends.find((b) => b.id === state.selection.part)?.between ?? [];
  }

  private thickness(state: State): number {
    const report = pieceOf(state)?.sheet ? pieceOf(state) : knownPiece(state),
      thickness = report?.sheet?.thickness ?? (state.input.spec as { thickness?: number } | null)?.thickness ?? 1;
    return thickness * millimetres(report?.units);
  }

  private picked = (state: State) => ({ part: pickedRow(state), edge: state.selection.edge });

  private pickLine(line: PickedLine): boolean {
    if (this.ui.state.pick !== 'none') return false;
    if ('part' in line) this.pickPart(line.part);
    else this.ui.dispatch({ type: 'select', selection: { edge: line.edge } });
    return true;
  }

  private pickFacet(facet: number | null, upper: boolean) {
    const { state } = this.ui;
    const row = facet === null ? undefined : state.shape?.facet_part[facet];
    const part = row === undefined ? undefined : state.shape?.parts[row];
    if (state.pick === 'root' || state.pick === 'up') {
      const face = part?.kind === 'flange' ? part.faces[0] : undefined;
      if (face === undefined && !(part && state.pick === 'up'))
        return this.ui.dispatch({ type: 'note', note: 'That is not a flange.' });
      this.ui.dispatch({ type: 'pick', pick: 'none' });
      return state.pick === 'up' ? this.ui.faceUp(upper) : this.ui.editOptions((o) => ({ ...o, root: face }));
    }
    this.pickPart(row ?? null);
  }

  /** The flange that stays can be shown here as well; of the sides only the one that faces up is seen. */
  private pickInFlat(...[picked, facet]: Parameters<PickInFlat>) {
    const { pick } = this.ui.state;
    if (pick === 'up')
      return this.ui.dispatch({
        type: 'note',
        note: 'This side faces up; click the other one in the folded view, or turn the part over.',
      });
    if (pick === 'root') return this.pickFacet(facet, true);
    if (picked && 'finding' in picked) {
      this.ui.dispatch({ type: 'tab', tab: 'findings' });
      return this.ui.dispatch({ type: 'select', selection: { finding: picked.finding } });
    }
    if (picked && 'edge' in picked) this.pickLine(picked);
    else this.pickPart(picked?.part ?? null);
  }

  /** What a mark or a line of the flat pattern is. */
  private describe(picked: PickedInFlat): string {
    const { state } = this.ui;
    if ('finding' in picked) return findingsOf(state)[picked.finding]?.message ?? '';
    return ('edge' in picked ? edgeText(state, picked.edge) : bendText(state, picked.part)) ?? '';
  }

  private measuringIn(view: MeasuredView): MeasuringEvents {
    return {
      measured: () => (this.ui.state.measure.on ? { of: this.measuring.in(view) } : null),
      measureHover: (ref) => this.measuring.hover(view, ref),
      measurePick: (ref) => this.measuring.pick(view, ref),
      paintAbove: (c, project) => this.measuring.paint(view, c, project, this.palette),
    };
  }

  /** What lies under the pointer in one view, or is marked by keys, lights up in both. */
  light(under: PickedLine | null) {
    const same = JSON.stringify(under) === JSON.stringify(this.hovered);
    this.hovered = under;
    if (same) return;
    this.folded.setHover(under);
    this.flat.setHover(under);
  }

  private pickPart(row: number | null) {
    const part = row === null ? undefined : this.ui.state.shape?.parts[row];
    if (part?.plate) this.ui.dispatch({ type: 'select', selection: { plate: part.plate } });
    else this.ui.dispatch({ type: 'select', selection: { part: part?.name ?? null } });
  }

  private addAnchorAt(end: RidgeEnd) {
    const { input } = this.ui.state,
      spec = input.spec as SlitSpec,
      scale = millimetres(spec.units);
    const index = spec.anchors?.length ?? 0;
    this.ui.edit<SlitSpec>((s) =>
      addAnchor(s, { strip: end.strip, ridge: end.ridge, side: end.side, at: end.at.map((v) => v / scale) as Vec3 }),
    );
    this.ui.dispatch({ type: 'select', selection: { anchor: index } });
  }

  private dragAnchor(anchor: number, at: Vec3, event: number) {
    this.dragged(event);
    this.ui.edit<SlitSpec>((s) => moveAnchor(s, anchor, at), true);
  }

  private dragPlate(id: string, moved: Matrix4, event: number) {
    const { state } = this.ui;
    this.plateAtStart ??= { id, spec: (state.pending ?? state.input).spec as PlatesSpec };
    const { spec } = this.plateAtStart,
      scale = millimetres(spec.units),
      v = new Vector3();
    this.dragged(event);
    this.ui.edit<PlatesSpec>(
      (s) => ({
        ...s,
        plates: movePlate(spec, id, (p) => {
          v.set(p[0] * scale, p[1] * scale, p[2] * scale)
            .applyMatrix4(moved)
            .divideScalar(scale);
          return [v.x, v.y, v.z];
        }).plates,
      }),
      true,
    );
  }
}

/** What is fitted into the views when it first is shown: a document, another body of it, another piece. */
const shownOf = ({ document, input: { options } }: State) =>
  document ? [document.id, options.body ?? '', options.piece ?? ''].join(' ') : null;

/**
 * The facet that stays in place while the sheet is folded: of the flange or plate that was chosen for it, else the
 * root.
 */
function heldFacet({ shape, input: { options, spec } }: State): number {
  if (!shape) return 0;
  const root = options.root ?? (spec as { root?: string } | null)?.root;
  const part =
    root === undefined
      ? -1
      : shape.parts.findIndex((p) => p.plate === root || (typeof root === 'number' && p.faces.includes(root)));
  return Math.max(0, part < 0 ? 0 : shape.facet_part.indexOf(part));
}
