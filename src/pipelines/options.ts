import type { LocalizedText } from '../messages/message.ts';

/**
 * A pipeline's option, in addition to a picture's settings. Flags of the command line, parameters of nodes and checks derive
 * from these descriptions.
 */
interface OptionBase {
  /** Help of the flag, which follows the owning pipelines. */
  readonly help: LocalizedText;
  /** Whether it changes the picture itself, not only noise or render time. */
  readonly changesPicture: boolean;
  /** Texts of the node parameter; absent: no parameter. */
  readonly param?: { readonly title: LocalizedText; readonly help: LocalizedText };
}
export interface IntegerOption extends OptionBase {
  readonly kind: 'integer';
  readonly min: number;
  readonly max: number;
  /** Absent: the pipeline chooses. */
  readonly default?: number;
}
/** A real number, of a range that includes both ends. */
export interface NumberOption extends OptionBase {
  readonly kind: 'number';
  readonly min: number;
  readonly max: number;
  readonly default: number;
  /** Of the parameter's slider. */
  readonly step: number;
}
export interface BooleanOption extends OptionBase {
  readonly kind: 'boolean';
  readonly default: boolean;
}
export type PipelineOption = IntegerOption | NumberOption | BooleanOption;
/** By name: `threads` is `--threads <n>`, `noiseThreshold` `--noise-threshold <x>`; a boolean with default true, such as `mirrors`, is `--no-mirrors`. */
export type PipelineOptions = Readonly<Record<string, PipelineOption>>;

type OptionValueOf<Option> = Option extends { readonly kind: 'boolean' }
  ? boolean
  : Option extends { readonly default: number }
    ? number
    : number | undefined;
export type OptionValuesOf<Options extends PipelineOptions> = {
  readonly [K in keyof Options]: OptionValueOf<Options[K]>;
};
/** Values as given; absent or undefined ones have their defaults. */
export type OptionValues = Readonly<Record<string, number | boolean | undefined>>;

export const withDefaults = <Options extends PipelineOptions>(
  options: Options,
  values: OptionValues,
): OptionValuesOf<Options> =>
  Object.fromEntries(
    Object.entries(options).map(([name, option]) => [name, values[name] ?? option.default]),
  ) as OptionValuesOf<Options>;

/** All options, those that change the picture first. */
export function optionsByEffect(options: PipelineOptions): readonly (readonly [string, PipelineOption])[] {
  const all = Object.entries(options);
  return [
    ...all.filter(([, { changesPicture }]) => changesPicture),
    ...all.filter(([, { changesPicture }]) => !changesPicture),
  ];
}
