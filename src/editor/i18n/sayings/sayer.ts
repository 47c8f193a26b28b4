/** A sentence of the catalogue: what stands between its values, and how another language says it. */
interface Saying {
  readonly parts: readonly string[];
  readonly other: string;
  /** How much of it is fixed. */
  readonly weight: number;
}

/** Values hold values; who nests them deeper makes them up. */
const DEEPEST = 6;

/**
 * Says in another language what the program says in English, where it arises: {} in a key of the catalogue is any value, {1} in its text the first
 * of them, itself said anew. Of several sentences that fit, the one with the most words of its own. What is not in the catalogue stays as it is.
 */
export function sayer(catalogue: Readonly<Record<string, string>>): (sentence: string) => string {
  const whole = new Map<string, string>();
  const sayings: Saying[] = [];
  for (const [key, other] of Object.entries(catalogue)) {
    const parts = key.split('{}');
    if (parts.length === 1) whole.set(key, other);
    else sayings.push({ parts, other, weight: key.length - 2 * (parts.length - 1) });
  }
  sayings.sort((a, b) => b.weight - a.weight);
  const say = (sentence: string, depth: number): string => {
    const known = whole.get(sentence);
    if (known !== undefined || depth === DEEPEST) return known ?? sentence;
    for (const { parts, other } of sayings) {
      const values = valuesIn(sentence, parts);
      if (!values) continue;
      const said = values.map((value) => say(value, depth + 1));
      // What only joins others is worth saying where one of them is known.
      if (!/\p{L}/u.test(parts.join('')) && said.every((value, i) => value === values[i])) continue;
      return other.replace(/\{(\d)\}/g, (_, nth: string) => said[Number(nth) - 1] ?? '');
    }
    return sentence;
  };
  return (sentence) => say(sentence, 0);
}

/** What stands in a sentence between its fixed parts, each of which is looked for as early as it can be; undefined where one is not there. */
function valuesIn(sentence: string, parts: readonly string[]): string[] | undefined {
  const [first, ...rest] = parts as [string, ...string[]];
  if (!sentence.startsWith(first)) return undefined;
  const values: string[] = [];
  let at = first.length;
  for (const [i, part] of rest.entries()) {
    const last = i === rest.length - 1;
    const found = last ? sentence.length - part.length : sentence.indexOf(part, at);
    if (found < at || (last && !sentence.endsWith(part))) return undefined;
    values.push(sentence.slice(at, found));
    at = found + part.length;
  }
  return values;
}
