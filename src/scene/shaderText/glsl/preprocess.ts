import { msg } from '../../../messages/message.ts';
import { refuse, SHADER_TEXT_LIMITS } from '../sourceLocation.ts';
import type { ShaderToken } from '../tokens.ts';

/** Directives that change nothing here. */
const IGNORED = new Set(['version', 'extension', 'pragma', 'line']);

/** Carries out `#define NAME value` and `#undef NAME`; throws for other directives that would matter. */
export function preprocess(tokens: readonly ShaderToken[]): readonly ShaderToken[] {
  const macros = new Map<string, readonly ShaderToken[]>();
  const out: ShaderToken[] = [];
  const expand = (token: ShaderToken): readonly ShaderToken[] => {
    const value = token.kind === 'name' ? macros.get(token.text) : undefined;
    return value ? value.map((part) => ({ ...part, line: token.line, column: token.column })) : [token];
  };
  for (let i = 0; i < tokens.length; ) {
    const token = tokens[i] as ShaderToken;
    i++;
    if (token.text === '#') {
      const line: ShaderToken[] = [];
      for (; tokens[i]?.line === token.line && tokens[i]?.kind !== 'end'; i++) line.push(tokens[i] as ShaderToken);
      directive(token, line, macros, expand);
    } else out.push(...expand(token));
    // Macros of macros double a text with every line.
    if (out.length > SHADER_TEXT_LIMITS.length)
      refuse(token, msg`its macros make the text longer than ${SHADER_TEXT_LIMITS.length} words: shorten it`);
  }
  return out;
}

function directive(
  at: ShaderToken,
  [name, macro, ...value]: readonly ShaderToken[],
  macros: Map<string, readonly ShaderToken[]>,
  expand: (token: ShaderToken) => readonly ShaderToken[],
): void {
  if (!name || IGNORED.has(name.text)) return;
  if (name.text !== 'define' && name.text !== 'undef')
    refuse(at, msg`\`#${name.text}\` is not taken: there are \`#version\`, \`#define\` and \`#undef\``);
  if (macro?.kind !== 'name') {
    refuse(macro ?? name, msg`expected a name for the macro here`);
    return;
  }
  if (name.text === 'undef') {
    macros.delete(macro.text);
    return;
  }
  const [first] = value;
  if (first?.text === '(' && first.column === macro.column + macro.text.length)
    refuse(macro, msg`the macro ${macro.text} has arguments, which are not taken: write a function`);
  const made = value.flatMap(expand);
  if (made.length > SHADER_TEXT_LIMITS.chain)
    refuse(macro, msg`the macro ${macro.text} is longer than ${SHADER_TEXT_LIMITS.chain} words: write a function`);
  macros.set(macro.text, made);
}
