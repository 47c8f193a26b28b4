import type { Catalogue } from './message.ts';

/** The texts of an example in another language than that of its file, which is English. */
export interface ExampleTexts {
  /** Of a project: the title in its file, for which `title` stands; users can give it another. */
  readonly of?: string;
  /** Its name in the gallery. */
  readonly title: string;
  /** What to look for in it. */
  readonly lookFor: string;
}

/** All texts of the program in one language. */
export interface Translation {
  /** Of every message. */
  readonly messages: Catalogue;
  /** By name of the file, without extension. */
  readonly examples: Readonly<Record<string, ExampleTexts>>;
}

export const ENGLISH: Translation = { messages: {}, examples: {} };
