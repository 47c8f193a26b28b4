/**
 * A sentence for users: its English template with `{}` for each value, and the values. Plain data, so that it crosses
 * workers and files, and is put into the user's language where it is shown: the template is the key of its translation.
 */
export interface Message {
  /** In English, with {} for each value. */
  readonly template: string;
  /** In the order of the English template. */
  readonly values: readonly (LocalizedText | number)[];
}

/** What is shown to users. A string is the same in every language: a name, a path, a number with its unit. */
export type LocalizedText = string | Message;

/** By template literal, since readers make messages for every part of a file that may turn out to be wrong. */
const templates = new WeakMap<TemplateStringsArray, string>();

/**
 * Makes a message where it arises. Messages can be values of others.
 * @example
 * const problem = msg`vertex ${3} of ${'/World/Cube'} is not finite`;
 * problem; // { template: 'vertex {} of {} is not finite', values: [3, '/World/Cube'] }
 */
export function msg(parts: TemplateStringsArray, ...values: readonly (LocalizedText | number)[]): Message {
  const template = templates.get(parts) ?? parts.join('{}');
  templates.set(parts, template);
  return { template, values };
}

/** Puts a text into a language. */
export type Translate = (text: LocalizedText) => string;

/** English templates and their translations, in which {1} is the first value; in any order, each once. */
export type Catalogue = Readonly<Record<string, string>>;

/**
 * The text in the language of a catalogue; what the catalogue lacks is in English.
 * @example
 * const german = { 'vertex {} of {}': 'Ecke {1} von {2}' };
 * translate(msg`vertex ${3} of ${'/Cube'}`, german); // 'Ecke 3 von /Cube'
 */
export function translate(text: LocalizedText, catalogue: Catalogue): string {
  if (typeof text === 'string') return text;
  const values = text.values.map((value) => (typeof value === 'object' ? translate(value, catalogue) : String(value)));
  const translation = Object.hasOwn(catalogue, text.template) ? catalogue[text.template] : undefined;
  return translation === undefined
    ? text.template.split('{}').reduce((before, after, i) => `${before}${values[i - 1] ?? ''}${after}`)
    : translation.replace(/\{(\d+)\}/g, (_, nth: string) => values[Number(nth) - 1] ?? '');
}

const NO_TRANSLATIONS: Catalogue = {};

/**
 * The English text.
 * @example
 * inEnglish(msg`vertex ${3} of ${'/Cube'}`); // 'vertex 3 of /Cube'
 */
export const inEnglish = (text: LocalizedText): string => translate(text, NO_TRANSLATIONS);

/** `a, b or c`; at least one. */
export function anyOf(texts: readonly LocalizedText[]): LocalizedText {
  const [last = '', ...others] = [...texts].reverse();
  return others.length === 0 ? last : msg`${listed(others.reverse())} or ${last}`;
}

/** `a, b, c` */
export const listed = (texts: readonly LocalizedText[]): LocalizedText => joined(texts, (a, b) => msg`${a}, ${b}`);

/** `a; b; c` */
export const inClauses = (texts: readonly LocalizedText[]): Message =>
  asMessage(joined(texts, (a, b) => msg`${a}; ${b}`));

/** Texts below each other. */
export const inLines = (texts: readonly LocalizedText[]): Message =>
  asMessage(joined(texts, (a, b) => msg`${a}\n${b}`));

const asMessage = (text: LocalizedText): Message => (typeof text === 'string' ? msg`${text}` : text);

/** By halves, so that a message of ten thousand lines is not ten thousand messages deep. */
function joined(texts: readonly LocalizedText[], join: (a: LocalizedText, b: LocalizedText) => Message): LocalizedText {
  const half = texts.length >> 1;
  return half === 0 ? (texts[0] ?? '') : join(joined(texts.slice(0, half), join), joined(texts.slice(half), join));
}
