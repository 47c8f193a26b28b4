import { Command } from 'commander';
import { msg } from '../../messages/message.ts';
import { localized } from '../terminal/language.ts';

/** `slowlight graph check|upgrade|docs` */
export function graphCommand(): Command {
  const command = new Command('graph').description(
    localized(msg`Checks and upgrades projects, and prints the reference of all nodes.`),
  );
  command
    .command('check')
    .description(localized(msg`Reports errors in projects, node by node, without opening the files that they use.`))
    .argument('<projects...>', '.slowlight.json')
    .option('--json', localized(msg`print the errors as JSON; for several projects, a list`))
    .action(async (paths: string[], flags: { json?: boolean }) =>
      (await import('./graphAction.ts')).check(paths, flags),
    );
  command
    .command('upgrade')
    .description(
      localized(msg`Upgrades a project to the current version; the same project always gives the same text.`),
    )
    .argument('<project>', '.slowlight.json')
    .option('-o, --output <file>', localized(msg`output file (default: the project itself)`))
    .action(async (path: string, flags: { output?: string }) =>
      (await import('./graphAction.ts')).upgrade(path, flags),
    );
  command
    .command('docs')
    .description(
      localized(msg`Prints the reference of all nodes, in Markdown: sockets, parameters, units, ranges, defaults.`),
    )
    .argument('[type]', localized(msg`a single node type, such as relativity-console`))
    .action(async (type?: string) => (await import('./graphAction.ts')).docs(type));
  return command;
}
