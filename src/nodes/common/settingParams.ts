import type { BooleanParam, ChoiceParam, NumberParam, ParamSpec } from '../../graph/nodeType.ts';
import {
  SETTING_NAMES,
  type SettingName,
  type SettingOfNode,
  type SettingValue,
  settingNamed,
} from '../../scene/settings/settings.ts';

type ParamOf<Name extends SettingName> =
  SettingValue<Name> extends boolean
    ? BooleanParam
    : SettingValue<Name> extends string
      ? ChoiceParam<SettingValue<Name>>
      : NumberParam;

/** The settings that a type of node has as its parameters, in the order of the list. */
export const settingParams = <Id extends string>(node: Id): { readonly [Name in SettingOfNode<Id>]: ParamOf<Name> } =>
  Object.fromEntries(
    SETTING_NAMES.filter((name) => settingNamed(name).nodes?.includes(node)).map((name) => [name, settingParam(name)]),
  ) as { readonly [Name in SettingOfNode<Id>]: ParamOf<Name> };

/** A setting as a node's parameter. */
export const settingParam = <Name extends SettingName>(name: Name): ParamOf<Name> =>
  paramSpec(name) as unknown as ParamOf<Name>;

/** Range of a number setting without a control. */
const UNBOUNDED = { min: -1e9, max: 1e9, step: 0.001 } as const;

function paramSpec(name: SettingName): ParamSpec {
  const setting = settingNamed(name);
  const common = {
    title: setting.title ?? name,
    ...(setting.help && { help: setting.help }),
    ...(setting.onlyWhen && { onlyWhen: setting.onlyWhen }),
  };
  const physical = setting.physical !== undefined && { physical: setting.physical };
  if (setting.kind === 'choice') {
    const options = Object.entries(setting.options).map(([value, title]) => ({ value, title }));
    return { kind: 'choice', ...common, default: setting.default, options, ...physical };
  }
  if (setting.kind === 'boolean') return { kind: 'boolean', ...common, default: setting.default, ...physical };
  const { control, default: value } = setting;
  return { kind: 'number', ...common, default: value ?? 0, ...(control ?? UNBOUNDED), ...physical };
}
