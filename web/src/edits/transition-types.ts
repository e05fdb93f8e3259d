import type {
  Transition,
  TransitionFrom,
  TransitionFromFrame,
  TransitionFromProfile,
  TransitionPressLines,
  TransitionSeam,
} from '../../generated/transition.ts';

export type {
  Transition as TransitionSpec,
  TransitionFrom as ProfileSpec,
  TransitionFromFrame as Frame,
  TransitionFromProfile as Profile,
  TransitionPressLines as PressLines,
  TransitionSeam as Seam,
};
