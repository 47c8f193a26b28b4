/** Source: GIF89a specification, appendix F; Welch 1984, "A Technique for High-Performance Data Compression". */

const CLEAR = 256;
const END = 257;
const MAX_CODES = 4096;
/** Slots of the table of known strings: a prime above 4/3 of the codes. */
const SLOTS = 5501;
const MAX_BLOCK = 255;

/** Image data of a GIF: indices of 8 bits, compressed, in blocks, with the code size before and an empty block after. */
export function lzwBlocks(indices: Uint8Array): Uint8Array {
  const out = new BlockWriter(indices.length);
  const strings = new Int32Array(SLOTS).fill(-1);
  const codes = new Uint16Array(SLOTS);
  let [next, width] = [END + 1, 9];
  out.byte(8);
  out.code(CLEAR, width);
  let prefix = indices[0] ?? 0;
  for (let i = 1; i < indices.length; i++) {
    const string = (prefix << 8) | indices[i];
    let slot = string % SLOTS;
    while (strings[slot] !== -1 && strings[slot] !== string) slot = slot + 1 === SLOTS ? 0 : slot + 1;
    if (strings[slot] === string) {
      prefix = codes[slot];
      continue;
    }
    out.code(prefix, width);
    prefix = indices[i];
    if (next === MAX_CODES) {
      out.code(CLEAR, width);
      strings.fill(-1);
      [next, width] = [END + 1, 9];
      continue;
    }
    // The decoder knows a code one step later, when it needs the wider codes.
    if (next === 1 << width) width++;
    strings[slot] = string;
    codes[slot] = next++;
  }
  out.code(prefix, width);
  // With this code the decoder may have filled the current width.
  if (next === 1 << width && width < 12) width++;
  out.code(END, width);
  return out.finish();
}

/** Bytes with codes of several bits, lowest bit first, in blocks that begin with their length. */
class BlockWriter {
  private bytes: Uint8Array;
  private used = 0;
  /** Where the length of the open block is; −1: no block is open. */
  private block = -1;
  private bits = 0;
  private count = 0;

  constructor(size: number) {
    this.bytes = new Uint8Array(1024 + size);
  }

  byte(value: number): void {
    if (this.used === this.bytes.length) {
      const larger = new Uint8Array(2 * this.bytes.length);
      larger.set(this.bytes);
      this.bytes = larger;
    }
    this.bytes[this.used++] = value;
  }

  code(code: number, width: number): void {
    this.bits |= code << this.count;
    this.count += width;
    while (this.count >= 8) {
      this.dataByte(this.bits & 255);
      this.bits >>>= 8;
      this.count -= 8;
    }
  }

  finish(): Uint8Array {
    if (this.count > 0) this.dataByte(this.bits & 255);
    this.closeBlock();
    this.byte(0);
    return this.bytes.slice(0, this.used);
  }

  private dataByte(value: number): void {
    if (this.block < 0) {
      this.block = this.used;
      this.byte(0);
    }
    this.byte(value);
    if (this.used - this.block - 1 === MAX_BLOCK) this.closeBlock();
  }

  private closeBlock(): void {
    if (this.block >= 0) this.bytes[this.block] = this.used - this.block - 1;
    this.block = -1;
  }
}
