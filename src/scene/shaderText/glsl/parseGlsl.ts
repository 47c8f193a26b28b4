import { anyOf, type Message, msg } from '../../../messages/message.ts';
import type { ShaderChannel } from '../program.ts';
import { ShaderParser } from '../shaderParser.ts';
import { refuse, type SourceLocation } from '../sourceLocation.ts';
import type {
  AssignmentSyntax,
  DeclarationSyntax,
  ExpressionSyntax,
  ForLoopSyntax,
  FunctionSyntax,
  ModuleSyntax,
  StatementSyntax,
  TypeSyntax,
} from '../syntax.ts';
import { type ShaderToken, tokenize } from '../tokens.ts';
import { preprocess } from './preprocess.ts';
import {
  channelOfSampler,
  fetchSyntax,
  GLOBAL_EXAMPLES,
  GLSL_TYPES,
  globalNamed,
  SAMPLER_EXAMPLES,
  sizeSyntax,
  textureSyntax,
} from './shaderInterface.ts';

/** Keywords of GLSL that are not supported, and what to write instead. */
const REFUSED: Readonly<Record<string, Message>> = {
  while: msg`write a \`for\` whose count is known: ${'`for (int i = 0; i < 16; i++)`'}`,
  do: msg`write a \`for\` whose count is known: ${'`for (int i = 0; i < 16; i++)`'}`,
  switch: msg`write \`if … else if … else\``,
  discard: msg`return the colour that is to be there`,
  struct: msg`use vectors`,
  buffer: msg`use vectors`,
  shared: msg`use vectors`,
  inout: msg`return the value`,
};
const TYPES_REFUSED: readonly [RegExp, Message][] = [
  [/^u(int|vec[234])$/, msg`use int`],
  [/^d(ouble|vec[234]|mat.*)$/, msg`use float`],
  [/^bvec[234]$/, msg`compare components one by one`],
  [/^mat\dx\d$/, msg`use a square matrix`],
  [/^[iu]?sampler|^image\dD/, msg`pixels are read by samplers declared outside of functions: \`uniform sampler2D\``],
];
/** GLSL's name of a function, and ours. */
const RENAMED: Readonly<Record<string, string>> = { inversesqrt: 'inverseSqrt' };
const LOOKUPS = new Set(['texture', 'texture2D', 'textureLod', 'texelFetch', 'textureSize']);
const PRECISIONS = new Set(['lowp', 'mediump', 'highp']);
/** Name of the pixel that `main` is for; no text can say it. */
const PIXEL = ' pixel';

/** Parses a fragment shader in GLSL; throws with the location where it is not of the language. */
export const parseGlsl = (text: string): ModuleSyntax => new GlslParser(preprocess(tokenize(text, 'glsl'))).module();

class GlslParser extends ShaderParser {
  protected readonly refusedWords = REFUSED;
  private readonly globals = new Map<string, ExpressionSyntax>();
  private readonly samplers = new Map<string, ShaderChannel>();
  private readonly own = new Set<string>();
  /** The variable that `main` writes the colour to. */
  private output: string | undefined;

  module(): ModuleSyntax {
    const constants: DeclarationSyntax[] = [];
    const functions: FunctionSyntax[] = [];
    while (this.here.kind !== 'end') {
      if (this.takes(';')) continue;
      if (this.is('layout')) this.layout();
      if (this.is('precision')) this.skipStatement();
      else if (this.is('uniform') || this.is('in') || this.is('varying')) this.global();
      else if (this.is('out')) this.outputVariable();
      else if (this.is('const')) constants.push(...this.ended(this.declarations('const')));
      else {
        const made = this.function();
        if (made) functions.push(made);
      }
    }
    if (!functions.some(({ name }) => name === 'effect'))
      refuse(this.here, msg`there is no function main: write \`void main() { … }\``);
    return { language: 'glsl', globals: this.globals, constants, functions };
  }

  private skipStatement(): void {
    while (!this.is(';') && this.here.kind !== 'end') this.take();
  }

  private layout(): void {
    this.word('layout');
    this.word('(');
    while (!this.is(')') && this.here.kind !== 'end') this.take();
    this.word(')');
  }

