import { msg } from '../../messages/message.ts';
import { refuse, SHADER_TEXT_LIMITS, type SourceLocation } from './sourceLocation.ts';

export interface ShaderToken extends SourceLocation {
  readonly kind: 'name' | 'number' | 'sign' | 'end';
  readonly text: string;
}

const WGSL = {
  space: /[ \t\r\n]+|\/\/[^\n]*/y,
  name: /[A-Za-z_][A-Za-z0-9_]*/y,
  number: /0[xX][0-9a-fA-F]+[iu]?|(?:\d+\.\d*|\.\d+|\d+)(?:[eE][+-]?\d+)?[fhiu]?/y,
  sign: /->|\+\+|--|&&|\|\||<<|>>|[<>=!+\-*/%&|^]=|[-+*/%&|^~!<>=(){}[\],.;:@]/y,
} as const;
const GLSL = {
  space: WGSL.space,
  name: WGSL.name,
  number: /0[xX][0-9a-fA-F]+|(?:\d+\.\d*|\.\d+|\d+)(?:[eE][+-]?\d+)?(?:lf|LF|[fFuU])?/y,
  sign: /\+\+|--|&&|\|\||<<|>>|[<>=!+\-*/%&|^]=|[-+*/%&|^~!<>=(){}[\],.;:?#]/y,
} as const;
const PARTS = { wgsl: WGSL, glsl: GLSL };
const LANGUAGES = { wgsl: 'WGSL', glsl: 'GLSL' };
type ShaderLanguage = keyof typeof PARTS;

/** Tokens of a text, with one for its end. */
export function tokenize(text: string, language: ShaderLanguage = 'wgsl'): readonly ShaderToken[] {
  const tokens: ShaderToken[] = [];
  let [at, line, start] = [0, 1, 0];
  const here = (): SourceLocation => ({ line, column: at - start + 1 });
  if (text.length > SHADER_TEXT_LIMITS.length)
    refuse(
      here(),
      msg`the text has ${text.length} characters; more than ${SHADER_TEXT_LIMITS.length} are not taken: shorten it`,
    );
  while (at < text.length) {
    const place = here();
    const [kind, found] = tokenAt(text, at, place, language);
    if (kind !== 'space') tokens.push({ ...place, kind, text: found });
    for (let i = 0; i < found.length; i++)
      if (found[i] === '\n') {
        line++;
        start = at + i + 1;
      }
    at += found.length;
  }
  return [...tokens, { ...here(), kind: 'end', text: '' }];
}

function tokenAt(
  text: string,
  at: number,
  place: SourceLocation,
  language: ShaderLanguage,
): readonly [keyof typeof WGSL, string] {
  if (text.startsWith('/*', at)) return ['space', comment(text, at, place, language)];
  const parts = PARTS[language];
  for (const kind of Object.keys(parts) as (keyof typeof parts)[]) {
    parts[kind].lastIndex = at;
    const found = parts[kind].exec(text);
    if (found) return [kind, found[0]];
  }
  return refuse(
    place,
    msg`the character ${JSON.stringify(String.fromCodePoint(text.codePointAt(at) ?? 0))} has no meaning in ${LANGUAGES[language]}`,
  );
}

/** In WGSL comments lie within comments. */
function comment(text: string, from: number, place: SourceLocation, language: ShaderLanguage): string {
  if (language === 'glsl') {
    const end = text.indexOf('*/', from + 2);
    if (end >= 0) return text.slice(from, end + 2);
  }
  let depth = 0;
  for (let at = from; at < text.length; at += 2) {
    if (text.startsWith('/*', at)) depth++;
    else if (text.startsWith('*/', at)) depth--;
    else at--;
    if (depth === 0) return text.slice(from, at + 2);
  }
  return refuse(place, msg`this comment has no end: close it with */`);
}
