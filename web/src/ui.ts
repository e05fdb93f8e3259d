import type { Recent } from './recents.ts';
import type { Action, State, Theme } from './state.ts';
import type { ApiProblem, OrderedStroke, Options, Spec } from './types.ts';
import type { StandardView } from './folded-camera.ts';

/** What panels may see and do. `edit` with `live` is part of a drag, which `commit` ends. */
export interface Ui {
  state: State;
  dispatch(action: Action): void;
  edit<S extends Spec>(change: (spec: S) => S, live?: boolean): void;
  editOptions(change: (options: Options) => Options, live?: boolean): void;
  /** Why the program refuses the open file with these options; null if it does not. */
  refusal(options: Options): Promise<ApiProblem | null>;
  commit(): void;
  /** The side that faces up now, or the other one, from now on. */
  faceUp(upper: boolean): void;
  openFiles(files: FileList | File[]): void;
  openNew(file: File): void;
  openExample(name: string): void;
  openRecent(recent: Recent): void;
  forgetRecents(): void;
  /** The file of the command line, once more. */
  openGiven(): void;
  /** Back to the start page. */
  close(): void;
  /** `artifact`: of the description, or "spec", the edited input. */
  download(artifact: string, suffix: string, more?: Partial<Options>): void;
  /** The DXF of every sheet of an assembly, as one archive. */
  downloadAll(): void;
  cancelArchive(): void;
  cancel(): void;
  /** Computes the result that was abandoned. */
  finish(): void;
  look(view: StandardView): void;
  /** A part of the shape, by its row, lights up in both views. */
  light(part: number | null): void;
  fit(): void;
  animate(): void;
  /** Has an order of strokes checked; null: the cheapest one is looked for. */
  askOrder(order: OrderedStroke[] | null): void;
  cancelOrder(): void;
  /** A stroke at its end, where what collides is seen; its bend is picked. */
  showStroke(stroke: number): void;
  showTime(time: number, playing?: boolean): void;
  playStrokes(): void;
  setTheme(theme: Theme): void;
}

/** The input before the current drag: slider ranges are based on it, so that they do not move. */
export const restingSpec = <S extends Spec>(ui: Ui) => (ui.state.pending ?? ui.state.input).spec as S;
