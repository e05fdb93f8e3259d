import type { Spec } from '../types.ts';
import type { Ui } from '../ui.ts';
import { lengthField, numberField } from './fields.ts';

/** Of the sheet that any input is made of. */
export const thicknessField = (ui: Ui, { thickness, units }: Spec, set: (patch: { thickness: number }) => void) =>
  lengthField(ui, {
    label: 'Thickness',
    testid: 'thickness',
    value: thickness,
    from: units,
    min: 1e-6,
    on: (v) => v && set({ thickness: v }),
  });

export const kFactorField = (
  { k_factor }: { k_factor?: number },
  otherwise: string,
  set: (patch: { k_factor: number | undefined }) => void,
) =>
  numberField({
    label: 'K-factor',
    testid: 'k-factor',
    value: k_factor,
    min: 0,
    max: 1,
    placeholder: otherwise,
    on: (v) => set({ k_factor: v ?? undefined }),
  });
