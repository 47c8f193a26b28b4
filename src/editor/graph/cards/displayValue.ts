import type { ParamValue } from '../../../graph/document/document.ts';
import type { ParamSpec } from '../../../graph/nodeType.ts';
import { type LocalizedText, msg } from '../../../messages/message.ts';
import { cssColor } from '../../color.ts';
import { formatNumber } from '../../format.ts';

/** A value as short text or a colour. */
export type DisplayValue =
  | { readonly kind: 'text'; readonly text: LocalizedText }
  /** CSS colour. */
  | { readonly kind: 'color'; readonly css: string };

const MAX_LENGTH = 40;
const DIGITS = 4;

/** A parameter's value for display. */
export function displayParam(spec: ParamSpec, value: ParamValue): DisplayValue {
  switch (spec.kind) {
    case 'choice': {
      const title = spec.options.find((option) => option.value === value)?.title;
      return title ? { kind: 'text', text: title } : displayText(String(value));
    }
    case 'boolean':
      return { kind: 'text', text: value === true ? msg`on` : msg`off` };
    case 'color':
      return displayColor(value as readonly number[]);
    case 'list':
      return { kind: 'text', text: msg`${(value as readonly string[]).length} lines` };
    case 'number':
      return displayText(withUnit(formatNumber(Number(value), DIGITS), spec.unit));
    case 'vector':
      return displayText(withUnit(formatNumbers(value as readonly number[]), spec.unit));
    case 'text':
      return displayText(String(value));
  }
}

export const displayColor = (linear: readonly number[]): DisplayValue => ({ kind: 'color', css: cssColor(linear) });

export const formatNumbers = (values: readonly number[]): string =>
  values
    .map((x) =>
      formatNumber(x, DIGITS)
        .replace(/(\.\d*?)0+$/, '$1')
        .replace(/\.$/, ''),
    )
    .join('  ');

export const displayText = (words: string): DisplayValue => ({
  kind: 'text',
  text: words.length > MAX_LENGTH ? `${words.slice(0, MAX_LENGTH - 1)}…` : words,
});

const withUnit = (words: string, unit: string | undefined): string => (unit ? `${words}\u202f${unit}` : words);
