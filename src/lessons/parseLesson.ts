import { parseInlines } from './inlines.ts';
import type {
  Lesson,
  LessonAnswer,
  LessonBlock,
  LessonClaim,
  LessonInline,
  LessonQuestion,
  LessonSetting,
  LessonStep,
} from './lesson.ts';
import { LessonError } from './lessonError.ts';
import { parseClaim, parseSetting } from './settings.ts';

/** A line of a file, numbered from 1. */
interface NumberedLine {
  readonly text: string;
  readonly line: number;
}

const FENCES = ['lesson', 'set', 'see', 'claim', 'formula'] as const;
type FenceName = (typeof FENCES)[number];

/** What a file consists of, one below the other. */
type LessonItem =
  | { readonly kind: 'heading'; readonly level: number; readonly text: string; readonly line: number }
  | { readonly kind: 'fence'; readonly name: FenceName; readonly lines: readonly NumberedLine[]; readonly line: number }
  | { readonly kind: 'answers'; readonly answers: readonly LessonAnswer[]; readonly line: number }
  | { readonly kind: 'text'; readonly block: LessonBlock; readonly line: number };

/** Signs that begin a line of Markdown that lessons do not have. */
const REFUSED = /^(?:\d+[.)] |[*+] |>|\||---|===|~~~|<|!\[|\[[^\]]*\]:)/;

/**
 * Reads a lesson. Its Markdown is a subset that is drawn in full, and everything else is refused: throws a LessonError with
 * file, line, and what to do. The form: docs/guide/lessons.md.
 */
export function parseLesson(source: string, file: string): Lesson {
  const items = itemsOf(source, file);
  const parts = split(items, (item) => item.kind === 'heading' && item.level === 2);
  const [head = [], ...steps] = parts;
  const title = head[0];
  if (title?.kind !== 'heading' || title.level !== 1)
    throw new LessonError(file, title?.line ?? 1, 'a lesson begins with its title, "# Title"');
  const facts = head[1];
  if (facts?.kind !== 'fence' || facts.name !== 'lesson')
    throw new LessonError(
      file,
      facts?.line ?? title.line,
      'below the title is a block ```lesson with place and minutes',
    );
  const summary = textsOf(head.slice(2), file);
  if (summary.length === 0) throw new LessonError(file, facts.line, 'a summary follows, for the list of lessons');
  if (steps.length === 0) throw new LessonError(file, title.line, 'a lesson has steps, each "## Title"');
  const read = steps.map((step) => readStep(step, file));
  if (!read[0]?.set.some(({ key }) => key === 'example'))
    throw new LessonError(file, read[0]?.line ?? 1, 'the first step opens a scene: ```set with example = …');
  return {
    title: title.text,
    place: factOf(facts.lines, 'place', file, facts.line),
    minutes: factOf(facts.lines, 'minutes', file, facts.line),
    summary,
    steps: read,
  };
}

function readStep(items: readonly LessonItem[], file: string): LessonStep {
  const [own = [], ...questions] = split(items, (item) => item.kind === 'heading' && item.level === 3);
  const heading = own[0];
  if (heading?.kind !== 'heading') throw new Error('a step begins with its heading');
  const second = questions[1]?.[0];
  if (second) throw new LessonError(file, second.line, 'a step has one question; make another step');
  const body = own.slice(1);
  const question = questions[0] && readQuestion(questions[0], file);
  const isPart = (item: LessonItem, name: FenceName) => item.kind === 'fence' && item.name === name;
  const text = textsOf(
    body.filter((item) => !isPart(item, 'set') && !isPart(item, 'claim')),
    file,
  );
  if (text.length === 0 && !question) throw new LessonError(file, heading.line, 'a step has a text, or a question');
  return {
    title: heading.text,
    line: heading.line,
    set: settingsIn(body, 'set', file),
    text,
    ...(question && { question }),
    claims: claimsIn(items, file),
  };
}

function readQuestion(items: readonly LessonItem[], file: string): LessonQuestion {
  const [heading, answers, ...rest] = items;
  if (heading?.kind !== 'heading') throw new Error('a question begins with its heading');
  if (answers?.kind !== 'answers')
    throw new LessonError(file, heading.line, 'answers follow a question: - [ ] or - [x], and below each why');
  const right = answers.answers.filter((answer) => answer.right).length;
  if (right !== 1) throw new LessonError(file, answers.line, `one answer is right, - [x]; here ${right} are`);
  if (answers.answers.length < 2) throw new LessonError(file, answers.line, 'a question has at least two answers');
  const explanation = textsOf(
    rest.filter((item) => item.kind !== 'fence' || (item.name !== 'see' && item.name !== 'claim')),
    file,
  );
  if (explanation.length === 0) throw new LessonError(file, answers.line, 'an explanation follows the answers');
  return {
    text: parseInlines(heading.text, file, heading.line),
    answers: answers.answers,
    see: settingsIn(rest, 'see', file),
    explanation,
  };
}

/** Blocks of text; anything else is out of place. */
function textsOf(items: readonly LessonItem[], file: string): readonly LessonBlock[] {
  return items.map((item) => {
    if (item.kind === 'text') return item.block;
    if (item.kind === 'fence' && item.name === 'formula')
      return { kind: 'formula', text: item.lines.map(({ text }) => text).join('\n') };
    const what = { heading: 'this heading', answers: 'these answers', fence: 'this block' }[item.kind];
    throw new LessonError(
      file,
      item.line,
      `${what} is out of place: \`\`\`set belongs to a step, answers and \`\`\`see below its question`,
    );
  });
}

const linesOf = (items: readonly LessonItem[], name: FenceName): readonly NumberedLine[] =>
  items.flatMap((item) => (item.kind === 'fence' && item.name === name ? item.lines : []));

