import { type LocalizedText, type Message, msg } from '../messages/message.ts';
import { MessageError } from '../messages/messageError.ts';
import type { ParamValue } from './document/document.ts';

/**
 * How a node type describes itself. Panels, menus, reference pages and tests are generated from these descriptions, so
 * a new node is one file.
 */
export interface Socket<Type extends string = string> {
  /**
   * Two sockets connect if their types are equal, or one converts to the other (analysis/conversion.ts). `any`: the
   * type of what is connected; all `any` sockets of a node have the same type.
   */
  readonly type: Type;
  /** Default: the socket's name. */
  readonly title?: LocalizedText;
  /** Whether it may be unconnected; otherwise a missing source is an error. */
  readonly optional?: boolean;
  /** Whether it takes any number of edges, ordered by number: `name.1`, `name.2`. The node's code gets an array. */
  readonly many?: boolean;
}
/** Type of a socket that takes its type from its connections. */
export const ANY = 'any';

interface ParamBase {
  readonly title: LocalizedText;
  /** Explanation. */
  readonly help?: LocalizedText;
  /** The parameter is active only while another is active and has this value, or one of these, or not this one. */
  readonly onlyWhen?:
    | { readonly param: string; readonly is: ParamValue | readonly ParamValue[] }
    | { readonly param: string; readonly isNot: ParamValue };
  /** The physical value; at any other the control is marked as unphysical. */
  readonly physical?: ParamValue;
}
/** A number with its range. */
export interface NumberParam extends ParamBase {
  readonly kind: 'number';
  /** Without a value in the document. */
  readonly default: number;
  /** Least value, in `unit`. */
  readonly min: number;
  /** Greatest value, in `unit`. */
  readonly max: number;
  /** Of the control. */
  readonly step: number;
  /**
   * `log`: the control moves in equal ratios. `approach`: in equal steps of the distance to 1, on a scale that never
   * reaches it.
   */
  readonly scale?: 'linear' | 'log' | 'approach';
  /** As displayed beside the number: `m/s`, `c`, `EV`, `°`. */
  readonly unit?: string;
  /** Whether it is a whole number. */
  readonly integer?: boolean;
  /** False: no bounded range, so there is only a text field. */
  readonly slider?: boolean;
  /** Name of the scene's suggestion, which precedes the default while the parameter is not set. */
  readonly suggestion?: string;
  /** The meaning depends on another parameter's value; with a value not listed here it is inactive. */
  readonly as?: { readonly param: string; readonly cases: Readonly<Record<string, NumberVariant>> };
}
/** Title and range of a number in one of its meanings. */
export type NumberVariant = Pick<
  NumberParam,
  'title' | 'default' | 'min' | 'max' | 'step' | 'scale' | 'unit' | 'slider'
>;
/** A switch. */
export interface BooleanParam extends ParamBase {
  readonly kind: 'boolean';
  /** Without a value in the document. */
  readonly default: boolean;
}
/** One of several values. */
export interface ChoiceParam<Value extends string = string> extends ParamBase {
  readonly kind: 'choice';
  /** Without a value in the document. */
  readonly default: Value;
  /** In the order of menus. */
  readonly options: readonly { readonly value: Value; readonly title: LocalizedText }[];
}
/** A text. */
export interface TextParam extends ParamBase {
  readonly kind: 'text';
  /** Without a value in the document. */
  readonly default: string;
  /** Source of its options: the scene's `cameras`. Absent: set by a special control (the opened file). */
  readonly choices?: 'cameras';
  /** Whether it names a file of the project. */
  readonly file?: true;
  /** Whether it is the source text of an effect, of many lines. */
  readonly shader?: true;
  /** Whether it may have several lines. */
  readonly lines?: true;
}
/** Three numbers: a direction or a position. */
export interface VectorParam extends ParamBase {
  readonly kind: 'vector';
  /** Without a value in the document. */
  readonly default: readonly [number, number, number];
  /** Unit of each component, as displayed beside the number. */
  readonly unit?: string;
}
/** Linear sRGB. */
export interface ColorParam extends ParamBase {
  readonly kind: 'color';
  /** Without a value in the document. */
  readonly default: readonly [number, number, number];
}
/** Any number of texts, set by a special control. */
export interface ListParam extends ParamBase {
  readonly kind: 'list';
  /** Without a value in the document. */
  readonly default: readonly string[];
}
/** The description of a parameter. */
export type ParamSpec = NumberParam | BooleanParam | ChoiceParam | TextParam | VectorParam | ColorParam | ListParam;

/** Type of a parameter's value in the node's code. */
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

/** The part of `AbortSignal` that the engine needs. */
export interface AbortSignalLike {
  /** Whether it is cancelled. */
  readonly aborted: boolean;
  /** Calls `listener` when it is cancelled. */
  addEventListener(type: 'abort', listener: () => void): void;
}

/** Reports the completed fraction, 0 … 1, or undefined if unknown, and what is being done. */
export type ProgressCallback = (part: number | undefined, what?: string) => void;

/** By output name. Other names may hold data that the node itself needs for resuming. */
export type Outputs = Readonly<Record<string, unknown>>;

/**
 * Gives the current state as outputs that are valid as far as they go. Call whenever there is something new; `make` is
 * only called if a result is wanted now.
 */
export type ReportInterim = (make: () => Outputs) => void;

/** What a node's code is given besides its inputs and parameters. */
export interface EvaluationContext<Services> {
  /** Of the host. */
  readonly services: Services;
  /** Whether the work is still wanted. */
  readonly signal?: AbortSignalLike;
  /** To be told how far the work is. */
  readonly progress: ProgressCallback;
  /** Absent if interim results are not requested. */
  readonly interim?: ReportInterim;
  /** The last interim result of the same content, if its work was cancelled. */
  readonly resume?: Outputs;
}

