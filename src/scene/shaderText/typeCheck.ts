import { type LocalizedText, msg } from '../../messages/message.ts';
import { checkExpression, constantIndex, isReservedName, type ShaderScope } from './expressions.ts';
import { convertTo } from './operations.ts';
import type { ShaderExpression, ShaderFunction, ShaderProgram, ShaderStatement } from './program.ts';
import { refuse, SHADER_TEXT_LIMITS, type SourceLocation } from './sourceLocation.ts';
import type {
  AssignmentSyntax,
  DeclarationSyntax,
  ExpressionSyntax,
  ForLoopSyntax,
  FunctionSyntax,
  ModuleSyntax,
  StatementSyntax,
} from './syntax.ts';
import { declaredType } from './typeNames.ts';
import {
  BOOL,
  componentCount,
  concreteType,
  expectType,
  I32,
  isInteger,
  isSameType,
  PIXEL,
  type ShaderType,
  vector,
} from './types.ts';

interface Signature {
  readonly index: number;
  readonly params: readonly ShaderType[];
  readonly result: ShaderType;
}

/** Resolves names and types of a text; throws where they are invalid. */
export function typeCheck(syntax: ModuleSyntax): Pick<ShaderProgram, 'functions' | 'effect'> {
  const signatures = new Map<string, Signature>();
  const known = new Map<string, ShaderExpression>();
  syntax.functions.forEach((of, index) => {
    if (syntax.language === 'wgsl' && isReservedName(of.name))
      refuse(of.at, msg`${of.name} is a function of WGSL or of effects: call yours otherwise`);
    if (signatures.has(of.name)) refuse(of.at, msg`there is a function ${of.name} already: call this one otherwise`);
    const params = of.params.map(({ type }) => declaredType(type));
    signatures.set(of.name, { index, params, result: declaredType(of.result) });
  });
  const effect = effectOf(syntax, signatures);
  const { language, globals } = syntax;
  const names: ShaderScope = {
    language,
    global: () => undefined,
    variable: (name) => known.get(name),
    function: () => undefined,
  };
  for (const constant of syntax.constants) known.set(constant.name, constantOf(constant, names));
  const functions = syntax.functions.map((of) =>
    new FunctionChecker(signatures, known, language, globals).function(of),
  );
  return { functions, effect };
}

function effectOf({ functions }: ModuleSyntax, signatures: ReadonlyMap<string, Signature>): number {
  const effect = signatures.get('effect');
  if (!effect)
    return refuse(
      { line: 1, column: 1 },
      msg`there is no function effect: write \`fn effect(p: Pixel) -> vec4f { … }\``,
    );
  const { params, result } = effect;
  const fits = params.length === 1 && params.every((type) => isSameType(type, PIXEL)) && isSameType(result, vector(4));
  if (!fits)
    refuse(
      functions[effect.index]?.at ?? { line: 1, column: 1 },
      msg`effect should be a function of one Pixel that returns vec4f`,
    );
  return effect.index;
}

function constantOf({ name, type, value, at }: DeclarationSyntax, names: ShaderScope): ShaderExpression {
  const found = checkExpression(value as ExpressionSyntax, names);
  if (found.op !== 'constant')
    return refuse(at, msg`the value of the const ${name} is not known beforehand: use \`let\``);
  if (!type) return found;
  const wanted = declaredType(type);
  expectType(found.type, wanted, (value as ExpressionSyntax).at, msg`the value of ${name}`);
  return convertTo(found, wanted);
}

interface Variable {
  readonly value: ShaderExpression;
  readonly how: 'let' | 'var' | 'const' | 'parameter' | 'counter';
}

class FunctionChecker {
  private readonly signatures: ReadonlyMap<string, Signature>;
  private readonly known: ReadonlyMap<string, ShaderExpression>;
  private readonly locals: ShaderType[] = [];
  private readonly scopes: Map<string, Variable>[] = [];
  private result: ShaderType = BOOL;
  private loops = 0;

  private readonly names: ShaderScope;

  constructor(
    signatures: ReadonlyMap<string, Signature>,
    known: ReadonlyMap<string, ShaderExpression>,
    language: ModuleSyntax['language'],
    globals: ModuleSyntax['globals'],
  ) {
    this.signatures = signatures;
    this.known = known;
    this.names = {
      language,
      global: (name) => globals.get(name),
      variable: (name) => this.find(name)?.value ?? this.known.get(name),
      function: (name) => this.signatures.get(name),
    };
  }

  function({ name, params, result, body, at }: FunctionSyntax): ShaderFunction {
    this.result = declaredType(result);
    if (this.result.of === 'pixel') refuse(result.at, msg`a Pixel cannot be returned: return its colour or a number`);
    const scope = new Map<string, Variable>();
    for (const param of params) {
      const type = declaredType(param.type);
      const value: ShaderExpression = type.of === 'pixel' ? { op: 'constant', type, numbers: [] } : this.local(type);
      scope.set(param.name, { value, how: 'parameter' });
    }
    const count = this.locals.length;
    this.scopes.push(scope);
    const steps = this.block(body);
    if (!alwaysReturns(body)) refuse(at, msg`not every way through ${name} returns a value: end it with \`return …;\``);
    return { name, locals: this.locals, params: count, result: this.result, body: steps };
  }

