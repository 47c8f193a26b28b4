/** A sentence of the catalogue: what stands between its values, and how another language says it. */
interface Saying {
  readonly parts: readonly string[];
  readonly other: string;
  /** How much of it is fixed. */
  readonly weight: number;
  /** It has no words of its own. */
  readonly joins: boolean;
}

/** Values hold values; who nests them deeper makes them up. */
const DEEPEST = 6;
/** Sentences of a page that is drawn again are not looked for again. */
const MOST_KEPT = 1000;

/** A sentence said, and how much of it the catalogue knows. */
interface Said {
  readonly text: string;
  readonly known: number;
}

/**
 * Says in another language what the program says in English, where it arises: {} in a key of the catalogue is any value, {1} in its text the first
 * of them, itself said anew. Of several sentences that fit, the one of which, with its values, most is known; else
 * one that only joins others, or the one with the most words of its own. What is not in the catalogue stays as it is.
 */
export function sayer(catalogue: Readonly<Record<string, string>>): (sentence: string) => string {
  const whole = new Map<string, string>();
  const sayings: Saying[] = [];
  for (const [key, other] of Object.entries(catalogue)) {
    const parts = key.split('{}');
    if (parts.length === 1) whole.set(key, other);
    else
      sayings.push({
        parts,
        other,
        weight: key.length - 2 * (parts.length - 1),
        joins: !/\p{L}/u.test(parts.join('')),
      });
  }
  sayings.sort((a, b) => Number(b.joins) - Number(a.joins) || b.weight - a.weight);
  const kept = new Map<string, string>();
  return (sentence) => {
    const found = new Map<string, Said>();
    const say = (text: string, depth: number): Said => {
      const key = `${depth} ${text}`;
      const said = found.get(key) ?? most(text, depth);
      found.set(key, said);
      return said;
    };
    const most = (text: string, depth: number): Said => {
      const known = whole.get(text);
      let best: Said = known === undefined ? { text, known: 0 } : { text: known, known: text.length };
      if (known !== undefined || depth === DEEPEST) return best;
      for (const { parts, other, weight, joins } of sayings) {
        const said = valuesIn(text, parts)?.map((value) => say(value, depth + 1));
        if (!said) continue;
        const ofValues = said.reduce((sum, value) => sum + value.known, 0);
        // What only joins others is worth saying where one of them is known.
        if (weight + ofValues <= best.known || (joins && ofValues === 0)) continue;
        best = {
          text: other.replace(/\{(\d)\}/g, (_, nth: string) => said[Number(nth) - 1]?.text ?? ''),
          known: weight + ofValues,
        };
      }
      return best;
    };
    const said = kept.get(sentence) ?? say(sentence, 0).text;
    if (kept.size >= MOST_KEPT) kept.clear();
    kept.set(sentence, said);
    return said;
  };
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