  private global(): void {
    const how = this.take();
    this.precision();
    const type = this.name(msg`the name of a type`);
    do {
      const name = this.name(msg`a name for the value`);
      if (/^[iu]?sampler|^image\dD/.test(type.text)) this.sampler(type, name);
      else this.value(how.text, type, name);
      if (this.is('[')) refuse(this.here, msg`arrays are not taken: pass and return numbers, vectors and matrices`);
    } while (this.takes(','));
    this.word(';');
  }

  private sampler(type: ShaderToken, name: ShaderToken): void {
    const channel = channelOfSampler(name.text);
    if (type.text !== 'sampler2D') refuse(type, msg`the type ${type.text} is not taken: ${msg`use sampler2D`}`);
    if (channel) this.samplers.set(name.text, channel);
    else
      refuse(
        name,
        msg`nothing is known by the name of the sampler ${name.text}: there are ${SAMPLER_EXAMPLES.join(', ')}`,
      );
  }

  private value(how: string, type: ShaderToken, name: ShaderToken): void {
    const found = globalNamed(name.text, name);
    if (!found) {
      const written = `${how} ${type.text} ${name.text}`;
      refuse(name, msg`nothing is known by the name of \`${written}\`: there are ${GLOBAL_EXAMPLES.join(', ')}`);
    }
    if (found.type !== type.text) refuse(type, msg`${name.text} is of type ${found.type}`);
    this.globals.set(name.text, found.value);
  }

  private outputVariable(): void {
    this.word('out');
    this.precision();
    const type = this.word('vec4');
    if (this.output) refuse(type, msg`there is a second output: a pixel has one colour`);
    this.output = this.name(msg`a name for the value`).text;
    this.word(';');
  }

  private precision(): void {
    if (PRECISIONS.has(this.here.text)) this.take();
  }

  private isType(token: ShaderToken): boolean {
    return token.kind === 'name' && (Object.hasOwn(GLSL_TYPES, token.text) || this.refusedType(token) !== undefined);
  }

  private refusedType = ({ text }: ShaderToken): Message | undefined =>
    Object.hasOwn(GLSL_TYPES, text) ? undefined : TYPES_REFUSED.find(([names]) => names.test(text))?.[1];

  private type(): TypeSyntax {
    this.precision();
    const at = this.name(msg`the name of a type`);
    const why = this.refusedType(at);
    if (why) refuse(at, msg`the type ${at.text} is not taken: ${why}`);
    const type = GLSL_TYPES[at.text];
    if (!type || !Object.hasOwn(GLSL_TYPES, at.text))
      return refuse(
        at,
        msg`the type ${at.text} is not known: there are ${Object.keys(GLSL_TYPES).slice(0, 12).join(', ')}`,
      );
    if (this.is('[')) refuse(this.here, msg`arrays are not taken: pass and return numbers, vectors and matrices`);
    return { at, name: at.text, type };
  }

  /** undefined: only announced. */
  private function(): FunctionSyntax | undefined {
    const isVoid = this.is('void');
    const start = this.here;
    const result = isVoid ? undefined : this.type();
    if (isVoid) this.take();
    const name = this.name(msg`a name for the function`);
    if (!this.is('('))
      refuse(start, msg`variables outside of functions are not taken: declare them inside, or with \`const\``);
    this.word('(');
    const params = this.params();
    if (!isVoid) this.own.add(name.text);
    if (isVoid && name.text !== 'main') refuse(name, msg`${name.text} returns nothing: let it return a value`);
    if (this.takes(';')) return undefined;
    if (isVoid) return this.main(name, params.length);
    const copies = params.map(({ at, name: param, type }): StatementSyntax => {
      return { at, kind: 'declare', how: 'var', name: param, type, value: { at, kind: 'name', name: param } };
    });
    const body = [...copies, ...this.block(undefined)];
    return { at: { ...start, ...name }, name: name.text, params, result: result as TypeSyntax, body };
  }

