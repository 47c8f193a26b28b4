import { Command, type Option } from 'commander';
import { addPipelineFlags } from '../../src/cli/flags/pipelineFlags.ts';
import { addSceneFlags } from '../../src/cli/flags/sceneFlags.ts';
import { addObserverFlags, addSettingFlags } from '../../src/cli/flags/viewFlags.ts';
import { commands } from '../../src/cli/main.ts';
import { EXIT_MEANINGS } from '../../src/cli/terminal/exitCodes.ts';
import { inEnglish } from '../../src/messages/message.ts';

/** Flags that several commands share, by the section of the page that has their table. */
const GROUPS = {
  Observer: addObserverFlags,
  'Files and motions': addSceneFlags,
  'Picture settings': addSettingFlags,
  'Pipelines and backends': addPipelineFlags,
};

const COMMANDS = commands().flatMap((command) => (command.commands.length > 0 ? command.commands : [command]));

/** Every flag of every command, `--no-` included. */
export const FLAGS: ReadonlySet<string> = new Set([
  '--help',
  '--version',
  '--lang',
  ...COMMANDS.flatMap(({ options }) => options.map(({ long }) => long!)),
]);

const optionsOf = (add: (command: Command) => Command): readonly Option[] => add(new Command()).options;

/** docs/guide/command-line.md with its generated parts, those between `<!-- made: NAME -->` and `<!-- end -->`, made anew. */
export const withTables = (page: string): string =>
  page.replace(
    /(<!-- made: ([^>]*) -->\n)[\s\S]*?(<!-- end -->)/g,
    (_, begin, name, end) => `${begin}${made(name)}\n${end}`,
  );

function made(name: string): string {
  if (name === 'commands') return COMMANDS.map(commandSection).join('\n\n');
  if (name === 'exit codes')
    return table(
      ['code', 'means'],
      Object.entries(EXIT_MEANINGS).map(([code, meaning]) => [code, inEnglish(meaning)]),
    );
  return flagTable(optionsOf(GROUPS[name as keyof typeof GROUPS]));
}

function commandSection(command: Command): string {
  const has = (option: Option): boolean => command.options.some(({ flags }) => flags === option.flags);
  const groups = Object.entries(GROUPS).filter(([, add]) => optionsOf(add).every(has));
  const shared = groups.flatMap(([, add]) => optionsOf(add).map(({ flags }) => flags));
  const own = command.options.filter(({ flags }) => !shared.includes(flags));
  const links = groups.map(([title]) => `[${title}](#${anchor(title)})`).join(', ');
  const names = command.parent ? [command.parent.name(), command.name()] : [command.name()];
  const args = command.registeredArguments.map((each) => (each.required ? `<${each.name()}>` : `[${each.name()}]`));
  return [
    `### ${names.join(' ')}`,
    `\`slowlight ${[...names, ...args].join(' ')}\`: ${command.description()}`,
    ...(own.length > 0 ? [flagTable(own)] : []),
    ...(links ? [`Also the flags of ${links}.`] : []),
  ].join('\n\n');
}

const anchor = (title: string): string =>
  title
    .toLowerCase()
    .replace(/[^\p{L}\s]/gu, '')
    .replaceAll(' ', '-');

const flagTable = (options: readonly Option[]): string => table(['flag', 'means', 'default'], options.map(flagRow));

function flagRow({ flags, description, argChoices, defaultValue, defaultValueDescription }: Option): string[] {
  const choices = argChoices ? ` (${argChoices.map((each) => `\`${each}\``).join(', ')})` : '';
  const fallback = defaultValueDescription ?? (defaultValue === false ? undefined : defaultValue);
  return [`\`${flags}\``, `${description}${choices}`, fallback === undefined ? '' : `\`${fallback}\``];
}

function table(head: readonly string[], rows: readonly (readonly string[])[]): string {
  const line = (row: readonly string[]): string => `| ${row.map((cell) => cell.replaceAll('|', '\\|')).join(' | ')} |`;
  return [line(head), line(head.map(() => '---')), ...rows.map(line)].join('\n');
}
