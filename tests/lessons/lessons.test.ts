import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { DIAGRAM_KINDS } from '../../src/diagrams/sceneDiagram.ts';
import { QUANTITIES as RUN_QUANTITIES } from '../../src/editor/energy/series.ts';
import { withParameters } from '../../src/editor/lessons/showState.ts';
import { parseDocument } from '../../src/graph/document/parse.ts';
import { resolveSpec, valueError } from '../../src/graph/nodeType.ts';
import { textOfStep } from '../../src/lessons/inlines.ts';
import { INSTRUMENTS } from '../../src/lessons/instruments.ts';
import type { Lesson } from '../../src/lessons/lesson.ts';
import { parseLesson } from '../../src/lessons/parseLesson.ts';
import { isParameter, type LessonState, stateAtStep } from '../../src/lessons/settings.ts';
import { LANGUAGE_TAGS } from '../../src/messages/languages.ts';
import { nodeLibrary } from '../../src/nodes/library.ts';
import { newProject } from '../../src/nodes/project/projectCommands.ts';
import { QUANTITIES } from './quantities.ts';

const FOLDER = new URL('../../lessons/', import.meta.url);
const EXAMPLES = new URL('../../examples/', import.meta.url);
const names = [...new Set(readdirSync(FOLDER).flatMap((file) => /^([a-z-]+)\.\w+\.md$/.exec(file)?.[1] ?? []))];
const sourceOf = (name: string, language: string) => readFileSync(new URL(`${name}.${language}.md`, FOLDER), 'utf8');
const lessonOf = (name: string, language: string): Lesson =>
  parseLesson(sourceOf(name, language), `${name}.${language}.md`);

/** The document that a state's example opens as. */
const openedAt = ({ example }: LessonState) =>
  example.endsWith('.slowlight.json')
    ? parseDocument(readFileSync(new URL(example, EXAMPLES), 'utf8'))
    : newProject(`examples/${example}`);

/** What languages have in common: settings, claims, and which answers are right. */
const skeleton = ({ place, minutes, steps }: Lesson) => ({
  place,
  minutes,
  steps: steps.map(({ set, question, claims }) => ({
    set: set.map(({ key, value }) => [key, value]),
    claims: claims.map(({ quantity, of, printed }) => [quantity, of, printed]),
    right: question?.answers.map(({ right }) => right),
    see: question?.see.map(({ key, value }) => [key, value]),
  })),
});

it('steps may show all that panels show', () => {
  expect([...INSTRUMENTS.energy].sort()).toEqual([...RUN_QUANTITIES].sort());
  expect(INSTRUMENTS.diagram).toEqual(DIAGRAM_KINDS);
});

it('there are lessons, each in its own place', () => {
  const places = names.map((name) => lessonOf(name, 'en').place);
  expect(names.length).toBeGreaterThanOrEqual(3);
  expect(new Set(places).size).toBe(names.length);
});

describe.each(names)('%s', (name) => {
  const english = lessonOf(name, 'en');

  it('is the same lesson in all languages', () => {
    for (const language of LANGUAGE_TAGS) expect(skeleton(lessonOf(name, language))).toEqual(skeleton(english));
  });

  it('has four to seven steps, and at least two questions that name misconceptions', () => {
    expect(english.steps.length).toBeGreaterThanOrEqual(4);
    expect(english.steps.length).toBeLessThanOrEqual(7);
    const questions = english.steps.flatMap(({ question }) => question ?? []);
    expect(questions.length).toBeGreaterThanOrEqual(2);
  });

  it('sets only what its examples have, to values in range', () => {
    for (const [i, { question }] of english.steps.entries()) {
      for (const isSeen of question ? [false, true] : [false]) {
        const state = stateAtStep(english, i, isSeen);
        expect(existsSync(new URL(state.example, EXAMPLES)), state.example).toBe(true);
        const document = withParameters(openedAt(state), state.settings);
        for (const [key, value] of [...state.settings].filter(([key]) => isParameter(key))) {
          const [id, param] = key.split('.') as [string, string];
          const { type: typeId, params } = document.nodes[id]!;
          const type = nodeLibrary[typeId]!;
          const spec = type.params[param];
          expect(spec, `${key} of ${state.example}`).toBeDefined();
          expect(valueError(resolveSpec(type, spec!, params), value), key).toBeUndefined();
        }
      }
    }
  });

  it('claims what the program computes and a closed form gives, and prints it in every language', () => {
    for (const language of LANGUAGE_TAGS) {
      for (const step of lessonOf(name, language).steps) {
        for (const { quantity, of, printed, line } of step.claims) {
          const where = `${name}.${language}.md:${line}`;
          const known = QUANTITIES[quantity];
          expect(known, `${where}: there is no quantity ${quantity}`).toBeDefined();
          const halfDigit = 0.5 * 10 ** -(printed.split('.')[1]?.length ?? 0);
          expect(Math.abs(known!.computed(...of) - Number(printed)), where).toBeLessThanOrEqual(halfDigit);
          expect(Math.abs(known!.closedForm(...of) / known!.computed(...of) - 1), where).toBeLessThan(1e-9);
          const alone = new RegExp(`(?<![\\d.])${printed.replace('.', '\\.')}(?!\\d|\\.\\d)`);
          expect(textOfStep(step), `${where}: ${printed} is not in the text`).toMatch(alone);
        }
      }
    }
  });

  it('links to steps that are there', () => {
    for (const language of LANGUAGE_TAGS) {
      for (const [, other, step] of sourceOf(name, language).matchAll(/\]\(\?lesson=([a-z-]+)(?:&step=(\d+))?\)/g)) {
        expect(names).toContain(other);
        expect(Number(step ?? 1)).toBeLessThanOrEqual(lessonOf(other!, language).steps.length);
      }
    }
  });
});