  private params(): FunctionSyntax['params'] {
    const params: { at: SourceLocation; name: string; type: TypeSyntax }[] = [];
    if (this.takes('void')) this.word(')');
    else {
      while (!this.is(')')) {
        if (this.is('out')) refuse(this.here, msg`\`${'out'}\` is not taken: ${msg`return the value`}`);
        while (this.takes('in') || this.takes('const'));
        const type = this.type();
        const at = this.here;
        const name = this.is(',') || this.is(')') ? ` ${params.length}` : this.name(msg`a parameter`).text;
        params.push({ at, name, type });
        if (!this.takes(',')) break;
      }
      this.word(')');
    }
    return params;
  }

  private main(at: ShaderToken, params: number): FunctionSyntax {
    if (params > 0) refuse(at, msg`main has no parameters`);
    const color = this.output ?? 'gl_FragColor';
    const vec4 = (name: string): TypeSyntax => ({ at, name, type: GLSL_TYPES.vec4! });
    const value: ExpressionSyntax = { at, kind: 'name', name: color };
    const body: StatementSyntax[] = [
      { at, kind: 'declare', how: 'var', name: color, type: vec4('vec4'), value: undefined },
      ...this.block(value),
      { at, kind: 'return', value },
    ];
    const pixel: TypeSyntax = { at, name: 'Pixel' };
    return { at, name: 'effect', params: [{ at, name: PIXEL, type: pixel }], result: vec4('vec4'), body };
  }

  /** `result`: what an empty `return` of `main` returns. */
  private block(result: ExpressionSyntax | undefined): readonly StatementSyntax[] {
    return this.within(() => {
      this.word('{');
      const body: StatementSyntax[] = [];
      while (!this.is('}')) {
        if (this.takes(';')) continue;
        body.push(...this.statement(result));
      }
      this.word('}');
      return body;
    });
  }

  /** A block, or one statement without brackets. */
  private body(result: ExpressionSyntax | undefined): readonly StatementSyntax[] {
    if (this.is('{')) return this.block(result);
    return this.takes(';') ? [] : this.within(() => this.statement(result));
  }

  private statement(result: ExpressionSyntax | undefined): readonly StatementSyntax[] {
    const at = this.here;
    switch (at.text) {
      case '{':
        return [{ at, kind: 'block', body: this.block(result) }];
      case 'if':
        return [this.branch(result)];
      case 'for':
        return [this.loop(result)];
      case 'return': {
        this.word('return');
        if (this.is(';') && !result) refuse(this.here, msg`this returns nothing: write the value after \`return\``);
        return [this.ended({ at, kind: 'return', value: this.is(';') && result ? result : this.expression() })];
      }
      case 'break':
      case 'continue':
        this.word(at.text);
        return [this.ended({ at, kind: at.text })];
      default:
        return this.ended(this.simple());
    }
  }

  private branch(result: ExpressionSyntax | undefined): StatementSyntax {
    const at = this.word('if');
    this.word('(');
    const test = this.expression();
    this.word(')');
    const yes = this.body(result);
    return { at, kind: 'if', test, yes, no: this.takes('else') ? this.body(result) : [] };
  }

  private loop(result: ExpressionSyntax | undefined): ForLoopSyntax {
    const at = this.word('for');
    this.word('(');
    const first = this.one(';', at);
    this.word(';');
    const test = this.is(';') ? undefined : this.expression();
    this.word(';');
    const next = this.one(')', at);
    this.word(')');
    return { at, kind: 'for', first, while: test, next, body: this.body(result) };
  }

  private one(end: string, at: SourceLocation): StatementSyntax | undefined {
    if (this.is(end)) return undefined;
    const [only, second] = this.simple();
    if (second) refuse(at, msg`the loop counts more than one variable: declare the others before it`);
    return only;
  }

  /** Declarations or assignments, separated by commas, without the semicolon. */
  private simple(): readonly (DeclarationSyntax | AssignmentSyntax)[] {
    if (this.is('const') || PRECISIONS.has(this.here.text) || this.isType(this.here))
      return this.declarations(this.is('const') ? 'const' : 'var');
    const made = [this.assignment()];
    while (this.takes(',')) made.push(this.assignment());
    return made;
  }

