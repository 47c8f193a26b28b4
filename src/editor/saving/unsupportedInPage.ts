import { formatBytes } from '../../formats/diagnostics/inputError.ts';

/** Limit on what the page buffers until the file is complete [bytes]. */
export const MAX_PAGE_BYTES = 2 ** 30;

type UnsupportedReason = 'notice.noFilm' | 'notice.tooLarge';

/** Something that this browser or any page cannot do; the command line can. */
export class UnsupportedInPage extends Error {
  readonly why: UnsupportedReason;
  /** Fillings of its message. */
  readonly fill = { most: formatBytes(MAX_PAGE_BYTES) };
  constructor(why: UnsupportedReason) {
    super(why);
    this.why = why;
  }
}
