import { type Message, msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';

/** Exit codes of the program. */
export const EXIT = {
  ok: 0,
  internal: 1,
  usage: 2,
  input: 3,
  unavailable: 4,
  different: 5,
  ended: 6,
  cancelled: 130,
} as const;

/** For `--help` and docs/guide/command-line.md. */
export const EXIT_MEANINGS: Readonly<Record<(typeof EXIT)[keyof typeof EXIT], Message>> = {
  [EXIT.ok]: msg`done`,
  [EXIT.internal]: msg`an internal error`,
  [EXIT.usage]: msg`an invalid flag or argument`,
  [EXIT.input]: msg`a file that is missing, damaged, unphysical, or cannot be written`,
  [EXIT.unavailable]: msg`no GPU, browser, encoder or port available`,
  [EXIT.different]: msg`compare --fail-above: the pictures differ by more`,
  [EXIT.ended]: msg`simulate: the simulation ended early; its result so far is written`,
  [EXIT.cancelled]: msg`stopped with Ctrl-C; no incomplete file is left`,
};

/** An error that the user can act on; `main` prints its message without a stack. */
export class CliError extends MessageError {
  readonly exitCode: number;
  constructor(exitCode: number, text: Message) {
    super(text);
    this.name = 'CliError';
    this.exitCode = exitCode;
  }
}

export const usageError = (text: Message): CliError => new CliError(EXIT.usage, text);
export const inputProblem = (text: Message): CliError => new CliError(EXIT.input, text);
/** What is made; what users are told of it by others is told as `refusal` does. Faults of our own stay what they are. */
export function orRefuse<T>(make: () => T, refusal: (text: Message) => CliError): T {
  try {
    return make();
  } catch (error) {
    throw error instanceof MessageError ? refusal(error.text) : error;
  }
}

export const unavailable = (text: Message): CliError => new CliError(EXIT.unavailable, text);
