import type { ParamValue } from '../../graph/document.ts';
import type { ParamSpec } from '../../graph/nodeType.ts';
import { cssColor } from '../color.ts';
import { formatNumber } from '../format.ts';

/** A value in few words. */
export type Shown =
  | { readonly kind: 'text'; readonly text: string }
  /** Key of the catalogue, with what is filled in. */
  | { readonly kind: 'words'; readonly key: string; readonly fill?: Readonly<Record<string, string>> }
  /** As CSS has it. */
  | { readonly kind: 'color'; readonly css: string };

const LONGEST = 40;
const DIGITS = 4;

/** A parameter's value as nodes show it. */
export function shownParam(spec: ParamSpec, value: ParamValue): Shown {
  switch (spec.kind) {
    case 'choice': {
      const title = spec.options.find((option) => option.value === value)?.title;
      return title ? { kind: 'words', key: title } : text(String(value));
    }
    case 'boolean':
      return { kind: 'words', key: value === true ? 'graph.on' : 'graph.off' };
    case 'color':
      return shownColor(value as readonly number[]);
    case 'list':
      return { kind: 'words', key: 'graph.lines', fill: { count: String((value as readonly string[]).length) } };
    case 'number':
      return text(withUnit(formatNumber(Number(value), DIGITS), spec.unit));
    case 'vector':
      return text(withUnit(numbers(value as readonly number[]), spec.unit));
    case 'text':
      return text(String(value));
  }
}

export const shownColor = (linear: readonly number[]): Shown => ({ kind: 'color', css: cssColor(linear) });

export const numbers = (values: readonly number[]): string =>
  values
    .map((x) =>
      formatNumber(x, DIGITS)
        .replace(/(\.\d*?)0+$/, '$1')
        .replace(/\.$/, ''),
    )
    .join('  ');

export const text = (words: string): Shown => ({
  kind: 'text',
  text: words.length > LONGEST ? `${words.slice(0, LONGEST - 1)}…` : words,
});

const withUnit = (words: string, unit: string | undefined): string => (unit ? `${words}\u202f${unit}` : words);
