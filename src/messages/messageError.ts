import { inEnglish, type Message, msg } from './message.ts';

/**
 * An error for users; `message` is its English text.
 * @example
 * const error = new MessageError(msg`${'a.usda'} has no object`);
 * error.message; // 'a.usda has no object'
 */
export class MessageError extends Error {
  /** What is wrong, and what to do. */
  readonly text: Message;
  constructor(text: Message, options?: ErrorOptions) {
    super(inEnglish(text), options);
    this.text = text;
  }
}

/**
 * What a thrown value tells users; errors that are not ours keep their words.
 * @example
 * inEnglish(messageOf(new RangeError('too long'))); // 'too long'
 */
export const messageOf = (thrown: unknown): Message =>
  thrown instanceof MessageError ? thrown.text : msg`${thrown instanceof Error ? thrown.message : String(thrown)}`;
