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
export const EXIT_MEANINGS: Readonly<Record<(typeof EXIT)[keyof typeof EXIT], string>> = {
  [EXIT.ok]: 'done',
  [EXIT.internal]: 'an internal error',
  [EXIT.usage]: 'an invalid flag or argument',
  [EXIT.input]: 'a file that is missing, damaged, unphysical, or cannot be written',
  [EXIT.unavailable]: 'no GPU, browser, encoder or port available',
  [EXIT.different]: 'compare --fail-above: the pictures differ by more',
  [EXIT.ended]: 'simulate: the simulation ended early; its result so far is written',
  [EXIT.cancelled]: 'stopped with Ctrl-C; no incomplete file is left',
};

/** An error that the user can act on; `main` prints its message without a stack. */
export class CliError extends Error {
  readonly exitCode: number;
  constructor(exitCode: number, message: string) {
    super(message);
    this.name = 'CliError';
    this.exitCode = exitCode;
  }
}

export const usageError = (message: string): CliError => new CliError(EXIT.usage, message);
export const inputProblem = (message: string): CliError => new CliError(EXIT.input, message);
export const unavailable = (message: string): CliError => new CliError(EXIT.unavailable, message);
