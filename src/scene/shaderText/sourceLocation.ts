/** Where in a text, both from 1. */
export interface SourceLocation {
  readonly line: number;
  readonly column: number;
}

/** Why a shader text is refused, and what to do. */
export class ShaderTextError extends Error {
  readonly line: number;
  readonly column: number;
  constructor({ line, column }: SourceLocation, message: string) {
    super(`line ${line}, column ${column}: ${message}`);
    this.name = 'ShaderTextError';
    this.line = line;
    this.column = column;
  }
}

export function refuse(at: SourceLocation, message: string): never {
  throw new ShaderTextError(at, message);
}

/** What a shader text may be, so that it neither stops the page nor the one who waits for its picture. */
export const SHADER_TEXT_LIMITS = {
  /** Characters. */
  length: 16_384,
  /** Brackets within brackets. */
  depth: 40,
  /** Operators and parts of one statement that follow each other. */
  chain: 128,
  /** Times that one loop goes round. */
  rounds: 512,
  /** Of loops within loops, also those of functions that are called in them, multiplied. */
  nested: 4096,
  /** Steps for one pixel: each operation is one, each look at a pixel eight. A million pixels take some 5·10¹⁰, a second of a small GPU. */
  steps: 50_000,
  /** Operations with every call written out. */
  size: 4000,
} as const;
