import type { Message } from '../../../../messages/message.ts';
import type { PathTable } from './pathTable.ts';
import type { TokenTable } from './tokenTable.ts';

/** Where the parts of a value go. */
export interface PackContext {
  readonly tokens: TokenTable;
  readonly paths: PathTable;
  /** Puts bytes into the file; returns where they are. */
  place(bytes: Uint8Array, alignment?: number): number;
  fail(message: Message): never;
}
