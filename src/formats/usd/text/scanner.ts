import { type LocalizedText, type Message, msg } from '../../../messages/message.ts';
import { inputError } from '../../diagnostics/inputError.ts';

const NEWLINE = 10;
const RETURN = 13;
const QUOTE = 34;
const HASH = 35;
const APOSTROPHE = 39;
const STAR = 42;
const MINUS = 45;
const DOT = 46;
const SLASH = 47;
const AT = 64;
const BACKSLASH = 92;

const isDigit = (c: number | undefined): boolean => c !== undefined && c >= 48 && c <= 57;
const isNameStart = (c: number): boolean => (c >= 65 && c <= 90) || (c >= 97 && c <= 122) || c === 95 || c >= 128;
const isName = (c: number): boolean => isNameStart(c) || isDigit(c);

/** 10⁰ … 10²²: the powers of ten that a double holds exactly. */
const POWERS = Float64Array.from({ length: 23 }, (_, i) => 10 ** i);

/** Tokenizer of USD text over its bytes, with positions. The bytes are never decoded to one string: a file can exceed the maximum string length. */
export class Scanner {
  readonly bytes: Uint8Array;
  readonly file: string;
  pos = 0;
  /** `pos` while only white space has followed the last new line. */
  private lineStart = 0;
  private readonly utf8 = new TextDecoder('utf-8', { fatal: true });

  constructor(bytes: Uint8Array, file: string) {
    this.bytes = bytes;
    this.file = file;
  }

  /** Skips white space and comments. */
  skip(): void {
    const { bytes } = this;
    for (;;) {
      const c = bytes[this.pos];
      if (c === 32 || c === 9) {
        if (this.lineStart === this.pos) this.lineStart++;
        this.pos++;
      } else if (c === NEWLINE || c === RETURN) {
        this.lineStart = ++this.pos;
      } else if (c === HASH || (c === SLASH && bytes[this.pos + 1] === SLASH)) this.skipLine();
      else if (c === SLASH && bytes[this.pos + 1] === STAR) this.skipBlock();
      else return;
    }
  }

  private skipLine(): void {
    const end = this.bytes.indexOf(NEWLINE, this.pos);
    this.pos = end < 0 ? this.bytes.length : end;
  }

  private skipBlock(): void {
    const start = this.pos;
    for (this.pos += 2; this.pos < this.bytes.length; this.pos++) {
      if (this.bytes[this.pos] === STAR && this.bytes[this.pos + 1] === SLASH) {
        this.pos += 2;
        if (this.lineStart === start) this.lineStart = this.pos;
        return;
      }
    }
    this.fail(msg`the comment that begins here is not closed with */`, start);
  }

  atEnd(): boolean {
    this.skip();
    return this.pos >= this.bytes.length;
  }

  /** The next character after white space; empty at the end. */
  peek(): string {
    this.skip();
    const c = this.bytes[this.pos];
    return c === undefined ? '' : String.fromCharCode(c);
  }

  /** Consumes `char` if it comes next. */
  take(char: string): boolean {
    if (this.peek() !== char) return false;
    this.pos++;
    return true;
  }

  expect(char: string, where: LocalizedText): void {
    if (!this.take(char)) this.expected(msg`'${char}' ${where}`);
  }

  /** Consumes a name; undefined if none comes next. */
  takeName(): string | undefined {
    this.skip();
    const start = this.pos;
    const first = this.bytes[start];
    if (first === undefined || !isNameStart(first)) return undefined;
    while (this.pos < this.bytes.length && isName(this.bytes[this.pos]!)) this.pos++;
    return this.text(start, this.pos);
  }

  name(what: LocalizedText): string {
    return this.takeName() ?? this.expected(what);
  }

  /** A name, then more of them joined by `separator` without spaces: `primvars:st`. */
  joinedName(separator: ':' | '.', what: LocalizedText): string {
    let name = this.name(what);
    const code = separator.charCodeAt(0);
    while (this.bytes[this.pos] === code && isNameStart(this.bytes[this.pos + 1] ?? 0)) {
      const start = this.pos++;
      while (this.pos < this.bytes.length && isName(this.bytes[this.pos]!)) this.pos++;
      name += this.text(start, this.pos);
    }
    return name;
  }

  /** The next name, not consumed. */
  peekName(): string | undefined {
    this.skip();
    const { pos } = this;
    const name = this.takeName();
    this.pos = pos;
    return name;
  }

