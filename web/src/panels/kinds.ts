import type { TemplateResult } from 'lit-html';
import type { Kind } from '../types.ts';
import type { Ui } from '../ui.ts';
import { connectPanel } from './connect.ts';
import { slitPanel } from './slit.ts';
import { transitionPanel } from './transition.ts';
import { unfoldPanel } from './unfold.ts';

/**
 * How the input of each maker is edited; a maker without a row can still be shown and downloaded.
 * `edits`: a JSON file.
 */
export const panels: Record<Kind, { draw: (ui: Ui) => TemplateResult; edits: boolean }> = {
  unfold: { draw: unfoldPanel, edits: false },
  connect: { draw: connectPanel, edits: true },
  transition: { draw: transitionPanel, edits: true },
  slit: { draw: slitPanel, edits: true },
};
