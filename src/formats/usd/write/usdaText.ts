/** USD text as lines; `block` indents what is inside. */
export type Lines = readonly string[];

const INDENT = '    ';

/** `head ( metadata ) { … }` */
export function block(head: string, contents: Lines, metadata: Lines = []): Lines {
  const opened = metadata.length > 0 ? [`${head} (`, ...metadata.map(indent), ')'] : [head];
  return [...opened, '{', ...contents.map(indent), '}'];
}

const indent = (line: string): string => (line === '' ? '' : INDENT + line);

/** A property with metadata below it. */
export const withMetadata = (property: string, ...metadata: string[]): Lines => [
  `${property} (`,
  ...metadata.map(indent),
  ')',
];

/** `declaration.timeSamples = { time: value, … }` */
export function timeSamples(declaration: string, codes: ArrayLike<number>, value: (i: number) => string): Lines {
  const samples = Array.from(codes, (code, i) => `${INDENT}${double(code)}: ${value(i)},`);
  return [`${declaration}.timeSamples = {`, ...samples, '}'];
}

/** The shortest text that reads back as the same double. */
export function double(x: number): string {
  if (Number.isNaN(x)) return 'nan';
  if (!Number.isFinite(x)) return x > 0 ? 'inf' : '-inf';
  return Object.is(x, -0) ? '-0' : String(x);
}

/** A short text that reads back as the same f32. */
export function float(value: number): string {
  const x = Math.fround(value);
  if (Number.isInteger(x) || !Number.isFinite(x)) return double(x);
  for (let digits = 6; digits < 9; digits++) {
    const short = Number(x.toPrecision(digits));
    if (Math.fround(short) === x) return String(short);
  }
  return String(Number(x.toPrecision(9)));
}

export const doubles = (values: readonly number[]): string => `(${values.map(double).join(', ')})`;
export const floats = (values: readonly number[]): string => `(${values.map(float).join(', ')})`;

/** `[(x, y, z), …]`; `scale` multiplies before rounding to f32. */
export function floatTuples(values: ArrayLike<number>, size: number, scale = 1): string {
  const tuples: string[] = [];
  for (let i = 0; i < values.length; i += size) {
    let tuple = '(';
    for (let k = 0; k < size; k++)
      tuple += (k > 0 ? ', ' : '') + float(scale === 1 ? values[i + k] : values[i + k] * scale);
    tuples.push(`${tuple})`);
  }
  return `[${tuples.join(', ')}]`;
}

/** A text in quotes. */
export function quoted(text: string): string {
  const escaped = text
    .replaceAll('\\', '\\\\')
    .replaceAll('"', '\\"')
    .replaceAll('\n', '\\n')
    .replaceAll('\r', '\\r')
    .replaceAll('\t', '\\t');
  return `"${escaped}"`;
}

/** A name that USD allows for a prim: letters, digits and _, not first a digit. */
export function primName(name: string): string {
  const safe = name.replaceAll(/[^\p{L}\p{N}_]/gu, '_');
  return /^[\p{L}_]/u.test(safe) ? safe : `_${safe}`;
}
