import { type Command, Option } from 'commander';
import { inClauses, listed, type Message, msg } from '../../messages/message.ts';
import { type OptionValues, optionsByEffect, type PipelineOption } from '../../pipelines/options.ts';
import type { Pipeline } from '../../pipelines/pipeline.ts';
import { AUTOMATIC_PIPELINES, PIPELINES, pipelineNamed } from '../../pipelines/registry.ts';
import type { Backend } from '../../render/settings.ts';
import type { AovName } from '../../scene/view/view.ts';
import { usageError } from '../terminal/exitCodes.ts';
import { localized } from '../terminal/language.ts';
import { parseWithin } from './parse.ts';
import { flagName, type SettingFlags } from './viewFlags.ts';

export interface PipelineFlags {
  /** Id of a pipeline, or `auto`. */
  readonly pipeline: string;
  /** GPU backend. */
  readonly backend: Backend | 'auto';
}

/** All flags by name: those of pipelines are only known from their records. */
type FlagValues = Readonly<Record<string, unknown>>;

const BACKENDS: Record<Backend, Message> = {
  webgpu: msg`webgpu in this process`,
  webgl: msg`webgl in a headless Chromium`,
};
const first = PIPELINES[0];

export function addPipelineFlags(command: Command): Command {
  const summaries = PIPELINES.map(({ id, summary }) => msg`${id} ${summary}`);
  const pipeline = new Option(
    '--pipeline <name>',
    localized(inClauses([...summaries, msg`auto: ${first.id} if possible`])),
  );
  const drawing = PIPELINES.filter(({ backends }) => backends.length > 0).map(({ id }) => id);
  const backend = new Option(
    '--backend <name>',
    localized(msg`of ${listed(drawing)}: ${inClauses([...Object.values(BACKENDS), msg`auto: the first that works`])}`),
  );
  command
    .addOption(pipeline.choices(['auto', ...PIPELINES.map(({ id }) => id)]).default('auto'))
    .addOption(backend.choices(['auto', ...Object.keys(BACKENDS)]).default('auto'));
  for (const [name, { option, owners }] of optionsOfAll()) addOptionFlag(command, name, option, owners);
  return command;
}

/** Options of all pipelines with the ids of their owners; the first owner's description is used. */
function optionsOfAll(): Map<string, { readonly option: PipelineOption; readonly owners: string[] }> {
  const all = new Map<string, { readonly option: PipelineOption; readonly owners: string[] }>();
  for (const { id, options } of PIPELINES)
    for (const [name, option] of Object.entries(options)) {
      const existing = all.get(name);
      if (existing) existing.owners.push(id);
      else all.set(name, { option, owners: [id] });
    }
  return all;
}

function addOptionFlag(command: Command, name: string, option: PipelineOption, owners: readonly string[]): void {
  const help = localized(msg`of ${listed(owners)}: ${option.help}`);
  const flag = flagName(name);
  if (option.kind === 'boolean' && option.default) command.option(`--no-${flag}`, help);
  else if (option.kind === 'boolean') command.option(`--${flag}`, help, false);
  else if (option.kind === 'integer')
    command.option(`--${flag} <n>`, help, parseWithin({ min: option.min, max: option.max, integer: true }));
  else command.option(`--${flag} <x>`, help, parseWithin({ min: option.min, max: option.max }));
}

/** The values of a pipeline's options. */
export const optionsOf = ({ options }: Pipeline, flags: PipelineFlags): OptionValues =>
  Object.fromEntries(Object.keys(options).map((name) => [name, (flags as unknown as OptionValues)[name]]));

/** Throws if flags exclude each other, before any work is done. */
export function checkPipeline(
  flags: PipelineFlags & Pick<SettingFlags, 'solver'> & { readonly aov?: readonly AovName[] },
): void {
  const idle = unusedOption(flags);
  if (idle)
    throw usageError(msg`${idle.flag} is for the ${idle.owner.name}: add --pipeline ${idle.owner.id}, or leave it out`);
  const lacking = flags.pipeline === 'auto' && flags.aov?.find((name) => !first.aovs.includes(name));
  const owner = lacking && PIPELINES.find(({ aovs }) => aovs.includes(lacking));
  if (owner)
    throw usageError(msg`${`--aov ${lacking}`} is for the ${owner.name}: add --pipeline ${owner.id}, or leave it out`);
  if (flags.pipeline === 'auto') return;
  const pipeline = pipelineNamed(flags.pipeline);
  const foreign = foreignSetting(flags, pipeline);
  if (foreign) {
    const why = pipeline.constraint ?? msg`does not have it`;
    throw usageError(msg`${foreign} is for the ${first.name}; --pipeline ${pipeline.id} ${why}. Leave one of them out`);
  }
  const odd = flags.aov?.find((name) => !pipeline.aovs.includes(name));
  if (odd) throw usageError(msg`--aov ${odd}: --pipeline ${pipeline.id} gives ${listed(pipeline.aovs) || msg`none`}`);
}

/** A backend or setting value that a pipeline does not support; undefined if none. */
export function foreignSetting(flags: PipelineFlags, { backends, fixedSettings }: Pipeline): string | undefined {
  const { backend } = flags;
  if (backend !== 'auto' && !backends.includes(backend)) return `--backend ${backend}`;
  const given = flags as unknown as FlagValues;
  const [odd] = Object.entries(fixedSettings).filter(([name, value]) => given[name] !== value);
  return odd && `--${odd[0]} ${given[odd[0]]}`;
}

/**
 * A given option that only other pipelines have; undefined if none. With `auto` an option of a fallback is accepted unless it changes the picture, which must not
 * depend on the machine.
 */
function unusedOption(flags: PipelineFlags): { readonly flag: string; readonly owner: Pipeline } | undefined {
  const drawing = flags.pipeline === 'auto' ? first : pipelineNamed(flags.pipeline);
  const given = flags as unknown as FlagValues;
  for (const owner of PIPELINES) {
    for (const [name, option] of optionsByEffect(owner.options)) {
      if (Object.hasOwn(drawing.options, name) || !isGiven(option, given[name])) continue;
      if (flags.pipeline === 'auto' && !option.changesPicture && AUTOMATIC_PIPELINES.includes(owner)) continue;
      const flag = flagName(name);
      return { flag: option.kind === 'boolean' && option.default ? `--no-${flag}` : `--${flag}`, owner };
    }
  }
  return undefined;
}

const isGiven = (option: PipelineOption, value: unknown): boolean =>
  option.kind === 'boolean' ? value !== option.default : value !== undefined;
