import { type Message, msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';

/** Line and column in a text, from 1. */
export interface SourceLocation {
  readonly line: number;
  readonly column: number;
}

/** An error in a shader text, with its location and a remedy. */
export class ShaderTextError extends MessageError {
  readonly line: number;
  readonly column: number;
  /** Without the location. */
  readonly reason: Message;
  constructor({ line, column }: SourceLocation, reason: Message) {
    super(msg`line ${line}, column ${column}: ${reason}`);
    this.name = 'ShaderTextError';
    this.reason = reason;
    this.line = line;
    this.column = column;
  }
}

export function refuse(at: SourceLocation, message: Message): never {
  throw new ShaderTextError(at, message);
}

/** Limits of a shader text, which bound the time of a frame. */
export const SHADER_TEXT_LIMITS = {
  /** Characters. */
  length: 16_384,
  /** Nesting depth of brackets. */
  depth: 40,
  /** Length of one statement in operators and parts. */
  chain: 128,
  /** Iterations of one loop. */
  rounds: 512,
  /** Product of the iterations of nested loops, including those in called functions. */
  nested: 4096,
  /** Steps per pixel: 1 per operation, 8 per sample. For a million pixels about 5·10¹⁰, a second on a small GPU. */
  steps: 50_000,
  /** Operations with all calls inlined. */
  size: 4000,
} as const;