/** Cause and remedy of a problem, as displayed on the node. */
export interface NodeProblem {
  /** With an error the node has no result. */
  readonly severity: 'error' | 'warning';
  /** Short and stable, for programs. */
  readonly code: string;
  /** Node, or file and prim path. */
  readonly place: LocalizedText;
  /** What is the matter and what to do, for people. */
  readonly message: Message;
  /** A parameter change that would solve it. */
  readonly remedy?: { readonly node: string; readonly param: string; readonly value: ParamValue };
}

/**
 * Thrown by a node's evaluation to refuse its inputs; the engine reports it at the node.
 * @example
 * import { msg } from 'slowlight/messages';
 * const refusal = new NodeRefusal({ severity: 'error', code: 'too-fast', place: 'fly1', message: msg`β is 1.2; choose less` });
 * refusal.problem.code; // 'too-fast'
 */
export class NodeRefusal extends MessageError {
  /** What the engine reports at the node. */
  readonly problem: NodeProblem;
  constructor(problem: NodeProblem) {
    super(problem.message);
    this.name = 'NodeRefusal';
    this.problem = problem;
  }
}

/** Of menus. */
export type NodeCategory = 'geometry' | 'dynamics' | 'composition' | 'render' | 'utility';

/** A node type with erased types, as engine and panels use it. */
export interface NodeType<Services = unknown> {
  /** Short and stable, in files. */
  readonly id: string;
  /** In menus and on the node. */
  readonly title: Message;
  /** Explanation. */
  readonly help: Message;
  /** Of menus. */
  readonly category: NodeCategory;
  /** Parameters by name, in the order of panels. */
  readonly params: Readonly<Record<string, ParamSpec>>;
  /** Sockets by name. */
  readonly inputs: Readonly<Record<string, Socket>>;
  /** Sockets by name. */
  readonly outputs: Readonly<Record<string, Socket>>;
  /** The inputs needed with these parameters; others are not evaluated. Default: all. */
  needs?(params: Readonly<Record<string, ParamValue | undefined>>): readonly string[];
  /** Whether it takes long and is evaluated in a worker, without services. */
  readonly heavy?: boolean;
  /** Whether it computes on a GPU, which is not available in every worker. */
  onGpu?(params: Readonly<Record<string, ParamValue | undefined>>): boolean;
  /** The outputs by name. Pure; throws a NodeRefusal where the inputs are not fit. */
  evaluate(
    inputs: Readonly<Record<string, unknown>>,
    params: Readonly<Record<string, ParamValue | undefined>>,
    work: EvaluationContext<Services> & { readonly node: string },
  ): Record<string, unknown> | Promise<Record<string, unknown>>;
}

/** The known node types by id. */
export type Registry<Services = unknown> = Readonly<Record<string, NodeType<Services>>>;

/** All parameters with their values: as set, else the default; undefined if the scene may suggest one. */
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

/** The description of a parameter at the given values of the others. */
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

/** Whether a parameter of a type is active at the values of the others. */
export function isParamActive(
  type: Pick<NodeType, 'params'>,
  spec: ParamSpec,
  params: Readonly<Record<string, ParamValue | undefined>>,
): boolean {
  const { onlyWhen } = spec;
  if (spec.kind === 'number' && spec.as) return Object.hasOwn(spec.as.cases, String(params[spec.as.param]));
  if (onlyWhen === undefined) return true;
  const value = params[onlyWhen.param] ?? '';
  const governs = type.params[onlyWhen.param];
  if (governs && !isParamActive(type, governs, params)) return false;
  return 'isNot' in onlyWhen ? value !== onlyWhen.isNot : [onlyWhen.is].flat().includes(value);
}

/** Whether the value differs from the physical one. */
export const isUnphysical = ({ physical }: ParamSpec, value: ParamValue): boolean =>
  physical !== undefined && value !== physical;

/**
 * Why a value is not valid for a parameter; undefined if it is.
 * @example
 * import { inEnglish } from 'slowlight/messages';
 * const speed: ParamSpec = { kind: 'number', title: 'Speed', default: 0, min: 0, max: 1, step: 0.1 };
 * valueError(speed, 0.5); // undefined
 * inEnglish(valueError(speed, 2)!); // '2 is outside 0 … 1'
 */
export function valueError(spec: ParamSpec, value: ParamValue): Message | undefined {
  if (spec.kind === 'number') return numberError(spec, value);
  if (spec.kind === 'choice')
    return spec.options.some((option) => option.value === value)
      ? undefined
      : msg`${String(value)} is none of the choices`;
  if (spec.kind === 'vector' || spec.kind === 'color')
    return isVector(value) ? undefined : msg`${String(value)} is not three numbers`;
  if (spec.kind === 'list') return isList(value) ? undefined : msg`${String(value)} is no list of texts`;
  if (spec.kind === 'boolean')
    return typeof value === 'boolean' ? undefined : msg`${String(value)} is neither true nor false`;
  return typeof value === 'string' ? undefined : msg`${String(value)} is not a text`;
}

const isVector = (value: ParamValue): boolean =>
  Array.isArray(value) && value.length === 3 && value.every((x) => Number.isFinite(x));
const isList = (value: ParamValue): boolean => Array.isArray(value) && value.every((text) => typeof text === 'string');

function numberError(spec: NumberParam, value: ParamValue): Message | undefined {
  if (typeof value !== 'number' || !Number.isFinite(value)) return msg`${String(value)} is not a number`;
  if (spec.integer && !Number.isInteger(value)) return msg`${value} is not a whole number`;
  return value < spec.min || value > spec.max ? msg`${value} is outside ${spec.min} … ${spec.max}` : undefined;
}
