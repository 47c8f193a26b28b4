/** How the program ends; documented in `slowlight --help`. */
export const EXIT = {
  ok: 0,
  /** A fault of ours. */
  internal: 1,
  /** A flag or an argument that makes no sense. */
  usage: 2,
  /** A file that is missing, damaged or describes what cannot be. */
  input: 3,
  /** No GPU, browser or encoder to do it with. */
  unavailable: 4,
  /** `compare --fail-above`: the pictures differ by more than that. */
  different: 5,
  /** `simulate`: it ended before its time; what there is of it is written. */
  ended: 6,
  /** Ctrl-C. */
  cancelled: 130,
} as const;

/** An error that a person can act on; `main` prints its message alone, without a stack. */
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
