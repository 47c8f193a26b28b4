import type { Words } from '../../scene/settings/setting.ts';
import { SETTING_NAMES, type SettingName, type SettingValue, settingNamed } from '../../scene/settings/settings.ts';

type Camel<Text extends string> = Text extends `${infer Head}-${infer Tail}`
  ? `${Head}${Capitalize<Camel<Tail>>}`
  : Text;
type ChoiceKey = {
  [Name in SettingName]: SettingValue<Name> extends infer Value extends string ? `${Name}.${Camel<Value>}` : never;
}[SettingName];
type SettingKey = `param.${SettingName}` | `param.${SettingName}.help` | ChoiceKey;

export const settingKey = (name: SettingName): string => `param.${name}`;

/** Text key of a choice's value: `metering.restingEye`. */
export const choiceKey = (name: SettingName, value: string): string =>
  `${name}.${value.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase())}`;

/** Titles and help texts of the settings. */
export const settingTexts = Object.fromEntries(SETTING_NAMES.flatMap(textsOf)) as Readonly<Record<SettingKey, Words>>;

function textsOf(name: SettingName): (readonly [string, Words])[] {
  const setting = settingNamed(name);
  const options = setting.kind === 'choice' ? Object.entries(setting.options) : [];
  return [
    ...(setting.title ? [[settingKey(name), setting.title] as const] : []),
    ...(setting.help ? [[`${settingKey(name)}.help`, setting.help] as const] : []),
    ...options.map(([value, title]) => [choiceKey(name, value), title] as const),
  ];
}
