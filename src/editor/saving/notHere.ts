import { formatBytes } from '../../formats/fail.ts';

/** What the page holds until all of it is there [bytes]. */
export const MOST = 2 ** 30;

type Why = 'notice.noFilm' | 'notice.tooLarge';

/** What this browser does not do, or no page can; the command line does. */
export class NotHere extends Error {
  readonly why: Why;
  /** What is filled in where that is told. */
  readonly fill = { most: formatBytes(MOST) };
  constructor(why: Why) {
    super(why);
    this.why = why;
  }
}
