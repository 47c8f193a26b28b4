import type { ShaderChannel, ShaderInput } from './program.ts';
import type { SourceLocation } from './sourceLocation.ts';
import type { ShaderType } from './types.ts';

/** The syntax tree, before names are resolved. */

interface SyntaxNode {
  readonly at: SourceLocation;
}
/** `vec3f`, or `vec3` with `f32` in brackets. */
export interface TypeSyntax extends SyntaxNode {
  readonly name: string;
  readonly of?: TypeSyntax;
  /** Known to the parser: GLSL's names mean other types. */
  readonly type?: ShaderType;
}

export type ExpressionSyntax =
  | (SyntaxNode & { readonly kind: 'number'; readonly text: string })
  | (SyntaxNode & { readonly kind: 'truth'; readonly value: boolean })
  | (SyntaxNode & { readonly kind: 'name'; readonly name: string })
  | (SyntaxNode & { readonly kind: 'input'; readonly input: ShaderInput })
  | (SyntaxNode & { readonly kind: 'unary'; readonly sign: string; readonly of: ExpressionSyntax })
  | (SyntaxNode & {
      readonly kind: 'binary';
      readonly sign: string;
      readonly a: ExpressionSyntax;
      readonly b: ExpressionSyntax;
    })
  | (SyntaxNode & { readonly kind: 'call'; readonly callee: TypeSyntax; readonly args: readonly ExpressionSyntax[] })
  | (SyntaxNode & { readonly kind: 'member'; readonly of: ExpressionSyntax; readonly name: string })
  /** GLSL's `texture`: a channel as the four components of a texel, at an offset in pixels. */
  | (SyntaxNode & { readonly kind: 'texel'; readonly channel: ShaderChannel; readonly offset: ExpressionSyntax })
  | (SyntaxNode & { readonly kind: 'index'; readonly of: ExpressionSyntax; readonly index: ExpressionSyntax });

export interface DeclarationSyntax extends SyntaxNode {
  readonly kind: 'declare';
  readonly how: 'let' | 'var' | 'const';
  readonly name: string;
  readonly type: TypeSyntax | undefined;
  readonly value: ExpressionSyntax | undefined;
}
export interface AssignmentSyntax extends SyntaxNode {
  readonly kind: 'assign';
  readonly target: ExpressionSyntax;
  /** `+` of `+=`. */
  readonly sign: string | undefined;
  readonly value: ExpressionSyntax;
}
export interface ForLoopSyntax extends SyntaxNode {
  readonly kind: 'for';
  readonly first: StatementSyntax | undefined;
  readonly while: ExpressionSyntax | undefined;
  readonly next: StatementSyntax | undefined;
  readonly body: readonly StatementSyntax[];
}
export type StatementSyntax =
  | DeclarationSyntax
  | AssignmentSyntax
  | ForLoopSyntax
  | (SyntaxNode & {
      readonly kind: 'if';
      readonly test: ExpressionSyntax;
      readonly yes: readonly StatementSyntax[];
      readonly no: readonly StatementSyntax[];
    })
  | (SyntaxNode & { readonly kind: 'block'; readonly body: readonly StatementSyntax[] })
  | (SyntaxNode & { readonly kind: 'return'; readonly value: ExpressionSyntax })
  | (SyntaxNode & { readonly kind: 'break' | 'continue' });

export interface FunctionSyntax extends SyntaxNode {
  readonly name: string;
  readonly params: readonly (SyntaxNode & { readonly name: string; readonly type: TypeSyntax })[];
  readonly result: TypeSyntax;
  readonly body: readonly StatementSyntax[];
}

export interface ModuleSyntax {
  readonly language: 'wgsl' | 'glsl';
  /** GLSL's uniforms and inputs. */
  readonly globals: ReadonlyMap<string, ExpressionSyntax>;
  readonly constants: readonly DeclarationSyntax[];
  readonly functions: readonly FunctionSyntax[];
}
