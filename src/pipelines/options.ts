/**
 * What a pipeline can be told beside a picture's settings. Flags of the command line, parameters of nodes and checks are made of these
 * descriptions.
 */
interface OptionBase {
  /** In the command line's help, after whose option it is. */
  readonly help: string;
  /** It changes what pictures show, not only their noise or how long they take. */
  readonly changesPicture: boolean;
  /** Absent: no node has it as a parameter. Keys of the catalogue of messages. */
  readonly param?: { readonly title: string; readonly help: string };
}
export interface IntegerOption extends OptionBase {
  readonly kind: 'integer';
  readonly min: number;
  readonly max: number;
  /** Absent: the pipeline chooses. */
  readonly default?: number;
}
export interface BooleanOption extends OptionBase {
  readonly kind: 'boolean';
  readonly default: boolean;
}
export type PipelineOption = IntegerOption | BooleanOption;
/** By name: `threads` is `--threads N`; a boolean that is on by default, as `mirrors`, is `--no-mirrors`. */
export type PipelineOptions = Readonly<Record<string, PipelineOption>>;

type OptionValueOf<Option> = Option extends { readonly kind: 'boolean' }
  ? boolean
  : Option extends { readonly default: number }
    ? number
    : number | undefined;
export type OptionValuesOf<Options extends PipelineOptions> = {
  readonly [K in keyof Options]: OptionValueOf<Options[K]>;
};
/** As somebody gives them: what is absent or undefined has its default. */
export type OptionValues = Readonly<Record<string, number | boolean | undefined>>;

export const withDefaults = <Options extends PipelineOptions>(
  options: Options,
  given: OptionValues,
): OptionValuesOf<Options> =>
  Object.fromEntries(
    Object.entries(options).map(([name, option]) => [name, given[name] ?? option.default]),
  ) as OptionValuesOf<Options>;

/** Those that change the picture first. */
export function optionsByEffect(options: PipelineOptions): readonly (readonly [string, PipelineOption])[] {
  const all = Object.entries(options);
  return [
    ...all.filter(([, { changesPicture }]) => changesPicture),
    ...all.filter(([, { changesPicture }]) => !changesPicture),
  ];
}