  private find(name: string): Variable | undefined {
    for (let i = this.scopes.length - 1; i >= 0; i--) {
      const found = this.scopes[i]?.get(name);
      if (found) return found;
    }
    return undefined;
  }

  private get isGlsl(): boolean {
    return this.names.language === 'glsl';
  }

  private isConstant(value: ExpressionSyntax | undefined): boolean {
    return value !== undefined && checkExpression(value, this.names).op === 'constant';
  }

  private local(type: ShaderType): ShaderExpression & { readonly op: 'local' } {
    this.locals.push(type);
    return { op: 'local', type, local: this.locals.length - 1 };
  }

  private declare(name: string, variable: Variable, at: SourceLocation): void {
    const scope = this.scopes[this.scopes.length - 1];
    if (scope?.has(name)) refuse(at, msg`there is a ${name} already: call this one otherwise`);
    scope?.set(name, variable);
  }

  private block(body: readonly StatementSyntax[]): readonly ShaderStatement[] {
    this.scopes.push(new Map());
    const steps = body.flatMap((statement) => this.statement(statement));
    this.scopes.pop();
    return steps;
  }

  private statement(statement: StatementSyntax): readonly ShaderStatement[] {
    switch (statement.kind) {
      case 'declare':
        return this.declaration(statement);
      case 'assign':
        return this.assignment(statement);
      case 'block':
        return this.block(statement.body);
      case 'if': {
        const test = checkExpression(statement.test, this.names);
        expectType(test.type, BOOL, statement.test.at, msg`what follows \`if\``);
        return [{ op: 'if', test, yes: this.block(statement.yes), no: this.block(statement.no) }];
      }
      case 'for':
        return this.loop(statement);
      case 'return': {
        const value = checkExpression(statement.value, this.names);
        expectType(value.type, this.result, statement.value.at, msg`the returned value`);
        return [{ op: 'return', value: convertTo(value, this.result) }];
      }
      case 'break':
      case 'continue':
        if (this.loops === 0) refuse(statement.at, msg`\`${statement.kind}\` is in no loop`);
        return [{ op: statement.kind }];
    }
  }

  private declaration(statement: DeclarationSyntax): readonly ShaderStatement[] {
    const { how, name, type, value, at } = statement;
    if (how === 'const' && !(this.isGlsl && !this.isConstant(value))) {
      this.declare(name, { value: constantOf(statement, this.names), how }, at);
      return [];
    }
    const wanted = type && declaredType(type);
    const found = value && checkExpression(value, this.names);
    const of = wanted ?? concreteType(found?.type ?? BOOL);
    if (of.of === 'pixel') refuse(at, msg`a Pixel cannot be kept: keep its colour, or a number of it`);
    const zero: ShaderExpression = {
      op: 'constant',
      type: of,
      numbers: Array.from({ length: componentCount(of) }, () => 0),
    };
    if (found) expectType(found.type, of, value.at, msg`the value of ${name}`);
    const local = this.local(of);
    this.declare(name, { value: local, how }, at);
    return [{ op: 'set', local: local.local, part: undefined, value: found ? convertTo(found, of) : zero }];
  }

  private assignment({ target, sign, value, at }: AssignmentSyntax): readonly ShaderStatement[] {
    const { local, type, parts, whole } = this.target(target);
    const sum: ExpressionSyntax = sign ? { at, kind: 'binary', sign, a: target, b: value } : value;
    const found = checkExpression(sum, this.names);
    expectType(found.type, type, value.at, msg`the new value`);
    if (!parts || parts.length === 1) return [{ op: 'set', local, part: parts?.[0], value: convertTo(found, type) }];
    return this.assignParts(local, whole, parts, convertTo(found, type));
  }

  /** `v.xy = …` by way of a variable, since the value may read what it changes. */
  private assignParts(
    local: number,
    type: ShaderType,
    parts: readonly number[],
    value: ShaderExpression,
  ): readonly ShaderStatement[] {
    const kept = this.local(value.type);
    const component = (of: ShaderExpression, part: number): ShaderExpression => ({
      ...{ op: 'parts', type: { ...of.type, rows: 1 }, of, parts: [part] },
    });
    const before: ShaderExpression = { op: 'local', type, local };
    const built = Array.from({ length: type.rows }, (_, k) =>
      parts.includes(k) ? component(kept, parts.indexOf(k)) : component(before, k),
    );
    return [
      { op: 'set', local: kept.local, part: undefined, value },
      { op: 'set', local, part: undefined, value: { op: 'build', type, parts: built } },
    ];
  }

