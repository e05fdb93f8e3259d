import type { ApiProblem } from './types.ts';

/** A message with the options that it names in words. */
export const sentence = ({
  message,
  wording,
}: Pick<ApiProblem, 'message'> & Partial<Pick<ApiProblem, 'wording'>>): string =>
  wording?.map(({ text, option }) => (option ? `“${option.replaceAll('_', ' ')}”` : text)).join('') ?? message;
