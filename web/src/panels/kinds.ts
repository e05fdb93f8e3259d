import type { TemplateResult } from 'lit-html';
import type { Kind, Spec } from '../types.ts';
import type { Ui } from '../ui.ts';
import { connectPanel } from './connect.ts';
import { newPlates } from './connect-template.ts';
import { slitPanel } from './slit.ts';
import { newSlitSheet } from './slit-template.ts';
import { transitionPanel } from './transition.ts';
import { newTransition } from './transition-template.ts';
import { unfoldPanel } from './unfold.ts';

/** How the input of a maker is shown and edited. */
interface KindRow {
  title: string; // of such a file, in the middle of a sentence
  draw: (ui: Ui) => TemplateResult;
  edits: boolean; // a JSON file
  begin?: { file: string; spec: Spec }; // by "New"
}

/** The makers whose input is edited here. What another maker makes is shown, folded and downloaded all the same. */
export const kinds: Record<Kind, KindRow> = {
  unfold: { title: 'STEP part', draw: unfoldPanel, edits: false },
  connect: { title: 'bent plate', draw: connectPanel, edits: true, begin: newPlates },
  transition: { title: 'transition', draw: transitionPanel, edits: true, begin: newTransition },
  slit: { title: 'slit sheet', draw: slitPanel, edits: true, begin: newSlitSheet },
};
