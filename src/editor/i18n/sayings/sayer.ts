/** Sentences with {} for each value, and how another language says them, with {1} for the first. */
export type Catalogue = Readonly<Record<string, string>>;
/** Says a sentence in another language. */
export type Say = (sentence: string) => string;

/** A sentence of the catalogue: what stands between its values, and how another language says it. */
interface Saying {
  readonly parts: readonly string[];
  readonly other: string;
  /** How much of it is fixed. */
  readonly weight: number;
  /** It has no words of its own. */
  readonly joins: boolean;
}

/** Values hold values; who nests them deeper, or makes them longer, makes them up. */
const DEEPEST = 6;
const LONGEST = 2000;
/** Sentences of a page that is drawn again are not looked for again. */
const MOST_KEPT = 10_000;

/** A text in the other language, and how much of it the catalogue knows. */
interface Said {
  readonly text: string;
  readonly known: number;
}

/**
 * Says in another language what the program says in English, where it arises: {} in a key of the catalogue is any value, {1} in its text the first
 * of them, itself said anew. Of several sentences that fit, the one of which, with its values, most is known; of equals one that only joins others,
 * or the one with the most words of its own. What is not in the catalogue stays as it is.
 */
export function sayer(catalogue: Catalogue): Say {
  const whole = new Map(Object.entries(catalogue).filter(([key]) => !key.includes('{}')));
  const sayings = Object.entries(catalogue).flatMap(([key, other]) => (key.includes('{}') ? [saying(key, other)] : []));
  sayings.sort((a, b) => Number(b.joins) - Number(a.joins) || b.weight - a.weight);
  const kept = new Map<string, Said>();
  const say = (text: string, depth: number): Said => {
    const key = `${depth} ${text}`;
    const said = kept.get(key) ?? most(text, depth);
    if (kept.size >= MOST_KEPT) kept.clear();
    kept.set(key, said);
    return said;
  };
  const most = (text: string, depth: number): Said => {
    const known = whole.get(text);
    if (known !== undefined) return { text: known, known: text.length };
    let best: Said = { text, known: 0 };
    if (depth === DEEPEST) return best;
    for (const { parts, other, weight, joins } of sayings) {
      const values = valuesIn(text, parts)?.map((value) => say(value, depth + 1));
      if (!values) continue;
      const ofValues = values.reduce((sum, value) => sum + value.known, 0);
      // What only joins others is worth saying where one of them is known.
      if (weight + ofValues <= best.known || (joins && ofValues === 0)) continue;
      const filled = other.replace(/\{(\d)\}/g, (_, nth: string) => values[Number(nth) - 1]?.text ?? '');
      best = { text: filled, known: weight + ofValues };
    }
    return best;
  };
  // A single word is a name, of a node or a file.
  return (sentence) => (sentence.length > LONGEST || !sentence.includes(' ') ? sentence : say(sentence, 0).text);
}

function saying(key: string, other: string): Saying {
  const parts = key.split('{}');
  return { parts, other, weight: parts.join('').length, joins: !/\p{L}/u.test(key) };
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
