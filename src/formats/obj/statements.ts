import { textLines } from '../files/textLines.ts';
import type { ObjStatement } from './context.ts';

/** The statements of an .obj or .mtl, without comments and empty lines; a line that ends in a backslash continues on the next. */
export function* statements(bytes: Uint8Array, file: string): Generator<ObjStatement> {
  let held = '';
  let first = 0;
  for (const { number, text } of textLines(bytes, file)) {
    if (held === '') first = number;
    if (text.endsWith('\\')) {
      held += `${text.slice(0, -1)} `;
      continue;
    }
    const made = statementOf(first, held + text);
    held = '';
    if (made) yield made;
  }
  const last = statementOf(first, held);
  if (last) yield last;
}

function statementOf(line: number, text: string): ObjStatement | undefined {
  const hash = text.indexOf('#');
  const plain = (hash >= 0 ? text.slice(0, hash) : text).trim();
  if (plain === '') return undefined;
  const words = plain.split(/\s+/);
  const keyword = words.shift()!;
  return { line, keyword, words, rest: plain.slice(keyword.length).trim() };
}