  private declarations(how: 'const' | 'var'): readonly DeclarationSyntax[] {
    if (how === 'const') this.word('const');
    const type = this.type();
    const made: DeclarationSyntax[] = [];
    do {
      const at = this.name(msg`a name for the value`);
      if (this.is('[')) refuse(this.here, msg`arrays are not taken: pass and return numbers, vectors and matrices`);
      const value = this.takes('=') ? this.expression() : undefined;
      if (!value && how === 'const') refuse(this.here, msg`${at.text} has no value: write \`= …\` after it`);
      made.push({ at, kind: 'declare', how, name: at.text, type, value });
    } while (this.takes(','));
    return made;
  }

  private assignment(): AssignmentSyntax {
    const at = this.here;
    const one: ExpressionSyntax = { at, kind: 'number', text: '1' };
    if (this.takes('++') || this.takes('--'))
      return { at, kind: 'assign', target: this.postfix(), sign: at.text[0], value: one };
    if (at.kind !== 'name' || this.isRefused(at.text)) this.refused(msg`a statement`);
    const target = this.postfix();
    const sign = this.here.text;
    if (this.takes('++') || this.takes('--')) return { at, kind: 'assign', target, sign: sign[0], value: one };
    if (target.kind === 'call')
      refuse(at, msg`what ${target.callee.name} returns is not used: assign it, or leave the call out`);
    if (!this.takes('=') && !/^[-+*/%]=$/.test(sign)) this.refused('`=`');
    else if (sign !== '=') this.word(sign);
    return { at, kind: 'assign', target, sign: sign === '=' ? undefined : sign[0], value: this.expression() };
  }

  protected override expression(level = 0): ExpressionSyntax {
    const test = super.expression(level);
    if (level > 0 || !this.is('?')) return test;
    const at = this.word('?');
    const yes = this.within(() => this.expression());
    this.word(':');
    const no = this.within(() => this.expression());
    return { at, kind: 'call', callee: { at, name: 'select' }, args: [no, yes, test] };
  }

  protected named(at: ShaderToken): ExpressionSyntax {
    if (this.isType(at)) {
      const callee = this.type();
      return { at, kind: 'call', callee, args: this.args() };
    }
    this.take();
    const { text: name } = at;
    if (this.is('(')) return this.call(at);
    if (this.samplers.has(name)) refuse(at, msg`a sampler is no value: read it by \`texture(${name}, uv)\``);
    const builtIn = name === 'gl_FragCoord' ? globalNamed(name, at) : undefined;
    return builtIn?.value ?? { at, kind: 'name', name };
  }

  private call(at: ShaderToken): ExpressionSyntax {
    const { text: name } = at;
    if (!this.own.has(name) && LOOKUPS.has(name)) return this.lookup(at);
    const args = this.args();
    const given = this.own.has(name)
      ? name
      : (RENAMED[name] ?? (name === 'atan' && args.length === 2 ? 'atan2' : name));
    return { at, kind: 'call', callee: { at, name: given }, args };
  }

  private lookup(at: ShaderToken): ExpressionSyntax {
    this.word('(');
    const sampler = this.name(msg`a sampler`);
    const channel = this.samplers.get(sampler.text);
    if (!channel)
      return refuse(sampler, msg`${sampler.text} is no sampler: \`uniform sampler2D ${sampler.text};\` before it`);
    const rest: ExpressionSyntax[] = [];
    while (this.takes(',')) rest.push(this.within(() => this.expression()));
    this.word(')');
    const [place, ...more] = rest;
    const counts = { texture: 0, texture2D: 0, textureLod: 1, texelFetch: 1, textureSize: 0 } as const;
    const name = at.text as keyof typeof counts;
    if (!place || more.length !== counts[name])
      return refuse(at, msg`${name} takes ${anyOf([`${counts[name] + 2}`])} values, and has ${rest.length + 1}`);
    if (name === 'textureSize') return sizeSyntax(at);
    return name === 'texelFetch' ? fetchSyntax(channel, place, at) : textureSyntax(channel, place, at);
  }
}
