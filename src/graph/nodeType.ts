import type { ParamValue } from './document/document.ts';

/**
 * How a node type describes itself. Panels, menus, the reference pages and the tests are made from these descriptions,
 * so that a new node is one file.
 */
export interface Socket<Type extends string = string> {
  /**
   * Two sockets connect where their types are the same, or one converts to the other (convert.ts). `any`: whatever is connected; all
   * sockets of a node that are `any` are of one type.
   */
  readonly type: Type;
  /** Key of the catalogue of messages; else it is shown by its name. */
  readonly title?: string;
  /** An input without a source is an error, unless it is optional. */
  readonly optional?: boolean;
  /** An input of any number of edges, in the order of their numbers: `name.1`, `name.2`. The node's code gets an array. */
  readonly many?: boolean;
}
/** The type of a socket that takes its type from what is connected. */
export const ANY = 'any';

interface ParamBase {
  /** Key of the catalogue of messages. */
  readonly title: string;
  /** Key of the sentence that explains it. */
  readonly help?: string;
  /** Matters only while another parameter of the node has this value, or one of these. */
  readonly onlyWhen?: { readonly param: string; readonly is: ParamValue | readonly ParamValue[] };
  /** The value that is nature's: at any other the control is marked as not physical. */
  readonly physical?: ParamValue;
}
export interface NumberParam extends ParamBase {
  readonly kind: 'number';
  readonly default: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  /** `log`: a control moves in equal ratios. `approach`: in equal steps of how near the value comes to 1. */
  readonly scale?: 'linear' | 'log' | 'approach';
  /** As written beside the number: `m/s`, `c`, `EV`, `°`. */
  readonly unit?: string;
  readonly integer?: boolean;
  /** False: it has no range that a slider could go through, and is only typed. */
  readonly slider?: boolean;
  /** While the parameter is not set, what the scene suggests under this name comes before the default. */
  readonly suggestion?: string;
  /** It means something else by the value of another parameter; with a value that is not among these, nothing. */
  readonly as?: { readonly param: string; readonly cases: Readonly<Record<string, NumberVariant>> };
}
/** What a number is called, and which it may be, in one of its meanings. */
export type NumberVariant = Pick<
  NumberParam,
  'title' | 'default' | 'min' | 'max' | 'step' | 'scale' | 'unit' | 'slider'
>;
export interface BooleanParam extends ParamBase {
  readonly kind: 'boolean';
  readonly default: boolean;
}
export interface ChoiceParam<Value extends string = string> extends ParamBase {
  readonly kind: 'choice';
  readonly default: Value;
  readonly options: readonly { readonly value: Value; readonly title: string }[];
}
export interface TextParam extends ParamBase {
  readonly kind: 'text';
  readonly default: string;
  /** Where its values come from: `cameras` of the scene. Without, a special control of the program sets it (the opened file). */
  readonly choices?: 'cameras';
  /** It names a file of the project. */
  readonly file?: true;
  /** It is the text of an effect, of many lines. */
  readonly shader?: true;
  /** It may be of several lines. */
  readonly lines?: true;
}
/** Three numbers: a direction, a place. */
export interface VectorParam extends ParamBase {
  readonly kind: 'vector';
  readonly default: readonly [number, number, number];
  /** Of each of them, as written beside the number. */
  readonly unit?: string;
}
/** Linear sRGB. */
export interface ColorParam extends ParamBase {
  readonly kind: 'color';
  readonly default: readonly [number, number, number];
}
/** Texts of which there may be any number; a special control of the program sets them. */
export interface ListParam extends ParamBase {
  readonly kind: 'list';
  readonly default: readonly string[];
}
export type ParamSpec = NumberParam | BooleanParam | ChoiceParam | TextParam | VectorParam | ColorParam | ListParam;

/** The value that a node's code gets for a parameter. */
export type ParamValueOf<Spec> =
  Spec extends ChoiceParam<infer Value>
    ? Value
    : Spec extends { readonly suggestion: string }
      ? number | undefined
      : Spec extends NumberParam
        ? number
        : Spec extends BooleanParam
          ? boolean
          : Spec extends VectorParam | ColorParam
            ? readonly [number, number, number]
            : Spec extends ListParam
              ? readonly string[]
              : string;

/** What an `AbortSignal` is, as far as the engine needs it. */
export interface AbortSignalLike {
  readonly aborted: boolean;
  addEventListener(type: 'abort', listener: () => void): void;
}

/** Reports a part done, 0 … 1, or undefined where it cannot be known, and what is being done. */
export type ProgressCallback = (part: number | undefined, what?: string) => void;

/** By the names of the outputs. Under other names a node may put what only itself needs, to go on from an interim. */
export type Outputs = Readonly<Record<string, unknown>>;

/**
 * Gives what there is so far, as outputs that are right as far as they go. To be called as often as there is something new: what is not
 * wanted now is not made.
 */
export type ReportInterim = (make: () => Outputs) => void;

export interface EvaluationContext<Services> {
  readonly services: Services;
  readonly signal?: AbortSignalLike;
  readonly progress: ProgressCallback;
  /** Absent where nobody looks. */
  readonly interim?: ReportInterim;
  /** The last interim of the same content, whose work was cancelled. */
  readonly resume?: Outputs;
}

