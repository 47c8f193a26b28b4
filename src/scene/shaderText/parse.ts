import { anyOf, type Message, msg } from '../../messages/message.ts';
import { ShaderParser } from './shaderParser.ts';
import { refuse, type SourceLocation } from './sourceLocation.ts';
import type {
  AssignmentSyntax,
  DeclarationSyntax,
  ExpressionSyntax,
  ForLoopSyntax,
  FunctionSyntax,
  ModuleSyntax,
  StatementSyntax,
  TypeSyntax,
} from './syntax.ts';
import { type ShaderToken, tokenize } from './tokens.ts';

/** WGSL keywords that are not supported, and what to write instead. */
const REFUSED: Readonly<Record<string, Message>> = {
  while: msg`write a \`for\` whose count is known: \`for (var i = 0; i < 16; i++)\``,
  loop: msg`write a \`for\` whose count is known: \`for (var i = 0; i < 16; i++)\``,
  switch: msg`write \`if … else if … else\``,
  discard: msg`return the colour that is to be there`,
  struct: msg`use vectors`,
  alias: msg`write the type's own name`,
  override: msg`use \`const\`, or arg1 … arg4 for what is to be turned`,
  enable: msg`what it enables is not taken`,
  requires: msg`what it requires is not taken`,
  diagnostic: msg`leave it out`,
  fallthrough: msg`write \`if … else if … else\``,
};
const TYPES_REFUSED: readonly [RegExp, Message][] = [
  [/^(ptr|atomic|array)$/, msg`pass and return values: numbers, vectors and matrices`],
  [/^(texture|sampler)/, msg`pixels are read by image(offset), depth(offset), normal(offset) …`],
  [/^(u32|vec[234]u)$/, msg`use i32`],
  [/^(f16|vec[234]h|mat\dx\dh)$/, msg`use f32`],
];
const TEMPLATES = /^(vec[234]|mat[234]x[234]|array|ptr|atomic|texture_\w+)$/;

/** Parses a text; throws with the location where it is not of the language. */
export const parse = (text: string): ModuleSyntax => new Parser(tokenize(text)).module();

class Parser extends ShaderParser {
  protected readonly refusedWords = REFUSED;

  module(): ModuleSyntax {
    const constants: DeclarationSyntax[] = [];
    const functions: FunctionSyntax[] = [];
    while (this.here.kind !== 'end') {
      if (this.takes(';')) continue;
      if (this.is('fn')) functions.push(this.function());
      else if (this.is('const')) constants.push(this.ended(this.declaration()));
      else if (this.is('var'))
        refuse(this.here, msg`\`var\` outside of a function is not taken: declare it inside, or use \`const\``);
      else this.refused(anyOf(['`fn`', '`const`']));
    }
    return { language: 'wgsl', globals: new Map(), constants, functions };
  }

  private function(): FunctionSyntax {
    const at = this.word('fn');
    const name = this.name(msg`a name for the function`);
    this.word('(');
    const params: { at: SourceLocation; name: string; type: TypeSyntax }[] = [];
    while (!this.is(')')) {
      const param = this.name(msg`a parameter`);
      this.word(':');
      params.push({ at: param, name: param.text, type: this.type() });
      if (!this.takes(',')) break;
    }
    this.word(')');
    if (!this.takes('->'))
      refuse(this.here, msg`${name.text} gives nothing: write \`-> vec4f\`, or what else it returns`);
    return { at: { ...at, ...name }, name: name.text, params, result: this.type(), body: this.block() };
  }

  private type(): TypeSyntax {
    const at = this.name(msg`the name of a type`);
    const why = TYPES_REFUSED.find(([names]) => names.test(at.text));
    if (why) refuse(at, msg`the type ${at.text} is not taken: ${why[1]}`);
    if (!TEMPLATES.test(at.text) || !this.takes('<')) return { at, name: at.text };
    const of = this.type();
    this.word('>');
    return { at, name: at.text, of };
  }

  private block(): readonly StatementSyntax[] {
    return this.within(() => {
      this.word('{');
      const body: StatementSyntax[] = [];
      while (!this.is('}')) {
        if (this.takes(';')) continue;
        body.push(this.statement());
      }
      this.word('}');
      return body;
    });
  }

  private statement(): StatementSyntax {
    const at = this.here;
    switch (at.text) {
      case '{':
        return { at, kind: 'block', body: this.block() };
      case 'if':
        return this.branch();
      case 'for':
        return this.loop();
      case 'return': {
        this.word('return');
        if (this.is(';')) refuse(this.here, msg`this returns nothing: write the value after \`return\``);
        return this.ended({ at, kind: 'return', value: this.expression() });
      }
      case 'break':
      case 'continue':
        this.word(at.text);
        return this.ended({ at, kind: at.text });
      default:
        return this.ended(this.simple());
    }
  }

  private branch(): StatementSyntax {
    const at = this.word('if');
    const test = this.expression();
    const yes = this.block();
    if (!this.takes('else')) return { at, kind: 'if', test, yes, no: [] };
    const no = this.is('if') ? [this.within(() => this.branch())] : this.block();
    return { at, kind: 'if', test, yes, no };
  }

  private loop(): ForLoopSyntax {
    const at = this.word('for');
    this.word('(');
    const first = this.is(';') ? undefined : this.simple();
    this.word(';');
    const test = this.is(';') ? undefined : this.expression();
    this.word(';');
    const next = this.is(')') ? undefined : this.simple();
    this.word(')');
    return { at, kind: 'for', first, while: test, next, body: this.block() };
  }

  /** A declaration or an assignment, without the semicolon. */
  private simple(): DeclarationSyntax | AssignmentSyntax {
    if (this.is('let') || this.is('var') || this.is('const')) return this.declaration();
    const at = this.here;
    if (at.kind !== 'name' || this.isRefused(at.text)) this.refused(msg`a statement`);
    const target = this.postfix();
    const sign = this.here.text;
    if (this.takes('++') || this.takes('--')) {
      const one: ExpressionSyntax = { at, kind: 'number', text: '1' };
      return { at, kind: 'assign', target, sign: sign[0], value: one };
    }
    if (target.kind === 'call')
      refuse(at, msg`what ${target.callee.name} returns is not used: assign it, or leave the call out`);
    if (!this.takes('=') && !/^[-+*/%]=$/.test(sign)) this.refused('`=`');
    else if (sign !== '=') this.word(sign);
    return { at, kind: 'assign', target, sign: sign === '=' ? undefined : sign[0], value: this.expression() };
  }

  private declaration(): DeclarationSyntax {
    const at = this.here;
    const how = this.take().text as DeclarationSyntax['how'];
    if (this.is('<')) refuse(this.here, msg`address spaces are not taken: write \`var\` alone`);
    const { text: name } = this.name(msg`a name for the value`);
    const type = this.takes(':') ? this.type() : undefined;
    const value = this.takes('=') ? this.expression() : undefined;
    if (!value && (how !== 'var' || !type)) refuse(this.here, msg`${name} has no value: write \`= …\` after it`);
    return { at, kind: 'declare', how, name, type, value };
  }

  protected named(at: ShaderToken): ExpressionSyntax {
    const templated = TEMPLATES.test(at.text);
    const callee = templated ? this.type() : { at, name: this.take().text };
    if (this.is('(')) return { at, kind: 'call', callee, args: this.args() };
    if (templated) this.refused('`(`');
    return { at, kind: 'name', name: callee.name };
  }
}