  /** A variable, or components of it: one of them in WGSL. */
  private target(target: ExpressionSyntax): {
    readonly local: number;
    readonly type: ShaderType;
    readonly parts: readonly number[] | undefined;
    readonly whole: ShaderType;
  } {
    const whole = target.kind === 'member' || target.kind === 'index' ? target.of : target;
    if (whole.kind !== 'name') return refuse(target.at, msg`only a variable, or one component of it, can be assigned`);
    const variable = this.find(whole.name);
    if (!variable) return refuse(whole.at, msg`${whole.name} is no variable here: declare it before`);
    if (variable.how === 'counter') refuse(whole.at, msg`${whole.name} counts this loop, and may not be changed in it`);
    if (variable.how !== 'var' || variable.value.op !== 'local')
      return refuse(whole.at, msg`${whole.name} cannot be changed: copy it into a variable`);
    const { local, type } = variable.value;
    if (target.kind === 'name') return { local, type, parts: undefined, whole: type };
    if (type.columns > 1) refuse(target.at, msg`a part of a matrix cannot be assigned: build it anew`);
    const found = checkExpression(target, this.names);
    if (found.op !== 'parts' || (found.parts.length !== 1 && !this.isGlsl))
      return refuse(target.at, msg`WGSL assigns one component at a time: .x, .y, .z or .w`);
    if (new Set(found.parts).size < found.parts.length) refuse(target.at, msg`this assigns one component twice`);
    return { local, type: found.type, parts: found.parts, whole: type };
  }

  private loop({ at, first, while: test, next, body }: ForLoopSyntax): readonly ShaderStatement[] {
    if (first?.kind !== 'declare' || first.how !== 'var' || !first.value)
      return refuse(
        at,
        msg`the loop declares no counter of its own: write ${this.isGlsl ? '`for (int i = 0; i < 16; i++)`' : '`for (var i = 0; i < 16; i++)`'}`,
      );
    const { name } = first;
    const from = this.whole(first.value, msg`the first value of ${name}`);
    const type = first.type ? declaredType(first.type) : I32;
    if (!isInteger(type) || componentCount(type) > 1)
      refuse(first.at, msg`${name} counts, and should be ${this.isGlsl ? 'int' : 'i32'}`);
    const by = this.stride(next, name, at);
    const count = this.rounds(test, name, from, by, at);
    const local = this.local(type);
    this.scopes.push(new Map([[name, { value: local, how: 'counter' } as const]]));
    this.loops++;
    const steps = this.block(body);
    this.loops--;
    this.scopes.pop();
    return [{ op: 'for', local: local.local, first: from, by, count, body: steps }];
  }

  /** A constant integer. */
  private whole(of: ExpressionSyntax, what: LocalizedText): number {
    const value = checkExpression(of, this.names);
    if (value.op !== 'constant' || !isInteger(value.type) || componentCount(value.type) !== 1)
      return refuse(
        of.at,
        msg`${what} must be a whole number that is known beforehand: a number or a \`const\`. Where fewer rounds are needed, leave the loop by \`break\``,
      );
    return constantIndex(value, of.at);
  }

  private stride(next: StatementSyntax | undefined, name: string, at: SourceLocation): number {
    const counts = next?.kind === 'assign' && next.target.kind === 'name' && next.target.name === name;
    if (!counts || (next.sign !== '+' && next.sign !== '-'))
      return refuse(
        next?.at ?? at,
        msg`the loop does not count ${name} on by a number that is known: write ${name}++ or ${name} += 2`,
      );
    const size = this.whole(next.value, msg`the step of ${name}`);
    if (size === 0) refuse(next.at, msg`${name} is counted on by 0: the loop would never end`);
    return next.sign === '+' ? size : -size;
  }

  private rounds(
    test: ExpressionSyntax | undefined,
    name: string,
    from: number,
    by: number,
    at: SourceLocation,
  ): number {
    const bounded = test?.kind === 'binary' && test.a.kind === 'name' && test.a.name === name;
    if (!bounded || !['<', '<=', '>', '>='].includes(test.sign))
      return refuse(
        test?.at ?? at,
        msg`the loop has no end that is known: write ${name} < 16, with the counter on the left`,
      );
    const to = this.whole(test.b, msg`the end of ${name}`);
    if (by > 0 !== test.sign.startsWith('<'))
      refuse(test.at, msg`${name} is counted away from its end: the loop would never end`);
    const distance = (by > 0 ? to - from : from - to) + (test.sign.length === 2 ? 1 : 0);
    const count = Math.max(0, Math.ceil(distance / Math.abs(by)));
    if (count > SHADER_TEXT_LIMITS.rounds)
      refuse(
        test.at,
        msg`this loop goes round ${count} times; more than ${SHADER_TEXT_LIMITS.rounds} are not taken: take fewer, in larger steps`,
      );
    return count;
  }
}

const alwaysReturns = (body: readonly StatementSyntax[]): boolean =>
  body.some(
    (statement) =>
      statement.kind === 'return' ||
      (statement.kind === 'block' && alwaysReturns(statement.body)) ||
      (statement.kind === 'if' && alwaysReturns(statement.yes) && alwaysReturns(statement.no)),
  );
