import { soundChoices, type DxfChoices } from './dxf-choices.ts';
import type { Options } from './types.ts';

/** A file of the workshop: a shop profile, a bend table or a tools file. */
export interface TableFile {
  kind: TableKind;
  name: string;
  text: string;
}
export type TableKind = 'shop' | 'k_table' | 'tools';
const kinds: TableKind[] = ['shop', 'k_table', 'tools'];

/** What belongs to this machine, not to a file: it is kept there from one start to the next. */
export interface Workshop {
  dxf: DxfChoices;
  files: TableFile[]; // the one used last first
  everyPart: Options | null; // how the bends of each part are laid flat that is opened
}

export type WorkshopAction =
  | { type: 'dxf'; dxf: DxfChoices }
  | { type: 'table-file'; file: TableFile }
  | { type: 'table-forgotten'; file: TableFile }
  | { type: 'every-part'; options: Options | null }
  | { type: 'workshop'; workshop: Workshop };

export const emptyWorkshop: Workshop = { dxf: {}, files: [], everyPart: null };

export function reduceWorkshop(workshop: Workshop, action: WorkshopAction): Workshop {
  switch (action.type) {
    case 'dxf':
      return { ...workshop, dxf: action.dxf };
    case 'table-file':
      return { ...workshop, files: [action.file, ...without(workshop.files, action.file)] };
    case 'table-forgotten':
      return { ...workshop, files: without(workshop.files, action.file) };
    case 'workshop':
      return action.workshop;
    case 'every-part':
      return { ...workshop, everyPart: action.options };
  }
}

const without = (files: TableFile[], { kind, name }: TableFile) =>
  files.filter((f) => f.kind !== kind || f.name !== name);

export const filesOf = (workshop: Workshop, kind: TableKind) => workshop.files.filter((f) => f.kind === kind);

/** What was kept, which an older or a newer page may have written: only what can be meant. */
export function soundWorkshop(kept: unknown): Workshop {
  const { dxf, files, everyPart } = (typeof kept === 'object' && kept !== null ? kept : {}) as Partial<Workshop>;
  return {
    dxf: soundChoices(dxf),
    files: Array.isArray(files)
      ? files.filter((f) => kinds.includes(f?.kind) && typeof f.name === 'string' && typeof f.text === 'string')
      : [],
    everyPart: typeof everyPart === 'object' ? everyPart : null,
  };
}
