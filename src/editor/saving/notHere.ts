import { formatBytes } from '../../formats/fail.ts';

/** What the page holds until all of it is there [bytes]. */
export const MOST = 2 ** 30;

type Why = 'notice.noFilm' | 'notice.tooLarge' | 'notice.tooManyPixels';

/** What this browser does not do, or no page can; the command line does. */
export class NotHere extends Error {
  readonly why: Why;
  /** What is filled in where that is told. */
  readonly fill: Readonly<Record<string, string | number>>;
  constructor(why: Why, fill: NotHere['fill'] = { most: formatBytes(MOST) }) {
    super(why);
    this.why = why;
    this.fill = fill;
  }
}
