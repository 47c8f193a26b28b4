import type { Lesson } from '../../lessons/lesson.ts';
import { parseLesson } from '../../lessons/parseLesson.ts';
import type { LanguageTag } from '../../messages/languages.ts';

/** Texts of `lessons/NAME.LANGUAGE.md`, each loaded when it is wanted. */
const FILES = import.meta.glob<string>('../../../lessons/*.*.md', { query: '?raw', import: 'default' });
const FOLDER = '../../../lessons/';

/** A lesson and the name that links know it by. */
export interface NamedLesson {
  readonly name: string;
  readonly lesson: Lesson;
}

/** All lessons in a language, in their order. */
export async function loadLessons(language: LanguageTag): Promise<readonly NamedLesson[]> {
  const ending = `.${language}.md`;
  const paths = Object.keys(FILES).filter((path) => path.endsWith(ending));
  const lessons = await Promise.all(
    paths.map(async (path) => ({
      name: path.slice(FOLDER.length, -ending.length),
      lesson: parseLesson(await FILES[path]!(), path.slice(FOLDER.length)),
    })),
  );
  return lessons.sort((a, b) => a.lesson.place - b.lesson.place);
}