  takeKeyword(word: string): boolean {
    if (this.peekName() !== word) return false;
    this.pos += word.length;
    return true;
  }

  /** Consumes the end of a statement: a new line, one ';' on its own line, or the closing bracket of the block. */
  endStatement(what: LocalizedText): void {
    const c = this.peek();
    const newline = this.lineStart === this.pos;
    if (newline || c === '}' || c === ')' || c === '') return;
    if (c !== ';') this.expected(msg`a new line or ';' after ${what}`);
    this.pos++;
  }

  /**
   * A decimal number, correctly rounded to a double: with at most 15 digits and a small exponent the product of two
   * exact doubles (Clinger 1990), else by the platform's own conversion.
   */
  number(): number {
    const { bytes } = this;
    this.skip();
    const start = this.pos;
    let p = start;
    const negative = bytes[p] === MINUS;
    if (negative) p++;
    let mantissa = 0;
    let digits = 0;
    let exponent = 0;
    let any = false;
    for (; isDigit(bytes[p]); p++) {
      mantissa = mantissa * 10 + (bytes[p]! - 48);
      if (mantissa > 0) digits++;
      any = true;
    }
    if (bytes[p] === DOT) {
      for (p++; isDigit(bytes[p]); p++) {
        mantissa = mantissa * 10 + (bytes[p]! - 48);
        if (mantissa > 0) digits++;
        exponent--;
        any = true;
      }
    }
    if (!any) return this.wordNumber(start, negative);
    if (bytes[p] === 69 || bytes[p] === 101) {
      const from = p + 1;
      p = this.exponentEnd(from, start);
      exponent += Number(this.text(from, p));
    }
    this.pos = p;
    if (digits > 15 || exponent > 22 || exponent < -22) return Number(this.text(start, p));
    const value = exponent < 0 ? mantissa / POWERS[-exponent] : mantissa * POWERS[exponent];
    return negative ? -value : value;
  }

  private exponentEnd(from: number, start: number): number {
    let p = from;
    if (this.bytes[p] === MINUS || this.bytes[p] === 43) p++;
    const first = p;
    while (isDigit(this.bytes[p])) p++;
    return p > first ? p : this.fail(msg`the exponent of this number has no digits`, start);
  }

  private wordNumber(start: number, negative: boolean): number {
    this.pos = negative ? start + 1 : start;
    const end = this.pos + 3;
    const word = isName(this.bytes[end] ?? 0) ? '' : this.ascii(this.pos, end);
    this.pos = end;
    if (word === 'inf') return negative ? -Infinity : Infinity;
    if (word === 'nan' && !negative) return NaN;
    this.pos = start;
    return this.expected(msg`a number`);
  }

  /** Digits of an integer of any size. */
  integerText(): string {
    this.skip();
    const start = this.pos;
    if (this.bytes[this.pos] === MINUS) this.pos++;
    const first = this.pos;
    while (isDigit(this.bytes[this.pos])) this.pos++;
    const next = this.bytes[this.pos];
    if (this.pos > first && next !== DOT && next !== 69 && next !== 101) return this.text(start, this.pos);
    this.pos = start;
    return this.expected(msg`a whole number`);
  }

  /** `"…"`, `'…'` or the tripled forms, which may hold new lines. */
  string(what: LocalizedText): string {
    this.skip();
    const start = this.pos;
    const quote = this.bytes[start];
    if (quote !== QUOTE && quote !== APOSTROPHE) return this.expected(what);
    const triple = this.bytes[start + 1] === quote && this.bytes[start + 2] === quote;
    const from = start + (triple ? 3 : 1);
    let escaped = false;
    for (let p = from; p < this.bytes.length; p++) {
      const c = this.bytes[p];
      if (c === BACKSLASH) {
        escaped = true;
        p++;
      } else if (c === quote && (!triple || (this.bytes[p + 1] === quote && this.bytes[p + 2] === quote))) {
        this.pos = p + (triple ? 3 : 1);
        return escaped ? this.unescape(from, p) : this.text(from, p);
      } else if (!triple && (c === NEWLINE || c === RETURN)) break;
    }
    const message = triple
      ? msg`the string that begins here is not closed`
      : msg`the string that begins here is not closed on its line`;
    return this.fail(message, start);
  }