/** Cause and remedy of a refusal, as it is shown on the node. */
export interface NodeProblem {
  readonly severity: 'error' | 'warning';
  readonly code: string;
  /** Node, or file and prim path. */
  readonly place: string;
  readonly message: string;
  /** A change of a parameter that would put it right. */
  readonly remedy?: { readonly node: string; readonly param: string; readonly value: ParamValue };
}

/** Thrown by a node's evaluation to refuse its inputs; the engine sets it on the node. */
export class NodeRefusal extends Error {
  readonly problem: NodeProblem;
  constructor(problem: NodeProblem) {
    super(problem.message);
    this.name = 'NodeRefusal';
    this.problem = problem;
  }
}

/** A node type with its types erased, as the engine and the panels see it. */
export interface NodeType<Services = unknown> {
  readonly id: string;
  readonly title: string;
  readonly help: string;
  readonly category: 'geometry' | 'dynamics' | 'composition' | 'render' | 'utility';
  readonly params: Readonly<Record<string, ParamSpec>>;
  readonly inputs: Readonly<Record<string, Socket>>;
  readonly outputs: Readonly<Record<string, Socket>>;
  /** The inputs that matter with these parameters; the others are not evaluated. Without: all. */
  needs?(params: Readonly<Record<string, ParamValue | undefined>>): readonly string[];
  /** Takes long: it is evaluated in a worker, without services. */
  readonly heavy?: boolean;
  /** Whether it computes on a GPU, which not every worker can reach. */
  onGpu?(params: Readonly<Record<string, ParamValue | undefined>>): boolean;
  evaluate(
    inputs: Readonly<Record<string, unknown>>,
    params: Readonly<Record<string, ParamValue | undefined>>,
    work: EvaluationContext<Services> & { readonly node: string },
  ): Record<string, unknown> | Promise<Record<string, unknown>>;
}

export type Registry<Services = unknown> = Readonly<Record<string, NodeType<Services>>>;

/** Every parameter with its value: as set, else the default; undefined where the scene may suggest one. */
export function resolveParams(
  type: NodeType,
  set: Readonly<Record<string, ParamValue>>,
): Record<string, ParamValue | undefined> {
  return Object.fromEntries(
    Object.entries(type.params).map(([name, spec]) => {
      if (Object.hasOwn(set, name)) return [name, set[name]];
      return [name, spec.kind === 'number' && spec.suggestion ? undefined : resolveSpec(type, spec, set).default];
    }),
  );
}

/** A parameter as it is described with these values of the others. */
export function resolveSpec(
  type: NodeType,
  spec: ParamSpec,
  params: Readonly<Record<string, ParamValue | undefined>>,
): ParamSpec {
  if (spec.kind !== 'number' || !spec.as) return spec;
  const { param, cases } = spec.as;
  const value = params[param] ?? type.params[param]?.default;
  return { ...spec, ...(typeof value === 'string' && Object.hasOwn(cases, value) ? cases[value] : undefined) };
}

/** Whether a parameter matters, by the values of the others. */
export function isParamActive(spec: ParamSpec, params: Readonly<Record<string, ParamValue | undefined>>): boolean {
  const { onlyWhen } = spec;
  if (spec.kind === 'number' && spec.as) return Object.hasOwn(spec.as.cases, String(params[spec.as.param]));
  return onlyWhen === undefined || [onlyWhen.is].flat().includes(params[onlyWhen.param] ?? '');
}

/** Whether nature has another value. */
export const isUnphysical = ({ physical }: ParamSpec, value: ParamValue): boolean =>
  physical !== undefined && value !== physical;

/** Why a value cannot stand for a parameter, or undefined where it can. */
export function valueError(spec: ParamSpec, value: ParamValue): string | undefined {
  if (spec.kind === 'number') return numberError(spec, value);
  if (spec.kind === 'choice')
    return spec.options.some((option) => option.value === value)
      ? undefined
      : `${String(value)} is none of the choices`;
  if (spec.kind === 'vector' || spec.kind === 'color')
    return isVector(value) ? undefined : `${String(value)} is not three numbers`;
  if (spec.kind === 'list') return isList(value) ? undefined : `${String(value)} is no list of texts`;
  const wanted = spec.kind === 'boolean' ? 'boolean' : 'string';
  return typeof value === wanted ? undefined : `${String(value)} is not a ${wanted}`;
}

const isVector = (value: ParamValue): boolean =>
  Array.isArray(value) && value.length === 3 && value.every((x) => Number.isFinite(x));
const isList = (value: ParamValue): boolean => Array.isArray(value) && value.every((text) => typeof text === 'string');

function numberError(spec: NumberParam, value: ParamValue): string | undefined {
  if (typeof value !== 'number' || !Number.isFinite(value)) return `${String(value)} is not a number`;
  if (spec.integer && !Number.isInteger(value)) return `${value} is not a whole number`;
  return value < spec.min || value > spec.max ? `${value} is outside ${spec.min} … ${spec.max}` : undefined;
}
