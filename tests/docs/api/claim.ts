/** What an example's comment says of a value: a literal, or a part of one. */
type Claim =
  | { readonly kind: 'number'; readonly value: number; readonly tolerance: number }
  | { readonly kind: 'exact'; readonly value: unknown }
  | { readonly kind: 'list'; readonly items: readonly Claim[]; readonly isOpen: boolean }
  | { readonly kind: 'record'; readonly fields: readonly (readonly [string, Claim])[] };

/** Throws where a value is not what the comment behind it says. Units and words may follow the value: `1.25 m`. */
export function claim(value: unknown, text: string): void {
  const { claim: claimed, end } = parse(text, 0);
  if (!/^(?:$|[\s,;:%°²³⁻/])/u.test(text.slice(end))) throw new Error(`cannot read the claim: ${text}`);
  const difference = compare(value, claimed, '');
  if (difference !== undefined) throw new Error(`the example says ${text}, but ${difference}`);
}

/** Whether a comment begins with a value, so that it is a claim. */
export const isClaim = (text: string): boolean =>
  /^(?:[-−]?\d|\[|\{|'|(?:-?Infinity|NaN|true|false|undefined|null)\b)/.test(text);

const WORDS: Readonly<Record<string, unknown>> = {
  Infinity: Number.POSITIVE_INFINITY,
  '-Infinity': Number.NEGATIVE_INFINITY,
  NaN: Number.NaN,
  true: true,
  false: false,
  undefined,
  null: null,
};

function parse(text: string, start: number): { claim: Claim; end: number } {
  const rest = text.slice(start);
  const word = /^(?:-?Infinity|NaN|true|false|undefined|null)\b/.exec(rest)?.[0];
  if (word) return { claim: { kind: 'exact', value: WORDS[word] }, end: start + word.length };
  const number = /^-?\d[\d_]*(?:\.(\d+))?(?:e([-+]?\d+))?/.exec(rest);
  if (number) {
    // Half a unit of the last digit that is given.
    const tolerance = 0.5001 * 10 ** (Number(number[2] ?? 0) - (number[1]?.length ?? 0));
    const value = Number(number[0].replaceAll('_', ''));
    const isWhole = number[1] === undefined && number[2] === undefined;
    return {
      claim: { kind: 'number', value, tolerance: isWhole ? 1e-9 * Math.max(1, Math.abs(value)) : tolerance },
      end: start + number[0].length,
    };
  }
  const string = /^'([^']*)'/.exec(rest);
  if (string) return { claim: { kind: 'exact', value: string[1] }, end: start + string[0].length };
  if (rest.startsWith('[')) return parseList(text, start + 1);
  if (rest.startsWith('{')) return parseRecord(text, start + 1);
  throw new Error(`cannot read the claim: ${text}`);
}

function parseList(text: string, start: number): { claim: Claim; end: number } {
  const items: Claim[] = [];
  let [at, isOpen] = [skip(text, start), false];
  while (text[at] !== ']') {
    if (text[at] === '…') {
      isOpen = true;
      at = skip(text, at + 1);
      continue;
    }
    const { claim: item, end } = parse(text, at);
    items.push(item);
    at = skip(text, end);
  }
  return { claim: { kind: 'list', items, isOpen }, end: at + 1 };
}

function parseRecord(text: string, start: number): { claim: Claim; end: number } {
  const fields: [string, Claim][] = [];
  let at = skip(text, start);
  while (text[at] !== '}') {
    if (text[at] === '…') {
      at = skip(text, at + 1);
      continue;
    }
    const name = /^(\w+):\s*/.exec(text.slice(at));
    if (!name) throw new Error(`cannot read the claim: ${text}`);
    const { claim: value, end } = parse(text, at + name[0].length);
    fields.push([name[1]!, value]);
    at = skip(text, end);
  }
  return { claim: { kind: 'record', fields }, end: at + 1 };
}

/** After spaces and commas. */
function skip(text: string, start: number): number {
  let at = start;
  while (/[\s,]/.test(text[at] ?? '')) at++;
  if (at >= text.length) throw new Error(`cannot read the claim: ${text}`);
  return at;
}

/** What is different, in words; undefined if nothing is. */
function compare(value: unknown, claimed: Claim, path: string): string | undefined {
  const is = `${path === '' ? 'it' : path} is ${show(value)}`;
  if (claimed.kind === 'exact') return Object.is(value, claimed.value) ? undefined : is;
  if (claimed.kind === 'number')
    return typeof value === 'number' && Math.abs(value - claimed.value) <= claimed.tolerance ? undefined : is;
  if (claimed.kind === 'list') {
    if (!Array.isArray(value) && !ArrayBuffer.isView(value)) return is;
    const list = Array.from(value as ArrayLike<unknown>);
    const { items, isOpen } = claimed;
    if (isOpen ? list.length < items.length : list.length !== items.length) return is;
    return first(items.map((item, i) => compare(list[i], item, `${path}[${i}]`)));
  }
  if (typeof value !== 'object' || value === null) return is;
  const record = value as Readonly<Record<string, unknown>>;
  return first(claimed.fields.map(([name, field]) => compare(record[name], field, `${path}.${name}`)));
}

const first = (list: readonly (string | undefined)[]): string | undefined => list.find((item) => item !== undefined);

const show = (value: unknown): string =>
  ArrayBuffer.isView(value)
    ? `[${Array.from(value as unknown as ArrayLike<number>).slice(0, 8)}]`
    : typeof value === 'object'
      ? (JSON.stringify(value) ?? '').slice(0, 300)
      : String(value);
