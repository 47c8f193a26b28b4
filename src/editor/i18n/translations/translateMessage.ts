/** Patterns with {} for each value, and their translations with {1} for the first. */
export type MessageCatalogue = Readonly<Record<string, string>>;
/** Translates a message. */
export type TranslateMessage = (sentence: string) => string;

/** A pattern: the literal parts between its values, and its translation. */
interface MessagePattern {
  readonly parts: readonly string[];
  readonly translation: string;
  /** Total length of its literal parts. */
  readonly literalLength: number;
  /** Whether it contains no words of its own. */
  readonly onlyJoins: boolean;
}

/** Limits on nested values and on the length of a message; real messages stay below them. */
const MAX_DEPTH = 6;
const MAX_LENGTH = 2000;
/** Maximum number of cached translations, for messages that are rendered repeatedly. */
const MAX_CACHED = 10_000;

/** A translation, and how many characters of the source the catalogue covers. */
interface TranslatedText {
  readonly text: string;
  readonly knownLength: number;
}

/**
 * Returns a translator of English messages: {} in a key of the catalogue matches any value, {1} in its translation is
 * the first of them, itself translated. Among several matches the one that covers most characters, values included,
 * wins; at equality a joining pattern, or the one with the longest literals. Messages without a match are returned
 * unchanged.
 */
export function messageTranslator(catalogue: MessageCatalogue): TranslateMessage {
  const whole = new Map(Object.entries(catalogue).filter(([key]) => !key.includes('{}')));
  const patterns = Object.entries(catalogue).flatMap(([key, other]) =>
    key.includes('{}') ? [messagePattern(key, other)] : [],
  );
  patterns.sort((a, b) => Number(b.onlyJoins) - Number(a.onlyJoins) || b.literalLength - a.literalLength);
  const cache = new Map<string, TranslatedText>();
  const translate = (text: string, depth: number): TranslatedText => {
    const key = `${depth} ${text}`;
    const translated = cache.get(key) ?? bestMatch(text, depth);
    if (cache.size >= MAX_CACHED) cache.clear();
    cache.set(key, translated);
    return translated;
  };
  const bestMatch = (text: string, depth: number): TranslatedText => {
    const known = whole.get(text);
    if (known !== undefined) return { text: known, knownLength: text.length };
    let best: TranslatedText = { text, knownLength: 0 };
    if (depth === MAX_DEPTH) return best;
    for (const { parts, translation: other, literalLength: weight, onlyJoins } of patterns) {
      const values = matchValues(text, parts)?.map((value) => translate(value, depth + 1));
      if (!values) continue;
      const ofValues = values.reduce((sum, value) => sum + value.knownLength, 0);
      // A joining pattern counts only if one of its values is translated.
      if (weight + ofValues <= best.knownLength || (onlyJoins && ofValues === 0)) continue;
      const filled = other.replace(/\{(\d)\}/g, (_, nth: string) => values[Number(nth) - 1]?.text ?? '');
      best = { text: filled, knownLength: weight + ofValues };
    }
    return best;
  };
  // Single words are names of nodes or files.
  return (sentence) =>
    sentence.length > MAX_LENGTH || !sentence.includes(' ') ? sentence : translate(sentence, 0).text;
}

function messagePattern(key: string, other: string): MessagePattern {
  const parts = key.split('{}');
  return { parts, translation: other, literalLength: parts.join('').length, onlyJoins: !/\p{L}/u.test(key) };
}

/** Values between the literal parts, each matched as early as possible; undefined if one is missing. */
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
