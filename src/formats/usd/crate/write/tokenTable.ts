import { type Message, msg } from '../../../../messages/message.ts';
import { ByteSink } from './byteSink.ts';
import { writeSized } from './integers.ts';
import { compress } from './lz4.ts';

/** Token 0, as in OpenUSD: it can be no name of a property, of which a path has the index with a minus sign. */
const FIRST = ';-)';

/** Texts of a crate, each once. Strings are indices of indices of tokens. */
export class TokenTable {
  private readonly tokens = new Map<string, number>([[FIRST, 0]]);
  private readonly strings = new Map<string, number>();
  private readonly fail: (message: Message) => never;

  constructor(fail: (message: Message) => never) {
    this.fail = fail;
  }

  index(text: string): number {
    const known = this.tokens.get(text);
    if (known !== undefined) return known;
    if (text.includes('\0')) this.fail(msg`the text ${JSON.stringify(text.slice(0, 80))} has the character U+0000`);
    const index = this.tokens.size;
    this.tokens.set(text, index);
    return index;
  }

  stringIndex(text: string): number {
    const known = this.strings.get(text);
    if (known !== undefined) return known;
    this.index(text);
    const index = this.strings.size;
    this.strings.set(text, index);
    return index;
  }

  /** How many, then their bytes, each with a zero after it. */
  writeTokens(sink: ByteSink): void {
    const text = new ByteSink();
    const utf8 = new TextEncoder();
    for (const token of this.tokens.keys()) {
      text.append(utf8.encode(token));
      text.u8(0);
    }
    sink.u64(this.tokens.size);
    sink.u64(text.length);
    writeSized(sink, compress(text.bytes));
  }

  writeStrings(sink: ByteSink): void {
    sink.u64(this.strings.size);
    for (const text of this.strings.keys()) sink.u32(this.index(text));
  }
}
