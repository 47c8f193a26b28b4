import type { Vec3 } from '../math/vec3.ts';

/** A guided page: what is read, what its steps set, and what it claims. */
export interface Lesson {
  readonly title: string;
  /** Lessons are listed in this order. */
  readonly place: number;
  /** How long it takes in class [min]. */
  readonly minutes: number;
  readonly summary: readonly LessonBlock[];
  /** At least one. */
  readonly steps: readonly LessonStep[];
}

/** A step of a lesson: it sets the document, tells something, and may ask what will be seen. */
export interface LessonStep {
  readonly title: string;
  /** Of its heading in the file. */
  readonly line: number;
  /** On entering the step. */
  readonly set: readonly LessonSetting[];
  readonly text: readonly LessonBlock[];
  readonly question?: LessonQuestion;
  readonly claims: readonly LessonClaim[];
}

/** A question that is answered before it is seen. */
export interface LessonQuestion {
  readonly text: readonly LessonInline[];
  /** One of them is right. */
  readonly answers: readonly LessonAnswer[];
  /** When the answer is looked at. */
  readonly see: readonly LessonSetting[];
  readonly explanation: readonly LessonBlock[];
}

export interface LessonAnswer {
  readonly text: readonly LessonInline[];
  readonly right: boolean;
  /** Why it is right, or what it takes for granted. */
  readonly why: readonly LessonInline[];
}

/** `example`, a key of the page (`observer.beta`), or a parameter of a node (`console.view`), with its value. */
export interface LessonSetting {
  readonly key: string;
  readonly value: LessonValue;
  readonly line: number;
}
export type LessonValue = number | boolean | string | Vec3;

/** A number in the text, and the checked quantity that it is: `aberration(0.9, 90) = 25.8`. */
export interface LessonClaim {
  readonly quantity: string;
  readonly of: readonly number[];
  /** As printed in the text. */
  readonly printed: string;
  readonly line: number;
}

export type LessonBlock =
  | { readonly kind: 'paragraph'; readonly content: readonly LessonInline[] }
  | { readonly kind: 'list'; readonly items: readonly (readonly LessonInline[])[] }
  | { readonly kind: 'formula'; readonly text: string };

export type LessonInline =
  | string
  | { readonly kind: 'strong' | 'emphasis' | 'code'; readonly text: string }
  | { readonly kind: 'link'; readonly text: string; readonly address: string };
