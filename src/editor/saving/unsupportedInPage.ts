import { inEnglish, type Message } from '../../messages/message.ts';

/** Limit on what the page buffers until the file is complete [bytes]. */
export const MAX_PAGE_BYTES = 2 ** 30;

/** Something that this browser or any page cannot do; the command line can. */
export class UnsupportedInPage extends Error {
  /** What to do about it, by the equivalent command line. */
  readonly remedy: (command: string) => Message;
  constructor(remedy: (command: string) => Message) {
    super(inEnglish(remedy('slowlight render')));
    this.remedy = remedy;
  }
}