  private unescape(from: number, to: number): string {
    const out = new Uint8Array(to - from);
    let n = 0;
    for (let p = from; p < to; ) {
      const c = this.bytes[p++]!;
      if (c !== BACKSLASH) out[n++] = c;
      else {
        const [byte, used] = this.escape(p, to);
        out[n++] = byte;
        p += used;
      }
    }
    return this.decode(out.subarray(0, n), from);
  }

  /** The byte that an escape stands for and how long it is after its backslash (as TfEscapeString of OpenUSD). */
  private escape(p: number, end: number): [byte: number, length: number] {
    const char = String.fromCharCode(this.bytes[p]!);
    const control = 'abfnrtv'.indexOf(char);
    if (control >= 0) return [[7, 8, 12, 10, 13, 9, 11][control]!, 1];
    const text = this.ascii(p, Math.min(p + 4, end));
    const hex = /^x([0-9a-fA-F]{1,2})/.exec(text);
    if (hex) return [Number.parseInt(hex[1]!, 16), hex[0].length];
    const octal = /^[0-7]{1,3}/.exec(text);
    if (octal) return [Number.parseInt(octal[0], 8) & 255, octal[0].length];
    return [this.bytes[p]!, 1];
  }

  /** `@…@`, or `@@@…@@@` for a path that holds an @. */
  asset(): string {
    this.skip();
    const start = this.pos;
    if (this.bytes[start] !== AT) return this.expected(msg`an asset path (@…@)`);
    const triple = this.bytes[start + 1] === AT && this.bytes[start + 2] === AT;
    const close = triple ? '@@@' : '@';
    for (let p = start + close.length; p < this.bytes.length && this.bytes[p] !== NEWLINE; p++) {
      if (triple && this.bytes[p] === BACKSLASH && this.ascii(p + 1, p + 4) === '@@@') p += 3;
      else if (this.bytes[p] === AT && this.ascii(p, p + close.length) === close) {
        // Up to two @ may stand right before the closing three.
        if (triple) while (this.bytes[p + 3] === AT) p++;
        this.pos = p + close.length;
        const text = this.text(start + close.length, p);
        return triple ? text.replaceAll('\\@@@', '@@@') : text;
      }
    }
    return this.fail(msg`the asset path that begins here is not closed with ${close} on its line`, start);
  }

  /** `<…>`, as written. */
  path(): string {
    this.skip();
    const start = this.pos;
    if (this.bytes[start] !== 60) return this.expected(msg`a path (<…>)`);
    for (let p = start + 1; p < this.bytes.length && this.bytes[p] !== NEWLINE; p++) {
      if (this.bytes[p] !== 62) continue;
      this.pos = p + 1;
      return this.text(start + 1, p);
    }
    return this.fail(msg`the path that begins here is not closed with > on its line`, start);
  }

  /** Decodes bytes; throws if not UTF-8. */
  text(from: number, to: number): string {
    return this.decode(this.bytes.subarray(from, to), from);
  }

  private decode(bytes: Uint8Array, from: number): string {
    if (bytes.length < 64 && bytes.every((b) => b < 128)) return String.fromCharCode(...bytes);
    try {
      return this.utf8.decode(bytes);
    } catch {
      return this.fail(msg`this text is not UTF-8; save the file as UTF-8`, from);
    }
  }

  /** Bytes as Latin-1, for comparison with ASCII. */
  private ascii(from: number, to: number): string {
    return String.fromCharCode(...this.bytes.subarray(from, to));
  }

  /** Throws for an unexpected token. */
  expected(what: LocalizedText): never {
    this.skip();
    if (this.pos >= this.bytes.length)
      return this.fail(msg`expected ${what}, found the end of the file; it may be cut off`);
    const line = String.fromCharCode(...this.bytes.subarray(this.pos, this.pos + 40)).split(/[\r\n]/)[0]!;
    const found = (/^([\w:.-]+|\W)/.exec(line)?.[0] ?? line).slice(0, 32);
    return this.fail(msg`expected ${what}, found '${found}'`);
  }

  fail(message: Message, at = this.pos): never {
    throw inputError('usd.syntax', this.place(at), message);
  }

  /** `file:line:column`, both from 1. */
  place(at = this.pos): string {
    let line = 1;
    let start = 0;
    for (let p = this.bytes.indexOf(NEWLINE); p >= 0 && p < at; p = this.bytes.indexOf(NEWLINE, p + 1)) {
      line++;
      start = p + 1;
    }
    return `${this.file}:${line}:${at - start + 1}`;
  }
}