function settingsIn(items: readonly LessonItem[], name: 'set' | 'see', file: string): readonly LessonSetting[] {
  const settings = linesOf(items, name).map(({ text, line }) => parseSetting(text, file, line));
  const keys = settings.map(({ key }) => key);
  const twice = settings.find(({ key }, i) => keys.indexOf(key) !== i);
  if (twice) throw new LessonError(file, twice.line, `${twice.key} is set twice; keep one`);
  if (settings.some(({ key }, i) => key === 'example' && i > 0))
    throw new LessonError(file, settings[0]!.line, 'example comes first: it begins anew');
  return settings;
}

const claimsIn = (items: readonly LessonItem[], file: string): readonly LessonClaim[] =>
  linesOf(items, 'claim').map(({ text, line }) => parseClaim(text, file, line));

function factOf(lines: readonly NumberedLine[], name: string, file: string, line: number): number {
  const found = lines.find(({ text }) => text.startsWith(`${name} = `));
  const value = Number(found?.text.slice(name.length + 3));
  if (!Number.isInteger(value) || value < 1)
    throw new LessonError(file, found?.line ?? line, `write ${name} = a whole number from 1`);
  return value;
}

/** The items before the first that begins a part, then each part with what begins it. */
function split(
  items: readonly LessonItem[],
  begins: (item: LessonItem) => boolean,
): readonly (readonly LessonItem[])[] {
  const parts: LessonItem[][] = [[]];
  for (const item of items) {
    if (begins(item)) parts.push([item]);
    else parts.at(-1)!.push(item);
  }
  return parts;
}

function itemsOf(source: string, file: string): readonly LessonItem[] {
  const lines = source.split('\n').map((text, i) => ({ text: text.trimEnd(), line: i + 1 }));
  const items: LessonItem[] = [];
  for (let at = 0; at < lines.length; ) {
    const first = lines[at]!;
    if (first.text === '') at++;
    else if (first.text.startsWith('```')) {
      const end = lines.findIndex(({ text }, i) => i > at && text === '```');
      items.push(fenceOf(lines.slice(at, end), end, file, first));
      at = end + 1;
    } else {
      // A heading stands alone, whatever follows it.
      const end = first.text.startsWith('#')
        ? at + 1
        : lines.findIndex(({ text }, i) => i > at && (text === '' || /^(?:#|```)/.test(text)));
      const stop = end < 0 ? lines.length : end;
      items.push(blockOf(lines.slice(at, stop), file));
      at = stop;
    }
  }
  return items;
}

function fenceOf(lines: readonly NumberedLine[], end: number, file: string, { text, line }: NumberedLine): LessonItem {
  const name = FENCES.find((known) => text === `\`\`\`${known}`);
  if (!name) throw new LessonError(file, line, `a block is one of ${FENCES.join(', ')}; this is ${text}`);
  if (end < 0) throw new LessonError(file, line, 'this block has no end; close it with ``` on a line of its own');
  return { kind: 'fence', name, lines: lines.slice(1).filter((each) => each.text !== ''), line };
}

function blockOf(lines: readonly NumberedLine[], file: string): LessonItem {
  const { text, line } = lines[0]!;
  const [, marks, title] = /^(#+) (.+)$/.exec(text) ?? [];
  if (marks !== undefined && title !== undefined && marks.length <= 3)
    return { kind: 'heading', level: marks.length, text: title, line };
  if (text.startsWith('#')) throw new LessonError(file, line, 'a heading is #, ## or ###, a space, and its text');
  if (/^- \[/.test(text)) return { kind: 'answers', answers: answersOf(lines, file), line };
  if (text.startsWith('- ')) {
    const items = groupItems(lines, file).map(({ own, below }) => {
      const whole = [own, ...below].map((each) => each.text).join(' ');
      return parseInlines(whole, file, own.line);
    });
    return { kind: 'text', block: { kind: 'list', items }, line };
  }
  for (const each of lines) {
    if (REFUSED.test(each.text) || /^\s/.test(each.text))
      throw new LessonError(file, each.line, 'a text is a paragraph or a list of "- "; write it so');
  }
  const content = parseInlines(lines.map((each) => each.text).join(' '), file, line);
  return { kind: 'text', block: { kind: 'paragraph', content }, line };
}

function answersOf(lines: readonly NumberedLine[], file: string): readonly LessonAnswer[] {
  return groupItems(lines, file).map(({ own, below }) => {
    const [, mark, text] = /^\[([ x])\] (.+)$/.exec(own.text) ?? [];
    if (mark === undefined || text === undefined)
      throw new LessonError(file, own.line, 'an answer is "- [ ] text", the right one "- [x] text"');
    if (below.length === 0) throw new LessonError(file, own.line, 'below an answer, indented by two, is why');
    const why: readonly LessonInline[] = parseInlines(below.map((each) => each.text).join(' '), file, below[0]!.line);
    return { text: parseInlines(text, file, own.line), right: mark === 'x', why };
  });
}

/** Items of a list, without their `- `, and the indented lines below each. */
function groupItems(
  lines: readonly NumberedLine[],
  file: string,
): readonly { readonly own: NumberedLine; readonly below: readonly NumberedLine[] }[] {
  const items: { own: NumberedLine; below: NumberedLine[] }[] = [];
  for (const { text, line } of lines) {
    const last = items.at(-1);
    if (text.startsWith('- ')) items.push({ own: { text: text.slice(2), line }, below: [] });
    else if (last && /^ {2}\S/.test(text)) last.below.push({ text: text.trim(), line });
    else throw new LessonError(file, line, 'a line of a list begins with "- ", or goes on indented by two');
  }
  return items;
}
