import { formatBytes } from '../../formats/diagnostics/inputError.ts';

/** What the page holds until all of it is there [bytes]. */
export const MAX_PAGE_BYTES = 2 ** 30;

type UnsupportedReason = 'notice.noFilm' | 'notice.tooLarge';

/** What this browser does not do, or no page can; the command line does. */
export class UnsupportedInPage extends Error {
  readonly why: UnsupportedReason;
  /** What is filled in where that is told. */
  readonly fill = { most: formatBytes(MAX_PAGE_BYTES) };
  constructor(why: UnsupportedReason) {
    super(why);
    this.why = why;
  }
}
