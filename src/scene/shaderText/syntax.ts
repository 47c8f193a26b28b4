import type { Place } from './place.ts';

/** A text as it is written, before anything is known of what its names stand for. */

interface At {
  readonly at: Place;
}
/** `vec3f`, or `vec3` with `f32` in brackets. */
export interface TypeName extends At {
  readonly name: string;
  readonly of?: TypeName;
}

export type Expression =
  | (At & { readonly kind: 'number'; readonly text: string })
  | (At & { readonly kind: 'truth'; readonly value: boolean })
  | (At & { readonly kind: 'name'; readonly name: string })
  | (At & { readonly kind: 'unary'; readonly sign: string; readonly of: Expression })
  | (At & { readonly kind: 'binary'; readonly sign: string; readonly a: Expression; readonly b: Expression })
  | (At & { readonly kind: 'call'; readonly callee: TypeName; readonly args: readonly Expression[] })
  | (At & { readonly kind: 'member'; readonly of: Expression; readonly name: string })
  | (At & { readonly kind: 'index'; readonly of: Expression; readonly index: Expression });

export interface Declaration extends At {
  readonly kind: 'declare';
  readonly how: 'let' | 'var' | 'const';
  readonly name: string;
  readonly type: TypeName | undefined;
  readonly value: Expression | undefined;
}
export interface Assignment extends At {
  readonly kind: 'assign';
  readonly target: Expression;
  /** Of `+=` the plus. */
  readonly sign: string | undefined;
  readonly value: Expression;
}
export interface ForLoop extends At {
  readonly kind: 'for';
  readonly first: Statement | undefined;
  readonly while: Expression | undefined;
  readonly next: Statement | undefined;
  readonly body: readonly Statement[];
}
export type Statement =
  | Declaration
  | Assignment
  | ForLoop
  | (At & {
      readonly kind: 'if';
      readonly test: Expression;
      readonly yes: readonly Statement[];
      readonly no: readonly Statement[];
    })
  | (At & { readonly kind: 'block'; readonly body: readonly Statement[] })
  | (At & { readonly kind: 'return'; readonly value: Expression })
  | (At & { readonly kind: 'break' | 'continue' });

export interface FunctionText extends At {
  readonly name: string;
  readonly params: readonly (At & { readonly name: string; readonly type: TypeName })[];
  readonly result: TypeName;
  readonly body: readonly Statement[];
}

export interface Syntax {
  readonly constants: readonly Declaration[];
  readonly functions: readonly FunctionText[];
}
