/** English and Chinese. */
export type Words = readonly [en: string, zh: string];

interface SettingBase {
  /** Name of its control; under `param.NAME` in the catalogue. */
  readonly title?: Words;
  /** What the control does; under `param.NAME.help`. */
  readonly help?: Words;
  /** Ids of the node types that have it as a parameter. */
  readonly nodes?: readonly string[];
  /** As that of a node's parameter: it matters only while another one has this value. */
  readonly onlyWhen?: { readonly param: string; readonly is: string };
  readonly flag: {
    /** Stands for the value: `<how>`. A boolean needs none. */
    readonly value?: string;
    /** Of `--help`. */
    readonly help: string;
  };
  /** The G-buffers of one picture may differ in it. */
  readonly perBuffer?: true;
  /** It is resolved before a renderer sees it, which does not have it among its settings. */
  readonly beforeRendering?: true;
  /** In the header of a picture's file, in the order of these numbers. */
  readonly header?: {
    readonly place: number;
    /** `always`: with its unit; `changed`: where it is not the default; `light`: always, in pictures of light. */
    readonly when: 'always' | 'changed' | 'light';
    readonly unit?: string;
  };
}

export interface BooleanSetting extends SettingBase {
  readonly kind: 'boolean';
  readonly default: boolean;
  /** Nature's value; see `ParamSpec`. */
  readonly physical?: boolean;
}

export interface ChoiceSetting<Value extends string = string> extends SettingBase {
  readonly kind: 'choice';
  readonly default: Value;
  /** The titles; under `SETTING.value` in the catalogue. */
  readonly options: Readonly<Record<Value, Words>>;
}

/** What numbers a flag takes; absent: all. */
export interface NumberRange {
  readonly min?: number;
  /** All above it, but not itself. */
  readonly above?: number;
  readonly max?: number;
  readonly integer?: true;
}

export interface NumberSetting extends SettingBase {
  readonly kind: 'number';
  /** Absent: the setting may be absent too. */
  readonly default?: number;
  readonly range?: NumberRange;
  /** Of the control that a node's parameter has. */
  readonly control?: {
    readonly min: number;
    readonly max: number;
    readonly step: number;
    readonly integer?: true;
    readonly unit?: string;
  };
  readonly physical?: number;
}

export type Setting = BooleanSetting | ChoiceSetting | NumberSetting;
