import type { LessonBlock, LessonInline, LessonStep } from './lesson.ts';
import { LessonError } from './lessonError.ts';

/** Code, strong, emphasis and link; text between them is plain. */
const MARKS = /`([^`]+)`|\*\*([^*]+)\*\*|\*([^*\s][^*]*)\*|\[([^\]]+)\]\(([^)\s]+)\)/g;
/** Links lead to lessons, or to pages of this kind. */
const ADDRESS = /^(?:\?lesson=[a-z-]+(?:&step=\d+)?|https:\/\/\S+)$/;
/** Signs that are Markdown elsewhere, and would be shown as they stand here. */
const STRAY = /[*`]|!?\[|\]\(|<\/?[a-z]|\\/;

/** A line of text with its marks. Throws a LessonError at `line` for what is none of them. */
export function parseInlines(text: string, file: string, line: number): readonly LessonInline[] {
  const parts: LessonInline[] = [];
  const plain = (piece: string): void => {
    const stray = STRAY.exec(piece);
    if (stray) throw new LessonError(file, line, `"${stray[0]}" has no meaning here; close it, or write it in words`);
    if (piece !== '') parts.push(piece);
  };
  let end = 0;
  for (const match of text.matchAll(MARKS)) {
    plain(text.slice(end, match.index));
    end = match.index + match[0].length;
    const [, code, strong, emphasis, label, address] = match;
    if (code !== undefined) parts.push({ kind: 'code', text: code });
    else if (strong !== undefined) parts.push({ kind: 'strong', text: strong });
    else if (emphasis !== undefined) parts.push({ kind: 'emphasis', text: emphasis });
    else if (label !== undefined && address !== undefined && ADDRESS.test(address))
      parts.push({ kind: 'link', text: label, address });
    else throw new LessonError(file, line, `a link leads to ?lesson=NAME&step=N or to https://…, not to ${address}`);
  }
  plain(text.slice(end));
  return parts;
}

const plainText = (inlines: readonly LessonInline[]): string =>
  inlines.map((part) => (typeof part === 'string' ? part : part.text)).join('');

function textOfBlock(block: LessonBlock): string {
  if (block.kind === 'formula') return block.text;
  return block.kind === 'paragraph' ? plainText(block.content) : block.items.map(plainText).join('\n');
}

/** All that a reader of a step reads, without marks. */
export const textOfStep = ({ title, text, question }: LessonStep): string =>
  [
    title,
    ...text.map(textOfBlock),
    ...(question
      ? [
          plainText(question.text),
          ...question.answers.flatMap((answer) => [plainText(answer.text), plainText(answer.why)]),
          ...question.explanation.map(textOfBlock),
        ]
      : []),
  ].join('\n');
