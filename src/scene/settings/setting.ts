import type { LocalizedText, Message } from '../../messages/message.ts';

interface SettingBase {
  /** Title of its control; a setting without a control has none. */
  readonly title?: Message;
  /** Help of its control. */
  readonly help?: Message;
  /** Ids of the node types with this parameter. */
  readonly nodes?: readonly string[];
  /** Relevant only while another parameter, which is relevant itself, has this value or one of these, as `onlyWhen` of `ParamSpec`. */
  readonly onlyWhen?: { readonly param: string; readonly is: string | readonly string[] };
  readonly flag: {
    /** Placeholder of the value: `<how>`; absent for booleans. */
    readonly value?: string;
    /** Text in `--help`. */
    readonly help: Message;
  };
  /** Whether the G-buffers of one picture may differ in it. */
  readonly perBuffer?: true;
  /** Whether it is resolved before rendering and not part of the renderers' settings. */
  readonly beforeRendering?: true;
  /** Written to picture file headers, ordered by `place`. */
  readonly header?: {
    readonly place: number;
    /** `always`; `changed`: if it differs from the default; `light`: always in pictures of light. */
    readonly when: 'always' | 'changed' | 'light';
    readonly unit?: string;
  };
}

export interface BooleanSetting extends SettingBase {
  readonly kind: 'boolean';
  readonly default: boolean;
  /** The physically correct value; see `ParamSpec`. */
  readonly physical?: boolean;
}

export interface ChoiceSetting<Value extends string = string> extends SettingBase {
  readonly kind: 'choice';
  readonly default: Value;
  /** As of `BooleanSetting`. */
  readonly physical?: Value;
  /** Titles of the values. */
  readonly options: Readonly<Record<Value, LocalizedText>>;
}

/** Values that a flag accepts; absent: all numbers. */
export interface NumberRange {
  readonly min?: number;
  /** Exclusive lower bound. */
  readonly above?: number;
  readonly max?: number;
  readonly integer?: true;
}

export interface NumberSetting extends SettingBase {
  readonly kind: 'number';
  /** Absent: the setting is optional. */
  readonly default?: number;
  readonly range?: NumberRange;
  /** The control of the node parameter. */
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
