import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import { refuse, SHADER_TEXT_LIMITS } from './sourceLocation.ts';
import type { ExpressionSyntax } from './syntax.ts';
import type { ShaderToken } from './tokens.ts';

/** Binary operators by increasing precedence. */
const LEVELS = [['||'], ['&&'], ['==', '!=', '<', '>', '<=', '>='], ['+', '-'], ['*', '/', '%']] as const;
const BITS = new Set(['&', '|', '^', '~', '<<', '>>']);

/** Reads tokens, and the expressions that WGSL and GLSL have in common. */
export abstract class ShaderParser {
  /** Keywords that are not supported, and what to write instead. */
  protected abstract readonly refusedWords: Readonly<Record<string, Message>>;
  private readonly tokens: readonly ShaderToken[];
  private next = 0;
  private depth = 0;
  private chained = 0;

  constructor(tokens: readonly ShaderToken[]) {
    this.tokens = tokens;
  }

  /** What begins with a name: a variable, a call, a constructor. */
  protected abstract named(at: ShaderToken): ExpressionSyntax;

  protected expression(level = 0): ExpressionSyntax {
    if (level === LEVELS.length) return this.unary();
    let a = this.within(() => this.expression(level + 1));
    while ((LEVELS[level] as readonly string[]).includes(this.here.text) && this.here.kind === 'sign') {
      const at = this.take();
      this.chain(at);
      const b = this.within(() => this.expression(level + 1));
      a = { at, kind: 'binary', sign: at.text, a, b };
    }
    if (this.here.kind === 'sign' && BITS.has(this.here.text))
      refuse(this.here, msg`the operator ${this.here.text} works on bits, and is not taken: use arithmetic`);
    return a;
  }

  private unary(): ExpressionSyntax {
    const at = this.here;
    if (this.takes('-') || this.takes('!'))
      return { at, kind: 'unary', sign: at.text, of: this.within(() => this.unary()) };
    if (at.text === '&' || at.text === '*') refuse(at, msg`pointers are not taken: pass and return values`);
    return this.postfix();
  }

  protected postfix(): ExpressionSyntax {
    let of = this.primary();
    for (;;) {
      const at = this.here;
      this.chain(at, at.text === '.' || at.text === '[');
      if (this.takes('.')) of = { at, kind: 'member', of, name: this.name(msg`x, y, z or w`).text };
      else if (this.takes('[')) {
        const index = this.within(() => this.expression());
        this.word(']');
        of = { at, kind: 'index', of, index };
      } else return of;
    }
  }

  private primary(): ExpressionSyntax {
    const at = this.here;
    if (at.kind === 'number') return { at, kind: 'number', text: this.take().text };
    if (this.takes('true') || this.takes('false')) return { at, kind: 'truth', value: at.text === 'true' };
    if (this.takes('(')) {
      const inner = this.within(() => this.expression());
      this.word(')');
      return inner;
    }
    if (at.kind !== 'name' || this.isRefused(at.text)) this.refused(msg`an expression`);
    return this.named(at);
  }

  /** The arguments of a call, with their brackets. */
  protected args(): readonly ExpressionSyntax[] {
    this.word('(');
    const args: ExpressionSyntax[] = [];
    while (!this.is(')')) {
      args.push(this.within(() => this.expression()));
      if (!this.takes(',')) break;
    }
    this.word(')');
    return args;
  }

  protected within<T>(read: () => T): T {
    if (++this.depth > LEVELS.length * SHADER_TEXT_LIMITS.depth)
      refuse(this.here, msg`this lies more than ${SHADER_TEXT_LIMITS.depth} brackets deep: give parts of it names`);
    const found = read();
    this.depth--;
    return found;
  }

  /** Chained operators nest as deep as they are long. */
  private chain(at: ShaderToken, longer = true): void {
    if (longer && ++this.chained > SHADER_TEXT_LIMITS.chain)
      refuse(at, msg`this statement is longer than ${SHADER_TEXT_LIMITS.chain} operators: give parts of it names`);
  }

  protected isRefused(text: string): boolean {
    return Object.hasOwn(this.refusedWords, text);
  }

  protected ended<T>(statement: T): T {
    this.chained = 0;
    this.word(';');
    return statement;
  }

  protected get here(): ShaderToken {
    return this.tokens[Math.min(this.next, this.tokens.length - 1)] as ShaderToken;
  }

  protected take(): ShaderToken {
    const token = this.here;
    this.next++;
    return token;
  }

  protected is(text: string): boolean {
    return this.here.text === text;
  }

  protected takes(text: string): boolean {
    if (!this.is(text)) return false;
    this.next++;
    return true;
  }

  protected word(text: string): ShaderToken {
    if (!this.is(text)) this.refused(`\`${text}\``);
    return this.take();
  }

  protected name(what: LocalizedText): ShaderToken {
    if (this.here.kind !== 'name' || this.isRefused(this.here.text)) this.refused(what);
    return this.take();
  }

  protected refused(expected: LocalizedText): never {
    const { text, kind } = this.here;
    const instead = this.isRefused(text) ? this.refusedWords[text] : undefined;
    if (instead && kind === 'name') refuse(this.here, msg`\`${text}\` is not taken: ${instead}`);
    if (text === '@') refuse(this.here, msg`attributes are not taken: leave them out`);
    refuse(
      this.here,
      msg`expected ${expected} here, found ${kind === 'end' ? msg`the end of the text` : `\`${text}\``}`,
    );
  }
}
