/** Sentences with {} for each value, and how another language says them, with {1} for the first. */
export type MessageCatalogue = Readonly<Record<string, string>>;
/** Says a sentence in another language. */
export type TranslateMessage = (sentence: string) => string;

/** A sentence of the catalogue: what stands between its values, and how another language says it. */
interface MessagePattern {
  readonly parts: readonly string[];
  readonly translation: string;
  /** How much of it is fixed. */
  readonly literalLength: number;
  /** It has no words of its own. */
  readonly onlyJoins: boolean;
}

/** Values hold values; who nests them deeper, or makes them longer, makes them up. */
const MAX_DEPTH = 6;
const MAX_LENGTH = 2000;
/** Sentences of a page that is drawn again are not looked for again. */
const MAX_CACHED = 10_000;

/** A text in the other language, and how much of it the catalogue knows. */
interface TranslatedText {
  readonly text: string;
  readonly knownLength: number;
}

/**
 * Says in another language what the program says in English, where it arises: {} in a key of the catalogue is any value, {1} in its text the first
 * of them, itself said anew. Of several sentences that fit, the one of which, with its values, most is known; of equals one that only joins others,
 * or the one with the most words of its own. What is not in the catalogue stays as it is.
 */
export function messageTranslator(catalogue: MessageCatalogue): TranslateMessage {
  const whole = new Map(Object.entries(catalogue).filter(([key]) => !key.includes('{}')));
  const sayings = Object.entries(catalogue).flatMap(([key, other]) =>
    key.includes('{}') ? [messagePattern(key, other)] : [],
  );
  sayings.sort((a, b) => Number(b.onlyJoins) - Number(a.onlyJoins) || b.literalLength - a.literalLength);
  const kept = new Map<string, TranslatedText>();
  const say = (text: string, depth: number): TranslatedText => {
    const key = `${depth} ${text}`;
    const said = kept.get(key) ?? most(text, depth);
    if (kept.size >= MAX_CACHED) kept.clear();
    kept.set(key, said);
    return said;
  };
  const most = (text: string, depth: number): TranslatedText => {
    const known = whole.get(text);
    if (known !== undefined) return { text: known, knownLength: text.length };
    let best: TranslatedText = { text, knownLength: 0 };
    if (depth === MAX_DEPTH) return best;
    for (const { parts, translation: other, literalLength: weight, onlyJoins } of sayings) {
      const values = matchValues(text, parts)?.map((value) => say(value, depth + 1));
      if (!values) continue;
      const ofValues = values.reduce((sum, value) => sum + value.knownLength, 0);
      // What only joins others is worth saying where one of them is known.
      if (weight + ofValues <= best.knownLength || (onlyJoins && ofValues === 0)) continue;
      const filled = other.replace(/\{(\d)\}/g, (_, nth: string) => values[Number(nth) - 1]?.text ?? '');
      best = { text: filled, knownLength: weight + ofValues };
    }
    return best;
  };
  // A single word is a name, of a node or a file.
  return (sentence) => (sentence.length > MAX_LENGTH || !sentence.includes(' ') ? sentence : say(sentence, 0).text);
}

function messagePattern(key: string, other: string): MessagePattern {
  const parts = key.split('{}');
  return { parts, translation: other, literalLength: parts.join('').length, onlyJoins: !/\p{L}/u.test(key) };
}

/** What stands in a sentence between its fixed parts, each of which is looked for as early as it can be; undefined where one is not there. */
function matchValues(sentence: string, parts: readonly string[]): string[] | undefined {
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
